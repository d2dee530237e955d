//! Why bytes are no saved structure.

use std::io;

use super::VERSION;

/// Why nothing was loaded.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum LoadError {
    /// The bytes cannot be read.
    #[error("a saved structure cannot be read")]
    Unreadable(#[source] io::Error),
    /// They end where more should follow.
    #[error("a saved structure ends too early")]
    Truncated,
    /// They do not begin as a saved structure does.
    #[error("this is not a saved structure")]
    NotSaved,
    /// They are of another version of the format.
    #[error(
        "a saved structure has version {version} of the format, and only {VERSION} can be read"
    )]
    Version {
        /// Which.
        version: u32,
    },
    /// They hold something else.
    #[error("the saved {what} is `{found}`, not `{expected}`")]
    Other {
        /// `structure` or `primitives`.
        what: &'static str,
        /// The name in the bytes.
        found: String,
        /// The name of what was to be loaded.
        expected: &'static str,
    },
    /// The checksum is that of other bytes.
    #[error("a saved structure was damaged: the checksum of its {what} is wrong")]
    Damaged {
        /// Of what: `nodes`, for example.
        what: &'static str,
    },
    /// They describe primitives that cannot be traced, or no structure over them.
    #[error("a saved structure is not valid: {what}")]
    Invalid {
        /// What is wrong.
        what: String,
    },
}

impl LoadError {
    /// For a [`Portable`](super::Portable) that has read something wrong.
    #[must_use]
    pub fn invalid(what: impl Into<String>) -> Self {
        Self::Invalid { what: what.into() }
    }
}

impl From<io::Error> for LoadError {
    fn from(error: io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::UnexpectedEof => Self::Truncated,
            _ => Self::Unreadable(error),
        }
    }
}
