//! Primitives together with the structure that finds them.

use std::time::{Duration, Instant};

use rayon::prelude::*;

use crate::counters::{Counters, Counts, NoCounters};
use crate::math::{Aabb, Hit, NONE, Ray};

use super::{
    Accel, Answers, AnyHit, Bounded, Build, BuildConfig, BuildStages, ClosestHit, IntoPrimitives,
    Moved, Order, PACK, Packs, Primitives, Query, Regions, Scratch, StructureShape, Tracer, Tree,
    Update, search_one,
};

/// What debug builds say of rays whose hits are not defined.
const OUT_OF_RANGE: &str = "a ray has an infinite component: see `Ray::check`";

/// Primitives, in the order of their structure.
///
/// This is all that rays need, without any scene.
///
/// ```
/// use srt::accel::{AnyHit, BuildConfig, Bvh, ClosestHit, Indexed};
/// use srt::glam::Vec3;
/// use srt::math::{Hit, Ray};
/// use srt::shapes::TriangleMesh;
///
/// // A square of two triangles.
/// let positions = [Vec3::ZERO, Vec3::X, Vec3::new(1.0, 1.0, 0.0), Vec3::Y];
/// let square = TriangleMesh::new(&positions, &[[0, 1, 2], [0, 2, 3]]);
/// let bvh: Indexed<_, Bvh> = Indexed::build(square, &BuildConfig::default());
///
/// let ray = Ray::new(Vec3::new(0.25, 0.75, 2.0), Vec3::NEG_Z);
/// assert_eq!((bvh.hit(&ray).prim, bvh.occluded(&ray)), (1, true));
///
/// // Many rays in one slice are the fastest.
/// let rays = [ray; 100];
/// let (mut hits, mut blocked) = ([Hit::MISS; 100], [false; 100]);
/// bvh.answer(&ClosestHit, &rays, &mut hits);
/// bvh.answer(&AnyHit, &rays, &mut blocked);
/// assert_eq!((hits[99].t, blocked[99]), (2.0, true));
/// ```
#[derive(Clone, Debug)]
pub struct Indexed<P, A> {
    primitives: P,
    accel: A,
    build_time: Duration,
    check_time: Duration,
    stages: BuildStages,
    config: BuildConfig,
}

impl<P: Primitives, A: Accel> Indexed<P, A> {
    /// Builds a structure over primitives, or what is to become them, and puts them into its order.
    ///
    /// # Panics
    /// If the structure's order ([`Built::order`](super::Built::order)) does not give each primitive
    /// its slots. If a primitive has a box that is empty or not finite. If primitives that were put into an order
    /// before are no longer complete.
    #[must_use]
    pub fn build(mut source: impl IntoPrimitives<Primitives = P>, config: &BuildConfig) -> Self {
        let start = Instant::now();
        source.prepare();
        // The checks are no part of what a build costs.
        let check = Instant::now();
        assert_sound_boxes(&source);
        let mut check_time = check.elapsed();
        let mut stages = BuildStages::default();
        let grain = <P::Packs as Packs>::GRAIN;
        let built = A::build(&source, &mut Build { config, grain, stages: &mut stages });
        if stages.iter().next().is_none() {
            stages.add("structure", start.elapsed() - check_time);
        }
        if let Some(order) = &built.order {
            let check = Instant::now();
            order.assert_whole(source.count(), grain);
            check_time += check.elapsed();
        }
        let order = built.order.as_ref().map(Order::slots);
        let primitives = stages.time("primitives", || source.into_primitives(order));
        let build_time = start.elapsed() - check_time;
        let config = config.clone();
        Self { primitives, accel: built.accel, build_time, check_time, stages, config }
    }

