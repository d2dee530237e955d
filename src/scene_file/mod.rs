//! The `sce1.0` scene format: text → [`SceneDescription`], or everything that is wrong with the text,
//! each error with its place.
//!
//! Touches no files and no terminal: a mesh is a name here, which others resolve, and a diagnostic
//! is data, which [`render_diagnostics`] turns into text.
//!
//! Files import only files after them in this list: `parser` (line after line), `header` and
//! `suggest`, `commands` (the table), `repeat`, `keys` (values by frame), `action` (a row of the
//! table), `builder` (the scene so far), `scopes` and `camera_draft` (parts of it), `values` (of a
//! command), `command`, `lexer`, `diagnostic`, `precision`, `text`. `render` needs only the last ones.
//!
//! # The format
//! The first line starts with `sce1.0`. Then one command a line: a keyword and its values, separated
//! by white space; [`commands`] lists them. `#` and `//` begin comments, `end` or the end of the text
//! ends the scene; what follows `end` is ignored with a warning. Where the format leaves a choice,
//! it is read as follows:
//!
//! * A byte order mark, white space before keywords and any kind of line end are allowed.
//! * A comment may follow a number without a space (`1.5//e`). In a line that names a file it must
//!   begin a word, since `meshes//bunny.obj` and `bunny#2.obj` are names. A name with spaces is put
//!   between double quotes.
//! * All camera commands are required. By default, view rays may take one mirror bounce, one ray goes
//!   through each pixel's centre, and the background is black.
//! * `nx` and `ny` go from 1 to 65535, `max_recursion` from 0 to 1000, `aasample` from 0 to 256;
//!   whole numbers may be written `4.0`.
//! * Numbers must be finite in single precision; what is smaller than its smallest normal number
//!   (1.2e-38) counts as 0 where 0 is not allowed. Colours may be any finite numbers, brighter than
//!   1 or negative, as in the original; reflectances above 1 are warned of.
//! * A `{` or `push_matrix` that is left open, or a closing one too many, is an error; a `}` closes
//!   what was pushed within its braces, with an error, and a `pop_matrix` never reaches out of them.
//! * Keys of one command follow each other directly; comments and empty lines may stand between them.
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

mod action;
mod builder;
mod camera_draft;
mod command;
mod commands;
mod diagnostic;
mod header;
mod keys;
mod lexer;
mod parser;
mod precision;
mod render;
mod repeat;
mod scopes;
mod suggest;
mod text;
mod values;

pub use command::{SceneCommand, Value, ValueKind};
pub use commands::commands;
pub use diagnostic::{Diagnostic, LineElsewhere, Severity};
pub use parser::ParseOptions;
pub use render::{MOST_RENDERED, render_diagnostics, summarize};
pub use text::line_column;

use crate::description::{MeshReference, SceneDescription};

/// A scene, and the warnings about it.
#[derive(Clone, Debug)]
pub struct Parsed {
    /// The scene, in the frame that was asked for.
    pub description: SceneDescription,
    /// The first and the last frame of all keys, as they are written; `None` of a scene that stands still.
    pub keyed_frames: Option<[f64; 2]>,
    /// Warnings, in the order of the text.
    pub warnings: Vec<Diagnostic>,
}

/// A text that is no valid scene: what is wrong with it, and what can be looked into all the same.
#[derive(Clone, Debug)]
pub struct Invalid {
    /// Errors and warnings, in the order of the text.
    pub diagnostics: Vec<Diagnostic>,
    /// The meshes that it names in lines that can be read, each once, in the order of the text: what is
    /// wrong with them can be told at the same time.
    pub meshes: Vec<MeshReference>,
}

/// Reads a scene.
///
/// # Errors
/// Everything that is wrong with it, errors and warnings, in the order of the text.
pub fn parse(source: &str, options: &ParseOptions) -> Result<Parsed, Vec<Diagnostic>> {
    parse_to_meshes(source, options).map_err(|invalid| invalid.diagnostics)
}

/// Reads a scene, or else at least the names of its meshes.
///
/// # Errors
/// Everything that is wrong with it, and the meshes that it names.
pub fn parse_to_meshes(source: &str, options: &ParseOptions) -> Result<Parsed, Invalid> {
    let mut read = parser::read(source, options);
    let diagnostics = match &mut read {
        Ok(parsed) => &mut parsed.warnings,
        Err(invalid) => &mut invalid.diagnostics,
    };
    // Stable: diagnostics of one place stay in the order in which they were found.
    diagnostics.sort_by_key(|d| d.span.start);
    read
}
