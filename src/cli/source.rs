//! The text of a scene file.

use std::fs;
use std::path::{Path, PathBuf};

/// Why a scene's text cannot be had.
#[derive(Debug, thiserror::Error)]
pub(crate) enum SourceError {
    /// What the system says.
    #[error("cannot read the scene `{}`: {source}", path.display())]
    Io {
        /// As typed.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
}

/// Reads a scene's text. Remarks in it may be of any encoding: what is no UTF-8 is replaced.
pub(crate) fn read(path: &Path) -> Result<String, SourceError> {
    match fs::read(path) {
        Ok(bytes) => Ok(String::from_utf8_lossy(&bytes).into_owned()),
        Err(source) => Err(SourceError::Io { path: path.to_owned(), source }),
    }
}
