//! A pack → bytes: the same files give the same bytes, whoever owns them and whenever they were changed.

use std::fmt::Write as _;
use std::io::{self, Write};

use sha2::{Digest, Sha256};
use tar::{Builder, EntryType, Header};

use super::names::resolve;
use super::{Pack, SUMS};
use crate::sealed::hexadecimal;

impl Pack {
    /// Writes an archive of files with their names in it; the first is the scene. Its list of hashes comes first.
    ///
    /// # Errors
    /// If it cannot be written; if a name cannot be in the archive or its list: two files of one name, a name that is
    /// empty, absolute or leads upwards, has control characters, or is too long (100 bytes, or 255 with a `/` in the
    /// right place).
    pub fn write(files: &[(&str, &[u8])], to: &mut dyn Write) -> io::Result<()> {
        let mut sums = String::new();
        for (place, (name, contents)) in files.iter().enumerate() {
            expect_name(name, &files[..place])?;
            let hash = hexadecimal(&Sha256::digest(contents));
            let _ = writeln!(sums, "{hash}  {name}"); // writing to a string cannot fail
        }
        let mut archive = Builder::new(to);
        add(&mut archive, SUMS, sums.as_bytes())?;
        for (name, contents) in files {
            add(&mut archive, name, contents)?;
        }
        archive.into_inner()?.flush()
    }
}

/// Refuses what would not be read again as it was written.
fn expect_name(name: &str, before: &[(&str, &[u8])]) -> io::Result<()> {
    let fault = if name.chars().any(char::is_control) {
        "has control characters"
    } else if name == SUMS || before.iter().any(|(other, _)| *other == name) {
        "is there twice"
    } else if resolve("", name).as_deref() != Some(name) || name.is_empty() {
        "is not a plain path from the root of the pack"
    } else {
        return Ok(());
    };
    Err(invalid(name, fault))
}

fn invalid(name: &str, fault: &str) -> io::Error {
    let name = name.escape_debug();
    io::Error::new(io::ErrorKind::InvalidInput, format!("the name `{name}` {fault}"))
}

fn add(archive: &mut Builder<&mut dyn Write>, name: &str, contents: &[u8]) -> io::Result<()> {
    let mut header = Header::new_ustar();
    header.set_entry_type(EntryType::Regular);
    header.set_path(name).map_err(|_| {
        let fault = "is too long for the archive: 100 bytes, or 255 with a `/` in the right place";
        invalid(name, fault)
    })?;
    header.set_size(contents.len() as u64);
    header.set_mode(0o644);
    header.set_mtime(0);
    header.set_uid(0);
    header.set_gid(0);
    header.set_cksum();
    archive.append(&header, contents)
}
