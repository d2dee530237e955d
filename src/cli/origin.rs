//! What the parts of a picture state that they are of: the scene, the settings, and this version of the program.

use sha2::{Digest, Sha256};

use super::load::Loaded;
use crate::assets::MeshData;
use crate::built_file::Program;
use crate::part_file::{Hash, Origin};
use crate::render::Settings;

/// Vertices or triangles that are hashed at a time.
const AT_ONCE: usize = 4096;

/// The origin of a picture of a scene with these settings.
pub(crate) fn origin(loaded: &Loaded, settings: &Settings) -> Origin {
    let settings = Settings { count: false, ..settings.clone() };
    let Program { version, sources } = program();
    Origin { scene: scene_hash(loaded), sources, version, settings }
}

/// This program.
pub(crate) fn program() -> Program {
    Program { version: env!("CARGO_PKG_VERSION").to_owned(), sources: sources() }
}

/// SHA-256 of the scene's text, of the frame unless it is 0, and of the meshes as they are traced, generated ones too.
/// Each list begins with its length, 64 bits; all numbers are little-endian.
/// A built scene has it written down.
pub(super) fn scene_hash(loaded: &Loaded) -> Hash {
    if let Some(hash) = loaded.built.as_ref().and_then(|built| built.hash) {
        return hash;
    }
    let mut hash = Sha256::new();
    hash.update((loaded.text.len() as u64).to_le_bytes());
    hash.update(&loaded.text);
    if loaded.frame != 0 {
        hash.update(loaded.frame.to_le_bytes());
    }
    for mesh in loaded.scene.meshes() {
        let MeshData { positions, triangles, normals, normal_indices, dropped: _ } = &**mesh;
        for vectors in [positions, normals] {
            add(&mut hash, vectors, |vector| vector.to_array().map(f32::to_le_bytes));
        }
        for indices in [triangles, normal_indices] {
            add(&mut hash, indices, |indices| indices.map(u32::to_le_bytes));
        }
    }
    hash.finalize().into()
}

fn add<T>(hash: &mut Sha256, list: &[T], bytes_of: impl Fn(&T) -> [[u8; 4]; 3]) {
    hash.update((list.len() as u64).to_le_bytes());
    let mut bytes = Vec::with_capacity(12 * AT_ONCE.min(list.len()));
    for some in list.chunks(AT_ONCE) {
        bytes.clear();
        some.iter().for_each(|one| bytes.extend(bytes_of(one).as_flattened()));
        hash.update(&bytes);
    }
}

/// The fingerprint of the sources that this program was built from, as the build noted it.
fn sources() -> Hash {
    let noted = option_env!("SRT_SOURCES").unwrap_or_default();
    let mut hash = Hash::default();
    for (byte, digits) in hash.iter_mut().zip(noted.as_bytes().chunks(2)) {
        let digits = std::str::from_utf8(digits).unwrap_or_default();
        *byte = u8::from_str_radix(digits, 16).unwrap_or(0);
    }
    hash
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sources_are_those_of_the_build() {
        let noted = option_env!("SRT_SOURCES").unwrap_or_default();
        assert_eq!(noted.len(), 64, "the build notes it");
        let digits: String = sources().iter().map(|byte| format!("{byte:02x}")).collect();
        assert_eq!(digits, noted);
    }
}
