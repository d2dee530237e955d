//! A structure over a scene, to be looked at: pictures of its parts of space, level by level, and a page of them.
//!
//! | file | what |
//! |---|---|
//! | `slides.rs` | the scene with the parts of each level drawn over it |
//! | `outline.rs` | a box or a ball → lines in the world |
//! | `canvas.rs` | a picture with its depths, and lines that are hidden where surfaces are before them |
//! | `page.rs` | the slides → one self-contained page of HTML |
//!
//! Touches no file; a page is bytes.

mod canvas;
mod outline;
mod page;
mod slides;

pub use page::{Facts, page};
pub use slides::{LevelFacts, Slide, SlideOptions, Which, slides};
