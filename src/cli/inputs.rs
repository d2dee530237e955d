//! What a command reads, which its result must not replace: a typing error (`srt scene.sce scene.sce --format png`)
//! must not destroy it.

use std::fs::canonicalize;
use std::path::Path;

use super::exit::Failure;
use super::load::Loaded;
use super::output::Output;

/// Refuses an output, called `result`, that would replace a file, which is called `what`.
pub(super) fn refuse_to_replace(
    output: &Output,
    result: &str,
    what: &str,
    path: &Path,
) -> Result<(), Failure> {
    if !output.file().is_some_and(|file| is_same_file(file, path)) {
        return Ok(());
    }
    let path = path.display();
    Err(Failure::new(format_args!("{result} would replace {what} `{path}`: give it another name")))
}

/// The same for the meshes of a scene, whose names are known once it is loaded.
pub(super) fn refuse_to_replace_a_mesh(
    output: &Output,
    result: &str,
    loaded: &Loaded,
) -> Result<(), Failure> {
    let what = "the mesh of the scene";
    loaded.mesh_files.iter().try_for_each(|mesh| refuse_to_replace(output, result, what, mesh))
}

/// Whether two paths lead to one file that is there.
pub(super) fn is_same_file(a: &Path, b: &Path) -> bool {
    canonicalize(a).is_ok_and(|a| canonicalize(b).is_ok_and(|b| a == b))
}
