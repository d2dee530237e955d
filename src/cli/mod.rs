//! The command: what was typed → work for the other layers → what the terminal shows.
//!
//! One file a subcommand. The terminal, its signals and the choice of where a result is written
//! are handled here alone; nothing here knows how a ray is traced or how a file format is made of
//! bytes.
//!
//! | file | what |
//! |---|---|
//! | `args.rs` | the definition of the command line |
//! | `work_args.rs`, `render_args.rs`, `part_args.rs` | its options of rendering |
//! | `compare_args.rs`, `animate_args.rs`, `rays_args.rs` | those of comparing, and of files of rays |
//! | `values.rs`, `choice.rs`, `structures.rs`, `near.rs` | what options take: numbers, names, structures, with slips |
//! | `command_line.rs` | the definition with the structures of this program; what was typed |
//! | `work.rs`, `options.rs`, `compare_plan.rs` | what was validated, for rendering and for comparing |
//! | `refine.rs`, `checkpoint.rs`, `origin.rs` | a rendering in passes, saved and gone on with; what it is of |
//! | `show.rs`, `show_args.rs` | a structure as a page of pictures |
//! | `view.rs`, `view_args.rs`, `watch.rs` | the live page, and the files that it follows |
//! | `frames.rs`, `sequence.rs` | the frames of a scene that moves, and their pictures |
//! | `part.rs`, `assemble.rs`, `pack.rs`, `build.rs` | the subcommands for many machines |
//! | `render.rs`, `compare.rs`, `animate.rs`, `conformance.rs`, `report.rs`, `rays.rs` | the subcommands |
//! | `check.rs`, `diff.rs`, `mesh.rs`, `accels.rs` | smaller ones |
//! | `completions.rs`, `man.rs` | the subcommands that print the definition in other forms |
//! | `output/` | where results go, whole or not at all |
//! | `inputs.rs` | what is read, and not replaced by a result |
//! | `ray_files.rs` | the files of rays of a comparison |
//! | `result_folder.rs`, `fingerprint.rs` | the files of a comparison; the hash of a scene's files |
//! | `terminal.rs`, `interrupt.rs`, `progress.rs`, `compare_progress.rs` | the terminal |
//! | `load.rs`, `source.rs` | a scene from its file, from a pack, or built |
//! | `diagnose.rs`, `inventory.rs` | what is wrong with a scene; what is in it |
//! | `picture.rs` | what was rendered → the file of the picture |
//! | `figures.rs`, `summary.rs` | the figures of a rendering, and their text |
//! | `exit.rs` | how the command ends |

mod accels;
mod animate;
mod animate_args;
mod args;
mod assemble;
mod build;
mod check;
mod checkpoint;
mod choice;
mod clipping;
mod command_line;
mod compare;
mod compare_args;
mod compare_plan;
mod compare_progress;
mod completions;
mod conformance;
mod diagnose;
mod diff;
mod exit;
mod figures;
mod fingerprint;
mod frames;
mod inputs;
mod interrupt;
mod inventory;
mod load;
mod man;
mod mesh;
mod mesh_scene;
mod near;
mod options;
mod origin;
mod output;
mod pack;
mod part;
mod part_args;
mod picture;
mod progress;
mod ray_files;
mod rays;
mod rays_args;
mod refine;
mod render;
mod render_args;
mod report;
mod result_folder;
mod sequence;
mod show;
mod show_args;
mod source;
mod structures;
mod summary;
mod terminal;
mod values;
mod view;
mod view_args;
mod watch;
mod work;
mod work_args;

use std::process::ExitCode;

use crate::scene::Structure;
use crate::simd::Isa;

use args::Command;
use exit::{CommandResult, Exit, Failure};
use interrupt::Interrupt;
use structures::Structures;

/// Runs the command with the arguments of this process.
#[must_use]
pub fn run() -> ExitCode {
    run_with(&[])
}

/// Runs the command with structures of your own beside the library's: `--accel` takes their names
/// wherever it takes the library's. This is a whole `main.rs`:
///
/// ```no_run
/// # use srt::accel::{Bvh, Bvh as Pairs};
/// use srt::scene::Structure;
///
/// fn main() -> std::process::ExitCode {
///     // A tree over the objects of a scene, pairs over the triangles of each mesh.
///     srt::cli::run_with(&[Structure::new::<Bvh, Pairs>("pairs", "two triangles in each box")])
/// }
/// ```
#[must_use]
pub fn run_with(extra: &[Structure]) -> ExitCode {
    exit::conclude(Structures::with(extra).and_then(|structures| dispatch(&structures)))
}

/// Hands what was typed to the file of its subcommand.
fn dispatch(structures: &Structures) -> CommandResult {
    let Some(arguments) = command_line::arguments(structures)? else { return Ok(Exit::Fine) };
    Isa::chosen().map_err(Failure::new)?;
    let interrupt = Interrupt::install().map_err(Failure::new)?;
    match arguments.command {
        None => render::run(arguments.render, structures, &interrupt),
        Some(Command::View(view)) => view::run(view, structures),
        Some(Command::Show(show)) => show::run(show, structures),
        Some(Command::Part(part)) => part::run(part, structures, &interrupt),
        Some(Command::Assemble(assemble)) => assemble::run(&assemble),
        Some(Command::Pack(pack)) => pack::run(&pack),
        Some(Command::Build(build)) => build::run(&build),
        Some(Command::Check(check)) => check::run(&check),
        Some(Command::Animate(animate)) => animate::run(&animate, &interrupt),
        Some(Command::Compare(compare)) => compare::run(&compare, &interrupt),
        Some(Command::Conformance(check)) => conformance::run(&check, &interrupt),
        Some(Command::Report(report)) => report::run(&report),
        Some(Command::Rays(rays)) => rays::run(&rays),
        Some(Command::Diff(diff)) => diff::run(&diff),
        Some(Command::Mesh(mesh)) => mesh::run(&mesh),
        Some(Command::Accels) => accels::run(structures),
        Some(Command::Completions(completions)) => {
            completions::run(&completions, command_line::command(structures))
        }
        Some(Command::Man(man)) => man::run(&man, command_line::command(structures)),
    }
}
