//! The first line, which marks the text as a scene.

use super::commands;
use super::diagnostic::{Diagnostic, quoted};
use super::lexer;
use super::text::{TextLine, line_column, lines};

/// What the first line of a scene starts with.
const MAGIC: &str = "sce1.0";

/// The first line, checked.
pub(super) struct Header {
    /// What is wrong with it.
    pub(super) diagnostic: Option<Diagnostic>,
    /// How the text is to be read.
    pub(super) first_line: FirstLine,
}

/// What the first line shows about the text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum FirstLine {
    /// It is right: a scene follows.
    Right,
    /// It is missing: the text is a scene from its first line on.
    Missing,
    /// It is wrong, and a scene follows all the same.
    Wrong,
    /// The text is no scene; errors in its lines would be of no use.
    NoScene,
}

/// Checks the first line. A byte order mark and white space before it are allowed.
pub(super) fn check(source: &str) -> Header {
    let first = first_line(source);
    let Some(behind) = first.text.strip_prefix(MAGIC) else { return wrong(source, first) };
    let start = first.start + MAGIC.len();
    let ignored = lexer::values(TextLine { text: behind, start });
    let diagnostic = ignored.first().zip(ignored.last()).map(|(from, to)| {
        Diagnostic::warning(from.start..to.end(), "what follows `sce1.0` on its line is not read")
            .with_help("write commands on lines of their own, and comments behind `#` or `//`")
    });
    Header { diagnostic, first_line: FirstLine::Right }
}

/// Whether a line is what the first one should be.
pub(super) fn begins_scene(line: TextLine<'_>) -> bool {
    line.text.trim_start().starts_with(MAGIC)
}

fn first_line(source: &str) -> TextLine<'_> {
    let line = lines(source).next().unwrap_or(TextLine { text: "", start: 0 });
    let text = line.text.trim_start_matches(|c: char| c == '\u{feff}' || c.is_whitespace());
    TextLine { text, start: line.text.len() - text.len() }
}

fn wrong(source: &str, first: TextLine<'_>) -> Header {
    let keyword = lexer::keyword(first).map(|(keyword, _)| keyword);
    let span = keyword.map_or(first.start..first.start, |k| k.span());
    let other_version = keyword.filter(|k| is_version(k.text));
    let is_missing = keyword.is_none_or(|k| commands::is_keyword(k.text));
    let error = match (other_version, keyword) {
        (Some(found), _) => {
            Diagnostic::error(span, format!("the scene format {} is unknown", quoted(found.text)))
                .with_label("must be `sce1.0`")
        }
        (None, Some(_)) => Diagnostic::error(span, "the first line must start with `sce1.0`")
            .with_label("found this instead"),
        (None, None) => Diagnostic::error(span, "the first line must start with `sce1.0`"),
    };
    let found = match (is_scene(source), is_missing) {
        (true, true) => FirstLine::Missing,
        (true, false) => FirstLine::Wrong,
        (false, _) => FirstLine::NoScene,
    };
    Header { diagnostic: Some(error.with_help(help(source, found))), first_line: found }
}

fn help(source: &str, found: FirstLine) -> String {
    let later = lines(source).skip(1).find(|line| begins_scene(*line));
    match (later, found) {
        (Some(line), _) => {
            let (number, _) = line_column(source, line.start);
            format!("`sce1.0` is on line {number}: make it the first line")
        }
        (None, FirstLine::NoScene) => "this does not look like a scene file".to_owned(),
        (None, FirstLine::Missing) => "add a line `sce1.0` before this one".to_owned(),
        (None, _) => "write `sce1.0` in the first line".to_owned(),
    }
}

/// Whether a word is of the form of [`MAGIC`]: `sce2.0`, `SCE1`.
fn is_version(word: &str) -> bool {
    word.to_lowercase()
        .strip_prefix("sce")
        .is_some_and(|digits| digits.starts_with(|c: char| c.is_ascii_digit()))
}

/// Whether a text without a proper first line is a scene nevertheless: it has a command of the camera.
fn is_scene(source: &str) -> bool {
    lines(source)
        .filter_map(lexer::keyword)
        .any(|(keyword, _)| commands::camera::is_keyword(keyword.text))
}