    /// Moves the primitives: `change` changes them where they stand, in slot order, and the structure follows as
    /// `update` says. `settle` is then told the box around all, which [`Primitives::padding`] depends on.
    ///
    /// ```
    /// use srt::accel::{BuildConfig, Bvh8, Indexed, Moved, Update};
    /// use srt::glam::Vec3;
    /// use srt::math::Ray;
    /// use srt::shapes::{TriangleMesh, TriangleSet};
    ///
    /// let (mut positions, triangles) = ([Vec3::ZERO, Vec3::X, Vec3::Y], [[0, 1, 2]]);
    /// let mesh = TriangleMesh::new(&positions, &triangles);
    /// let mut bvh: Indexed<_, Bvh8> = Indexed::build(mesh, &BuildConfig::default());
    /// positions.iter_mut().for_each(|position| position.z += 3.0);
    /// let change = |set: &mut TriangleSet| set.move_to(&positions, &triangles);
    /// bvh.refit(Update::Refit, Moved::All, change, TriangleSet::settle)?;
    /// let t = bvh.hit(&Ray::new(Vec3::new(0.2, 0.2, 5.0), Vec3::NEG_Z)).t;
    /// assert!((t - 2.0).abs() < 1e-6);
    /// # Ok::<(), srt::shapes::MeshError>(())
    /// ```
    ///
    /// # Errors
    /// Those of `change` and `settle`. Then neither primitives nor structure are of further use.
    ///
    /// # Panics
    /// If the structure does not offer it: [`Accel::UPDATES`]. If a slot has moved that there is not. If the
    /// structure's order ([`Followed::order`](super::Followed::order)) does not give each primitive its slots.
    pub fn refit<E>(
        &mut self,
        update: Update,
        moved: Moved<'_>,
        change: impl FnOnce(&mut P) -> Result<(), E>,
        settle: impl FnOnce(&mut P, &Aabb) -> Result<(), E>,
    ) -> Result<(), E> {
        assert!(A::UPDATES.contains(&update), "the structure cannot follow primitives in this way");
        change(&mut self.primitives)?;
        if let Moved::Slots(moved) = moved {
            assert_slots(moved, self.primitives.slots());
        }
        let grain = <P::Packs as Packs>::GRAIN;
        let build = Build { config: &self.config, grain, stages: &mut BuildStages::default() };
        let followed = self.accel.refit(update, &self.primitives, moved, &build);
        if let Some(order) = &followed.order {
            assert_keeps_all(order, &self.primitives);
            self.primitives.reorder(order);
        }
        settle(&mut self.primitives, &followed.bounds)
    }

    /// What was built elsewhere, and read: primitives in the order of their structure.
    pub(super) fn loaded(primitives: P, accel: A) -> Self {
        let [build_time, check_time] = [Duration::ZERO; 2];
        let (stages, config) = (BuildStages::default(), BuildConfig::default());
        Self { primitives, accel, build_time, check_time, stages, config }
    }

    /// The structure, for what it offers beside searches. Its slots are those of [`primitives`](Self::primitives).
    #[must_use]
    pub fn accel(&self) -> &A {
        &self.accel
    }

    /// What is searched, to be changed but for its boxes.
    #[cfg(feature = "program")]
    pub(crate) fn primitives_mut(&mut self) -> &mut P {
        &mut self.primitives
    }

    /// What is searched.
    #[must_use]
    pub fn primitives(&self) -> &P {
        &self.primitives
    }

    /// How long the build took, with what it took to put the primitives into their order, and without the checks
    /// of their boxes and of that order.
    #[must_use]
    pub fn build_time(&self) -> Duration {
        self.build_time
    }

    /// How long the checks of the boxes and of the order took, for those who time around the build.
    #[must_use]
    pub fn check_time(&self) -> Duration {
        self.check_time
    }

    /// What the build spent its time on.
    #[must_use]
    pub fn build_stages(&self) -> &BuildStages {
        &self.stages
    }

