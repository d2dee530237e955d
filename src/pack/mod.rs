//! A scene and the files that it names, in one file that travels: a tar archive whose first member, `SHA256SUMS`, has
//! the hash of every other, as `sha256sum --check` reads them. Described in `docs/pack-file.md`. Touches no file.

mod error;
mod names;
mod read;
mod write;

pub use error::PackError;
pub use names::{Located, NameError, locate};

use names::resolve;

/// The member that lists the others with their hashes. The first that it names is the scene.
const SUMS: &str = "SHA256SUMS";

/// A scene and its files.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pack {
    /// Bytes that hold all files, among others.
    bytes: Vec<u8>,
    /// The files with their names; the first is the scene.
    files: Vec<File>,
}

/// A file within the bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
struct File {
    name: String,
    range: std::ops::Range<usize>,
}

impl Pack {
    /// The scene's name, and its text as it was in its file.
    #[must_use]
    pub fn scene(&self) -> (&str, &[u8]) {
        let scene = &self.files[0];
        (&scene.name, &self.bytes[scene.range.clone()])
    }

    /// The contents of a file that the scene names, by the name as the scene has it: relative to the scene's folder.
    #[must_use]
    pub fn file(&self, name: &str) -> Option<&[u8]> {
        let name = self.member(name)?;
        let file = self.files[1..].iter().find(|file| file.name == name)?;
        Some(&self.bytes[file.range.clone()])
    }

    /// The name that a file has here which the scene calls so; `None` if that lies outside of what can be packed.
    #[must_use]
    pub fn member(&self, name: &str) -> Option<String> {
        let folder = self.files[0].name.rsplit_once('/').map_or("", |(folder, _)| folder);
        resolve(folder, name)
    }

    /// The names of all files, that of the scene first.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.files.iter().map(|file| file.name.as_str())
    }
}

#[cfg(test)]
mod tests;
