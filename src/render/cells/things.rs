//! Things that are hit by their own rule, as primitives: solids over a mesh, and what stands in the world.

use std::ops::Range;

use glam::Vec3A;

use crate::accel::{Bounded, NoPacks, Primitives, Query};
use crate::counters::Counters;
use crate::math::{Aabb, BoxRay, Hit, Padding, Ray};

/// Something in a box that a ray may hit.
pub(super) trait Thing: Clone + Send + Sync {
    /// The box around it.
    fn bounds(&self) -> Aabb;

    /// The hit of the thing of this id within the ray's interval.
    fn hit(&self, id: u32, ray: &Ray, box_ray: &BoxRay) -> Option<Hit>;
}

/// Things in slot order, each with its id.
#[derive(Clone, Debug)]
pub(super) struct Things<T> {
    all: Vec<(T, u32)>,
    padding: Padding,
}

impl<T: Thing> Things<T> {
    /// Things whose ids are their places.
    pub(super) fn new(all: impl IntoIterator<Item = T>) -> Self {
        let all: Vec<_> = all.into_iter().zip(0..).collect();
        let bounds = all.iter().map(|(thing, _)| thing.bounds()).fold(Aabb::EMPTY, Aabb::union);
        Self { all, padding: Padding::of_bounds(&bounds) }
    }
}

impl<T: Thing> Bounded for Things<T> {
    fn count(&self) -> u32 {
        self.all.len() as u32
    }

    fn bounds(&self, slot: u32) -> Aabb {
        self.all[slot as usize].0.bounds()
    }

    fn mean_point(&self) -> Vec3A {
        self.total_bounds().center()
    }
}

impl<T: Thing> Primitives for Things<T> {
    type Packs = NoPacks;

    fn packs(&self) -> &NoPacks {
        &NoPacks
    }

    fn padding(&self) -> Padding {
        self.padding
    }

    fn reorder(&mut self, order: &[u32]) {
        let in_order = order.iter().filter_map(|&from| self.all.get(from as usize).cloned());
        self.all = in_order.collect();
    }

    fn test<Q: Query, C: Counters>(
        &self,
        query: &Q,
        slots: Range<u32>,
        ray: &Ray,
        box_ray: &BoxRay,
        answer: &mut Q::Answer,
        _: &mut C,
    ) {
        for (thing, id) in &self.all[slots.start as usize..slots.end as usize] {
            let shorter = Ray { t_max: query.end(ray, answer), ..*ray };
            let Some(hit) = thing.hit(*id, &shorter, box_ray) else { continue };
            if !Q::FILTERS || query.accepts(ray, &hit) {
                query.record(answer, &hit);
            }
        }
    }
}
