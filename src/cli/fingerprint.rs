//! What a scene's files are told apart by.

use std::fmt::Write;
use std::fs;
use std::io;
use std::path::Path;

use sha2::{Digest, Sha256};

use crate::assets::generate::Recipe;
use crate::description::SceneDescription;

/// SHA-256 of a scene's file and of all mesh files that it names, in its order; hexadecimal.
pub(super) fn of_scene(path: &Path, description: &SceneDescription) -> io::Result<String> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let mut hash = Sha256::new();
    hash.update(fs::read(path)?);
    for mesh in description.meshes.iter().filter(|mesh| Recipe::parse(&mesh.name).is_none()) {
        hash.update(fs::read(folder.join(&mesh.name))?);
    }
    Ok(hash.finalize().iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}"); // writing to a string cannot fail
        text
    }))
}
