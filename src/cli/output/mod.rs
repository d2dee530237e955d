//! Where results go: checked before the work, written whole or not at all.
//!
//! A file is written beside its place and renamed into it. A pipe or a device is opened before the
//! work, as a shell's `>` would, and written to; it is never replaced. Of pictures it knows the
//! names of the formats alone.

mod error;
mod folder;
mod picture;
mod replace;
mod target;
mod writer;

pub(crate) use error::OutputError;
pub(crate) use folder::{claim_folder, make_folder};
pub(crate) use picture::prepare_picture;
pub(crate) use replace::abandon_and_exit;
pub(crate) use writer::{Output, print};

#[cfg(test)]
mod tests;
