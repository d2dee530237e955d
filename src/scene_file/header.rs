//! The first line, which says that the text is a scene.

use super::diagnostic::{Diagnostic, quoted};
use super::lexer;
use super::suggest::did_you_mean;
use super::table;
use super::text::{Line, line_column, lines};

/// What the first line of a scene starts with.
const MAGIC: &str = "sce1.0";

/// What the first line tells.
pub(super) struct Header {
    /// What is wrong with it.
    pub(super) diagnostic: Option<Diagnostic>,
    /// Whether the rest is worth reading: a scene that lacks its first line is one nevertheless.
    pub(super) is_scene: bool,
    /// How many lines it takes.
    pub(super) lines: usize,
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
    Header { diagnostic, is_scene: true, lines: 1 }
}

fn first_line(source: &str) -> Line<'_> {
    let line = lines(source).next().unwrap_or(Line { text: "", start: 0 });
    let text = line.text.trim_start_matches(|c: char| c == '\u{feff}' || c.is_whitespace());
    Line { text, start: line.text.len() - text.len() }
}

fn wrong(source: &str, first: Line<'_>) -> Header {
    let word = lexer::values(first).first().copied();
    let span = word.map_or(first.start..first.start, |w| w.span());
    let keyword = lexer::keyword(first).map(|(keyword, _)| keyword.text);
    let is_command = keyword.is_some_and(|k| table::find(k).is_some());
    let other_version = keyword.filter(|k| k.to_lowercase().starts_with("sce"));
    let message = match other_version {
        Some(found) => format!("{} is not a scene format that is known here", quoted(found)),
        None => "the first line must start with `sce1.0`".to_owned(),
    };
    let error = Diagnostic::error(span, message).with_help(help(source));
    let error = match word {
        Some(_) if other_version.is_none() => error.with_label("found this instead"),
        _ => error,
    };
    let is_scene = is_command
        || keyword.is_none_or(|k| did_you_mean(k).is_some())
        || other_version.is_some()
        || later_magic(source).is_some();
    Header { diagnostic: Some(error), is_scene, lines: usize::from(!is_command) }
}

fn help(source: &str) -> String {
    match later_magic(source) {
        Some(line) => format!("`sce1.0` stands in line {line}: make it the first"),
        None => "write `sce1.0` into the first line".to_owned(),
    }
}

/// The number of a later line that is the first one's proper text.
fn later_magic(source: &str) -> Option<usize> {
    let found = lines(source).skip(1).find(|line| line.text.trim_start().starts_with(MAGIC))?;
    Some(line_column(source, found.start).0)
}
