//! A ray: an origin, a direction and the interval of the parameter in which hits count.

use glam::Vec3;

/// The points `origin + t·dir` with `t_min ≤ t ≤ t_max`.
///
/// `dir` has any length and is never renormalised, so that `t` keeps its meaning when the ray is
/// taken to another space.
///
/// # Range
/// All components are finite, `t_min` is not negative, and `t_max` is at most [`f32::MAX`]:
/// [`check`](Self::check) tells. For such rays every structure returns the same hits. A ray with a NaN
/// hits nothing. What one with an infinite component hits is not defined, and need not be the same in
/// all structures; builds with debug assertions panic.
///
/// Where products of lengths leave the range of `f32`, a ray misses what it should hit, in every
/// structure. That does not happen to triangles within
/// [`SizeRange::TRIANGLES`](super::SizeRange::TRIANGLES) if the origin is within it, too, and the
/// direction has a length from 10⁻⁹ to 10¹².
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Ray {
    /// Where the ray starts.
    pub origin: Vec3,
    /// The smallest parameter at which a hit counts (inclusive); not negative.
    pub t_min: f32,
    /// The direction, not normalised.
    pub dir: Vec3,
    /// The largest parameter at which a hit counts (inclusive); at most [`f32::MAX`].
    pub t_max: f32,
}

impl Ray {
    /// The half line from `origin` along `dir`.
    #[must_use]
    pub fn new(origin: Vec3, dir: Vec3) -> Self {
        Self { origin, t_min: 0.0, dir, t_max: f32::MAX }
    }

    /// The part of a line with `t_min ≤ t ≤ t_max`.
    ///
    /// The end is cut to the largest finite float, which keeps infinite parameters (of planes
    /// parallel to the ray, of degenerate triangles) from ever counting as hits.
    #[must_use]
    pub fn with_interval(origin: Vec3, dir: Vec3, t_min: f32, t_max: f32) -> Self {
        Self { origin, t_min, dir, t_max: t_max.min(f32::MAX) }
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
        if !(0.0..=f32::MAX).contains(&t_min) || !(f32::MIN..=f32::MAX).contains(&t_max) {
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

    /// The point at parameter `t`.
    #[must_use]
    pub fn at(&self, t: f32) -> Vec3 {
        self.origin + t * self.dir
    }
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
    /// The interval begins below 0, or an end of it is infinite or no number.
    #[error("the ray's interval is from {t_min} to {t_max}: it must be within 0 and 3.4e38")]
    Interval {
        /// Its begin.
        t_min: f32,
        /// Its end.
        t_max: f32,
    },
}

#[cfg(test)]
mod tests {
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
        for (t_min, t_max) in [(-1.0, 1.0), (f32::NAN, 1.0), (0.0, f32::INFINITY), (0.0, f32::NAN)]
        {
            let cut = Ray { t_min, t_max, ..ray };
            assert!(matches!(cut.check(), Err(RayError::Interval { .. })), "{t_min} {t_max}");
        }
    }
}
