//! A packet of coherent rays as boxes see it: a ray in each lane, and what bounds all of them.
//!
//! The slab test with the smallest and the largest of the rays' terms bounds that of every ray from
//! below and above, because each of its operations is monotone.

use crate::accel::PACK;
use crate::math::slab::{crossing, cut_to_finite, meets, not_before};
use crate::math::{Lanes, Lanes3, Mask as _, Padding, Ray, search_ends};
use crate::simd::{Row, Simd};

use super::super::node::{FAR, Node, near_planes};
use super::super::slab_ray::{LARGEST_PRODUCT, SlabTerms};

/// A bit for each of the lanes of a row.
pub(super) const fn all(rays: usize) -> u32 {
    u32::MAX >> (32 - rays)
}

/// Rays of one octant, a ray in each lane.
pub(in crate::accel::bvh8) struct Packet<S: Simd, R: Row<N>, const N: usize> {
    pub(super) origin: Lanes3<R>,
    pub(super) dir: Lanes3<R>,
    pub(super) inv_dir: Lanes3<R>,
    /// The padded origins that near and far planes are measured from: `BoxRay`'s terms.
    pub(super) near: Lanes3<R>,
    pub(super) far: Lanes3<R>,
    /// The factors of [`Row::slab`]: `inv_dir`, but where they are cut.
    pub(super) slab_inv_dir: Lanes3<R>,
    /// The offsets of [`Row::slab`].
    pub(super) near_offset: Lanes3<R>,
    pub(super) far_offset: Lanes3<R>,
    pub(super) t_min: R,
    pub(super) octant: u32,
    pub(super) hull: Hull<S>,
}

/// What bounds the slab test of all rays of a packet.
pub(super) struct Hull<S: Simd> {
    /// The padded origins that give the earliest entry and the latest exit.
    pub(super) near: Lanes3<S::F8>,
    pub(super) far: Lanes3<S::F8>,
    /// The smallest and the largest inverse directions.
    pub(super) inv_dir: [Lanes3<S::F8>; 2],
    pub(super) t_min: S::F8,
}

impl<S: Simd, R: Row<N>, const N: usize> Packet<S, R, N> {
    /// One that holds no rays yet.
    #[inline(always)]
    pub(in crate::accel::bvh8) fn vacant() -> Self {
        let (row, eight) = ([R::splat(0.0); 3], [S::F8::splat(0.0); 3]);
        Self {
            origin: row,
            dir: row,
            inv_dir: row,
            near: row,
            far: row,
            slab_inv_dir: row,
            near_offset: row,
            far_offset: row,
            t_min: row[0],
            octant: 0,
            hull: Hull { near: eight, far: eight, inv_dir: [eight; 2], t_min: eight[0] },
        }
    }

    /// Lays out rays where others were, or returns `None` if their directions are not all of one octant. Returns the
    /// rays' ends, and whether the usual terms will do: else they must be [`cut`](Self::cut).
    #[inline(always)]
    pub(super) fn load(&mut self, rays: &[Ray; N], padding: Padding) -> Option<(R, bool)> {
        let rows = R::of_records(rays.each_ref().map(Ray::as_array));
        let (origin, dir) = ([rows[0], rows[1], rows[2]], [rows[4], rows[5], rows[6]]);
        let (one, zero) = (R::splat(1.0), R::splat(0.0));
        let inv_dir = [one / dir[0], one / dir[1], one / dir[2]];
        let mut octant = 0;
        let mut mixed = false;
        for (axis, inv) in inv_dir.iter().enumerate() {
            let backwards = inv.le(zero).bits();
            mixed |= backwards != 0 && backwards != all(N);
            octant |= (backwards & 1) << axis;
        }
        // An end that is no number would be the end of all.
        if mixed || rows[3].le(rows[7]).bits() != all(N) {
            return None;
        }
        let pad = padding.of_rays(origin[0].abs().max(origin[1].abs()).max(origin[2].abs()));
        (self.origin, self.dir, self.inv_dir) = (origin, dir, inv_dir);
        (self.t_min, self.octant) = (rows[3], octant);
        self.hull.t_min = S::F8::splat(self.t_min.smallest());
        let mut fits = all(N);
        for axis in 0..3 {
            let (plus, minus) = (origin[axis] + pad, origin[axis] - pad);
            let backwards = octant >> axis & 1 != 0;
            let (near, far) = if backwards { (minus, plus) } else { (plus, minus) };
            let terms = SlabTerms { inv_dir: inv_dir[axis], near, far };
            let product = padding.reach(origin[axis], pad) * inv_dir[axis].abs();
            let fits_axis = product.le(R::splat(LARGEST_PRODUCT)) & zero.lt(inv_dir[axis].abs());
            fits &= fits_axis.bits();
            self.near[axis] = near;
            self.far[axis] = far;
            self.set_slab(axis, terms, product);
        }
        Some((search_ends(rows[7]), fits == all(N)))
    }

