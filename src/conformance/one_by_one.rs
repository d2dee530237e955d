//! Triangles as the objects of a scene are: without packs, so that structures test them one by one.

use std::ops::Range;

use glam::Vec3A;

use crate::accel::{Bounded, NoPacks, Primitives, Query};
use crate::counters::Counters;
use crate::math::{Aabb, BoxRay, Padding, Ray};
use crate::shapes::TriangleSet;

/// Triangles that show no packs.
pub(super) struct OneByOne(pub(super) TriangleSet);

impl Bounded for OneByOne {
    const SOUND_BOXES: bool = TriangleSet::SOUND_BOXES;

    fn count(&self) -> u32 {
        self.0.count()
    }

    fn bounds(&self, index: u32) -> Aabb {
        Bounded::bounds(&self.0, index)
    }

    fn mean_point(&self) -> Vec3A {
        self.0.mean_point()
    }
}

impl Primitives for OneByOne {
    type Packs = NoPacks;

    fn packs(&self) -> &NoPacks {
        &NoPacks
    }

    fn padding(&self) -> Padding {
        self.0.padding()
    }

    fn close_ranks(&mut self) {
        self.0.close_ranks();
    }

    fn reorder(&mut self, order: &[u32]) {
        self.0.reorder(order);
    }

    fn test<Q: Query, C: Counters>(
        &self,
        query: &Q,
        slots: Range<u32>,
        ray: &Ray,
        box_ray: &BoxRay,
        answer: &mut Q::Answer,
        counters: &mut C,
    ) {
        self.0.test(query, slots, ray, box_ray, answer, counters);
    }
}
