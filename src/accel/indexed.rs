//! Primitives together with the structure that finds them.

use std::time::{Duration, Instant};

use crate::counters::{Counters, Counts, NoCounters};
use crate::math::{Hit, Ray};

use super::{
    Accel, BuildConfig, BuildStages, Primitives, StructureShape, Tracer, Tree, blocked, closest,
};

/// Primitives, in the order of their structure.
///
/// This is all that rays need, without any scene: [`Tracer`] takes them in slices.
///
/// ```
/// use srt::accel::{BuildConfig, Bvh, Indexed, Tracer};
/// use srt::glam::Vec3;
/// use srt::math::{Hit, Ray};
/// use srt::shapes::TriangleSet;
///
/// // A square of two triangles.
/// let positions = [Vec3::ZERO, Vec3::X, Vec3::new(1.0, 1.0, 0.0), Vec3::Y];
/// let square = TriangleSet::new(&positions, &[[0, 1, 2], [0, 2, 3]]);
/// let bvh: Indexed<_, Bvh> = Indexed::build(square, &BuildConfig::default());
///
/// let rays = [Ray::new(Vec3::new(0.25, 0.75, 2.0), Vec3::NEG_Z)];
/// let (mut hits, mut blocked) = ([Hit::MISS], [false]);
/// bvh.intersect(&rays, &mut hits, None);
/// bvh.occluded(&rays, &mut blocked, None);
/// assert_eq!((hits[0].t, hits[0].prim, blocked[0]), (2.0, 1, true));
/// ```
#[derive(Clone, Debug)]
pub struct Indexed<P, A> {
    primitives: P,
    accel: A,
    build_time: Duration,
    check_time: Duration,
    stages: BuildStages,
}

impl<P: Primitives, A: Accel> Indexed<P, A> {
    /// Builds a structure and puts the primitives into its order.
    ///
    /// # Panics
    /// If the structure's order ([`Built::order`](super::Built::order)) does not give each primitive
    /// its slots.
    #[must_use]
    pub fn build(mut primitives: P, config: &BuildConfig) -> Self {
        let start = Instant::now();
        let mut stages = BuildStages::default();
        let built = A::build_in_stages(&primitives, config, &mut stages);
        let mut check_time = Duration::ZERO;
        if let Some(order) = &built.order {
            // No part of the build: a structure is not to pay for being trusted little.
            let check = Instant::now();
            order.assert_whole(primitives.count(), primitives.lanes());
            check_time = check.elapsed();
            stages.time("order", || primitives.reorder(order.slots()));
        }
        let build_time = start.elapsed() - check_time;
        Self { primitives, accel: built.accel, build_time, check_time, stages }
    }

    /// What is searched.
    #[must_use]
    pub fn primitives(&self) -> &P {
        &self.primitives
    }

    /// How long the build took, the reordering of the primitives included, and without the check of
    /// their order.
    #[must_use]
    pub fn build_time(&self) -> Duration {
        self.build_time
    }

    /// How long the check of the order took, for those who time around the build.
    pub(crate) fn check_time(&self) -> Duration {
        self.check_time
    }

    /// What the build spent its time on.
    #[must_use]
    pub fn build_stages(&self) -> &BuildStages {
        &self.stages
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
        closest(&self.accel, &self.primitives, ray, counters)
    }

    /// Whether there is any hit with `ray.t_min ≤ t ≤ ray.t_max`.
    #[inline]
    pub fn blocked<C: Counters>(&self, ray: &Ray, counters: &mut C) -> bool {
        blocked(&self.accel, &self.primitives, ray, counters)
    }

    /// [`Indexed::closest`] of many rays.
    ///
    /// # Panics
    /// If the slices differ in length.
    pub fn intersect_many<C: Counters>(&self, rays: &[Ray], hits: &mut [Hit], counters: &mut C) {
        assert_eq!(rays.len(), hits.len(), "a hit for each ray");
        self.accel.intersect_many(&self.primitives, rays, hits, counters);
    }

    /// [`Indexed::blocked`] of many rays.
    ///
    /// # Panics
    /// If the slices differ in length.
    pub fn occluded_many<C: Counters>(&self, rays: &[Ray], answers: &mut [bool], counters: &mut C) {
        assert_eq!(rays.len(), answers.len(), "an answer for each ray");
        self.accel.occluded_many(&self.primitives, rays, answers, counters);
    }
}

impl<P: Primitives, A: Accel> Tracer for Indexed<P, A> {
    fn intersect(&self, rays: &[Ray], hits: &mut [Hit], counts: Option<&mut Counts>) {
        match counts {
            Some(counts) => self.intersect_many(rays, hits, counts),
            None => self.intersect_many(rays, hits, &mut NoCounters),
        }
    }

    fn occluded(&self, rays: &[Ray], blocked: &mut [bool], counts: Option<&mut Counts>) {
        match counts {
            Some(counts) => self.occluded_many(rays, blocked, counts),
            None => self.occluded_many(rays, blocked, &mut NoCounters),
        }
    }
}
