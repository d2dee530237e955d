//! A place that a result is written to, and how that is done for each kind of place.

use std::fs::{File, OpenOptions};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use super::error::OutputError;
use super::replace;
use super::target::{self, Target};

/// A place that was checked and can be written to.
#[derive(Debug)]
pub(crate) struct Output {
    /// As it was typed, for messages.
    name: PathBuf,
    sink: Sink,
}

/// What takes the bytes.
#[derive(Debug)]
enum Sink {
    Stdout,
    Stream(File),
    File(PathBuf),
}

impl Output {
    /// Standard output, which needs no check.
    pub(crate) fn stdout() -> Self {
        Self { name: PathBuf::from("-"), sink: Sink::Stdout }
    }

    /// Checks a path, and opens it if it is a pipe or device. `-` is standard output.
    ///
    /// If nobody reads a pipe yet, this waits for its reader.
    pub(crate) fn prepare(path: &Path) -> Result<Self, OutputError> {
        let sink = match target::resolve(path)? {
            Target::Stdout => Sink::Stdout,
            Target::Stream => Sink::Stream(open_stream(path)?),
            Target::File(target) => {
                replace::check(&target).map_err(|error| OutputError::io(path, error))?;
                Sink::File(target)
            }
        };
        Ok(Self { name: path.to_owned(), sink })
    }

    /// Whether the bytes go to standard output.
    pub(crate) fn is_stdout(&self) -> bool {
        matches!(self.sink, Sink::Stdout)
    }

    /// The regular file that will be made or replaced, if it is one; behind symbolic links.
    pub(crate) fn file(&self) -> Option<&Path> {
        match &self.sink {
            Sink::File(path) => Some(path),
            Sink::Stdout | Sink::Stream(_) => None,
        }
    }

    /// Writes what `body` writes, and closes a pipe. If that fails, a file is as it was before.
    pub(crate) fn write(
        self,
        body: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    ) -> Result<(), OutputError> {
        self.write_once_more(body)
    }

    /// The same, and there may be more: a file is written anew as a whole each time, a pipe gets one after the other.
    pub(crate) fn write_once_more(
        &self,
        body: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    ) -> Result<(), OutputError> {
        let written = match &self.sink {
            Sink::Stdout => buffered(io::stdout().lock(), body),
            Sink::Stream(file) => buffered(file, body),
            Sink::File(path) => replace::replace(path, |file| buffered(file, body)),
        };
        written.map_err(|error| OutputError::io(&self.name, error))
    }
}

/// Prints text on standard output.
pub(crate) fn print(text: &str) -> Result<(), OutputError> {
    Output::stdout().write(|to| to.write_all(text.as_bytes()))
}

fn open_stream(path: &Path) -> Result<File, OutputError> {
    OpenOptions::new().write(true).open(path).map_err(|error| OutputError::io(path, error))
}

fn buffered(to: impl Write, body: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
    let mut writer = BufWriter::with_capacity(1 << 16, to);
    body(&mut writer)?;
    writer.flush()
}
