//! Why a result cannot be written.

use std::io;
use std::path::{Path, PathBuf};

use crate::cli::exit::Failure;
use crate::image_io::UnknownFormat;

/// Why a result cannot be written.
#[derive(Debug, thiserror::Error)]
pub(crate) enum OutputError {
    /// The folder of a new file does not exist.
    #[error("cannot write `{}`: there is no folder `{}`", path.display(), folder.display())]
    NoFolder {
        /// As typed.
        path: PathBuf,
        /// What is missing.
        folder: PathBuf,
    },
    /// The path is that of a folder.
    #[error("cannot write `{}`: it is a folder; name a file in it", path.display())]
    IsFolder {
        /// As typed.
        path: PathBuf,
    },
    /// A folder for results cannot be made.
    #[error("cannot make the folder `{}`: {source}", path.display())]
    MakeFolder {
        /// As typed.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// The extension is that of no format.
    #[error("cannot write `{}`: {source}", path.display())]
    UnknownFormat {
        /// As typed.
        path: PathBuf,
        /// What is wrong with it, and which are known.
        source: UnknownFormat,
    },
    /// A picture would be printed on the screen as text.
    #[error(
        "a picture does not print well on a terminal: redirect standard output, or name a file"
    )]
    Terminal,
    /// The reader of a pipe closed it.
    #[error("the reader closed the pipe")]
    BrokenPipe,
    /// The system's error.
    #[error("cannot write {}: {source}", named(path))]
    Io {
        /// As typed.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
}

/// A path as it was typed; `-` is what it stands for.
fn named(path: &Path) -> String {
    match path.to_str() {
        Some("-") => "standard output".to_owned(),
        _ => format!("`{}`", path.display()),
    }
}

impl OutputError {
    /// The system's error about a path, as typed.
    pub(super) fn io(path: &Path, source: io::Error) -> Self {
        match source.kind() {
            io::ErrorKind::BrokenPipe => Self::BrokenPipe,
            _ => Self::Io { path: path.to_owned(), source },
        }
    }
}

impl From<OutputError> for Failure {
    fn from(error: OutputError) -> Self {
        match error {
            OutputError::BrokenPipe => Self::BrokenPipe,
            _ => Self::new(error),
        }
    }
}
