//! Folders that results are written into.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::error::OutputError;

/// Makes a folder and those that it lies in, unless they exist.
pub(crate) fn make_folder(path: &Path) -> Result<(), OutputError> {
    fs::create_dir_all(path).map_err(|error| no_folder(path, error))
}

/// Makes a new folder of this name within `parent`, with a number behind it if there is one already.
///
/// Making it is what claims the name: of commands that run at the same time, each gets its own.
pub(crate) fn claim_folder(parent: &Path, name: &str) -> Result<PathBuf, OutputError> {
    make_folder(parent)?;
    let mut path = parent.join(name);
    let mut number = 1u64;
    loop {
        match fs::create_dir(&path) {
            Ok(()) => return Ok(path),
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
                number += 1;
                path.set_file_name(format!("{name}-{number}"));
            }
            Err(error) => return Err(no_folder(&path, error)),
        }
    }
}

fn no_folder(path: &Path, source: io::Error) -> OutputError {
    OutputError::MakeFolder { path: path.to_owned(), source }
}
