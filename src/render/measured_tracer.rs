//! The one place of the renderer that traces rays. It counts them, shows them to the observer, and
//! measures the time.
//!
//! Each thread has one. It also times what the thread does between two calls, so that all of a
//! thread's time belongs to a stage. Knows nothing of scenes and pictures.

use crate::accel::{Answers, Scratch, Tracer};
use crate::math::Ray;

use super::stopwatch::Stopwatch;
use super::{Observer, RayClass, RenderStats, Stage};

pub(super) struct MeasuredTracer<'a> {
    tracer: &'a dyn Tracer,
    observer: &'a dyn Observer,
    /// Whether tests of boxes and primitives are counted.
    counts_tests: bool,
    scratch: Scratch,
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
        Self {
            tracer,
            observer,
            counts_tests,
            scratch: Scratch::default(),
            stats: RenderStats::default(),
            stopwatch: Stopwatch::start(),
        }
    }

    /// Answers rays of a class.
    pub(super) fn trace(&mut self, class: RayClass, rays: &[Ray], mut answers: Answers<'_>) {
        self.observer.rays_sent(class, rays);
        let stats = self.stats.class_mut(class);
        let counts = self.counts_tests.then_some(&mut stats.tests);
        self.tracer.trace(rays, answers.reborrow(), &mut self.scratch, counts);
        stats.rays += rays.len() as u64;
        stats.hits += answers.hit_count() as u64;
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
