//! A file that is read in large blocks, each by several threads.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;
use std::sync::Arc;

use rayon::prelude::*;

/// What one thread reads at a time.
const BLOCK: usize = 1 << 18;

/// A place in a file. Copies read on from there, each by itself.
#[derive(Clone, Debug)]
pub struct FileReader {
    file: Arc<File>,
    at: u64,
    size: u64,
}

impl FileReader {
    /// Opens a file at its beginning; `None` if it is no regular file.
    ///
    /// # Errors
    /// Those of the system.
    pub fn open(path: &Path) -> io::Result<Option<Self>> {
        let file = File::open(path)?;
        let metadata = file.metadata()?;
        let reader = Self { file: Arc::new(file), at: 0, size: metadata.len() };
        Ok(metadata.is_file().then_some(reader))
    }

    /// How many bytes the file had as it was opened.
    #[must_use]
    pub fn size(&self) -> u64 {
        self.size
    }

    fn read_whole(&self, bytes: &mut [u8], mut at: u64) -> io::Result<()> {
        let mut left = bytes;
        while !left.is_empty() {
            match read_at(&self.file, left, at) {
                Ok(0) => return Err(io::ErrorKind::UnexpectedEof.into()),
                Ok(read) => {
                    at += read as u64;
                    left = &mut left[read..];
                }
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                Err(error) => return Err(error),
            }
        }
        Ok(())
    }
}

impl Read for FileReader {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        let read = read_at(&self.file, bytes, self.at)?;
        self.at += read as u64;
        Ok(read)
    }

    /// Reads on the threads of the current rayon pool.
    fn read_exact(&mut self, bytes: &mut [u8]) -> io::Result<()> {
        let length = bytes.len() as u64;
        let blocks = bytes.par_chunks_mut(BLOCK).enumerate();
        blocks.try_for_each(|(block, bytes)| {
            self.read_whole(bytes, self.at + (block * BLOCK) as u64)
        })?;
        self.at += length;
        Ok(())
    }
}

#[cfg(unix)]
fn read_at(file: &File, bytes: &mut [u8], at: u64) -> io::Result<usize> {
    std::os::unix::fs::FileExt::read_at(file, bytes, at)
}

#[cfg(windows)]
fn read_at(file: &File, bytes: &mut [u8], at: u64) -> io::Result<usize> {
    std::os::windows::fs::FileExt::seek_read(file, bytes, at)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_read_from_where_one_is() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a");
        let bytes: Vec<u8> = (0..3 * BLOCK + 5).map(|i| (i % 251) as u8).collect();
        std::fs::write(&path, &bytes).unwrap();
        assert!(FileReader::open(folder.path()).unwrap().is_none());
        let mut reader = FileReader::open(&path).unwrap().unwrap();
        assert_eq!(reader.size(), bytes.len() as u64);
        let (mut first, mut rest) = ([0; 3], vec![0; bytes.len() - 3]);
        reader.read_exact(&mut first).unwrap();
        let mut copy = reader.clone();
        for reader in [&mut reader, &mut copy] {
            reader.read_exact(&mut rest).unwrap();
            assert!(first[..] == bytes[..3] && rest[..] == bytes[3..]);
            let error = reader.read_exact(&mut first).unwrap_err();
            assert_eq!(error.kind(), io::ErrorKind::UnexpectedEof);
            assert_eq!(reader.read(&mut first).unwrap(), 0);
        }
    }
}
