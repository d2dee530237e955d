//! What a leaf offers one ray.

use crate::accel::{PACK, Packs, Primitives, Query, Search};
use crate::math::slab::{meets, not_before};
use crate::math::{BoxRay, Hit, Lanes as _, Mask as _, Ray, ones, within};
use crate::simd::{Row as _, Simd};

use super::task::{RayOf, Task};

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

    /// Tests a ray with all primitives of a block, and notes those that it may hit within `searched`. Returns whether
    /// there are any.
    #[inline(always)]
    pub(super) fn test<S: Simd, P: Primitives, Q: Query>(
        &mut self,
        task: &Task<'_, P, Q>,
        block: usize,
        (rays, ray): (&[Ray], usize),
        formula: &RayOf<P>,
        [t_min, end]: [f32; 2],
    ) -> bool {
        let mut hits = task.packs.test_pack::<S>(block, formula);
        for lane in ones(hits.flat()) {
            hits.replace(lane, task.packs.flat_hit(block, lane, &rays[ray]));
        }
        let t = hits.t / hits.scale;
        let in_reach = within(t, [S::F8::splat(t_min), S::F8::splat(end)]);
        (self.lanes, self.block) = ((hits.inside & in_reach).bits(), block as u32);
        t.store(&mut self.t);
        if const { !matches!(Q::SEARCH, Search::First) || Q::FILTERS } {
            hits.u.store(&mut self.u);
            hits.v.store(&mut self.v);
            hits.scale.store(&mut self.scale);
        }
        self.lanes != 0
    }

    /// A candidate as a hit at a parameter.
    #[inline(always)]
    fn hit(&self, lane: usize, t: f32, packs: &impl Packs) -> Hit {
        let scale = self.scale[lane];
        Hit {
            t,
            object: 0,
            prim: packs.id(self.block as usize, lane),
            u: self.u[lane] / scale,
            v: self.v[lane] / scale,
        }
    }

    /// Those that count by their own boxes, a bit for each, and where they do.
    #[inline(always)]
    fn placed<S: Simd, P: Primitives, Q: Query>(
        &self,
        task: &Task<'_, P, Q>,
        ray: &Ray,
        [t_min, end]: [f32; 2],
    ) -> (u32, S::F8) {
        // Most rays come here once at most: not kept.
        let box_ray = BoxRay::new(ray, task.padding);
        let (begin, leave) = box_ray.intervals(task.packs.boxes::<S>(self.block as usize));
        let searched = [S::F8::splat(t_min), S::F8::splat(end)];
        let lanes = self.lanes & meets([begin, leave], searched).bits();
        (lanes, not_before(S::F8::load(&self.t), begin))
    }

    /// Whether the query accepts a candidate at a parameter.
    #[inline(always)]
    fn is_accepted<P: Primitives, Q: Query>(
        &self,
        task: &Task<'_, P, Q>,
        (lane, t): (usize, f32),
        ray: &Ray,
    ) -> bool {
        !Q::FILTERS || task.query.accepts(ray, &self.hit(lane, t, task.packs))
    }

    /// Whether any candidate counts.
    #[inline(always)]
    pub(super) fn any_counts<S: Simd, P: Primitives, Q: Query>(
        &self,
        task: &Task<'_, P, Q>,
        ray: &Ray,
        searched: [f32; 2],
    ) -> bool {
        let (lanes, at) = self.placed::<S, P, Q>(task, ray, searched);
        let mut t = [0.0; PACK];
        at.store(&mut t);
        ones(lanes).any(|lane| self.is_accepted(task, (lane % PACK, t[lane % PACK]), ray))
    }

    /// Hands over the first candidate that counts, as a hit. Returns whether there is one.
    #[inline(always)]
    pub(super) fn first<S: Simd, P: Primitives, Q: Query>(
        &self,
        task: &Task<'_, P, Q>,
        ray: &Ray,
        searched: [f32; 2],
        offer: impl FnOnce(&Hit),
    ) -> bool {
        let (mut lanes, at) = self.placed::<S, P, Q>(task, ray, searched);
        // Apart from what it was before: what a masked store has just written is not handed on to loads (AMD).
        let mut t = [0.0; PACK];
        at.store(&mut t);
        while lanes != 0 {
            // Ids ascend within a pack: the first of equal lanes is the one that counts.
            let lane = at.first_smallest(lanes) % PACK;
            if self.is_accepted(task, (lane, t[lane]), ray) {
                offer(&self.hit(lane, t[lane], task.packs));
                return true;
            }
            lanes &= !(1 << lane);
        }
        false
    }
}
