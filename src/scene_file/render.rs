//! Diagnostics → text, as compilers show them: the place, the line with the place marked, what is
//! wrong and what would be right.
//!
//! The text of a scene is not trusted: control characters, which could control a terminal, are shown
//! as replacement characters.

use std::fmt::Write;
use std::ops::Range;

use annotate_snippets::{Annotation, AnnotationKind, Group, Level, Renderer, Snippet};

use super::diagnostic::{Diagnostic, LineElsewhere, Severity, counted};
use super::text::{floor_boundary, line_around};
use crate::description::Span;

/// How many diagnostics are shown; the rest is counted.
pub const MOST_RENDERED: usize = 50;

/// How many characters of a long word, or of a long rest of a line, are marked.
const LONGEST_MARK: usize = 60;

/// The text of some diagnostics about a source; errors first where there are too many for all.
///
/// Spans that do not fit the source are cut to it. Ends with a line end, unless it is empty.
#[must_use]
pub fn render_diagnostics(
    diagnostics: &[Diagnostic],
    source: &str,
    file_name: &str,
    color: bool,
) -> String {
    let renderer = if color { Renderer::styled() } else { Renderer::plain() };
    let file_name = printable(file_name);
    let mut text = String::new();
    for diagnostic in most_important(diagnostics) {
        text += &renderer.render(&[group(diagnostic, source, &file_name)]);
        text += "\n\n";
    }
    let more = diagnostics.len().saturating_sub(MOST_RENDERED);
    if more > 0 {
        let note = format!("and {more} more like these");
        text += &renderer.render(&[Group::with_title(Level::NOTE.secondary_title(note))]);
        text += "\n\n";
    }
    // Between two diagnostics, not after the last.
    text.truncate(text.trim_end().len());
    if !text.is_empty() {
        text.push('\n');
    }
    text
}

/// As many as are shown, in the order given.
fn most_important(diagnostics: &[Diagnostic]) -> Vec<&Diagnostic> {
    let mut indices: Vec<_> = (0..diagnostics.len()).collect();
    indices.sort_by_key(|&i| diagnostics[i].severity);
    indices.truncate(MOST_RENDERED);
    indices.sort_unstable();
    indices.into_iter().map(|i| &diagnostics[i]).collect()
}

fn group<'a>(diagnostic: &Diagnostic, source: &str, file_name: &str) -> Group<'a> {
    let level = match diagnostic.severity {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
    };
    let excerpts = excerpts(diagnostic, source);
    let snippets = excerpts.into_iter().map(|excerpt| {
        Snippet::source(excerpt.text)
            .line_start(excerpt.number)
            .path(file_name.to_owned())
            .annotations(excerpt.marks)
    });
    let group = level
        .primary_title(printable(&diagnostic.message))
        .elements(snippets)
        .elements(diagnostic.elsewhere.as_deref().map(snippet_elsewhere));
    match &diagnostic.help {
        Some(help) => group.element(Level::HELP.message(printable(help))),
        None => group,
    }
}

/// A line of another file, marked.
fn snippet_elsewhere<'a>(line: &LineElsewhere) -> Snippet<'a, Annotation<'a>> {
    let text = printable(&line.text);
    let place = line.marked.as_ref().and_then(|marked| {
        let (before, word) = (line.text.get(..marked.start)?, line.text.get(marked.clone())?);
        let start = printable(before).len();
        Some(
            start
                ..start
                    + printable(word).chars().take(LONGEST_MARK).map(char::len_utf8).sum::<usize>(),
        )
    });
    let mark = AnnotationKind::Primary.span(place.unwrap_or_else(|| marked(&text)));
    Snippet::source(text).line_start(line.line).path(printable(&line.file)).annotation(mark)
}

/// What is marked of a line that is marked as a whole: no white space around it, and no more than
/// a sensible length.
fn marked(text: &str) -> Range<usize> {
    let start = text.len() - text.trim_start().len();
    let length = text.trim().chars().take(LONGEST_MARK).map(char::len_utf8).sum::<usize>();
    start..start + length
}

/// A line of the source, made printable, with its marks.
struct Excerpt<'a> {
    number: usize,
    text: String,
    marks: Vec<Annotation<'a>>,
}

/// The lines that a diagnostic refers to, its own place first, each once.
fn excerpts<'a>(diagnostic: &Diagnostic, source: &str) -> Vec<Excerpt<'a>> {
    let mut excerpts: Vec<Excerpt<'a>> = Vec::new();
    let own = (&diagnostic.span, diagnostic.label.as_deref(), AnnotationKind::Primary);
    let others = diagnostic
        .related
        .iter()
        .map(|(span, label)| (span, Some(label.as_str()), AnnotationKind::Context));
    for (span, label, kind) in std::iter::once(own).chain(others) {
        let (number, text, place) = locate(source, span);
        let mark = kind.span(place).label(label.map(printable));
        match excerpts.iter_mut().find(|e| e.number == number) {
            Some(excerpt) => excerpt.marks.push(mark),
            None => excerpts.push(Excerpt { number, text, marks: vec![mark] }),
        }
    }
    excerpts
}

/// The number and the printable text of the line in which a span begins, and the span within it,
/// cut to the line and to a sensible length.
fn locate(source: &str, span: &Span) -> (usize, String, Range<usize>) {
    let (number, line) = line_around(source, span.start);
    let within = |offset: usize| floor_boundary(line.text, offset.saturating_sub(line.start));
    let (start, end) = (within(span.start), within(span.end.max(span.start)));
    let before = printable(line.text[..start].trim_start_matches('\u{feff}'));
    let marked: String = printable(&line.text[start..end]).chars().take(LONGEST_MARK).collect();
    let place = before.len()..before.len() + marked.len();
    let text = before + &printable(&line.text[start..]);
    (number, text, place)
}

/// The same text, each control character but tabs and line feeds replaced, so that columns stay.
fn printable(text: &str) -> String {
    let shown = |c: char| match c {
        '\t' | '\n' => c,
        c if c.is_control() || is_format_control(c) => char::REPLACEMENT_CHARACTER,
        c => c,
    };
    text.chars().map(shown).collect()
}

/// Characters that change the direction or the joining of text, or that cannot be seen.
fn is_format_control(c: char) -> bool {
    matches!(c, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}')
}

/// `2 errors and 1 warning`, or an empty text for nothing.
#[must_use]
pub fn summarize(diagnostics: &[Diagnostic]) -> String {
    let errors = diagnostics.iter().filter(|d| d.is_error()).count();
    let warnings = diagnostics.len() - errors;
    let mut text = String::new();
    if errors > 0 {
        text += &counted(errors, "error");
    }
    if warnings > 0 {
        let and = if errors > 0 { " and " } else { "" };
        // Writing to a string cannot fail.
        let _ = write!(text, "{and}{}", counted(warnings, "warning"));
    }
    text
}
