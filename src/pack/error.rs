//! What is wrong with a pack.

use thiserror::Error;

/// Why bytes are no pack.
#[derive(Debug, Error)]
pub enum PackError {
    /// No tar archive, or one that ends too early.
    #[error("it is cut off or altered: {0}")]
    Archive(#[from] std::io::Error),
    /// The archive does not begin with the list of hashes.
    #[error("it does not begin with `SHA256SUMS`: it was not made by `srt pack`")]
    NoSums,
    /// A line of the list is not one of `sha256sum`.
    #[error("line {0} of its `SHA256SUMS` is not a hash, two spaces and a name")]
    Sums(usize),
    /// The list has no line.
    #[error("its `SHA256SUMS` names no scene")]
    NoScene,
    /// A file is listed and not there.
    #[error("`{0}` is missing in it: it is cut off or altered")]
    Missing(String),
    /// A member is not listed, or is there twice.
    #[error("it holds `{0}`, which its `SHA256SUMS` does not name at this place")]
    Unexpected(String),
    /// A member is no plain file.
    #[error("`{0}` in it is not a plain file")]
    NotPlain(String),
    /// A file's hash is not the listed one.
    #[error("`{name}` in it was altered: its SHA-256 is {found}, and `SHA256SUMS` says {stated}")]
    Altered {
        /// The file.
        name: String,
        /// The hash of what is there, hexadecimal.
        found: String,
        /// The hash that is listed.
        stated: String,
    },
}
