//! The place and the format of a picture.

use std::io::{self, IsTerminal};
use std::path::Path;

use super::error::OutputError;
use super::target::{Target, resolve};
use super::writer::Output;
use crate::image_io::Format;

/// The format for standard output, pipes and devices if neither extension nor option names one: it
/// needs no seeking, and all common tools read it from a pipe.
const STREAM_FORMAT: Format = Format::Ppm;

/// Checks where a picture shall go and in which format; `format` takes precedence over the extension.
pub(crate) fn prepare_picture(
    path: &Path,
    format: Option<Format>,
) -> Result<(Output, Format), OutputError> {
    // The name is checked before the place: a wrong extension is wrong everywhere, and opening a
    // pipe may wait for its reader.
    let named = format.map_or_else(|| Format::from_path(path), Ok);
    let format = match named {
        Ok(format) => format,
        Err(_) if is_stream(path) => STREAM_FORMAT,
        Err(source) => return Err(OutputError::UnknownFormat { path: path.to_owned(), source }),
    };
    let output = Output::prepare(path)?;
    if output.is_stdout() && io::stdout().is_terminal() {
        return Err(OutputError::Terminal);
    }
    Ok((output, format))
}

/// Whether a path is no regular file, nor would become one. A folder counts as a stream here, because
/// its own error is the better message.
fn is_stream(path: &Path) -> bool {
    match resolve(path) {
        Ok(Target::File(_)) => false,
        Ok(Target::Stdout | Target::Stream) | Err(_) => true,
    }
}
