//! A structure that is compared in a scene, from its build to its row of the report.

use std::time::Duration;

use crate::accel::BuildConfig;
use crate::record::{Conformance, Status, StructureRecord};
use crate::scene::{BuildReport, Scene, Structure, TracedWorld};

use super::conformance::reason_not_to_time;
use super::panics::catch_panic;

/// A structure, what it was built into, and its row of the report.
pub(super) struct Candidate<'a> {
    pub(super) structure: &'a Structure,
    /// Absent before the build, and after a failure.
    world: Option<Box<dyn TracedWorld>>,
    pub(super) record: StructureRecord,
    /// Why it is not to be timed, if it does not conform.
    unfit: Option<String>,
}

impl<'a> Candidate<'a> {
    pub(super) fn new(structure: &'a Structure) -> Self {
        let record = StructureRecord {
            name: structure.name.to_owned(),
            peer: structure.peer,
            ..Default::default()
        };
        Self { structure, world: None, record, unfit: None }
    }

    /// The same, not to be timed if it does not conform.
    pub(super) fn judged_by(self, checked: &[Conformance]) -> Self {
        Self { unfit: reason_not_to_time(checked, self.name()), ..self }
    }

    /// Whether nothing is known against it before its first ray in a scene.
    pub(super) fn is_fit(&self) -> bool {
        self.unfit.is_none()
    }

    /// Takes it out of the comparison if it does not conform, unless it has failed before.
    pub(super) fn fail_if_unfit(&mut self) {
        if let Some(reason) = self.unfit.clone().filter(|_| self.can_trace()) {
            self.fail(reason);
        }
    }

    pub(super) fn name(&self) -> &'static str {
        self.structure.name
    }

    /// Whether it is another program's structure, whose hits must be close to the reference's, not
    /// equal, and which counts no tests.
    pub(super) fn is_peer(&self) -> bool {
        self.structure.peer
    }

    /// Whether the library has it, and nobody is trying it out.
    pub(super) fn is_of_library(&self) -> bool {
        self.structure.is_of_library()
    }

    /// Builds it, on the threads of the current rayon pool, and keeps what was built.
    pub(super) fn build(&mut self, scene: &Scene, config: &BuildConfig) {
        match catch_panic(|| self.structure.try_build(scene, config)) {
            Ok(Ok(world)) => self.world = Some(world),
            Ok(Err(error)) => self.fail(error.to_string()),
            Err(message) => self.fail(message),
        }
    }

    /// Whether it was built and has not failed since.
    pub(super) fn can_trace(&self) -> bool {
        self.world.is_some()
    }

    /// What its build took and gave.
    pub(super) fn build_report(&self) -> Option<BuildReport> {
        self.world.as_ref().map(|world| world.build_report())
    }

    /// Runs some work with what was built; `None` if that is absent or if the work panics, which
    /// is a failure of the structure.
    pub(super) fn attempt<T>(&mut self, work: impl FnOnce(&dyn TracedWorld) -> T) -> Option<T> {
        let world = self.world.as_deref()?;
        match catch_panic(|| work(world)) {
            Ok(result) => Some(result),
            Err(message) => {
                self.fail(message);
                None
            }
        }
    }

    /// Takes it out of the comparison.
    pub(super) fn fail(&mut self, message: String) {
        self.world = None;
        self.record.status = Status::Failed { message };
    }

    /// Notes that a measurement of it was left out because the budget is too small.
    pub(super) fn mark_too_slow(&mut self, after: Duration) {
        if self.record.status == Status::Ok {
            self.record.status = Status::TooSlow { after_seconds: after.as_secs_f64() };
        }
    }

    /// Notes that the comparison was stopped before its measurements were complete.
    pub(super) fn mark_stopped(&mut self) {
        if self.record.status == Status::Ok {
            self.record.status = Status::Stopped;
        }
    }
}

/// Which of them has a name.
pub(super) fn position(candidates: &[Candidate<'_>], name: &str) -> Option<usize> {
    candidates.iter().position(|candidate| candidate.name() == name)
}
