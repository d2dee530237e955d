//! A scene from its file, from standard input, or from a pack with all that it names.

use std::borrow::Cow;
use std::io;
use std::path::{Path, PathBuf};

use crate::assets::{MeshFiles, read_file, read_stream};
use crate::pack::{Located, Pack, PackError};

/// Why a scene's text cannot be read.
#[derive(Debug, thiserror::Error)]
pub(crate) enum SourceError {
    /// The system's error.
    #[error("cannot read the scene {}: {source}", quoted(path))]
    Io {
        /// As typed.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// An archive that is no pack, or no longer one.
    #[error("cannot read the pack {}: {source}", quoted(path))]
    Pack {
        /// As typed.
        path: PathBuf,
        /// Why.
        source: PackError,
    },
}

/// A scene and where the files are that it names.
pub(crate) struct Source {
    path: PathBuf,
    from: From,
}

enum From {
    /// The bytes of a scene that stands by itself.
    Scene(Vec<u8>),
    Pack(Pack),
}

/// Reads a scene, or a pack, from its file, or from standard input if the path is `-`.
pub(crate) fn read(path: &Path) -> Result<Source, SourceError> {
    let read = if is_stdin(path) { read_stream(io::stdin().lock()) } else { read_file(path) };
    let path = path.to_owned();
    match read {
        Ok(bytes) if Pack::is_archive(&bytes) => match Pack::read(bytes) {
            Ok(pack) => Ok(Source { path, from: From::Pack(pack) }),
            Err(source) => Err(SourceError::Pack { path, source }),
        },
        Ok(bytes) => Ok(Source { path, from: From::Scene(bytes) }),
        Err(source) => Err(SourceError::Io { path, source }),
    }
}

impl Source {
    /// The scene as it was in its file.
    pub(crate) fn bytes(&self) -> &[u8] {
        match &self.from {
            From::Scene(bytes) => bytes,
            From::Pack(pack) => pack.scene().1,
        }
    }

    /// The scene's text. Remarks in it may have any encoding: what is no UTF-8 is replaced.
    pub(crate) fn text(&self) -> Cow<'_, str> {
        String::from_utf8_lossy(self.bytes())
    }

    /// The name of the scene in messages about its text.
    pub(crate) fn name(&self) -> String {
        match &self.from {
            From::Scene(_) => name(&self.path),
            From::Pack(pack) => name(&self.path.join(pack.scene().0)),
        }
    }

    /// Where the meshes are that it names.
    pub(crate) fn files(&self) -> MeshFiles<'_> {
        match &self.from {
            From::Scene(_) => MeshFiles::Folder(folder_of(&self.path)),
            From::Pack(pack) => MeshFiles::Pack(pack, &self.path),
        }
    }

    /// What the scene and these files are called in the pack that they are from, if they are from one.
    pub(crate) fn located(&self, names: &[&str]) -> Option<Located> {
        let From::Pack(pack) = &self.from else { return None };
        let files: Option<Vec<String>> = names.iter().map(|name| pack.member(name)).collect();
        Some(Located { scene: pack.scene().0.to_owned(), files: files? })
    }

    /// The contents of a file that the scene names.
    pub(crate) fn file(&self, name: &str) -> io::Result<Cow<'_, [u8]>> {
        match &self.from {
            From::Scene(_) => read_file(&folder_of(&self.path).join(name)).map(Cow::Owned),
            From::Pack(pack) => {
                pack.file(name).map(Cow::Borrowed).ok_or_else(|| io::ErrorKind::NotFound.into())
            }
        }
    }
}

/// Whether a path means standard input.
pub(crate) fn is_stdin(path: &Path) -> bool {
    path == Path::new("-")
}

/// The name of a file in messages.
pub(crate) fn name(path: &Path) -> String {
    if is_stdin(path) { "standard input".to_owned() } else { path.display().to_string() }
}

/// The same, between backquotes if it was typed.
pub(crate) fn quoted(path: &Path) -> String {
    if is_stdin(path) { name(path) } else { format!("`{}`", name(path)) }
}

/// The folder that the scene's mesh paths are relative to: the working folder for a scene from
/// standard input.
pub(crate) fn folder_of(path: &Path) -> &Path {
    path.parent().unwrap_or(Path::new(""))
}