    /// Bytes of the structure, without the primitives.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        self.accel.bytes()
    }

    /// What the structure looks like, for which a tree is walked.
    #[must_use]
    pub fn shape(&self) -> StructureShape {
        self.accel.shape()
    }

    /// All nodes of the structure, where it is a tree.
    #[must_use]
    pub fn tree(&self) -> Option<Tree> {
        self.accel.tree()
    }

    /// The parts of space that the structure tests rays against; none where it has no boxes.
    #[must_use]
    pub fn regions(&self) -> Regions {
        self.accel.regions()
    }

    /// The first hit of a ray in the order `(t, object, prim)`, or [`Hit::MISS`].
    #[inline]
    #[must_use]
    pub fn hit(&self, ray: &Ray) -> Hit {
        self.search_one(&ClosestHit, ray, &mut NoCounters)
    }

    /// Whether a ray hits anything.
    #[inline]
    #[must_use]
    pub fn occluded(&self, ray: &Ray) -> bool {
        self.search_one(&AnyHit, ray, &mut NoCounters)
    }

    /// Answers a query for many rays, without counting, with the thread's own memory.
    ///
    /// # Panics
    /// If the slices differ in length.
    pub fn answer<Q: Query>(&self, query: &Q, rays: &[Ray], answers: &mut [Q::Answer]) {
        Scratch::of_thread(|scratch| self.search(query, rays, answers, scratch, &mut NoCounters));
    }

    /// Answers a query for one ray.
    #[inline]
    pub fn search_one<Q: Query, C: Counters>(
        &self,
        query: &Q,
        ray: &Ray,
        counters: &mut C,
    ) -> Q::Answer {
        debug_assert!(!ray.is_infinite(), "{}", OUT_OF_RANGE);
        search_one(&self.accel, query, &self.primitives, ray, counters)
    }

    /// Answers a query for many rays.
    ///
    /// # Panics
    /// If the slices differ in length.
    pub fn search<Q: Query, C: Counters>(
        &self,
        query: &Q,
        rays: &[Ray],
        answers: &mut [Q::Answer],
        scratch: &mut Scratch,
        counters: &mut C,
    ) {
        assert_eq!(rays.len(), answers.len(), "an answer for each ray");
        debug_assert!(!rays.iter().any(Ray::is_infinite), "{}", OUT_OF_RANGE);
        self.accel.search(query, &self.primitives, rays, answers, scratch, counters);
    }

    /// [`search`](Self::search), compiled with counters and without.
    fn search_counted<Q: Query>(
        &self,
        query: &Q,
        rays: &[Ray],
        answers: &mut [Q::Answer],
        scratch: &mut Scratch,
        counts: Option<&mut Counts>,
    ) {
        match counts {
            Some(counts) => self.search(query, rays, answers, scratch, counts),
            None => self.search(query, rays, answers, scratch, &mut NoCounters),
        }
    }
}

/// Panics unless all boxes are finite and not empty; the message names the first that is not.
fn assert_sound_boxes<B: Bounded>(source: &B) {
    /// Boxes that a thread looks at together.
    const CHUNK: usize = 1 << 12;
    if const { B::SOUND_BOXES } {
        return;
    }
    let is_sound = |index: &u32| {
        let bounds = source.bounds(*index);
        bounds.min.is_finite() && bounds.max.is_finite() && !bounds.is_empty()
    };
    let each = (0..source.count()).into_par_iter().with_min_len(CHUNK);
    if let Some(index) = each.find_first(|index| !is_sound(index)) {
        let Aabb { min, max } = source.bounds(index);
        panic!("primitive {index} has no finite box: from {min} to {max}");
    }
}

/// Panics if a structure is told of a slot that there is not.
fn assert_slots(moved: &[u32], slots: u32) {
    let wrong = moved.par_iter().with_min_len(1 << 14).find_first(|&&slot| slot >= slots);
    if let Some(slot) = wrong {
        panic!("slot {slot} has moved, and there are {slots}, counted from 0");
    }
}

/// Panics unless an order of slots keeps each primitive.
fn assert_keeps_all<P: Primitives>(order: &[u32], primitives: &P) {
    let (slots, grain) = (primitives.slots(), <P::Packs as Packs>::GRAIN);
    let named = order.par_iter().with_min_len(1 << 14).filter(|&&slot| slot != NONE);
    if let Some(slot) = named.find_first(|&&slot| slot >= slots) {
        panic!("after a refit the order names slot {slot}, and there are {slots}, counted from 0");
    }
    let count = if grain > 1 { primitives.count() } else { slots };
    let primitive_in = |&slot: &u32| match slot {
        NONE => NONE,
        slot if grain > 1 => primitives.packs().id(slot as usize / PACK, slot as usize % PACK),
        slot => slot,
    };
    let ids = Order::References(order.par_iter().map(primitive_in).collect());
    if let Some(fault) = ids.fault(count, grain) {
        panic!("after a refit {fault}");
    }
}

impl<P: Primitives, A: Accel> Tracer for Indexed<P, A> {
    fn trace(
        &self,
        rays: &[Ray],
        answers: Answers<'_>,
        scratch: &mut Scratch,
        counts: Option<&mut Counts>,
    ) {
        match answers {
            Answers::ClosestHit(hits) => {
                self.search_counted(&ClosestHit, rays, hits, scratch, counts);
            }
            Answers::AnyHit(blocked) => {
                self.search_counted(&AnyHit, rays, blocked, scratch, counts);
            }
        }
    }

    fn is_one_by_one(&self) -> bool {
        A::ONE_BY_ONE
    }
}

#[cfg(test)]
mod tests;
