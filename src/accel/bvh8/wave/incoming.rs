//! Rays on their way into a wave: the terms of eight at a time are worked out, a ray in each lane, and written to their
//! slots at once.
//!
//! Most rays meet few boxes, so what a ray costs before its first one counts.

use crate::accel::{PACK, Packs};
use crate::math::{Lanes as _, Lanes3, Mask as _, Padding, Ray, search_ends};
use crate::simd::{Cache, Row as _, Simd, prefetch};

use super::super::diverged::{Diverged, DivergedRay};
use super::super::slab_ray::{LARGEST_PRODUCT, SlabTerms};
use super::root::Columns;
use super::slot::{AT_ROOT, Slot, near_plane, order};

/// So many rays before they come, rays are asked for.
const RAYS_AHEAD: usize = 64;

/// Rays that are not yet in flight.
pub(super) struct Incoming<'a> {
    /// Those that begin with the root, by their places in the slice.
    fresh: &'a [u32],
    /// Those that a packet has set aside; they come after the others.
    diverged: &'a Diverged,
    /// How many were taken.
    taken: usize,
}

/// Up to eight rays that come next.
pub(super) struct Eight {
    /// Their places in the slice. If they are fewer, the last one comes several times.
    pub(super) index: [u32; PACK],
    /// How many they are.
    pub(super) count: usize,
    /// The number of the first of them, among all that come.
    number: usize,
}

/// The terms of eight rays: the first two rows of their [`Slot`]s.
pub(super) struct Terms<S: Simd> {
    near: [S::F8; PACK],
    far: [S::F8; PACK],
    /// A bit for each ray that has usual terms, because it moves enough along all axes, and not infinitely fast.
    pub(super) usual: u32,
}

impl<S: Simd> Terms<S> {
    /// Works out the terms of eight rays: those of [`SlabRay::new`](super::super::slab_ray::SlabRay::new), and those of
    /// the primitives' formula. The former come by ray and by axis.
    #[inline(always)]
    pub(super) fn new<K: Packs>(
        index: &[u32; PACK],
        rays: &[Ray],
        padding: Padding,
        formula: &mut [K::Ray; PACK],
    ) -> (Self, Columns<S>) {
        let (terms, columns, [origin, dir]) = Self::of_slabs(index, rays, padding);
        K::eight_rays::<S>(&origin, &dir, &columns.inv_dir, formula);
        (terms, columns)
    }

    /// Begins one of them in a slot: its terms, those of the formula, and its number.
    #[inline(always)]
    pub(super) fn begin<R: Copy>(
        &self,
        lane: usize,
        slot: &mut Slot<R>,
        formulas: &[R; PACK],
        index: &[u32; PACK],
    ) {
        let lane = lane % PACK;
        self.near[lane].store(&mut slot.near);
        self.far[lane].store(&mut slot.far);
        slot.formula = formulas[lane];
        slot.take_up(index[lane]);
    }

