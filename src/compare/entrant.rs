//! A structure that is compared in a scene, from its build to its row of the report.

use std::time::Duration;

use crate::accel::{self, BuildConfig, Scratch, Tracer};
use crate::counters::Counts;
use crate::math::{Hit, Ray};
use crate::record::{Status, StructureRecord};
use crate::scene::{BuildReport, Scene, Structure, TracedWorld};

use super::guard::guarded;
use super::record_rays::Query;

/// Rays in a call, as in a renderer's wave.
const RAYS_AT_ONCE: usize = 1024;

/// A structure, what it was built into, and what it did.
pub(super) struct Entrant<'a> {
    pub(super) structure: &'a Structure,
    /// Absent before the build, and after a failure.
    world: Option<Box<dyn TracedWorld>>,
    pub(super) record: StructureRecord,
}

impl<'a> Entrant<'a> {
    pub(super) fn new(structure: &'a Structure) -> Self {
        let record = StructureRecord {
            name: structure.name.to_owned(),
            peer: structure.peer,
            ..Default::default()
        };
        Self { structure, world: None, record }
    }

    /// Builds it, on the threads of the current rayon pool, and keeps what was built.
    pub(super) fn build(&mut self, scene: &Scene, config: &BuildConfig) {
        match guarded(|| self.structure.try_build(scene, config)) {
            Ok(Ok(world)) => self.world = Some(world),
            Ok(Err(error)) => self.fail(error.to_string()),
            Err(message) => self.fail(message),
        }
    }

    /// Whether it can trace.
    pub(super) fn is_fit(&self) -> bool {
        self.world.is_some()
    }

    /// What its build took and gave.
    pub(super) fn report(&self) -> Option<BuildReport> {
        self.world.as_ref().map(|world| world.build_report())
    }

    /// Lets it trace something. `None` if it cannot, or if it fails now.
    pub(super) fn attempt<T>(&mut self, work: impl FnOnce(&dyn TracedWorld) -> T) -> Option<T> {
        let world = self.world.as_deref()?;
        match guarded(|| work(world)) {
            Ok(result) => Some(result),
            Err(message) => {
                self.fail(message);
                None
            }
        }
    }

    /// It takes no further part.
    pub(super) fn fail(&mut self, message: String) {
        self.world = None;
        self.record.status = Status::Failed { message };
    }

    /// It takes part, but a measurement of it was left out for want of time.
    pub(super) fn too_slow(&mut self, after: Duration) {
        if self.record.status == Status::Ok {
            self.record.status = Status::TooSlow { after_seconds: after.as_secs_f64() };
        }
    }

    /// The comparison ended before it was done.
    pub(super) fn stop(&mut self) {
        if self.record.status == Status::Ok {
            self.record.status = Status::Stopped;
        }
    }
}

/// What a structure says to some rays.
#[derive(Clone, Debug, Default)]
pub(super) struct Answers {
    pub(super) hits: Vec<Hit>,
    pub(super) blocked: Vec<bool>,
}

impl Answers {
    /// How many rays hit something.
    pub(super) fn hit_count(&self, query: Query) -> u64 {
        match query {
            Query::Closest => self.hits.iter().filter(|hit| hit.is_hit()).count() as u64,
            Query::Any => self.blocked.iter().filter(|&&blocked| blocked).count() as u64,
        }
    }
}

/// Traces rays in calls of a wave's size, into buffers that are used again.
pub(super) fn trace(
    tracer: &dyn Tracer,
    query: Query,
    rays: &[Ray],
    answers: &mut Answers,
    mut counts: Option<&mut Counts>,
) {
    Scratch::of_thread(|scratch| match query {
        Query::Closest => {
            answers.hits.resize(rays.len(), Hit::MISS);
            let hits = answers.hits.chunks_mut(RAYS_AT_ONCE);
            for (rays, hits) in rays.chunks(RAYS_AT_ONCE).zip(hits) {
                let answers = accel::Answers::ClosestHit(hits);
                tracer.trace(rays, answers, scratch, counts.as_deref_mut());
            }
        }
        Query::Any => {
            answers.blocked.resize(rays.len(), false);
            let blocked = answers.blocked.chunks_mut(RAYS_AT_ONCE);
            for (rays, blocked) in rays.chunks(RAYS_AT_ONCE).zip(blocked) {
                let answers = accel::Answers::AnyHit(blocked);
                tracer.trace(rays, answers, scratch, counts.as_deref_mut());
            }
        }
    });
}
