//! `srt mesh`: a generated mesh as a Wavefront OBJ file. What the meshes look like is not known
//! here.

use super::args::MeshArguments;
use super::exit::{Exit, Outcome};
use super::output::Output;
use super::pending::write_mesh;

/// Generates and writes the mesh.
pub(super) fn run(arguments: &MeshArguments) -> Outcome {
    let output = Output::prepare(&arguments.output)?;
    output
        .write(|mut to| write_mesh(arguments.kind, arguments.triangles, arguments.seed, &mut to))?;
    Ok(Exit::Fine)
}
