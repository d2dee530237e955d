//! The one place of the renderer that traces rays. It counts them, shows them to the observer, and
//! measures the time.
//!
//! Each thread has one. It also times what the thread does between two calls, so that all of a
//! thread's time belongs to a stage. Knows nothing of scenes and pictures.

use crate::accel::Tracer;
use crate::counters::Counts;
use crate::math::{Hit, Ray};

use super::stopwatch::Stopwatch;
use super::{Observer, RayClass, RenderStats, Stage};

pub(super) struct MeasuredTracer<'a> {
    tracer: &'a dyn Tracer,
    observer: &'a dyn Observer,
    /// Whether tests of boxes and primitives are counted.
    counts_tests: bool,
    stats: RenderStats,
    stopwatch: Stopwatch,
}

impl<'a> MeasuredTracer<'a> {
    /// Time counts from now on.
    pub(super) fn new(
        tracer: &'a dyn Tracer,
        observer: &'a dyn Observer,
        counts_tests: bool,
    ) -> Self {
        let (stats, stopwatch) = (RenderStats::default(), Stopwatch::start());
        Self { tracer, observer, counts_tests, stats, stopwatch }
    }

    /// Finds the closest hit of each ray. The slices are of equal length.
    pub(super) fn closest_hits(&mut self, class: RayClass, rays: &[Ray], hits: &mut [Hit]) {
        self.trace(class, rays, |tracer, counts| {
            tracer.intersect(rays, hits, counts);
            hits.iter().filter(|hit| hit.is_hit()).count()
        });
    }

    /// Finds whether each shadow ray is blocked. The slices are of equal length.
    pub(super) fn occlusion(&mut self, rays: &[Ray], blocked: &mut [bool]) {
        self.trace(RayClass::Shadow, rays, |tracer, counts| {
            tracer.occluded(rays, blocked, counts);
            blocked.iter().filter(|&&blocked| blocked).count()
        });
    }

    /// Traces rays by `query`, which returns how many of them hit something.
    fn trace(
        &mut self,
        class: RayClass,
        rays: &[Ray],
        query: impl FnOnce(&dyn Tracer, Option<&mut Counts>) -> usize,
    ) {
        self.observer.rays_sent(class, rays);
        let stats = self.stats.class_mut(class);
        let hits = query(self.tracer, self.counts_tests.then_some(&mut stats.tests));
        stats.rays += rays.len() as u64;
        stats.hits += hits as u64;
        self.lap(Stage::Tracing(class));
    }

    /// Adds the time since the last lap to a stage.
    pub(super) fn lap(&mut self, stage: Stage) {
        self.stats.thread_times.add(stage, self.stopwatch.lap());
    }

    /// The statistics since they were last taken.
    pub(super) fn stats(&self) -> &RenderStats {
        &self.stats
    }

    /// Takes the statistics, and counts from zero again.
    pub(super) fn take_stats(&mut self) -> RenderStats {
        std::mem::take(&mut self.stats)
    }
}