    /// Notes the terms of the slab test of an axis; `product` is the reach times the inverse
    /// direction.
    #[inline(always)]
    pub(super) fn set_slab(&mut self, axis: usize, terms: SlabTerms<R>, product: R) {
        let SlabTerms { inv_dir, near, far } = terms;
        self.slab_inv_dir[axis] = inv_dir;
        (self.near_offset[axis], self.far_offset[axis]) = terms.offsets::<S>(product);
        let (first, last) = if self.octant >> axis & 1 != 0 {
            (near.smallest(), far.largest())
        } else {
            (near.largest(), far.smallest())
        };
        self.hull.near[axis] = S::F8::splat(first);
        self.hull.far[axis] = S::F8::splat(last);
        self.hull.inv_dir[0][axis] = S::F8::splat(inv_dir.smallest());
        self.hull.inv_dir[1][axis] = S::F8::splat(inv_dir.largest());
    }

    /// Takes up terms that serve where some rays hardly move along an axis. Returns false if they do
    /// not serve for all rays, or if a ray is no number.
    #[inline(always)]
    pub(super) fn cut(&mut self, padding: Padding) -> bool {
        let origin = &self.origin;
        let pad = padding.of_rays(origin[0].abs().max(origin[1].abs()).max(origin[2].abs()));
        let zero = R::splat(0.0);
        let (mut bounded, mut gives_bound) = (all(N), 0);
        for axis in 0..3 {
            let reach = padding.reach(self.origin[axis], pad);
            bounded &= zero.le(reach * self.inv_dir[axis].abs()).bits();
            let inv_dir = cut_to_finite(self.inv_dir[axis]);
            let (near, far) = (self.near[axis], self.far[axis]);
            let cut = SlabTerms { inv_dir, near, far }.cut(reach);
            bounded &= cut.bounded;
            gives_bound |= cut.gives_bound;
            self.inv_dir[axis] = inv_dir;
            self.set_slab(axis, cut.terms, cut.product);
        }
        bounded & gives_bound == all(N)
    }

    /// The rows of [`Boxes`] that hold the near planes; the far ones are beside them.
    #[inline(always)]
    pub(super) fn near_rows(&self) -> [usize; 3] {
        let row = |axis: usize| 2 * axis + (self.octant >> axis & 1) as usize;
        [row(0), row(1), row(2)]
    }

    /// What the intervals of all rays in a node's eight boxes lie in.
    #[inline(always)]
    pub(super) fn hull_of_node(&self, node: &Node, end: S::F8) -> (S::F8, S::F8) {
        let [x, y, z] = near_planes(self.octant);
        self.hull.interval(
            [node.planes::<S>(x), node.planes::<S>(y), node.planes::<S>(z)],
            [node.planes::<S>(x ^ FAR), node.planes::<S>(y ^ FAR), node.planes::<S>(z ^ FAR)],
            end,
        )
    }

    /// Where each ray meets a child's plane along an axis.
    #[inline(always)]
    pub(super) fn slab(&self, plane: f32, axis: usize, offsets: &Lanes3<R>) -> R {
        R::slab(R::splat(plane), self.slab_inv_dir[axis], offsets[axis])
    }