    /// Works out what the slab test needs. Returns origins and directions, too.
    #[inline(always)]
    #[allow(clippy::needless_range_loop, reason = "wide values do not go through iterators")]
    pub(super) fn of_slabs(
        &[a, b, c, d, e, f, g, h]: &[u32; PACK],
        rays: &[Ray],
        padding: Padding,
    ) -> (Self, Columns<S>, [Lanes3<S::F8>; 2]) {
        let [ox, oy, oz, t_min, dx, dy, dz, t_max] = S::F8::of_records([
            rays[a as usize].as_array(),
            rays[b as usize].as_array(),
            rays[c as usize].as_array(),
            rays[d as usize].as_array(),
            rays[e as usize].as_array(),
            rays[f as usize].as_array(),
            rays[g as usize].as_array(),
            rays[h as usize].as_array(),
        ]);
        let t_max = search_ends(t_max);
        let (origin, dir): (Lanes3<S::F8>, Lanes3<S::F8>) = ([ox, oy, oz], [dx, dy, dz]);
        let (one, zero) = (S::F8::splat(1.0), S::F8::splat(0.0));
        let inv_dir = [one / dx, one / dy, one / dz];
        let pad = padding.of_rays(ox.abs().max(oy.abs()).max(oz.abs()));
        let (mut near, mut far, mut planes) = (origin, origin, origin);
        let (mut low, mut high) = (origin, origin);
        let mut usual = u32::MAX;
        let mut orders = [zero; 8];
        for octant in 0..8 {
            orders[octant] = S::F8::splat(order(octant as u32));
        }
        for axis in 0..3 {
            let (plus, minus) = (origin[axis] + pad, origin[axis] - pad);
            let backwards = inv_dir[axis].lt(zero).bits();
            let terms = SlabTerms {
                inv_dir: inv_dir[axis],
                near: minus.select(backwards, plus),
                far: plus.select(backwards, minus),
            };
            let product = padding.reach(origin[axis], pad) * inv_dir[axis].abs();
            let is_usual = product.le(S::F8::splat(LARGEST_PRODUCT)) & zero.lt(inv_dir[axis].abs());
            usual &= is_usual.bits();
            (near[axis], far[axis]) = terms.offsets::<S>(product);
            low[axis] = far[axis].select(backwards, near[axis]);
            high[axis] = near[axis].select(backwards, far[axis]);
            let [ahead, back] = [near_plane(axis, false), near_plane(axis, true)];
            planes[axis] = S::F8::splat(back).select(backwards, S::F8::splat(ahead));
            // Half as many octants are left.
            for octant in 0..4 >> axis {
                orders[octant] = orders[2 * octant + 1].select(backwards, orders[2 * octant]);
            }
        }
        let [x, y, z] = inv_dir;
        let near = S::transpose_eight([x, y, z, t_min, near[0], near[1], near[2], t_max]);
        let [x, y, z] = far;
        let at_root = S::F8::splat(AT_ROOT);
        let [a, b, c] = planes;
        let far = S::transpose_eight([x, y, z, at_root, a, b, c, orders[0]]);
        let columns = Columns { inv_dir, low, high, searched: [t_min, t_max] };
        (Self { near, far, usual }, columns, [origin, dir])
    }
}

impl<'a> Incoming<'a> {
    pub(super) fn new(fresh: &'a [u32], diverged: &'a Diverged) -> Self {
        Self { fresh, diverged, taken: 0 }
    }

    /// The next eight rays, or those that are left; `None` if there are none.
    #[inline(always)]
    pub(super) fn next_eight(&mut self) -> Option<Eight> {
        let number = self.taken;
        if let Some(index) = self.fresh[number.min(self.fresh.len())..].first_chunk() {
            self.taken += PACK;
            return Some(Eight { index: *index, count: PACK, number });
        }
        let left = self.fresh.len() + self.diverged.rays().len() - number;
        let count = left.min(PACK);
        self.taken += count;
        let mut index = [0; PACK];
        for (place, index) in index.iter_mut().enumerate().take(PACK * usize::from(left > 0)) {
            *index = self.ray(number + place.min(count - 1)).0;
        }
        (left > 0).then_some(Eight { index, count, number })
    }

    /// Asks for rays that come soon after these.
    #[inline(always)]
    pub(super) fn prefetch_ahead(&self, eight: &Eight, rays: &[Ray]) {
        // Fresh rays are neighbours, mostly.
        if let Some(&first) = self.fresh.get(eight.number + RAYS_AHEAD)
            && let Some(ahead) = rays[first as usize..].first_chunk::<PACK>()
        {
            prefetch(ahead, Cache::First);
        }
    }

