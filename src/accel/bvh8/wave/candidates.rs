//! What a leaf offers a ray of a wave.

use crate::accel::{PACK, PackHits, Packs, Primitives, Query};
use crate::math::slab::{meets, not_before};
use crate::math::{BoxRay, Hit, Lanes as _, Mask as _, Ray, ones};
use crate::simd::{Row as _, Simd};

use super::super::task::Task;
use super::RayOf;
use super::slot::Slot;

/// The hits of a leaf that a ray may have, before the primitives' own boxes are consulted.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub(super) struct Candidates {
    t: [f32; PACK],
    u: [f32; PACK],
    v: [f32; PACK],
    scale: [f32; PACK],
    lanes: u32,
    block: u32,
}

impl Candidates {
    pub(super) const NONE: Self = Self {
        t: [0.0; PACK],
        u: [0.0; PACK],
        v: [0.0; PACK],
        scale: [0.0; PACK],
        lanes: 0,
        block: 0,
    };

    /// Notes the hits of some lanes of a block, at these parameters.
    #[inline(always)]
    pub(super) fn set<S: Simd>(&mut self, t: S::F8, lanes: u32, block: usize) {
        t.store(&mut self.t);
        (self.lanes, self.block) = (lanes, block as u32);
    }

    /// Notes the coordinates of hits, and what they are to be divided by.
    #[inline(always)]
    pub(super) fn set_coordinates<S: Simd>(&mut self, hits: &PackHits<S::F8>) {
        hits.u.store(&mut self.u);
        hits.v.store(&mut self.v);
        hits.scale.store(&mut self.scale);
    }

    /// A candidate as a hit.
    #[inline(always)]
    fn hit(&self, lane: usize, packs: &impl Packs) -> Hit {
        let scale = self.scale[lane];
        Hit {
            t: self.t[lane],
            object: 0,
            prim: packs.id(self.block as usize, lane),
            u: self.u[lane] / scale,
            v: self.v[lane] / scale,
        }
    }

    /// Takes those out that do not count by their own boxes, and puts the others where they count.
    #[inline(always)]
    fn place<S: Simd, P: Primitives, Q: Query>(
        &mut self,
        slot: &Slot<RayOf<P>>,
        task: &Task<'_, P, Q>,
        rays: &[Ray],
    ) {
        // Most rays come here once at most: not kept in the slot.
        let box_ray = BoxRay::new(&rays[slot.ray as usize], task.padding);
        let (begin, leave) = box_ray.intervals(task.packs.boxes::<S>(self.block as usize));
        let searched = [S::F8::splat(slot.t_min()), S::F8::splat(slot.end())];
        self.lanes &= meets([begin, leave], searched).bits();
        not_before(S::F8::load(&self.t), begin).store(&mut self.t);
    }

    /// Whether the query accepts a candidate.
    #[inline(always)]
    fn is_accepted<P: Primitives, Q: Query>(
        &self,
        lane: usize,
        ray: u32,
        task: &Task<'_, P, Q>,
        rays: &[Ray],
    ) -> bool {
        !Q::FILTERS || task.query.accepts(&rays[ray as usize], &self.hit(lane, task.packs))
    }

    /// Whether any candidate counts.
    #[inline(always)]
    pub(super) fn any_accepted<S: Simd, P: Primitives, Q: Query>(
        &mut self,
        slot: &Slot<RayOf<P>>,
        task: &Task<'_, P, Q>,
        rays: &[Ray],
    ) -> bool {
        self.place::<S, P, Q>(slot, task, rays);
        ones(self.lanes).any(|lane| self.is_accepted(lane % PACK, slot.ray, task, rays))
    }

    /// Replaces a ray's best hit by the first candidate that counts, if that comes before. Returns
    /// whether there is one.
    #[inline(always)]
    pub(super) fn improve<S: Simd, P: Primitives, Q: Query>(
        &mut self,
        slot: &mut Slot<RayOf<P>>,
        task: &Task<'_, P, Q>,
        rays: &[Ray],
    ) -> bool {
        self.place::<S, P, Q>(slot, task, rays);
        let t = S::F8::load(&self.t);
        let mut lanes = self.lanes;
        while lanes != 0 {
            // Ids ascend within a pack: the first of equal lanes is the one that counts.
            let lane = t.first_smallest(lanes) % PACK;
            if self.is_accepted(lane, slot.ray, task, rays) {
                slot.offer(&self.hit(lane, task.packs));
                return true;
            }
            lanes &= !(1 << lane);
        }
        false
    }
}
