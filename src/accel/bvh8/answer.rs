//! What is asked of rays: where they hit first, or whether they hit anything.

use std::ops::Range;

use crate::accel::{Primitives, blocked, closest};
use crate::counters::Counters;
use crate::math::{Hit, Ray};
use crate::simd::{Row, ones};

use super::Bvh8;
use super::packet::{ALL, Best, RAYS};

/// An answer of the kernels.
pub(super) trait Answer: Copy {
    /// Whether any hit will do.
    const ANY: bool;

    /// From what a wave found.
    fn of(found: Hit) -> Self;

    /// From what a packet found.
    fn of_packet<R: Row<RAYS>>(best: &Best<R>, answers: &mut [Self; RAYS]);

    /// At the start of a stream.
    fn start(ray: &Ray) -> Self;

    /// How far the search goes on; before every ray's beginning, if it does not.
    fn end(&self, ray: &Ray) -> f32;

    /// Whether the search goes on.
    fn is_open(&self) -> bool;

    /// Asks primitives about some of a stream's rays.
    fn ask<P: Primitives, C: Counters>(
        primitives: &P,
        slots: Range<u32>,
        rays: &[Ray],
        which: &[u32],
        answers: &mut [Self],
        counters: &mut C,
    );

    /// At the end of a stream.
    fn finish(&mut self);

    /// By walking a ray alone.
    fn alone<P: Primitives, C: Counters>(
        tree: &Bvh8,
        primitives: &P,
        ray: &Ray,
        counters: &mut C,
    ) -> Self;
}

impl Answer for Hit {
    const ANY: bool = false;

    #[inline(always)]
    fn of(found: Hit) -> Self {
        found
    }

    #[inline(always)]
    fn of_packet<R: Row<RAYS>>(best: &Best<R>, answers: &mut [Self; RAYS]) {
        best.write(answers);
        for ray in ones(!best.hit & ALL) {
            answers[ray] = Self::MISS;
        }
    }

    #[inline(always)]
    fn start(ray: &Ray) -> Self {
        Self::none_before(ray.t_max)
    }

    #[inline(always)]
    fn end(&self, _: &Ray) -> f32 {
        self.t
    }

    #[inline(always)]
    fn is_open(&self) -> bool {
        true
    }

    fn ask<P: Primitives, C: Counters>(
        primitives: &P,
        slots: Range<u32>,
        rays: &[Ray],
        which: &[u32],
        answers: &mut [Self],
        counters: &mut C,
    ) {
        primitives.intersect_stream(slots, rays, which, answers, counters);
    }

    #[inline(always)]
    fn finish(&mut self) {
        if !self.is_hit() {
            *self = Self::MISS;
        }
    }

    #[cold]
    #[inline(never)]
    fn alone<P: Primitives, C: Counters>(
        tree: &Bvh8,
        primitives: &P,
        ray: &Ray,
        counters: &mut C,
    ) -> Self {
        closest(tree, primitives, ray, counters)
    }
}

impl Answer for bool {
    const ANY: bool = true;

    #[inline(always)]
    fn of(found: Hit) -> Self {
        found.is_hit()
    }

    #[inline(always)]
    fn of_packet<R: Row<RAYS>>(best: &Best<R>, answers: &mut [Self; RAYS]) {
        for (ray, answer) in answers.iter_mut().enumerate() {
            *answer = best.hit >> ray & 1 != 0;
        }
    }

    #[inline(always)]
    fn start(_: &Ray) -> Self {
        false
    }

    #[inline(always)]
    fn end(&self, ray: &Ray) -> f32 {
        if *self { f32::NEG_INFINITY } else { ray.t_max }
    }

    #[inline(always)]
    fn is_open(&self) -> bool {
        !*self
    }

    fn ask<P: Primitives, C: Counters>(
        primitives: &P,
        slots: Range<u32>,
        rays: &[Ray],
        which: &[u32],
        answers: &mut [Self],
        counters: &mut C,
    ) {
        primitives.occluded_stream(slots, rays, which, answers, counters);
    }

    #[inline(always)]
    fn finish(&mut self) {}

    #[cold]
    #[inline(never)]
    fn alone<P: Primitives, C: Counters>(
        tree: &Bvh8,
        primitives: &P,
        ray: &Ray,
        counters: &mut C,
    ) -> Self {
        blocked(tree, primitives, ray, counters)
    }
}
