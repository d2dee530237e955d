//! What is wrong with a scene, and where: plain data, to be shown by the caller.
//!
//! Knows nothing of commands, nor of how or where it is shown; [`render`](super::render) does that.

use crate::description::Span;

/// How bad it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// The scene cannot be used.
    Error,
    /// The scene can be used, but perhaps not as its author meant it.
    Warning,
}

/// One thing that is wrong with a scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// How bad it is.
    pub severity: Severity,
    /// The marked place: bytes of the scene's text, empty where something is missing.
    pub span: Span,
    /// What is wrong, in one line that is complete by itself.
    pub message: String,
    /// A few words at the marked place.
    pub label: Option<Box<str>>,
    /// What would be right.
    pub help: Option<Box<str>>,
    /// Related places, each with a few words: where a brace was opened, for example.
    pub related: Vec<(Span, String)>,
    /// The line of another file that is wrong, where one is. Boxed, since it is rare.
    pub elsewhere: Option<Box<LineElsewhere>>,
}

/// A line of a file that the scene names, such as a mesh.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LineElsewhere {
    /// The file's name, as it is to be shown.
    pub file: String,
    /// The line's number, from 1.
    pub line: usize,
    /// The line itself, without its end.
    pub text: String,
    /// The bytes of it to be marked; without them all of it is.
    pub marked: Option<Span>,
}

impl Diagnostic {
    /// An error at a place.
    #[must_use]
    pub fn error(span: Span, message: impl Into<String>) -> Self {
        Self::new(Severity::Error, span, message.into())
    }

    /// A warning at a place.
    #[must_use]
    pub fn warning(span: Span, message: impl Into<String>) -> Self {
        Self::new(Severity::Warning, span, message.into())
    }

    fn new(severity: Severity, span: Span, message: String) -> Self {
        Self {
            severity,
            span,
            message,
            label: None,
            help: None,
            related: Vec::new(),
            elsewhere: None,
        }
    }

    /// The same with a few words at the marked place.
    #[must_use]
    pub fn with_label(self, label: impl Into<String>) -> Self {
        Self { label: Some(label.into().into_boxed_str()), ..self }
    }

    /// The same with what would be right.
    #[must_use]
    pub fn with_help(self, help: impl Into<String>) -> Self {
        Self { help: Some(help.into().into_boxed_str()), ..self }
    }

    /// The same with one more place.
    #[must_use]
    pub fn with_related(mut self, span: Span, label: impl Into<String>) -> Self {
        self.related.push((span, label.into()));
        self
    }

    /// The same with a line of another file.
    #[must_use]
    pub fn with_elsewhere(self, elsewhere: LineElsewhere) -> Self {
        Self { elsewhere: Some(Box::new(elsewhere)), ..self }
    }

    /// Whether the scene cannot be used.
    #[must_use]
    pub fn is_error(&self) -> bool {
        self.severity == Severity::Error
    }
}

/// A word of the scene between backticks, cut where it would fill the line.
pub(super) fn quoted(word: &str) -> String {
    const LONGEST: usize = 40;
    match word.char_indices().nth(LONGEST) {
        Some((cut, _)) => format!("`{}…`", &word[..cut]),
        None => format!("`{word}`"),
    }
}

/// `1 value`, `2 values`.
pub(super) fn counted(n: usize, noun: &str) -> String {
    format!("{n} {noun}{}", if n == 1 { "" } else { "s" })
}
