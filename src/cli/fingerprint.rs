//! The fingerprint of a scene's files, by which reports distinguish scenes.

use std::fs;
use std::io;
use std::path::Path;

use sha2::{Digest, Sha256};

use crate::assets::generate::Recipe;
use crate::description::SceneDescription;
use crate::sealed::hexadecimal;

/// SHA-256 of a scene's file and of all mesh files that it names, in its order; hexadecimal.
pub(super) fn of_scene(path: &Path, description: &SceneDescription) -> io::Result<String> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let mut hash = Sha256::new();
    hash.update(fs::read(path)?);
    for mesh in description.meshes.iter().filter(|mesh| Recipe::parse(&mesh.name).is_none()) {
        hash.update(fs::read(folder.join(&mesh.name))?);
    }
    Ok(hexadecimal(&hash.finalize()))
}
