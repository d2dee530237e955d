//! What a path leads to: standard output, a stream, or a file to be made or replaced.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::error::OutputError;

/// What a path leads to.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Target {
    /// Standard output: `-`, or the system's names for it.
    Stdout,
    /// A pipe, a device, or an open file of this process: written to, never replaced.
    Stream,
    /// A regular file, which may not exist yet, behind all symbolic links. Its folder exists.
    File(PathBuf),
}

/// So many links are followed, as in the kernel; more are taken for a circle.
const MOST_LINKS: usize = 40;

/// Finds out where a path leads. `./-` is a file named `-`.
pub(super) fn resolve(path: &Path) -> Result<Target, OutputError> {
    if path == Path::new("-") {
        return Ok(Target::Stdout);
    }
    let end = follow_links(path).map_err(|error| OutputError::io(path, error))?;
    if is_standard_output(&end) {
        return Ok(Target::Stdout);
    }
    if is_descriptor(&end) {
        return Ok(Target::Stream);
    }
    match fs::metadata(&end) {
        Ok(metadata) if metadata.is_dir() => Err(OutputError::IsFolder { path: path.to_owned() }),
        Ok(metadata) if metadata.is_file() => Ok(Target::File(end)),
        Ok(_) => Ok(Target::Stream),
        Err(error) if error.kind() == io::ErrorKind::NotFound => new_file(path, end),
        Err(error) => Err(OutputError::io(path, error)),
    }
}

/// The folder that a file's path names; the working folder where it names none.
pub(super) fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// A file that does not exist yet needs a folder that does, and a name.
fn new_file(typed: &Path, end: PathBuf) -> Result<Target, OutputError> {
    let folder = folder_of(&end);
    if !folder.is_dir() {
        return Err(OutputError::NoFolder { path: typed.to_owned(), folder: folder.to_owned() });
    }
    let last = end.as_os_str().as_encoded_bytes().last().copied().map(char::from);
    if last.is_some_and(std::path::is_separator) || end.file_name().is_none() {
        return Err(OutputError::IsFolder { path: typed.to_owned() });
    }
    Ok(Target::File(end))
}

/// Follows symbolic links one by one, because the last one may lead to a file that does not exist yet.
/// Stops at the system's names of open files, because the files behind them must not be replaced.
fn follow_links(path: &Path) -> io::Result<PathBuf> {
    let mut path = path.to_owned();
    for _ in 0..MOST_LINKS {
        if is_standard_output(&path) || is_descriptor(&path) {
            return Ok(path);
        }
        match fs::read_link(&path) {
            Ok(target) => path = folder_of(&path).join(target),
            Err(_) => return Ok(path),
        }
    }
    Err(io::Error::other("too many levels of symbolic links"))
}

/// The system's names for standard output.
fn is_standard_output(path: &Path) -> bool {
    let names = ["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"];
    cfg!(unix) && names.iter().any(|name| path == Path::new(name))
}

/// The system's names for open files: `/dev/fd/63`, as a shell's `>(…)` makes, and the like.
fn is_descriptor(path: &Path) -> bool {
    let folder = path.parent().unwrap_or(Path::new(""));
    let of_process = folder.starts_with("/proc") && folder.ends_with("fd");
    cfg!(unix) && (path == Path::new("/dev/stderr") || folder == Path::new("/dev/fd") || of_process)
}
