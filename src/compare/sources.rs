//! The fingerprint of the program's sources.
//!
//! `build.rs` compiles this file too and notes the fingerprint of what it builds, so that a
//! program can find out later whether the sources beside it are its own. Knows nothing of the
//! crate.

use std::fmt::Write;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

/// All that a build reads, from the package's root.
pub(super) const SOURCES: [&str; 4] = ["Cargo.lock", "Cargo.toml", "build.rs", "src"];

/// SHA-256 of the names and contents of all sources; hexadecimal.
///
/// # Errors
/// If any of them cannot be read.
pub(super) fn fingerprint(root: &Path) -> io::Result<String> {
    let mut hash = Sha256::new();
    for source in SOURCES {
        add(root, Path::new(source), &mut hash)?;
    }
    Ok(hexadecimal(&hash.finalize()))
}

/// Bytes as hexadecimal digits: of its own, because `build.rs` has nothing of the crate.
fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}"); // writing to a string cannot fail
        text
    })
}

/// Adds a file, or all files of a folder in the order of their names.
fn add(root: &Path, path: &Path, hash: &mut Sha256) -> io::Result<()> {
    let place = root.join(path);
    if place.is_dir() {
        let names = fs::read_dir(&place)?.map(|entry| Ok(path.join(entry?.file_name())));
        let mut names: Vec<PathBuf> = names.collect::<io::Result<_>>()?;
        names.sort();
        return names.iter().try_for_each(|name| add(root, name, hash));
    }
    let bytes = fs::read(place)?;
    let name = path.to_string_lossy();
    // The lengths separate a name from its content.
    for part in [name.as_bytes(), &bytes] {
        hash.update((part.len() as u64).to_le_bytes());
        hash.update(part);
    }
    Ok(())
}
