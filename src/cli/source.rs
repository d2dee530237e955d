//! The text of a scene.

use std::io;
use std::path::{Path, PathBuf};

use crate::assets::{read_file, read_stream};

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
}

/// Whether a path means standard input.
pub(crate) fn is_stdin(path: &Path) -> bool {
    path == Path::new("-")
}

/// The name of a scene in messages.
pub(crate) fn name(path: &Path) -> String {
    if is_stdin(path) { "standard input".to_owned() } else { path.display().to_string() }
}

/// The same, between backquotes if it was typed.
pub(crate) fn quoted(path: &Path) -> String {
    if is_stdin(path) { name(path) } else { format!("`{}`", name(path)) }
}

/// Reads a scene's text from its file, or from standard input if the path is `-`. Remarks in it may
/// have any encoding: what is no UTF-8 is replaced.
pub(crate) fn read(path: &Path) -> Result<String, SourceError> {
    let read = if is_stdin(path) { read_stream(io::stdin().lock()) } else { read_file(path) };
    match read {
        Ok(bytes) => Ok(String::from_utf8_lossy(&bytes).into_owned()),
        Err(source) => Err(SourceError::Io { path: path.to_owned(), source }),
    }
}
