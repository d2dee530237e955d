//! The material, the transform, the deformation and the clock in force, and the scopes that restore them.
//!
//! `{` saves all of it, `push_matrix` the transform alone. Scopes nest: a `}` closes
//! the innermost `{`; a `push_matrix` that is still open within it is an error, and is closed with
//! it. A `pop_matrix` never closes anything outside the braces around it, and nothing in an
//! iteration of a `repeat` closes anything outside of it.

use glam::DAffine3;

use crate::description::{Deformation, Material, Span};

use super::diagnostic::Diagnostic;

/// What is in force, and the scopes that are open.
#[derive(Default)]
pub(super) struct Scopes {
    current: State,
    /// The innermost last.
    open: Vec<Scope>,
}

/// What is in force.
#[derive(Clone, Default)]
struct State {
    material: Material,
    deformation: Deformation,
    /// The frame, as what follows sees it: delays and periods are taken into account.
    clock: f64,
    /// Object space to world space.
    transform: DAffine3,
    /// The last command that changed the transform.
    last_transform: Option<Span>,
    /// Whether the transform was reported as unusable, so that every further object need not.
    reported: bool,
}

struct Scope {
    kind: ScopeKind,
    /// The keyword that opened it.
    opened: Span,
    /// What it restores.
    saved: State,
}

#[derive(Clone, Copy, PartialEq)]
enum ScopeKind {
    Brace,
    Matrix,
    /// An iteration of a `repeat`.
    Iteration,
}

impl Scopes {
    /// The material in force.
    pub(super) fn material(&mut self) -> &mut Material {
        &mut self.current.material
    }

    /// The deformation in force.
    pub(super) fn deformation(&mut self) -> &mut Deformation {
        &mut self.current.deformation
    }

    /// The clock in force, in frames.
    pub(super) fn clock(&mut self) -> &mut f64 {
        &mut self.current.clock
    }

    /// The transform in force: object space to world space.
    pub(super) fn transform(&self) -> DAffine3 {
        self.current.transform
    }

    /// transform ← transform · `by`, because of a command.
    pub(super) fn compose(&mut self, by: DAffine3, command: Span) {
        self.current.transform *= by;
        self.current.last_transform = Some(command);
    }

    /// What is wrong with the transform at a command that uses it; once for each transform.
    pub(super) fn unusable_transform(&mut self, used: Span, what: &str) -> Option<Diagnostic> {
        if std::mem::replace(&mut self.current.reported, true) {
            return None;
        }
        let error = Diagnostic::error(used, format!("the transform here {what}"))
            .with_label("made with this transform")
            .with_help("look for a `scale` that shrinks or stretches too much");
        Some(match &self.current.last_transform {
            Some(last) => error.with_related(last.clone(), "the last command that went into it"),
            None => error,
        })
    }

    pub(super) fn open_brace(&mut self, here: Span) {
        self.open(ScopeKind::Brace, here);
    }

    pub(super) fn push_matrix(&mut self, here: Span) {
        self.open(ScopeKind::Matrix, here);
    }

    fn open(&mut self, kind: ScopeKind, opened: Span) {
        self.open.push(Scope { kind, opened, saved: self.current.clone() });
    }

    /// Closes the innermost brace, and what is open within it; gives back what is wrong.
    pub(super) fn close_brace(&mut self, here: &Span) -> Vec<Diagnostic> {
        let Some(brace) = self.innermost_brace() else {
            return vec![
                Diagnostic::error(here.clone(), "`}` closes nothing")
                    .with_label("no `{` is open here")
                    .with_help("remove it, or add the `{` that it should close"),
            ];
        };
        let mut within = self.open.split_off(brace).into_iter();
        if let Some(scope) = within.next() {
            self.current = scope.saved;
        }
        within.map(|matrix| matrix.unclosed(here, "this `}` closes the scope around it")).collect()
    }

    fn innermost_brace(&self) -> Option<usize> {
        let innermost = self.open.iter().rposition(|scope| scope.kind != ScopeKind::Matrix);
        innermost.filter(|&scope| self.open[scope].kind == ScopeKind::Brace)
    }

    /// Restores the transform that the innermost scope has saved; gives back what is wrong.
    pub(super) fn pop_matrix(&mut self, here: &Span) -> Option<Diagnostic> {
        let Some(matrix) = self.open.pop_if(|scope| scope.kind == ScopeKind::Matrix) else {
            return Some(self.unbalanced_pop(here.clone()));
        };
        let State { material, deformation, clock, .. } = self.current;
        self.current = State { material, deformation, clock, ..matrix.saved };
        None
    }

    fn unbalanced_pop(&self, here: Span) -> Diagnostic {
        let error = Diagnostic::error(here, "`pop_matrix` restores nothing")
            .with_label("no `push_matrix` is open here")
            .with_help("remove it, or add the `push_matrix` that it belongs to");
        // Perhaps there is one, but outside the braces around this place.
        let outside = self.open.iter().rposition(|scope| scope.kind == ScopeKind::Matrix);
        let (Some(matrix), Some(around)) = (outside, self.open.last()) else { return error };
        let where_it_is = match around.kind {
            ScopeKind::Iteration => "this one is outside the `repeat`",
            ScopeKind::Brace | ScopeKind::Matrix => "this one is outside the braces",
        };
        error
            .with_related(self.open[matrix].opened.clone(), where_it_is)
            .with_related(around.opened.clone(), "the scope of the `pop_matrix` begins here")
    }

    /// Begins an iteration of a `repeat`.
    pub(super) fn begin_iteration(&mut self, repeat: Span) {
        self.open(ScopeKind::Iteration, repeat);
    }

    /// Ends an iteration of a `repeat`: closes what is open within it, and gives back what is wrong.
    /// What is in force stays.
    pub(super) fn end_iteration(&mut self, end: &Span) -> Vec<Diagnostic> {
        let is_iteration = |scope: &Scope| scope.kind == ScopeKind::Iteration;
        let Some(begin) = self.open.iter().rposition(is_iteration) else { return Vec::new() };
        let within = self.open.split_off(begin).into_iter().skip(1).rev();
        within
            .map(|scope| scope.unclosed(end, "this iteration of the `repeat` ends here"))
            .collect()
    }

    /// What is open when the scene ends.
    pub(super) fn unclosed(&self, end: &Span) -> Vec<Diagnostic> {
        self.open.iter().map(|scope| scope.unclosed(end, "the scene ends here")).collect()
    }
}

impl Scope {
    fn unclosed(&self, end: &Span, at_end: &str) -> Diagnostic {
        let (keyword, closing) = match self.kind {
            ScopeKind::Brace => ("{", "}"),
            ScopeKind::Matrix => ("push_matrix", "pop_matrix"),
            ScopeKind::Iteration => ("repeat", "end_repeat"),
        };
        Diagnostic::error(self.opened.clone(), format!("`{keyword}` is never closed"))
            .with_label("opened here")
            .with_related(end.clone(), at_end)
            .with_help(format!("add a `{closing}` on a line of its own"))
    }
}
