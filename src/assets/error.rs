//! Why a mesh that a scene names cannot be loaded.

use std::ops::Range;
use std::path::{Path, PathBuf};

use thiserror::Error;

use super::MemoryShortage;
use super::generate::RecipeError;

/// A mesh that cannot be loaded: which one, why, where in its file, and what would be right.
///
/// Displayed it is only what is wrong; the place and the help are fields, for the caller to format.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("{problem}")]
pub struct AssetError {
    /// Index of the reference among those that were to be loaded.
    pub reference: usize,
    /// What is wrong.
    pub problem: Problem,
    /// The line of the mesh file that is wrong, where one is.
    pub place: Option<FileLine>,
    /// What would be right.
    pub help: Option<String>,
}

/// A line of a mesh file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileLine {
    /// The file.
    pub path: PathBuf,
    /// The line's number, from 1.
    pub line: usize,
    /// The line itself, without its end; cut where it is very long.
    pub text: String,
    /// The bytes of it that are wrong, where it is not the line as a whole.
    pub wrong: Option<Range<usize>>,
}

/// Why there is no mesh.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum Problem {
    /// No such file.
    #[error("there is no mesh file `{}`", path.display())]
    Missing {
        /// Where it was looked for.
        path: PathBuf,
    },
    /// A folder where a file should be.
    #[error("`{}` is a folder, not a mesh file", path.display())]
    Directory {
        /// The folder.
        path: PathBuf,
    },
    /// The operating system does not let the file be read.
    #[error("cannot read the mesh file `{}`: {reason}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// The error of the operating system.
        reason: String,
    },
    /// A mesh in a format that is not read.
    #[error("the mesh file `{}` looks like {format}", path.display())]
    OtherFormat {
        /// The file.
        path: PathBuf,
        /// What it looks like.
        format: &'static str,
    },
    /// Bytes that are not UTF-8 text.
    #[error("the mesh file `{}` is not text", path.display())]
    NotText {
        /// The file.
        path: PathBuf,
    },
    /// A line that is not OBJ, or that is impossible, as an index out of range.
    #[error("malformed mesh file `{}`: {what}", path.display())]
    Malformed {
        /// The file.
        path: PathBuf,
        /// What is wrong with the line.
        what: String,
    },
    /// Nothing to see in the file.
    #[error("the mesh file `{}` {}", path.display(), if *empty { "is empty" } else { "has no faces" })]
    NoFaces {
        /// The file.
        path: PathBuf,
        /// Whether there is nothing in it at all.
        empty: bool,
    },
    /// Nothing left of the file once triangles without area were dropped.
    #[error("no triangle of the mesh file `{}` has an area ({dropped} degenerate)", path.display())]
    OnlyDegenerate {
        /// The file.
        path: PathBuf,
        /// How many there were.
        dropped: usize,
    },
    /// More than there is memory for.
    #[error("the mesh `{name}` is too large: {shortage}")]
    NoMemory {
        /// As the scene names it.
        name: String,
        /// How much it would take, together with the meshes before it.
        shortage: MemoryShortage,
    },
    /// Nothing that can be traced is left once it is deformed.
    #[error(
        "the mesh `{name}` cannot be deformed by {deformation}: it leaves single precision, or no triangle keeps an area"
    )]
    Deformed {
        /// As the scene names it.
        name: String,
        /// As the scene has it.
        deformation: String,
    },
    /// A name that starts with `generate:` and is not that of a generated mesh.
    #[error(transparent)]
    Recipe(#[from] RecipeError),
}

/// An [`AssetError`] without its reference.
#[derive(Clone)]
pub(super) struct LoadFailure {
    pub(super) problem: Problem,
    pub(super) place: Option<FileLine>,
    pub(super) help: Option<String>,
}

impl LoadFailure {
    pub(super) fn new(problem: Problem, help: Option<String>) -> Box<Self> {
        Box::new(Self { problem, place: None, help })
    }

    pub(super) fn too_large(name: String, shortage: MemoryShortage) -> Box<Self> {
        let help = "use a mesh of fewer triangles, or let the program use more memory".to_owned();
        Self::new(Problem::NoMemory { name, shortage }, Some(help))
    }

    pub(super) fn unreadable(path: &Path, error: &std::io::Error) -> Box<Self> {
        let reason = error.to_string();
        Self::new(Problem::Unreadable { path: path.to_owned(), reason }, None)
    }

    pub(super) fn for_reference(self, reference: usize) -> AssetError {
        AssetError { reference, problem: self.problem, place: self.place, help: self.help }
    }
}
