//! Files that end with a hash of all that is before it: what their readers share.

use std::fmt::Write;

use sha2::{Digest, Sha256};

/// A SHA-256.
pub type Hash = [u8; 32];

/// The hashes of bytes that were altered, hexadecimal.
pub(crate) struct Altered {
    /// That of what is there.
    pub(crate) found: String,
    /// The one at the end.
    pub(crate) stated: String,
}

/// Whether at least as many bytes as a hash has end with that of all before it.
pub(crate) fn check(bytes: &[u8]) -> Result<(), Altered> {
    let (contents, stated) = bytes.split_at(bytes.len() - size_of::<Hash>());
    let found: Hash = Sha256::digest(contents).into();
    if stated == found {
        return Ok(());
    }
    Err(Altered { found: hexadecimal(&found), stated: hexadecimal(stated) })
}

/// The bytes as hexadecimal digits.
pub(crate) fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}"); // writing to a string cannot fail
        text
    })
}

/// A number at a place that is within the bytes.
pub(crate) fn u32_at(bytes: &[u8], at: usize) -> u32 {
    bytes[at..].first_chunk().copied().map_or(0, u32::from_le_bytes)
}

/// The same, of 64 bits.
pub(crate) fn u64_at(bytes: &[u8], at: usize) -> u64 {
    bytes[at..].first_chunk().copied().map_or(0, u64::from_le_bytes)
}
