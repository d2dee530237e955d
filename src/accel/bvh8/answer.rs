//! What is asked of rays: where they hit first, or whether they hit anything.

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
