//! A scene that someone looks at: the camera moves, the picture refines until it stands, structures are exchanged and
//! raced, and the scene is replaced when it was saved again.
//!
//! A [`Studio`] has what all lookers share: the scene, the structures over it, the threads. Each looker has a
//! [`Session`] of its own, with a camera, a view and one or two structures. Commands go in as JSON, pictures and
//! figures come out as bytes; the one that carries them is told when there are new ones, and takes the newest when it
//! is ready, so that a slow one skips pictures and nothing piles up.
//!
//! | file | what |
//! |---|---|
//! | `studio.rs`, `worlds.rs` | the scene, who looks at it, and the structures that were built over it |
//! | `session.rs`, `inbox.rs` | a looker: commands in, the newest picture out |
//! | `worker.rs` | the thread of a session: what commands change, and what is rendered next |
//! | `lane.rs`, `coarse.rs` | a structure and its picture: a coarse one at once, then slices of passes |
//! | `turns.rs` | sessions take turns, so that each measures itself alone |
//! | `orbit.rs` | the camera, moved about the point that is looked at |
//! | `command.rs`, `update.rs`, `greeting.rs` | the messages |
//!
//! A finished picture is that of a rendering in one go, bit for bit: it comes from the same
//! [`Film`](crate::film::Film).
//!
//! Knows neither sockets, files nor the terminal.

mod coarse;
mod command;
mod greeting;
mod inbox;
mod lane;
mod orbit;
mod session;
mod studio;
mod turns;
mod update;
mod worker;
mod worlds;

pub use command::{CommandError, MOST_LANES};
pub use session::{Seen, Session};
pub use studio::{Show, Studio, StudioError};
