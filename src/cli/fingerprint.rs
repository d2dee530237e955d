//! The fingerprint of a scene's files, by which reports distinguish scenes.

use std::io;
use std::path::Path;

use sha2::{Digest, Sha256};

use super::source;
use crate::assets::generate::Recipe;
use crate::description::SceneDescription;
use crate::sealed::hexadecimal;

/// SHA-256 of a scene's file and of all mesh files that it names, in its order; hexadecimal. That of a pack is the same
/// as that of what it was made from.
pub(super) fn of_scene(path: &Path, description: &SceneDescription) -> io::Result<String> {
    let source = source::read(path).map_err(io::Error::other)?;
    let mut hash = Sha256::new();
    hash.update(source.bytes());
    for name in files(description) {
        hash.update(source.file(name)?);
    }
    Ok(hexadecimal(&hash.finalize()))
}

/// The names of the files that a scene names, in its order.
pub(super) fn files(description: &SceneDescription) -> impl Iterator<Item = &str> {
    let names = description.meshes.iter().map(|mesh| mesh.name.as_str());
    names.filter(|name| Recipe::parse(name).is_none())
}
