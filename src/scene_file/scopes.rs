//! What is open: `{` saves material and transform, `push_matrix` the transform alone.
//!
//! Scopes nest. A `}` closes the innermost `{`; a `push_matrix` that is still open within it is an
//! error, and is closed with it. A `pop_matrix` never reaches through a brace. Nothing reaches out of a turn
//! of a `repeat`.

use crate::description::Span;

use super::builder::Builder;
use super::diagnostic::Diagnostic;
use super::state::State;
use super::values::Values;

/// What is open, the innermost last.
#[derive(Default)]
pub(super) struct Scopes(Vec<Scope>);

struct Scope {
    kind: Kind,
    /// The keyword that opened it.
    opened: Span,
    /// What it restores.
    saved: State,
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Brace,
    Matrix,
    /// A turn of a `repeat`: nothing within it closes what is outside.
    Turn,
}

impl Scopes {
    fn innermost_brace(&self) -> Option<usize> {
        let innermost = self.0.iter().rposition(|scope| scope.kind != Kind::Matrix);
        innermost.filter(|&scope| self.0[scope].kind == Kind::Brace)
    }
}

pub(super) fn open_brace(builder: &mut Builder, values: &Values<'_>) {
    open(builder, Kind::Brace, values.keyword.clone());
}

pub(super) fn push_matrix(builder: &mut Builder, values: &Values<'_>) {
    open(builder, Kind::Matrix, values.keyword.clone());
}

fn open(builder: &mut Builder, kind: Kind, opened: Span) {
    builder.scopes.0.push(Scope { kind, opened, saved: builder.state.clone() });
}

pub(super) fn close_brace(builder: &mut Builder, values: &Values<'_>) {
    let here = values.keyword.clone();
    let Some(brace) = builder.scopes.innermost_brace() else {
        builder.report(
            Diagnostic::error(here, "`}` closes nothing")
                .with_label("no `{` is open here")
                .with_help("remove it, or add the `{` that it should close"),
        );
        return;
    };
    let mut within = builder.scopes.0.split_off(brace).into_iter();
    builder.state = within.next().map_or_else(State::default, |scope| scope.saved);
    for matrix in within {
        builder.report(unclosed(&matrix, here.clone(), "this `}` closes the scope around it"));
    }
}

pub(super) fn pop_matrix(builder: &mut Builder, values: &Values<'_>) {
    match builder.scopes.0.pop_if(|scope| scope.kind == Kind::Matrix) {
        Some(matrix) => builder.state.transform = matrix.saved.transform,
        None => {
            let error = unbalanced_pop(&builder.scopes, values.keyword.clone());
            builder.report(error);
        }
    }
}

fn unbalanced_pop(scopes: &Scopes, here: Span) -> Diagnostic {
    let error = Diagnostic::error(here, "`pop_matrix` restores nothing")
        .with_label("no `push_matrix` is open here")
        .with_help("remove it, or add the `push_matrix` that it belongs to");
    // Perhaps there is one, but outside the braces around this place.
    let outside = scopes.0.iter().rposition(|scope| scope.kind == Kind::Matrix);
    match (outside, scopes.0.last()) {
        (Some(matrix), Some(around)) => error
            .with_related(
                scopes.0[matrix].opened.clone(),
                match around.kind {
                    Kind::Turn => "this one is outside the `repeat`",
                    Kind::Brace | Kind::Matrix => "this one is outside the braces",
                },
            )
            .with_related(around.opened.clone(), "the scope of the `pop_matrix` begins here"),
        _ => error,
    }
}

/// Begins a turn of a `repeat`.
pub(super) fn begin_turn(builder: &mut Builder, opened: Span) {
    open(builder, Kind::Turn, opened);
}

/// Ends a turn of a `repeat`: what it has opened, it has closed. Material and transform go on.
pub(super) fn end_turn(builder: &mut Builder, end: &Span) {
    while let Some(scope) = builder.scopes.0.pop_if(|scope| scope.kind != Kind::Turn) {
        builder.report(unclosed(&scope, end.clone(), "the turn of the `repeat` ends here"));
    }
    builder.scopes.0.pop();
}

/// Ends the scene.
pub(super) fn end(builder: &mut Builder, values: &Values<'_>) {
    builder.end = Some(values.keyword.clone());
}

/// Reports what is open when the scene ends.
pub(super) fn report_unclosed(builder: &mut Builder, end: &Span) {
    for scope in std::mem::take(&mut builder.scopes.0) {
        builder.report(unclosed(&scope, end.clone(), "the scene ends here"));
    }
}

fn unclosed(scope: &Scope, end: Span, at_end: &str) -> Diagnostic {
    let (keyword, closing) = match scope.kind {
        Kind::Brace => ("{", "}"),
        Kind::Matrix => ("push_matrix", "pop_matrix"),
        Kind::Turn => ("repeat", "end_repeat"),
    };
    Diagnostic::error(scope.opened.clone(), format!("`{keyword}` is never closed"))
        .with_label("opened here")
        .with_related(end, at_end)
        .with_help(format!("add a `{closing}` on a line of its own"))
}
