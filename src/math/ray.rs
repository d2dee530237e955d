//! A ray: an origin, a direction and the interval of the parameter in which hits count.

use bytemuck::{Pod, Zeroable};
use glam::Vec3;

use super::Lanes;

/// The points `origin + t·dir` with `t_min ≤ t ≤ t_max`.
///
/// `dir` has any length and is never renormalised, so that `t` keeps its meaning when the ray is
/// taken to another space.
///
/// # Range
/// Origin and direction are finite, `t_min` is finite and not negative, and `t_max` is a number or +∞:
/// [`check`](Self::check) tells. For such rays every structure returns the same hits. A ray with a NaN
/// hits nothing. What one with an infinite origin or direction hits is not defined, and need not be the same in
/// all structures; builds with debug assertions panic.
///
/// Where products of lengths leave the range of `f32`, a ray misses what it should hit, in every
/// structure. That does not happen to triangles within
/// [`SizeRange::TRIANGLES`](super::SizeRange::TRIANGLES) if the origin is within it, too, and the
/// direction has a length from 10⁻⁹ to 10¹².
///
/// # Memory
/// Eight floats in the order of the fields, so that rays in memory of another's need not be copied:
/// [`from_arrays`](Self::from_arrays), or a cast of [`bytemuck`].
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Ray {
    /// Where the ray starts.
    pub origin: Vec3,
    /// The smallest parameter at which a hit counts (inclusive); not negative.
    pub t_min: f32,
    /// The direction, not normalised.
    pub dir: Vec3,
    /// The largest parameter at which a hit counts (inclusive). No hit is farther than [`f32::MAX`]: see
    /// [`end`](Self::end).
    pub t_max: f32,
}

impl Ray {
    /// The half line from `origin` along `dir`.
    #[must_use]
    pub fn new(origin: Vec3, dir: Vec3) -> Self {
        Self { origin, t_min: 0.0, dir, t_max: f32::MAX }
    }

    /// The part of a line with `t_min ≤ t ≤ t_max`.
    #[must_use]
    pub fn with_interval(origin: Vec3, dir: Vec3, t_min: f32, t_max: f32) -> Self {
        Self { origin, t_min, dir, t_max }
    }

    /// Arrays of origin, `t_min`, direction and `t_max` as rays, where they lie.
    #[inline]
    #[must_use]
    pub fn from_arrays(arrays: &[[f32; 8]]) -> &[Self] {
        bytemuck::cast_slice(arrays)
    }

    /// The largest parameter at which a hit counts: `t_max`, or the largest finite float where that is infinite. So
    /// infinite parameters, of planes parallel to the ray or of degenerate triangles, never count.
    #[inline]
    #[must_use]
    pub fn end(&self) -> f32 {
        if self.t_max > f32::MAX { f32::MAX } else { self.t_max }
    }

    /// Whether it is within the range of rays.
    ///
    /// In a scene the same must hold in the space of each object with a transform: a ray with components beyond about
    /// 10¹² may be infinite in that of a small one, and what it hits there is not defined.
    ///
    /// # Errors
    /// With what is first out of it.
    pub fn check(&self) -> Result<(), RayError> {
        for (what, vector) in [("origin", self.origin), ("direction", self.dir)] {
            if !vector.is_finite() {
                return Err(RayError::NotFinite { what, vector });
            }
        }
        let Self { t_min, t_max, .. } = *self;
        // A NaN is in neither range.
        if !(0.0..=f32::MAX).contains(&t_min) || !(f32::MIN..=f32::INFINITY).contains(&t_max) {
            return Err(RayError::Interval { t_min, t_max });
        }
        Ok(())
    }

    /// Whether it has an infinite component: what it hits is not defined.
    pub(crate) fn is_infinite(&self) -> bool {
        let infinite = |vector: Vec3| vector.to_array().into_iter().any(f32::is_infinite);
        infinite(self.origin) || infinite(self.dir)
    }

    /// Origin, `t_min`, direction, `t_max`.
    #[inline]
    #[must_use]
    pub fn to_array(&self) -> [f32; 8] {
        let ([ox, oy, oz], [dx, dy, dz]) = (self.origin.to_array(), self.dir.to_array());
        [ox, oy, oz, self.t_min, dx, dy, dz, self.t_max]
    }

