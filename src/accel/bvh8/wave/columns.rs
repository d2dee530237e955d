//! What is worked out for eight rays at a time, a ray in each lane, before they take slots.
//!
//! Most rays meet few boxes, so what a ray costs before its first one counts.

use crate::accel::PACK;
use crate::math::{Lanes as _, Lanes3, Mask as _, Padding, Ray, search_ends};
use crate::simd::{Row as _, Simd};

use super::super::slab_ray::{LARGEST_PRODUCT, SlabTerms};
use super::slot::{AT_ROOT, Slot, near_plane, order};

/// Eight rays, a ray in each lane.
pub(super) struct Columns<S: Simd> {
    pub(super) origin: Lanes3<S::F8>,
    pub(super) dir: Lanes3<S::F8>,
    pub(super) inv_dir: Lanes3<S::F8>,
    /// What the smaller planes are measured from: near ones for rays that run forwards, far ones for others.
    pub(super) low: Lanes3<S::F8>,
    /// What the larger planes are measured from.
    pub(super) high: Lanes3<S::F8>,
    /// The beginning and the end of the search.
    pub(super) searched: [S::F8; 2],
}

/// How many rows [`Columns`] are.
pub(super) const COLUMNS: usize = 17;

/// The terms of eight rays: the first two rows of their [`Slot`]s.
pub(super) struct Terms<S: Simd> {
    near: [S::F8; PACK],
    far: [S::F8; PACK],
}

impl<S: Simd> Columns<S> {
    /// The rays at eight places, and a bit for each that has usual terms, because it moves enough along all axes, and
    /// not infinitely fast.
    #[inline(always)]
    pub(super) fn new(
        &[a, b, c, d, e, f, g, h]: &[u32; PACK],
        rays: &[Ray],
        padding: Padding,
    ) -> (Self, u32) {
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
        let searched = [t_min, search_ends(t_max)];
        let (origin, dir): (Lanes3<S::F8>, Lanes3<S::F8>) = ([ox, oy, oz], [dx, dy, dz]);
        let (one, zero) = (S::F8::splat(1.0), S::F8::splat(0.0));
        let inv_dir = [one / dx, one / dy, one / dz];
        let pad = padding.of_rays(ox.abs().max(oy.abs()).max(oz.abs()));
        let (mut low, mut high) = (origin, origin);
        let mut usual = u32::MAX;
        for axis in 0..3 {
            let size = inv_dir[axis].abs();
            let product = padding.reach(origin[axis], pad) * size;
            usual &= (product.le(S::F8::splat(LARGEST_PRODUCT)) & zero.lt(size)).bits();
            // Near planes are the smaller ones of rays that run forwards.
            let slack = SlabTerms::slack(product).flipped_by(inv_dir[axis]);
            let terms = SlabTerms {
                inv_dir: inv_dir[axis],
                near: origin[axis] + pad,
                far: origin[axis] - pad,
            };
            (low[axis], high[axis]) = terms.offsets_with::<S>(slack);
        }
        (Self { origin, dir, inv_dir, low, high, searched }, usual)
    }

    /// All rows.
    #[inline(always)]
    pub(super) fn rows(&self) -> [S::F8; COLUMNS] {
        let Self { origin: [a, b, c], dir: [d, e, f], inv_dir: [g, h, i], .. } = *self;
        let Self { low: [j, k, l], high: [m, n, o], searched: [p, q], .. } = *self;
        [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q]
    }

    /// Those of these rows, in the order of [`rows`](Self::rows).
    #[inline(always)]
    pub(super) fn of_rows(
        [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q]: [S::F8; COLUMNS],
    ) -> Self {
        let (origin, dir, inv_dir) = ([a, b, c], [d, e, f], [g, h, i]);
        Self { origin, dir, inv_dir, low: [j, k, l], high: [m, n, o], searched: [p, q] }
    }

    /// The terms of the rays: those of [`SlabRay::new`](super::super::slab_ray::SlabRay::new).
    #[inline(always)]
    #[allow(clippy::needless_range_loop, reason = "wide values do not go through iterators")]
    pub(super) fn terms(&self) -> Terms<S> {
        let zero = S::F8::splat(0.0);
        let (mut near, mut far, mut planes) = (self.low, self.high, self.low);
        let mut orders = [zero; 8];
        for octant in 0..8 {
            orders[octant] = S::F8::splat(order(octant as u32));
        }
        for axis in 0..3 {
            let backwards = self.inv_dir[axis].lt(zero);
            let (low, high) = (self.low[axis], self.high[axis]);
            near[axis] = high.select_where(backwards, low);
            far[axis] = low.select_where(backwards, high);
            let [ahead, back] = [near_plane(axis, false), near_plane(axis, true)];
            planes[axis] = S::F8::splat(back).select_where(backwards, S::F8::splat(ahead));
            // Half as many octants are left.
            for octant in 0..4 >> axis {
                orders[octant] = orders[2 * octant + 1].select_where(backwards, orders[2 * octant]);
            }
        }
        let ([x, y, z], [t_min, t_max]) = (self.inv_dir, self.searched);
        let near = S::transpose_eight([x, y, z, t_min, near[0], near[1], near[2], t_max]);
        let [x, y, z] = far;
        let at_root = S::F8::splat(AT_ROOT);
        let [a, b, c] = planes;
        let far = S::transpose_eight([x, y, z, at_root, a, b, c, orders[0]]);
        Terms { near, far }
    }
}

impl<S: Simd> Terms<S> {
    /// Begins one of the rays in a slot: its terms, those of the formula, and its number.
    #[inline(always)]
    pub(super) fn begin<R: Copy>(
        &self,
        lane: usize,
        slot: &mut Slot<R>,
        formulas: &[R; PACK],
        ray: u32,
    ) {
        let lane = lane % PACK;
        self.near[lane].store(&mut slot.near);
        self.far[lane].store(&mut slot.far);
        slot.formula = formulas[lane];
        slot.take_up(ray);
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::super::super::node::{near_planes, order_shift};
    use super::super::super::slab_ray::{SlabRay, tests::STILL};
    use super::*;
    use crate::math::{BoxRay, Random};
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
            let (columns, usual) = Columns::<S>::new(index, rays, PADDING);
            let terms = columns.terms();
            let mut rows = [[[0.0; PACK]; 2]; PACK];
            for (lane, [near, far]) in rows.iter_mut().enumerate() {
                terms.near[lane].store(near);
                terms.far[lane].store(far);
            }
            let alone = std::array::from_fn(|i| {
                SlabRay::new::<S>(&rays[i], &BoxRay::new(&rays[i], PADDING), PADDING)
            });
            (rows, usual, alone)
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
}
