//! The first line, which says that the text is a scene.

use super::command::Group;
use super::diagnostic::{Diagnostic, quoted};
use super::lexer;
use super::table;
use super::text::{Line, line_column, lines};

/// What the first line of a scene starts with.
const MAGIC: &str = "sce1.0";

/// What the first line tells.
pub(super) struct Header {
    /// What is wrong with it.
    pub(super) diagnostic: Option<Diagnostic>,
    /// What to do with the rest.
    pub(super) verdict: Verdict,
}

/// What the first line says of the rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Verdict {
    /// A scene follows.
    Read,
    /// The text is a scene, but for its first line: the first line is one of the rest.
    Missing,
    /// The first line is wrong, and the rest is a scene all the same.
    Wrong,
    /// The rest would only make nonsense of errors.
    NoScene,
}

/// Looks at the first line. A byte order mark and white space before it are let pass.
pub(super) fn check(source: &str) -> Header {
    let first = first_line(source);
    let Some(behind) = first.text.strip_prefix(MAGIC) else { return wrong(source, first) };
    let start = first.start + MAGIC.len();
    let ignored = lexer::values(Line { text: behind, start });
    let diagnostic = ignored.first().zip(ignored.last()).map(|(from, to)| {
        Diagnostic::warning(from.start..to.end(), "what follows `sce1.0` on its line is not read")
            .with_help("write commands on lines of their own, and remarks behind `#` or `//`")
    });
    Header { diagnostic, verdict: Verdict::Read }
}

/// Whether a line is what the first one should be.
pub(super) fn begins_scene(line: Line<'_>) -> bool {
    line.text.trim_start().starts_with(MAGIC)
}

fn first_line(source: &str) -> Line<'_> {
    let line = lines(source).next().unwrap_or(Line { text: "", start: 0 });
    let text = line.text.trim_start_matches(|c: char| c == '\u{feff}' || c.is_whitespace());
    Line { text, start: line.text.len() - text.len() }
}

fn wrong(source: &str, first: Line<'_>) -> Header {
    let keyword = lexer::keyword(first).map(|(keyword, _)| keyword);
    let span = keyword.map_or(first.start..first.start, |k| k.span());
    let other_version = keyword.filter(|k| is_version(k.text));
    let is_missing = keyword.is_none_or(|k| table::find(k.text).is_some());
    let error = match (other_version, keyword) {
        (Some(found), _) => {
            Diagnostic::error(span, format!("the scene format {} is unknown", quoted(found.text)))
                .with_label("must be `sce1.0`")
        }
        (None, Some(_)) => Diagnostic::error(span, "the first line must start with `sce1.0`")
            .with_label("found this instead"),
        (None, None) => Diagnostic::error(span, "the first line must start with `sce1.0`"),
    };
    let verdict = match (is_scene(source), is_missing) {
        (true, true) => Verdict::Missing,
        (true, false) => Verdict::Wrong,
        (false, _) => Verdict::NoScene,
    };
    Header { diagnostic: Some(error.with_help(help(source, verdict))), verdict }
}

fn help(source: &str, verdict: Verdict) -> String {
    let later = lines(source).skip(1).find(|line| begins_scene(*line));
    match (later, verdict) {
        (Some(line), _) => {
            let (number, _) = line_column(source, line.start);
            format!("`sce1.0` stands in line {number}: make it the first")
        }
        (None, Verdict::NoScene) => "this does not look like a scene file".to_owned(),
        (None, Verdict::Missing) => "add a line `sce1.0` before this one".to_owned(),
        (None, _) => "write `sce1.0` into the first line".to_owned(),
    }
}

/// Whether a word is of the form of [`MAGIC`]: `sce2.0`, `SCE1`.
fn is_version(word: &str) -> bool {
    word.to_lowercase()
        .strip_prefix("sce")
        .is_some_and(|digits| digits.starts_with(|c: char| c.is_ascii_digit()))
}

/// Whether a text without a proper first line is a scene nevertheless: it speaks of a camera.
fn is_scene(source: &str) -> bool {
    lines(source).filter_map(lexer::keyword).any(|(keyword, _)| {
        table::find(keyword.text).is_some_and(|command| command.group == Group::Camera)
    })
}