    /// What one of eight rays has done on its way, if it has begun.
    #[inline(always)]
    pub(super) fn diverged(&self, eight: &Eight, lane: usize) -> Option<&'a DivergedRay> {
        self.ray(eight.number + lane).1
    }

    /// Whether all of eight rays begin with the root.
    #[inline(always)]
    pub(super) fn are_fresh(&self, eight: &Eight) -> bool {
        eight.number + eight.count <= self.fresh.len()
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

    use super::super::super::node::{Child, near_planes, order_shift};
    use super::super::super::slab_ray::{SlabRay, tests::STILL};
    use super::*;
    use crate::math::{BoxRay, Hit, Random};
    use crate::simd::{Kernel, dispatch};

    const PADDING: Padding = Padding { largest: 3.0, factor: 1.0 };

    /// The terms of eight rays, and of each of them alone.
    struct Prepare<'a>(&'a [u32; PACK], &'a [Ray; PACK]);

    /// The two rows of each ray, which of them are usual, and what each is alone.
    type Prepared = ([[[f32; PACK]; 2]; PACK], u32, [Option<SlabRay>; PACK]);

    impl Kernel for Prepare<'_> {
        type Output = Prepared;

        #[inline(always)]
        fn run<S: Simd>(self) -> Prepared {
            let Self(index, rays) = self;
            let (terms, ..) = Terms::<S>::of_slabs(index, rays, PADDING);
            let mut rows = [[[0.0; PACK]; 2]; PACK];
            for (lane, [near, far]) in rows.iter_mut().enumerate() {
                terms.near[lane].store(near);
                terms.far[lane].store(far);
            }
            let alone = std::array::from_fn(|i| {
                SlabRay::new::<S>(&rays[i], &BoxRay::new(&rays[i], PADDING), PADDING)
            });
            (rows, terms.usual, alone)
        }
    }

    #[test]
    fn eight_rays_have_the_terms_of_each_of_them() {
        let mut random = Random::new(&[23]);
        let order = [7, 1, 6, 2, 5, 3, 4, 0];
        let (mut usual, mut others) = (0, 0);
        for _ in 0..2000 {
            let rays: [Ray; PACK] = std::array::from_fn(|_| {
                let mut point =
                    || Vec3::from_array(std::array::from_fn(|_| random.next_f32() - 0.5));
                let (origin, mut dir) = (4.0 * point(), point());
                let still = random.below(20);
                if still < 3 {
                    dir[still as usize] = STILL[random.below(8) as usize];
                } else if still == 3 {
                    dir[random.below(3) as usize] = f32::NEG_INFINITY;
                }
                let end = if random.below(4) > 0 { 9.0 * random.next_f32() } else { f32::INFINITY };
                Ray::with_interval(origin, dir, random.next_f32(), end)
            });
            let (rows, of_usual, alone) = dispatch(Prepare(&order, &rays));
            for (lane, [near, far]) in rows.into_iter().enumerate() {
                let index = order[lane] as usize;
                let (ray, Some(slab)) = (&rays[index], alone[index]) else {
                    assert!(of_usual >> lane & 1 == 0);
                    others += 1;
                    continue;
                };
                usual += 1;
                assert!(of_usual >> lane & 1 == 1);
                let [x, y, z] = slab.inv_dir.to_array();
                let [p, q, r] = slab.near.to_array();
                assert_eq!(near, [x, y, z, ray.t_min, p, q, r, ray.end()]);
                assert_eq!(far[..3], slab.far.to_array());
                let [a, b, c] = near_planes(slab.octant);
                let bits = [1, a, b, c, order_shift(slab.octant)];
                assert_eq!(far[3..].iter().map(|x| x.to_bits()).collect::<Vec<_>>(), bits);
            }
        }
        assert!(usual > 10_000 && others > 1000, "{usual} {others}");
    }

    #[test]
    fn rays_come_one_after_the_other_those_that_diverged_last() {
        let mut diverged = Diverged::default();
        for ray in [3, 1, 20] {
            diverged.add(ray, Hit::MISS, [(Child::ROOT, 0.0)].into_iter());
        }
        for count in [0, 1, 8, 9, 30] {
            let fresh: Vec<u32> = (0..count).map(|i| 39 - i).collect();
            let mut incoming = Incoming::new(&fresh, &diverged);
            let mut taken = Vec::new();
            while let Some(eight) = incoming.next_eight() {
                assert!(
                    eight.index[eight.count..].iter().all(|&i| i == eight.index[eight.count - 1])
                );
                let begun = |lane| incoming.diverged(&eight, lane).is_some();
                assert_eq!(incoming.are_fresh(&eight), !(0..eight.count).any(begun));
                taken.extend((0..eight.count).map(|lane| (eight.index[lane], begun(lane))));
            }
            let expected: Vec<_> =
                fresh.iter().map(|&i| (i, false)).chain([3, 1, 20].map(|i| (i, true))).collect();
            assert_eq!(taken, expected);
        }
    }
}
