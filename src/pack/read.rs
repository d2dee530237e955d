//! Bytes → a pack, each file checked against its hash.

use std::io::Cursor;

use sha2::{Digest, Sha256};
use tar::{Archive, Entry};

use super::{File, Pack, PackError, SUMS};
use crate::sealed::hexadecimal;

/// Where a tar archive of POSIX has its own magic word, and what that is.
const USTAR: (usize, &[u8]) = (257, b"ustar");

impl Pack {
    /// Whether bytes look like a tar archive.
    #[must_use]
    pub fn is_archive(bytes: &[u8]) -> bool {
        bytes.get(USTAR.0..).is_some_and(|rest| rest.starts_with(USTAR.1))
    }

    /// Reads a pack: its files in the order of the list, each with the hash that the list has, and nothing else.
    ///
    /// # Errors
    /// If the bytes are no such archive.
    pub fn read(bytes: Vec<u8>) -> Result<Self, PackError> {
        if !Self::is_archive(&bytes) {
            return Err(PackError::NoSums);
        }
        let files = files(&bytes)?;
        Ok(Self { bytes, files })
    }
}

fn files(bytes: &[u8]) -> Result<Vec<File>, PackError> {
    let mut archive = Archive::new(Cursor::new(bytes));
    let mut members = archive.entries()?.raw(true);
    let sums = match members.next() {
        Some(member) => member_of(bytes, &member?)?,
        None => return Err(PackError::NoSums),
    };
    if sums.name != SUMS {
        return Err(PackError::NoSums);
    }
    let listed = listed(&bytes[sums.range])?;
    let mut files: Vec<File> = Vec::with_capacity(listed.len());
    let mut expected = listed.iter();
    for member in members {
        let file = member_of(bytes, &member?)?;
        match expected.next() {
            Some((stated, name)) if *name == file.name => {
                let found = hexadecimal(&Sha256::digest(&bytes[file.range.clone()]));
                if found != *stated {
                    let (name, stated) = (file.name, (*stated).to_owned());
                    return Err(PackError::Altered { name, found, stated });
                }
                files.push(file);
            }
            _ => return Err(PackError::Unexpected(file.name)),
        }
    }
    match expected.next() {
        Some((_, name)) => Err(PackError::Missing((*name).to_owned())),
        None => Ok(files),
    }
}

/// The hashes and names of a list, of which there is at least one.
fn listed(sums: &[u8]) -> Result<Vec<(&str, &str)>, PackError> {
    let mut listed = Vec::new();
    for (line, number) in sums.split(|&byte| byte == b'\n').zip(1..) {
        if line.is_empty() {
            continue;
        }
        let line = std::str::from_utf8(line).map_err(|_| PackError::Sums(number))?;
        let (hash, name) = line.split_once("  ").ok_or(PackError::Sums(number))?;
        if hash.len() != 64 || name.is_empty() || listed.iter().any(|(_, other)| *other == name) {
            return Err(PackError::Sums(number));
        }
        listed.push((hash, name));
    }
    if listed.is_empty() { Err(PackError::NoScene) } else { Ok(listed) }
}

/// The name of a plain file, and where its contents are.
fn member_of(bytes: &[u8], member: &Entry<'_, Cursor<&[u8]>>) -> Result<File, PackError> {
    let name = String::from_utf8_lossy(&member.path_bytes()).into_owned();
    let header = member.header();
    if !header.entry_type().is_file() {
        return Err(PackError::NotPlain(name));
    }
    let start = usize::try_from(member.raw_file_position()).ok();
    let size = usize::try_from(header.entry_size()?).ok();
    let end = start.zip(size).and_then(|(start, size)| start.checked_add(size));
    match start.zip(end).filter(|&(_, end)| end <= bytes.len()) {
        Some((start, end)) => Ok(File { name, range: start..end }),
        None => Err(PackError::Missing(name)),
    }
}
