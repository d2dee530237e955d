//! Files of users, read whole: up to a size, so that a device or a pipe without end is an error.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use super::memory::{Bytes, expect_memory};

/// The most bytes of what tells no size beforehand: pipes, devices, standard input.
const MOST_OF_STREAM: u64 = 1_000_000_000;

/// Reads a whole file.
///
/// # Errors
/// Those of the system; if the file does not fit into memory, or a pipe or a device gives more than 1 GB.
pub fn read_file(path: &Path) -> io::Result<Vec<u8>> {
    let file = File::open(path)?;
    let metadata = file.metadata()?;
    if !metadata.is_file() {
        return read_stream(file);
    }
    expect_memory(metadata.len())
        .map_err(|shortage| io::Error::new(io::ErrorKind::OutOfMemory, shortage))?;
    let mut bytes = Vec::new();
    bytes.try_reserve_exact(usize::try_from(metadata.len()).unwrap_or(usize::MAX))?;
    // A file may grow meanwhile, or tell no size, as those of the system do.
    read_at_most(file, &mut bytes, metadata.len().saturating_add(MOST_OF_STREAM))?;
    Ok(bytes)
}

/// Reads what tells no size beforehand, to its end.
///
/// # Errors
/// Those of the system, and if it gives more than 1 GB.
pub fn read_stream(stream: impl Read) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    read_at_most(stream, &mut bytes, MOST_OF_STREAM)?;
    Ok(bytes)
}

fn read_at_most(stream: impl Read, bytes: &mut Vec<u8>, most: u64) -> io::Result<()> {
    let read = stream.take(most.saturating_add(1)).read_to_end(bytes)?;
    if read as u64 > most {
        let message = format!("it does not end within {}, the most that is read", Bytes(most));
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, message));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_does_not_end_is_refused() {
        let mut bytes = Vec::new();
        read_at_most(io::repeat(1).take(5), &mut bytes, 5).unwrap();
        assert_eq!(bytes, [1; 5]);
        let error = read_at_most(io::repeat(1), &mut Vec::new(), 2_000_000).unwrap_err();
        assert_eq!(error.to_string(), "it does not end within 2 MB, the most that is read");
    }

    #[test]
    fn files_without_a_size_are_read() {
        if let Ok(text) = read_file(Path::new("/proc/self/status")) {
            assert!(!text.is_empty());
        }
    }
}
