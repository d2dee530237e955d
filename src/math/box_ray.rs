//! The slab test: one formula for every box that any structure, or any primitive, tests.
//!
//! Equal hits rest on this file. A hit counts only if its `t` lies in the interval of its
//! primitive's own box, and a structure may only skip a box whose interval ends before, or begins
//! behind, what is searched. Each operation below rounds monotonically in the plane's coordinate,
//! so the interval of an enclosing box contains that of every box within, to the last bit: what
//! counts is never skipped.

use glam::Vec3A;

use super::{Aabb, Ray};

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

    /// The same with `times` the width: for boxes that are stored with less precision.
    #[must_use]
    pub fn scaled(self, times: f32) -> Self {
        Self { factor: self.factor * times, ..self }
    }
}

/// A ray as boxes see it.
#[derive(Clone, Copy, Debug)]
pub struct BoxRay {
    /// 1/dir, cut to finite values: an axis along which the ray does not move then yields huge
    /// intervals or none, and never a NaN.
    pub inv_dir: Vec3A,
    /// origin + padding: what planes are measured from where the ray runs along the axis.
    pub origin_plus: Vec3A,
    /// origin − padding.
    pub origin_minus: Vec3A,
}

impl BoxRay {
    /// Prepares a ray for boxes with the given padding.
    #[inline]
    #[must_use]
    pub fn new(ray: &Ray, padding: Padding) -> Self {
        let origin = Vec3A::from(ray.origin);
        let reach = padding.largest + origin.abs().max_element();
        let pad = Vec3A::splat(16.0 * f32::EPSILON * padding.factor * reach);
        let inv_dir = Vec3A::ONE / Vec3A::from(ray.dir);
        Self {
            inv_dir: inv_dir.clamp(Vec3A::splat(-f32::MAX), Vec3A::splat(f32::MAX)),
            origin_plus: origin + pad,
            origin_minus: origin - pad,
        }
    }

    /// The parameters at which the ray enters and leaves the padded box; it misses if near > far.
    ///
    /// The box must not be empty. Where a direction is positive the first product is the near one,
    /// where it is negative the second: the smaller of the two either way.
    #[inline]
    #[must_use]
    pub fn interval(&self, aabb: &Aabb) -> (f32, f32) {
        let low = (aabb.min - self.origin_plus) * self.inv_dir;
        let high = (aabb.max - self.origin_minus) * self.inv_dir;
        (low.min(high).max_element(), low.max(high).min_element())
    }

    /// Whether `t` lies in the interval of the box: the own-box rule.
    #[inline]
    #[must_use]
    pub fn accepts(&self, aabb: &Aabb, t: f32) -> bool {
        let (near, far) = self.interval(aabb);
        near <= t && t <= far
    }
}
