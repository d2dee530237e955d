//! The fingerprint of a scene's files, by which reports distinguish scenes.

use std::io;

use sha2::{Digest, Sha256};

use super::source::Source;
use crate::assets::generate::Recipe;
use crate::description::SceneDescription;
use crate::sealed::Hash;

/// SHA-256 of a scene's file and of all mesh files that it names, in its order. That of a pack is the same as that of
/// what it was made from; a built scene has it written down.
pub(super) fn of_source(source: &Source, description: &SceneDescription) -> io::Result<Hash> {
    if let Some(built) = source.built() {
        return Ok(built.scene.fingerprint);
    }
    let mut hash = Sha256::new();
    hash.update(source.bytes());
    for name in files(description) {
        hash.update(source.file(name)?);
    }
    Ok(hash.finalize().into())
}

/// The names of the files that a scene names, in its order.
pub(super) fn files(description: &SceneDescription) -> impl Iterator<Item = &str> {
    let names = description.meshes.iter().map(|mesh| mesh.name.as_str());
    names.filter(|name| Recipe::parse(name).is_none())
}
