//! Why bytes are no rays.

use thiserror::Error;

use crate::math::RayError;

/// Why bytes cannot be read as a file of rays.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum RayFileError {
    /// It does not begin as such a file does.
    #[error(
        "it does not begin with `srt-rays`: it is no file of rays that `srt compare --save-rays` or \
         `srt rays import` wrote"
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
    /// A word of its header is not what version 1 has there.
    #[error("bytes {at} to {} have {found}, where version 1 of the form has {expected}", at + 3)]
    Header {
        /// Where the word is.
        at: usize,
        /// What is there.
        found: u32,
        /// What version 1 has.
        expected: u32,
    },
    /// A class, a query or a field without a meaning has a number that is not known.
    #[error("class {number} of its table has an unknown {what}: {found}")]
    Unknown {
        /// The place in the table, from 1.
        number: usize,
        /// What it is.
        what: &'static str,
        /// What the file has.
        found: u64,
    },
    /// A class is there twice.
    #[error("its table has the class `{class}` twice")]
    Twice {
        /// The class.
        class: &'static str,
    },
    /// A ray is out of the range of rays.
    #[error("{class} ray {index} cannot be traced: {error}")]
    Ray {
        /// The class.
        class: &'static str,
        /// The ray's place in it, from 0.
        index: usize,
        /// What is wrong.
        error: RayError,
    },
    /// An answer is none that a ray can have.
    #[error("the answer of {class} ray {index} is impossible: {why}")]
    Answer {
        /// The class.
        class: &'static str,
        /// The ray's place in it, from 0.
        index: usize,
        /// What is wrong.
        why: &'static str,
    },
}
