//! `srt mesh`: a generated mesh as a Wavefront OBJ file. Knows nothing of the shapes.

use super::args::MeshArguments;
use super::exit::{CommandResult, Exit, Failure};
use super::output::Output;
use super::terminal::print_message;
use crate::assets::expect_memory;
use crate::assets::generate::{Recipe, generate};

/// Generates and writes the mesh.
pub(super) fn run(arguments: &MeshArguments) -> CommandResult {
    let output = Output::prepare(&arguments.output)?;
    let MeshArguments { kind, triangles, seed, .. } = *arguments;
    let recipe = Recipe { kind, triangles, seed };
    expect_memory(recipe.bytes()).map_err(|shortage| {
        Failure::new(format_args!("the mesh `{recipe}` is too large: {shortage}"))
    })?;
    let mesh = generate(arguments.kind, arguments.triangles, arguments.seed);
    output.write(|mut to| mesh.to_obj(&mut to))?;
    let made = mesh.triangles.len();
    let requested = arguments.triangles;
    if made != requested as usize {
        let least = generate(arguments.kind, 1, arguments.seed).triangles.len();
        let why = if (requested as usize) < least {
            format!("{requested} were requested, the least is {least}")
        } else {
            format!("{requested} were requested, but the shape does not allow every number")
        };
        print_message(format_args!("the {} has {made} triangles: {why}", arguments.kind));
    }
    Ok(Exit::Fine)
}
