//! The command: what was typed → work for the other layers → what the terminal shows.
//!
//! One file a subcommand. The terminal, its signals and the choice of where a result is written
//! live here alone; nothing here knows how a ray is traced or how a file format is made of bytes.
//!
//! | file | what |
//! |---|---|
//! | `args.rs`, `render_args.rs`, `values.rs` | what was typed |
//! | `options.rs` | what was validated |
//! | `render.rs`, `check.rs`, `diff.rs`, `mesh.rs`, `completions.rs`, `man.rs` | the subcommands |
//! | `output/` | where results go, whole or not at all |
//! | `terminal.rs`, `interrupt.rs`, `progress.rs` | the terminal |
//! | `source.rs`, `inventory.rs` | a scene's text; what is in it |
//! | `report.rs`, `summary.rs`, `units.rs` | figures → text |
//! | `exit.rs` | how the command ends |

mod args;
mod check;
mod completions;
mod diff;
mod exit;
mod interrupt;
#[cfg_attr(not(test), expect(dead_code, reason = "told once scenes can be parsed"))]
mod inventory;
mod man;
mod mesh;
mod options;
mod output;
mod pending;
mod progress;
mod render;
mod render_args;
mod report;
mod source;
mod summary;
mod terminal;
mod units;
mod values;

use std::process::ExitCode;

use clap::Parser;

use args::{Arguments, Command};
use exit::Outcome;

/// Runs the command with the arguments of this process.
#[must_use]
pub fn run() -> ExitCode {
    exit::conclude(dispatch(Arguments::parse()))
}

/// Hands what was typed to the file of its subcommand.
fn dispatch(arguments: Arguments) -> Outcome {
    match arguments.command {
        None => render::run(arguments.render),
        Some(Command::Check(check)) => check::run(&check),
        Some(Command::Diff(diff)) => diff::run(&diff),
        Some(Command::Mesh(mesh)) => mesh::run(&mesh),
        Some(Command::Completions(completions)) => completions::run(&completions),
        Some(Command::Man(man)) => man::run(&man),
    }
}