    /// [`to_array`](Self::to_array), where it lies.
    #[inline(always)]
    pub(crate) fn as_array(&self) -> &[f32; 8] {
        bytemuck::cast_ref(self)
    }

    /// The point at parameter `t`.
    #[must_use]
    pub fn at(&self, t: f32) -> Vec3 {
        self.origin + t * self.dir
    }
}

/// [`Ray::end`] of the rays of a row, by their `t_max`. A NaN is left, and nothing is before it: rows give the second
/// of two values where either is one, which a scalar does not.
#[inline(always)]
pub(crate) fn search_ends<L: Lanes>(t_max: L) -> L {
    L::splat(f32::MAX).min(t_max)
}

/// Why a ray is out of the range in which hits are defined.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum RayError {
    /// A component is infinite or no number.
    #[error("the {what} of the ray is not finite: {vector}")]
    NotFinite {
        /// `origin` or `direction`.
        what: &'static str,
        /// What it is.
        vector: Vec3,
    },
    /// The interval begins below 0 or at infinity, ends at −∞, or an end of it is no number.
    #[error(
        "the ray's interval is from {t_min} to {t_max}: it must begin at a number from 0 on, and end at one or at inf"
    )]
    Interval {
        /// Its begin.
        t_min: f32,
        /// Its end.
        t_max: f32,
    },
}

#[cfg(test)]
mod tests {
    use glam::Vec4;

    use super::*;

    #[test]
    fn rays_out_of_their_range_are_named() {
        let ray = Ray::new(Vec3::ZERO, Vec3::X);
        let long = Ray { dir: Vec3::splat(f32::MAX), ..ray };
        let behind = Ray { t_max: -1.0, ..ray };
        for fine in [ray, long, behind, Ray::with_interval(Vec3::ONE, Vec3::Y, 1.0, f32::INFINITY)]
        {
            assert_eq!(fine.check(), Ok(()));
            assert!(!fine.is_infinite());
        }
        let infinite = Ray { dir: Vec3::new(0.0, f32::NEG_INFINITY, 0.0), ..ray };
        assert!(infinite.is_infinite());
        assert_eq!(
            infinite.check().unwrap_err().to_string(),
            "the direction of the ray is not finite: [0, -inf, 0]"
        );
        let nowhere = Ray { origin: Vec3::NAN, ..ray };
        assert!(matches!(nowhere.check(), Err(RayError::NotFinite { what: "origin", .. })));
        let infinity = f32::INFINITY;
        for (t_min, t_max) in
            [(-1.0, 1.0), (f32::NAN, 1.0), (infinity, infinity), (0.0, -infinity), (0.0, f32::NAN)]
        {
            let cut = Ray { t_min, t_max, ..ray };
            assert!(matches!(cut.check(), Err(RayError::Interval { .. })), "{t_min} {t_max}");
        }
    }

    #[test]
    fn arrays_of_eight_are_rays_where_they_lie() {
        let arrays = [[1.0, 2.0, 3.0, 0.5, 4.0, 5.0, 6.0, f32::INFINITY], [0.0; 8]];
        let rays = Ray::from_arrays(&arrays);
        let (origin, dir) = (Vec3::new(1.0, 2.0, 3.0), Vec3::new(4.0, 5.0, 6.0));
        assert_eq!(rays[0], Ray::with_interval(origin, dir, 0.5, f32::INFINITY));
        assert_eq!(rays.as_ptr().cast(), arrays.as_ptr());
        assert_eq!(rays[1].to_array(), [0.0; 8]);
    }

    #[test]
    fn searches_end_before_infinity() {
        let end = |t_max| Ray { t_max, ..Ray::new(Vec3::ZERO, Vec3::X) }.end();
        assert_eq!([end(2.0), end(-1.0), end(f32::INFINITY)], [2.0, -1.0, f32::MAX]);
        assert!(end(f32::NAN).is_nan());
        let ends = search_ends(Vec4::new(2.0, -1.0, f32::INFINITY, f32::NAN));
        assert_eq!(ends.truncate().to_array(), [2.0, -1.0, f32::MAX]);
        assert!(ends.w.is_nan());
    }
}
