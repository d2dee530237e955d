//! Why bytes are no parts of a picture.

use thiserror::Error;

use crate::film::FilmError;

/// Why bytes cannot be read as a file of parts.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum PartFileError {
    /// It does not begin as such a file does.
    #[error(
        "it does not begin with `srt-part`: it is no file that `srt part` or `srt --checkpoint` wrote"
    )]
    Magic,
    /// It is of a version that is not read.
    #[error("it has version {found} of the form; this version of srt reads version 1")]
    Version {
        /// The version in the file.
        found: u32,
    },
    /// It ends before its counts say, or goes on after that.
    #[error("it has {found} bytes, and by its own counts {expected}: it was cut off or added to")]
    Length {
        /// Bytes by the counts; the least for a file whose counts are not there.
        expected: u64,
        /// Bytes that there are.
        found: u64,
    },
    /// The hash at its end is not that of the bytes before.
    #[error("its contents have SHA-256 {found}, and it says {stated}: it was altered")]
    Hash {
        /// The hash of what is there, hexadecimal.
        found: String,
        /// The hash at the end, hexadecimal.
        stated: String,
    },
    /// A field of its header has a value that version 1 has not.
    #[error(
        "byte {at} and those after it, its {what}, have a value that version 1 of the form has not"
    )]
    Header {
        /// Where the field is.
        at: usize,
        /// What it is.
        what: &'static str,
    },
    /// An entry of its table has a number that is not known.
    #[error(
        "entry {number} of its table has an unknown form of values, or reserved bytes that are not 0"
    )]
    Entry {
        /// The place in the table, from 1.
        number: usize,
    },
    /// A part cannot be of its picture.
    #[error("entry {number} of its table: {error}")]
    Part {
        /// The place in the table, from 1.
        number: usize,
        /// What is wrong.
        error: FilmError,
    },
}
