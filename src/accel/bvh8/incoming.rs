//! Rays on their way into a wave: the terms of eight at a time are worked out, a ray in each lane.
//!
//! Most rays meet few boxes, so what a ray costs before its first one counts.

use crate::accel::{PACK, Packs};
use crate::math::{Lanes as _, Lanes3, Mask as _, Padding, Ray};
use crate::simd::{Row as _, Simd};

use super::diverged::{Diverged, DivergedRay};
use super::slab_ray::{LARGEST_PRODUCT, SlabTerms};

/// Rays that are not yet in flight.
pub(super) struct Incoming<'a> {
    rays: &'a [Ray],
    /// Those that begin with the root, by their places in the slice.
    fresh: &'a [u32],
    /// Those that a packet has set aside; they come after the others.
    diverged: &'a Diverged,
    /// How many were taken.
    taken: usize,
    /// How many of them, and of those that come next, have their terms.
    prepared: usize,
}

/// The terms of eight rays.
pub(super) struct Terms<R> {
    /// The rays' places in the slice.
    index: [u32; PACK],
    /// 1/direction, beginning, offsets of near planes, end.
    pub(super) near: [[f32; 8]; PACK],
    /// Offsets of far planes, in the first three.
    pub(super) far: [[f32; 8]; PACK],
    pub(super) formula: [R; PACK],
    /// For each axis, a bit for each ray that runs backwards along it.
    backwards: [u32; 3],
    /// A bit for each ray that has usual terms, because it moves enough along all axes.
    usual: u32,
}

/// A ray that comes next.
pub(super) struct Next<'a> {
    /// Its place in the slice.
    pub(super) index: u32,
    /// Its place among the terms.
    pub(super) lane: usize,
    /// What it has done on its way, if it has begun.
    pub(super) diverged: Option<&'a DivergedRay>,
}

impl<R: Copy + Default> Terms<R> {
    pub(super) const fn room(vacant: R) -> Self {
        Self {
            index: [0; PACK],
            near: [[0.0; 8]; PACK],
            far: [[0.0; 8]; PACK],
            formula: [vacant; PACK],
            backwards: [0; 3],
            usual: 0,
        }
    }
}

impl<R> Terms<R> {
    /// Whether a ray has the usual terms.
    #[inline(always)]
    pub(super) fn are_usual(&self, lane: usize) -> bool {
        self.usual >> lane & 1 != 0
    }

    /// The octant of a ray's direction: a bit for each axis along which it runs backwards.
    #[inline(always)]
    pub(super) fn octant(&self, lane: usize) -> u32 {
        let [x, y, z] = self.backwards;
        x >> lane & 1 | (y >> lane & 1) << 1 | (z >> lane & 1) << 2
    }

    /// Works out the terms of eight rays: those of [`SlabRay::new`](super::slab_ray::SlabRay::new), and those of
    /// the primitives' formula.
    #[inline(always)]
    fn prepare<S: Simd, K: Packs<Ray = R>>(&mut self, rays: &[Ray], padding: Padding) {
        let [origin, dir, inv_dir] = self.prepare_slabs::<S>(rays, padding);
        K::eight_rays::<S>(&origin, &dir, &inv_dir, &mut self.formula);
    }

    /// Works out what the slab test needs. Returns origins, directions, and 1/direction.
    #[inline(always)]
    #[allow(clippy::needless_range_loop, reason = "wide values do not go through iterators")]
    fn prepare_slabs<S: Simd>(&mut self, rays: &[Ray], padding: Padding) -> [Lanes3<S::F8>; 3] {
        let [a, b, c, d, e, f, g, h] = self.index;
        let [ox, oy, oz, t_min, dx, dy, dz, t_max] = S::transpose_eight([
            S::F8::load(&rays[a as usize].to_array()),
            S::F8::load(&rays[b as usize].to_array()),
            S::F8::load(&rays[c as usize].to_array()),
            S::F8::load(&rays[d as usize].to_array()),
            S::F8::load(&rays[e as usize].to_array()),
            S::F8::load(&rays[f as usize].to_array()),
            S::F8::load(&rays[g as usize].to_array()),
            S::F8::load(&rays[h as usize].to_array()),
        ]);
        let (origin, dir): (Lanes3<S::F8>, Lanes3<S::F8>) = ([ox, oy, oz], [dx, dy, dz]);
        let (one, zero) = (S::F8::splat(1.0), S::F8::splat(0.0));
        let inv_dir = [one / dx, one / dy, one / dz];
        let pad = padding.of_rays(ox.abs().max(oy.abs()).max(oz.abs()));
        let (mut near, mut far) = (origin, origin);
        self.usual = u32::MAX;
        for axis in 0..3 {
            let (plus, minus) = (origin[axis] + pad, origin[axis] - pad);
            let backwards = inv_dir[axis].lt(zero).bits();
            let terms = SlabTerms {
                inv_dir: inv_dir[axis],
                near: minus.select(backwards, plus),
                far: plus.select(backwards, minus),
            };
            let product = padding.reach(origin[axis], pad) * inv_dir[axis].abs();
            self.usual &= product.le(S::F8::splat(LARGEST_PRODUCT)).bits();
            self.backwards[axis] = backwards;
            (near[axis], far[axis]) = terms.offsets::<S>(product);
        }
        let [x, y, z] = inv_dir;
        let records = S::transpose_eight([x, y, z, t_min, near[0], near[1], near[2], t_max]);
        for lane in 0..PACK {
            records[lane].store(&mut self.near[lane]);
        }
        let [x, y, z] = far;
        let records = S::transpose_eight([x, y, z, zero, zero, zero, zero, zero]);
        for lane in 0..PACK {
            records[lane].store(&mut self.far[lane]);
        }
        [origin, dir, inv_dir]
    }
}