    /// Where each ray enters and leaves a box.
    #[inline(always)]
    pub(super) fn interval(&self, node: &Node, lane: usize, end: R) -> (R, R) {
        let [x, y, z] = near_planes(self.octant);
        let (near, far) = (&self.near_offset, &self.far_offset);
        let begin =
            self.slab(node.plane(x, lane), 0, near).max(self.slab(node.plane(y, lane), 1, near));
        let leave = self.slab(node.plane(x ^ FAR, lane), 0, far).min(self.slab(
            node.plane(y ^ FAR, lane),
            1,
            far,
        ));
        (
            begin.max(self.slab(node.plane(z, lane), 2, near).max(self.t_min)),
            leave.min(self.slab(node.plane(z ^ FAR, lane), 2, far).min(end)),
        )
    }

    /// A product of `BoxRay::interval`: of the near planes, or of the far ones.
    #[inline(always)]
    pub(super) fn product(&self, plane: f32, origin: &Lanes3<R>, axis: usize) -> R {
        crossing(R::splat(plane), origin[axis], self.inv_dir[axis])
    }

    /// Where hits that the formula puts at `t` count, and which do before `end`, by a primitive's own box:
    /// [`BoxRay::begin`](crate::math::BoxRay::begin).
    #[inline(always)]
    pub(super) fn placed(&self, boxes: &Boxes, lane: usize, t: R, end: R) -> (R, u32) {
        let [x, y, z] = self.near_rows();
        let (near, far) = (&self.near, &self.far);
        let begin = self
            .product(boxes.plane(x, lane), near, 0)
            .max(self.product(boxes.plane(y, lane), near, 1))
            .max(self.product(boxes.plane(z, lane), near, 2));
        let leave = self
            .product(boxes.plane(x ^ 1, lane), far, 0)
            .min(self.product(boxes.plane(y ^ 1, lane), far, 1))
            .min(self.product(boxes.plane(z ^ 1, lane), far, 2));
        (not_before(t, begin), meets([begin, leave], [self.t_min, end]).bits())
    }
}

/// The own boxes of a leaf's primitives, written down so that one box, or one row of near planes,
/// can be picked: low planes along x, high planes along x, then y and z.
pub(super) struct Boxes([[f32; PACK]; 6]);

impl Boxes {
    #[inline(always)]
    pub(super) fn new<S: Simd>([low, high]: [Lanes3<S::F8>; 2]) -> Self {
        let mut rows = [[0.0; PACK]; 6];
        for axis in 0..3 {
            low[axis].store(&mut rows[2 * axis]);
            high[axis].store(&mut rows[2 * axis + 1]);
        }
        Self(rows)
    }

    #[inline(always)]
    pub(super) fn row<S: Simd>(&self, row: usize) -> S::F8 {
        S::F8::load(&self.0[row])
    }

    #[inline(always)]
    pub(super) fn plane(&self, row: usize, lane: usize) -> f32 {
        self.0[row][lane % PACK]
    }
}

impl<S: Simd> Hull<S> {
    /// Along one axis: where the first ray enters planes.
    #[inline(always)]
    pub(super) fn enter(&self, axis: usize, planes: S::F8) -> S::F8 {
        let distance = planes - self.near[axis];
        (distance * self.inv_dir[0][axis]).min(distance * self.inv_dir[1][axis])
    }

    /// Along one axis: where the last ray leaves planes.
    #[inline(always)]
    pub(super) fn leave(&self, axis: usize, planes: S::F8) -> S::F8 {
        let distance = planes - self.far[axis];
        (distance * self.inv_dir[0][axis]).max(distance * self.inv_dir[1][axis])
    }

    /// What the intervals of all rays in eight boxes lie in.
    #[inline(always)]
    pub(super) fn interval(
        &self,
        near: Lanes3<S::F8>,
        far: Lanes3<S::F8>,
        end: S::F8,
    ) -> (S::F8, S::F8) {
        let begin = self.enter(0, near[0]).max(self.enter(1, near[1]));
        let leave = self.leave(0, far[0]).min(self.leave(1, far[1]));
        (
            begin.max(self.enter(2, near[2]).max(self.t_min)),
            leave.min(self.leave(2, far[2]).min(end)),
        )
    }
}

#[cfg(test)]
mod tests;
