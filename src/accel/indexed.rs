//! Primitives together with the structure that finds them.

use std::ops::ControlFlow;
use std::time::{Duration, Instant};

use crate::counters::{Counters, Counts, NoCounters};
use crate::math::{BoxRay, Hit, Ray};

use super::{Accel, BuildConfig, Primitives, StructureShape, Tracer, Tree};

/// Primitives, in the order of their structure.
#[derive(Clone, Debug)]
pub struct Indexed<P, A> {
    primitives: P,
    accel: A,
    build_time: Duration,
}

impl<P: Primitives, A: Accel> Indexed<P, A> {
    /// Builds a structure and puts the primitives into its order.
    #[must_use]
    pub fn build(mut primitives: P, config: &BuildConfig) -> Self {
        let start = Instant::now();
        let built = A::build(&primitives, config);
        if let Some(order) = &built.order {
            primitives.reorder(order);
        }
        Self { primitives, accel: built.accel, build_time: start.elapsed() }
    }

    /// What is searched.
    #[must_use]
    pub fn primitives(&self) -> &P {
        &self.primitives
    }

    /// How long the build took, the reordering of the primitives included.
    #[must_use]
    pub fn build_time(&self) -> Duration {
        self.build_time
    }

    /// What the structure looks like.
    #[must_use]
    pub fn shape(&self) -> StructureShape {
        self.accel.shape()
    }

    /// All nodes of the structure, where it is a tree.
    #[must_use]
    pub fn tree(&self) -> Option<Tree> {
        self.accel.tree()
    }

    /// The first hit in the order `(t, object, prim)` with `ray.t_min ≤ t ≤ ray.t_max`, or
    /// [`Hit::MISS`].
    #[inline]
    pub fn closest<C: Counters>(&self, ray: &Ray, counters: &mut C) -> Hit {
        let box_ray = BoxRay::new(ray, self.primitives.padding());
        let mut best = Hit::none_before(ray.t_max);
        self.accel.traverse(ray, &box_ray, counters, |slots, counters| {
            self.primitives.intersect(slots, ray, &box_ray, &mut best, counters);
            ControlFlow::Continue(best.t)
        });
        if best.is_hit() { best } else { Hit::MISS }
    }

    /// Whether there is any hit with `ray.t_min ≤ t ≤ ray.t_max`.
    #[inline]
    pub fn blocked<C: Counters>(&self, ray: &Ray, counters: &mut C) -> bool {
        let box_ray = BoxRay::new(ray, self.primitives.padding());
        let mut blocked = false;
        self.accel.traverse(ray, &box_ray, counters, |slots, counters| {
            blocked = self.primitives.occluded(slots, ray, &box_ray, counters);
            if blocked { ControlFlow::Break(()) } else { ControlFlow::Continue(ray.t_max) }
        });
        blocked
    }

    fn intersect_each<C: Counters>(&self, rays: &[Ray], hits: &mut [Hit], counters: &mut C) {
        for (ray, hit) in rays.iter().zip(hits) {
            *hit = self.closest(ray, counters);
        }
    }

    fn occluded_each<C: Counters>(&self, rays: &[Ray], blocked: &mut [bool], counters: &mut C) {
        for (ray, blocked) in rays.iter().zip(blocked) {
            *blocked = self.blocked(ray, counters);
        }
    }
}

impl<P: Primitives, A: Accel> Tracer for Indexed<P, A> {
    fn intersect(&self, rays: &[Ray], hits: &mut [Hit], counts: Option<&mut Counts>) {
        assert_eq!(rays.len(), hits.len(), "a hit for each ray");
        match counts {
            Some(counts) => self.intersect_each(rays, hits, counts),
            None => self.intersect_each(rays, hits, &mut NoCounters),
        }
    }

    fn occluded(&self, rays: &[Ray], blocked: &mut [bool], counts: Option<&mut Counts>) {
        assert_eq!(rays.len(), blocked.len(), "an answer for each ray");
        match counts {
            Some(counts) => self.occluded_each(rays, blocked, counts),
            None => self.occluded_each(rays, blocked, &mut NoCounters),
        }
    }
}