impl<'a> Incoming<'a> {
    pub(super) fn new(rays: &'a [Ray], fresh: &'a [u32], diverged: &'a Diverged) -> Self {
        Self { rays, fresh, diverged, taken: 0, prepared: 0 }
    }

    /// The next ray, if there is one. Its terms are then among those of eight.
    #[inline(always)]
    pub(super) fn next<S: Simd, K: Packs>(
        &mut self,
        terms: &mut Terms<K::Ray>,
        padding: Padding,
    ) -> Option<Next<'a>> {
        if self.taken == self.prepared {
            if !self.choose(&mut terms.index) {
                return None;
            }
            terms.prepare::<S, K>(self.rays, padding);
        }
        Some(self.take(&terms.index))
    }

    /// Chooses the next eight rays, by their places; returns false if none is left. Of less than eight
    /// the last comes several times.
    #[inline(always)]
    fn choose(&mut self, next: &mut [u32; PACK]) -> bool {
        if let Some(index) = self.fresh[self.taken.min(self.fresh.len())..].first_chunk() {
            *next = *index;
            self.prepared += PACK;
            return true;
        }
        let left = self.fresh.len() + self.diverged.rays().len() - self.taken;
        if left > 0 {
            for (place, index) in next.iter_mut().enumerate() {
                *index = self.ray(self.taken + place.min(left - 1)).0;
            }
        }
        self.prepared += left.min(PACK);
        left > 0
    }

    /// Takes a ray of those that were chosen.
    #[inline(always)]
    fn take(&mut self, chosen: &[u32; PACK]) -> Next<'a> {
        // All but the last eight are whole, so a number begins at the first of them.
        let lane = self.taken % PACK;
        let diverged = self.ray(self.taken).1;
        self.taken += 1;
        Next { index: chosen[lane], lane, diverged }
    }

    /// A ray by its number: its place in the slice, and what it has done if it has begun.
    #[inline(always)]
    fn ray(&self, number: usize) -> (u32, Option<&'a DivergedRay>) {
        match self.fresh.get(number) {
            Some(&index) => (index, None),
            None => {
                let ray = &self.diverged.rays()[number - self.fresh.len()];
                (ray.ray, Some(ray))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::super::node::Child;
    use super::super::slab_ray::{SlabRay, tests::STILL};
    use super::*;
    use crate::math::{BoxRay, Hit, Random};
    use crate::simd::{Kernel, dispatch};

    const PADDING: Padding = Padding { largest: 3.0, factor: 1.0 };

    /// The terms of eight rays, and of each of them alone.
    struct Prepare<'a>(&'a [Ray; PACK], &'a mut Terms<()>);

    impl Kernel for Prepare<'_> {
        type Output = [Option<SlabRay>; PACK];

        #[inline(always)]
        fn run<S: Simd>(self) -> Self::Output {
            let Self(rays, terms) = self;
            terms.prepare_slabs::<S>(rays, PADDING);
            std::array::from_fn(|i| {
                SlabRay::new::<S>(&rays[i], &BoxRay::new(&rays[i], PADDING), PADDING)
            })
        }
    }

    #[test]
    fn eight_rays_have_the_terms_of_each_of_them() {
        let mut random = Random::new(&[23]);
        let mut terms = Terms::room(());
        terms.index = [7, 1, 6, 2, 5, 3, 4, 0];
        let (mut usual, mut others) = (0, 0);
        for _ in 0..2000 {
            let rays: [Ray; PACK] = std::array::from_fn(|_| {
                let mut point =
                    || Vec3::from_array(std::array::from_fn(|_| random.next_f32() - 0.5));
                let (origin, mut dir) = (4.0 * point(), point());
                let still = random.below(20);
                if still < 3 {
                    dir[still as usize] = STILL[random.below(8) as usize];
                }
                Ray::with_interval(origin, dir, random.next_f32(), 9.0 * random.next_f32())
            });
            let alone = dispatch(Prepare(&rays, &mut terms));
            for lane in 0..PACK {
                let index = terms.index[lane] as usize;
                let (ray, Some(slab)) = (&rays[index], alone[index]) else {
                    assert!(!terms.are_usual(lane));
                    others += 1;
                    continue;
                };
                usual += 1;
                assert!(terms.are_usual(lane));
                assert_eq!(terms.octant(lane), slab.octant);
                let [x, y, z] = slab.inv_dir.to_array();
                let [p, q, r] = slab.near.to_array();
                assert_eq!(terms.near[lane], [x, y, z, ray.t_min, p, q, r, ray.t_max]);
                assert_eq!(terms.far[lane][..3], slab.far.to_array());
            }
        }
        assert!(usual > 10_000 && others > 1000, "{usual} {others}");
    }

    #[test]
    fn rays_come_one_after_the_other_those_that_diverged_last() {
        let rays = [Ray::new(Vec3::ZERO, Vec3::ONE); 40];
        let mut diverged = Diverged::default();
        for ray in [3, 1, 20] {
            diverged.add(ray, Hit::MISS, [(Child::ROOT, 0.0)].into_iter());
        }
        for count in [0, 1, 8, 9, 30] {
            let fresh: Vec<u32> = (0..count).map(|i| 39 - i).collect();
            let mut incoming = Incoming::new(&rays, &fresh, &diverged);
            let (mut chosen, mut taken) = ([0; PACK], Vec::new());
            while incoming.taken < incoming.prepared || incoming.choose(&mut chosen) {
                let next = incoming.take(&chosen);
                taken.push((next.index, next.diverged.is_some()));
            }
            let expected: Vec<_> =
                fresh.iter().map(|&i| (i, false)).chain([3, 1, 20].map(|i| (i, true))).collect();
            assert_eq!(taken, expected);
        }
    }
}
