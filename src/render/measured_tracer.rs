//! The one place of the renderer that traces rays. It counts them, shows them to the observer, and
//! measures the time.
//!
//! Each thread has one. It also times what the thread does between two calls, so that all of a
//! thread's time belongs to a stage. Knows nothing of scenes and pictures.

use crate::accel::{Answers, Scratch, Tracer};
use crate::math::Ray;

use super::stopwatch::Stopwatch;
use super::{Observer, RayClass, RenderStats, Stage};

/// Rays that are searched one by one between two questions whether to stop: few, because one may take
/// milliseconds without a structure, and enough for the question to cost nothing beside them.
const RAYS_BETWEEN_QUESTIONS: usize = 8;

pub(super) struct MeasuredTracer<'a> {
    tracer: &'a dyn Tracer,
    observer: &'a dyn Observer,
    /// Whether tests of boxes and primitives are counted.
    counts_tests: bool,
    cancelled: bool,
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
            cancelled: false,
            scratch: Scratch::default(),
            stats: RenderStats::default(),
            stopwatch: Stopwatch::start(),
        }
    }

    /// Asks whether the rendering is cancelled; once it is, it stays so.
    pub(super) fn is_cancelled(&mut self) -> bool {
        self.cancelled = self.cancelled || self.observer.cancelled();
        self.cancelled
    }

    /// Whether it was found to be cancelled: answers since then mean nothing.
    pub(super) fn was_cancelled(&self) -> bool {
        self.cancelled
    }

    /// Answers rays of a class. If the rendering is cancelled, they hit nothing, so that whoever sent
    /// them is soon done.
    pub(super) fn trace(&mut self, class: RayClass, rays: &[Ray], mut answers: Answers<'_>) {
        if self.is_cancelled() {
            answers.clear();
            return;
        }
        self.observer.rays_sent(class, rays);
        // Rays that a structure searches for together stay together; they are fast.
        let one_by_one = self.tracer.is_one_by_one();
        let at_once = if one_by_one { RAYS_BETWEEN_QUESTIONS } else { rays.len().max(1) };
        let mut first = 0;
        for rays in rays.chunks(at_once) {
            if first > 0 && self.is_cancelled() {
                answers.clear();
                return;
            }
            let counts = self.counts_tests.then(|| &mut self.stats.class_mut(class).tests);
            let part = answers.part(first..first + rays.len());
            self.tracer.trace(rays, part, &mut self.scratch, counts);
            first += rays.len();
        }
        let stats = self.stats.class_mut(class);
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

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicUsize, Ordering};

    use glam::Vec3;

    use super::*;
    use crate::counters::Counts;
    use crate::math::Hit;

    /// Everything is blocked. Notes the length of the longest slice.
    struct Wall {
        one_by_one: bool,
        longest: AtomicUsize,
    }

    impl Tracer for Wall {
        fn trace(
            &self,
            rays: &[Ray],
            answers: Answers<'_>,
            _: &mut Scratch,
            _: Option<&mut Counts>,
        ) {
            self.longest.fetch_max(rays.len(), Ordering::Relaxed);
            match answers {
                Answers::ClosestHit(hits) => {
                    hits.fill(Hit { t: 1.0, object: 0, prim: 0, u: 0.0, v: 0.0 });
                }
                Answers::AnyHit(blocked) => blocked.fill(true),
            }
        }

        fn is_one_by_one(&self) -> bool {
            self.one_by_one
        }
    }

    /// Says yes after it was asked so often.
    struct CancelAfter {
        questions: usize,
        asked: AtomicUsize,
    }

    impl Observer for CancelAfter {
        fn tile_done(&self, _: u64, _: u64) {}
        fn cancelled(&self) -> bool {
            self.asked.fetch_add(1, Ordering::Relaxed) >= self.questions
        }
    }

    /// What is blocked of a hundred rays, whether the rendering was cancelled, and the longest slice.
    fn traced(one_by_one: bool, questions: usize) -> (Vec<bool>, bool, usize) {
        let wall = Wall { one_by_one, longest: AtomicUsize::new(0) };
        let observer = CancelAfter { questions, asked: AtomicUsize::new(0) };
        let mut tracer = MeasuredTracer::new(&wall, &observer, false);
        let (rays, mut blocked) = ([Ray::new(Vec3::ZERO, Vec3::X); 100], vec![false; 100]);
        tracer.trace(RayClass::View, &rays, Answers::AnyHit(&mut blocked));
        (blocked, tracer.was_cancelled(), wall.longest.into_inner())
    }

    #[test]
    fn all_rays_are_traced_however_they_are_cut() {
        assert_eq!(traced(true, usize::MAX), (vec![true; 100], false, RAYS_BETWEEN_QUESTIONS));
        assert_eq!(traced(false, usize::MAX), (vec![true; 100], false, 100));
    }

    #[test]
    fn a_structure_that_walks_rays_one_by_one_is_stopped_among_them() {
        let nothing = vec![false; 100];
        assert_eq!(traced(true, 2), (nothing.clone(), true, RAYS_BETWEEN_QUESTIONS));
        assert_eq!(traced(true, 0), (nothing.clone(), true, 0));
        assert_eq!(traced(false, 0), (nothing, true, 0));
    }
}
