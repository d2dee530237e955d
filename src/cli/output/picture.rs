//! The place and the format of a picture.

use std::io::{self, IsTerminal};
use std::path::Path;

use super::{Output, OutputError};
use crate::image_io::Format;

/// What standard output, pipes and devices get where neither extension nor option says otherwise:
/// the format that needs no seeking and that every tool of the trade reads from a pipe.
const STREAM_FORMAT: Format = Format::Ppm;

/// Checks where a picture shall go and in which format; `format` counts more than the extension.
pub(crate) fn prepare_picture(
    path: &Path,
    format: Option<Format>,
) -> Result<(Output, Format), OutputError> {
    // The name is judged before the place: a wrong extension is wrong everywhere, and to open a
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

/// Whether a path is no regular file, nor would become one. A folder counts as one here: that it
/// is a folder is the better message.
fn is_stream(path: &Path) -> bool {
    use super::target::{Target, resolve};
    match resolve(path) {
        Ok(Target::File(_)) => false,
        Ok(Target::Stdout | Target::Stream) | Err(_) => true,
    }
}
