//! A ray as the slab test of wide nodes sees it.

use glam::Vec3A;

use crate::math::{BoxRay, Padding, Ray};
use crate::simd::Simd;

/// Reach times inverse direction up to which the products below stay far from overflow. Beyond it
/// lie rays that run along an axis, which are few and are walked one by one.
pub(super) const LARGEST_PRODUCT: f32 = 1e37;

/// Four units of rounding: the fused form is off by at most three of them.
pub(super) const SLACK: f32 = 4.0 * (f32::EPSILON / 2.0);

/// What the near and the far planes of boxes are measured from.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sides {
    pub(super) near: Vec3A,
    pub(super) far: Vec3A,
    /// A bit for each axis along which the ray runs backwards.
    pub(super) octant: u32,
}

impl Sides {
    #[inline(always)]
    pub(super) fn of(box_ray: &BoxRay) -> Self {
        let backwards = box_ray.inv_dir.cmplt(Vec3A::ZERO);
        Self {
            near: Vec3A::select(backwards, box_ray.origin_minus, box_ray.origin_plus),
            far: Vec3A::select(backwards, box_ray.origin_plus, box_ray.origin_minus),
            octant: backwards.bitmask(),
        }
    }
}

/// The terms of the slab test `plane·inv_dir − offset`.
///
/// Where an instruction set fuses product and difference, the test is one operation a plane, and
/// its result differs from [`BoxRay::interval`]'s. The offsets hold a slack that makes the interval
/// wider, for every plane within reach. With `w` the largest distance of a plane from the padded
/// origin and `u` a unit of rounding, `BoxRay` rounds `(plane − origin)·inv_dir` from a value that
/// is off by at most `u·w·|inv_dir|`; the offset here is off by `2u·w·|inv_dir|`; both end in one
/// monotone rounding. So `4u·w·|inv_dir|`, and the smallest normal number against underflow, cover
/// the difference.
#[derive(Clone, Copy, Debug)]
pub(super) struct SlabRay {
    pub(super) inv_dir: Vec3A,
    /// Offsets of the near planes.
    pub(super) near: Vec3A,
    /// Offsets of the far planes.
    pub(super) far: Vec3A,
    /// A bit for each axis along which the ray runs backwards.
    pub(super) octant: u32,
}

impl SlabRay {
    /// In a place without a ray.
    pub(super) const VACANT: Self =
        Self { inv_dir: Vec3A::ZERO, near: Vec3A::ZERO, far: Vec3A::ZERO, octant: 0 };

    /// The terms of a ray, or `None` if one of its directions is too small for them.
    #[inline(always)]
    pub(super) fn new<S: Simd>(ray: &Ray, box_ray: &BoxRay, padding: Padding) -> Option<Self> {
        let inv_dir = box_ray.inv_dir;
        let Sides { near, far, octant } = Sides::of(box_ray);
        let width = Vec3A::from(ray.origin).abs() + Vec3A::splat(padding.largest + box_ray.pad);
        let product = width * inv_dir.abs();
        if !product.cmple(Vec3A::splat(LARGEST_PRODUCT)).all() {
            return None;
        }
        if !S::FUSES {
            return Some(Self { inv_dir, near, far, octant });
        }
        let slack = product * SLACK + Vec3A::splat(f32::MIN_POSITIVE);
        Some(Self { inv_dir, near: near * inv_dir + slack, far: far * inv_dir - slack, octant })
    }
}
