//! Structures that are wrong on purpose.

use std::ops::{ControlFlow, Range};

use srt::accel::{Accel, Bounded, Build, Built};
use srt::counters::Counters;
use srt::math::{Aabb, BoxRay, Ray};

/// Offers each primitive whose box, made smaller by a twentieth, the ray meets: it loses hits near
/// silhouettes.
pub(crate) struct Shrunken {
    boxes: Vec<Aabb>,
}

impl Accel for Shrunken {
    fn build(primitives: &impl Bounded, _: &mut Build<'_>) -> Built<Self> {
        let shrunken = |i| {
            let Aabb { min, max } = primitives.bounds(i);
            let margin = 0.025 * (max - min);
            Aabb { min: min + margin, max: max - margin }
        };
        let accel = Self { boxes: (0..primitives.count()).map(shrunken).collect() };
        Built { accel, order: None }
    }

    fn traverse<C: Counters>(
        &self,
        ray: &Ray,
        box_ray: &BoxRay,
        counters: &mut C,
        mut leaf: impl FnMut(Range<u32>, &mut C) -> ControlFlow<(), f32>,
    ) {
        let mut end = ray.end();
        for (slot, bounds) in (0..).zip(&self.boxes) {
            counters.boxes(1);
            let (near, far) = box_ray.interval(bounds);
            if near.max(ray.t_min) <= far.min(end) {
                match leaf(slot..slot + 1, counters) {
                    ControlFlow::Continue(t) => end = t,
                    ControlFlow::Break(()) => return,
                }
            }
        }
    }

    fn bytes(&self) -> u64 {
        0
    }
}

/// Panics: in its build, or in its first search.
pub(crate) struct Panicking<const IN_BUILD: bool>;

impl<const IN_BUILD: bool> Accel for Panicking<IN_BUILD> {
    fn build(_: &impl Bounded, _: &mut Build<'_>) -> Built<Self> {
        assert!(!IN_BUILD, "on purpose");
        Built { accel: Self, order: None }
    }

    fn traverse<C: Counters>(
        &self,
        _: &Ray,
        _: &BoxRay,
        _: &mut C,
        _: impl FnMut(Range<u32>, &mut C) -> ControlFlow<(), f32>,
    ) {
        panic!("on purpose");
    }

    fn bytes(&self) -> u64 {
        0
    }
}
