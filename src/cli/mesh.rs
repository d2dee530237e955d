//! `srt mesh`: a generated mesh as a Wavefront OBJ file. What the meshes look like is not known
//! here.

use super::args::MeshArguments;
use super::exit::{Exit, Outcome};
use super::output::Output;
use super::terminal::tell;
use crate::assets::generate::generate;

/// Generates and writes the mesh.
pub(super) fn run(arguments: &MeshArguments) -> Outcome {
    let output = Output::prepare(&arguments.output)?;
    let mesh = generate(arguments.kind, arguments.triangles, arguments.seed);
    output.write(|mut to| mesh.to_obj(&mut to))?;
    let made = mesh.triangles.len();
    let asked = arguments.triangles;
    if made != asked as usize {
        let least = generate(arguments.kind, 1, arguments.seed).triangles.len();
        let why = if (asked as usize) < least {
            format!("asked for {asked}, the least is {least}")
        } else {
            format!("asked for {asked}, the form does not allow every number")
        };
        tell(format_args!("the {} has {made} triangles: {why}", arguments.kind));
    }
    Ok(Exit::Fine)
}
