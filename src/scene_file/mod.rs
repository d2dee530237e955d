//! The `sce1.0` scene format: text → [`SceneDescription`], or what is wrong with the text, all of it
//! at once and each with its place.
//!
//! Touches no files and no terminal: a mesh is a name here, which others resolve, and a diagnostic
//! is data, which [`render_diagnostics`] turns into text.
//!
//! # The format
//! The first line starts with `sce1.0`. Then one command a line: a keyword and its values, parted
//! by white space; [`COMMANDS`] is the list of them. `#` and `//` begin remarks, `end` or the end of
//! the text ends the scene; what follows `end` is passed over with a warning. Where the format
//! leaves a choice, this is what is read here:
//!
//! * A byte order mark, white space before keywords and any kind of line end are let pass.
//! * A remark may follow a number without a space (`1.5//e`). In a line that names a file it must
//!   begin a word, since `meshes//bunny.obj` and `bunny#2.obj` are names. A name with spaces stands
//!   between double quotes.
//! * All camera commands are required. Without the options' commands, view rays may take one mirror
//!   bounce, one ray goes through each pixel's centre, and the background is black.
//! * `nx` and `ny` go from 1 to 65535, `max_recursion` from 0 to 1000, `aasample` from 0 to 256;
//!   whole numbers may be written `4.0`.
//! * Numbers must be finite in single precision; what is smaller than its smallest normal number
//!   (1.2e-38) counts as 0 where 0 is not allowed. Colours may be any finite numbers, brighter than
//!   1 or negative, as in the original.
//! * A `{` or `push_matrix` that is left open, or a closing one too many, is an error; a `}` closes
//!   what was pushed within its braces, with an error, and a `pop_matrix` never reaches out of them.
//! * A triangle whose corners lie on one line is left out, with one warning for all of them.
//!
//! ```
//! use srt::scene_file::{ParseOptions, parse, render_diagnostics};
//!
//! let source = "sce1.0\neyepos 0 -5 1\nbal 1 0 0 0\n";
//! let diagnostics = parse(source, &ParseOptions::default()).unwrap_err();
//! assert_eq!(diagnostics[0].message, "unknown command `bal`, did you mean `ball`?");
//! let text = render_diagnostics(&diagnostics, source, "example.sce", false);
//! assert!(text.contains("example.sce:3:1"));
//! ```

mod builder;
mod camera;
mod command;
mod diagnostic;
mod entities;
mod header;
mod lexer;
mod parser;
mod render;
mod repeat;
mod scopes;
mod state;
mod suggest;
mod table;
mod text;
mod values;

pub use command::{Command, Group, Kind, Value};
pub use diagnostic::{Diagnostic, LineElsewhere, Severity};
pub use render::{MOST_RENDERED, render_diagnostics, summarize};
pub use table::COMMANDS;
pub use text::line_column;

use crate::description::SceneDescription;

/// How strictly a scene is read.
#[derive(Clone, Debug, Default)]
pub struct ParseOptions {
    /// Unknown commands are skipped with a warning, as the course's loader did, and are no errors.
    pub lenient: bool,
}

/// A scene, and what its author should know of it.
#[derive(Clone, Debug)]
pub struct Parsed {
    /// The scene.
    pub description: SceneDescription,
    /// Warnings, in the order of the text.
    pub warnings: Vec<Diagnostic>,
}

/// Reads a scene.
///
/// # Errors
/// Everything that is wrong with it, errors and warnings, in the order of the text.
pub fn parse(source: &str, options: &ParseOptions) -> Result<Parsed, Vec<Diagnostic>> {
    let (description, mut diagnostics) = parser::read(source, options);
    // Stable: what is said of one place stays in the order in which it was found.
    diagnostics.sort_by_key(|d| d.span.start);
    match description {
        Some(description) => Ok(Parsed { description, warnings: diagnostics }),
        None => Err(diagnostics),
    }
}
