//! Why bytes are no built scene.

use super::Program;
use crate::accel::LoadError;
use crate::sealed::hexadecimal;

/// Why there is no built scene, in words that follow its name.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum BuiltFileError {
    /// They do not begin as one does.
    #[error("it is not a built scene")]
    NotBuilt,
    /// They are of another version of the form.
    #[error(
        "it has version {version} of the form, and only {} can be read: build it again",
        super::VERSION
    )]
    Version {
        /// Which.
        version: u32,
    },
    /// Another program wrote it: its meshes and its hits may be others.
    #[error(
        "it was built by another version of srt, {}, and this is {}: build it again",
        name(of),
        name(this)
    )]
    OtherProgram {
        /// By which.
        of: Box<Program>,
        /// This one.
        this: Box<Program>,
    },
    /// It ends within a part of it.
    #[error("it is cut off in {part}")]
    Truncated {
        /// In which.
        part: String,
    },
    /// A part was altered.
    #[error("{part} in it was altered: the checksum of {what} is wrong")]
    Altered {
        /// Which.
        part: String,
        /// Of what in it.
        what: &'static str,
    },
    /// A part is not what it should be, or cannot be read.
    #[error("{part} in it is wrong: {what}")]
    Wrong {
        /// Which.
        part: String,
        /// In which way.
        what: String,
    },
    /// Something follows its end.
    #[error("it is longer than it should be: it was altered, or something was put behind it")]
    Longer,
}

impl BuiltFileError {
    /// What is wrong with a part.
    #[must_use]
    pub fn part(part: impl Into<String>, source: LoadError) -> Self {
        let part = part.into();
        match source {
            LoadError::Truncated => Self::Truncated { part },
            LoadError::Damaged { what } => Self::Altered { part, what },
            LoadError::Invalid { what } => Self::Wrong { part, what },
            LoadError::Unreadable(error) => Self::Wrong { part, what: error.to_string() },
            other => Self::Wrong { part, what: other.to_string() },
        }
    }
}

/// A program's version and the beginning of its sources' hash.
fn name(program: &Program) -> String {
    let Program { version, sources } = program;
    format!("{} of sources {}…", version.escape_debug(), hexadecimal(&sources[..4]))
}
