//! The arithmetic of the slab test, each step written once, for any number of lanes.
//!
//! Equal hits rest on these few lines: whoever tests a box, for one ray, for several rays or for
//! several boxes, calls them. Each rounds monotonically in the plane's coordinate.

use super::{Aabb, Lanes};

/// How much wider than exact arithmetic the boxes of a set of primitives are tested.
///
/// The padding of a ray is `16·ε·factor·(largest + |origin|)`: it covers the rounding of the slab
/// test and of `t` itself, and it grows with the distance of the ray's origin, because both do. It
/// belongs to the ray, not to the boxes, so the same boxes serve near and far origins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Padding {
    /// The largest absolute coordinate of any of the set's boxes.
    pub largest: f32,
    /// At least 1; more where `t` comes through a transform that amplifies rounding.
    pub factor: f32,
}

impl Padding {
    /// The padding of primitives that are tested in the space of the ray.
    #[must_use]
    pub fn of_bounds(bounds: &Aabb) -> Self {
        Self { largest: bounds.largest_coordinate(), factor: 1.0 }
    }

    /// The padding of rays, a length, by the largest absolute coordinates of their origins.
    #[inline(always)]
    #[must_use]
    pub fn of_rays<L: Lanes>(self, largest_of_origin: L) -> L {
        let reach = L::splat(self.largest) + largest_of_origin;
        L::splat(16.0 * f32::EPSILON * self.factor) * reach
    }

    /// The largest distances of planes from padded origins, along one axis.
    #[inline(always)]
    #[must_use]
    pub fn reach<L: Lanes>(self, origin: L, pad: L) -> L {
        origin.abs() + (L::splat(self.largest) + pad)
    }
}

/// 1/dir, cut to finite values: an axis along which a ray does not move then yields huge parameters
/// or none, and never a NaN.
#[inline(always)]
#[must_use]
pub fn finite_reciprocal<L: Lanes>(dir: L) -> L {
    cut_to_finite(L::splat(1.0) / dir)
}

/// The same values, with the largest finite ones in place of infinities.
#[inline(always)]
#[must_use]
pub fn cut_to_finite<L: Lanes>(values: L) -> L {
    values.max(L::splat(-f32::MAX)).min(L::splat(f32::MAX))
}

/// The parameters at which rays cross planes along one axis. Where a ray runs along the axis,
/// `origin` is `origin + pad` for the low plane of a box and `origin − pad` for the high plane.
#[inline(always)]
#[must_use]
pub fn crossing<L: Lanes>(plane: L, origin: L, inv_dir: L) -> L {
    (plane - origin) * inv_dir
}

/// The parameters at which rays enter and leave slabs, whatever their direction: the smaller and the
/// larger of both crossings. `origins` are `origin + pad` and `origin − pad`.
#[inline(always)]
#[must_use]
pub fn slab<L: Lanes>([low, high]: [L; 2], origins: [L; 2], inv_dir: L) -> (L, L) {
    let a = crossing(low, origins[0], inv_dir);
    let b = crossing(high, origins[1], inv_dir);
    (a.min(b), a.max(b))
}

/// Whether intervals of boxes are not empty and reach what is searched: with [`not_before`], the own-box
/// rule.
#[inline(always)]
#[must_use]
pub fn meets<L: Lanes>([begin, leave]: [L; 2], [t_min, end]: [L; 2]) -> L::Mask {
    begin.le(leave) & begin.le(end) & t_min.le(leave)
}

/// `t`, or `begin` if that comes later. A zero that comes from there is positive, so that it does not
/// matter which of two zeros the smaller or the larger of both was.
#[inline(always)]
#[must_use]
pub fn not_before<L: Lanes>(t: L, begin: L) -> L {
    t.select_where(begin.le(t), begin + L::splat(0.0))
}
