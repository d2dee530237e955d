//! Why a result cannot be written.

use std::io;
use std::path::{Path, PathBuf};

use crate::cli::exit::Failure;
use crate::cli::pending::Format;

/// Why a result cannot be written.
#[derive(Debug, thiserror::Error)]
pub(crate) enum OutputError {
    /// The folder of a file to be does not exist.
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
    /// The extension is that of no format.
    #[error(
        "cannot write `{}`: {}; known formats are {}; give one of these extensions or --format",
        path.display(),
        extension(path),
        known_formats()
    )]
    UnknownFormat {
        /// As typed.
        path: PathBuf,
    },
    /// A picture would be printed on the screen as text.
    #[error(
        "a picture does not print well on a terminal: redirect standard output, or name a file"
    )]
    Terminal,
    /// The reader of a pipe went away.
    #[error("the reader went away")]
    BrokenPipe,
    /// What the system says.
    #[error("cannot write `{}`: {source}", path.display())]
    Io {
        /// As typed.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
}

impl OutputError {
    /// What the system said about a path, as typed.
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

/// What is wrong with a path's extension.
fn extension(path: &Path) -> String {
    match path.extension() {
        Some(extension) => {
            format!("no picture format has the extension `.{}`", extension.display())
        }
        None => "it has no extension that would tell the format".to_owned(),
    }
}

/// `.tga, .png and .ppm`, all of them.
fn known_formats() -> String {
    let names: Vec<String> = Format::ALL.iter().map(|f| format!(".{}", f.name())).collect();
    match names.split_last() {
        Some((last, rest)) if !rest.is_empty() => format!("{} and {last}", rest.join(", ")),
        _ => names.concat(),
    }
}
