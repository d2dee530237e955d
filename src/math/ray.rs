//! A ray: an origin, a direction and the interval of the parameter in which hits count.

use glam::Vec3;

/// The points `origin + t·dir` with `t_min ≤ t ≤ t_max`.
///
/// `dir` has any length and is never renormalised, so that `t` keeps its meaning when the ray is
/// taken to another space. All components are finite; a ray with a NaN hits nothing.
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
