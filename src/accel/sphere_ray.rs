//! A ray as bounding balls see it, in `f64`.
//!
//! A ball that encloses the corners of some boxes is tested so much larger that no point is outside
//! that their padded slab test accepts. The rounding of the test itself vanishes beside that.

use glam::DVec3;

use crate::math::{BoxRay, Ray};

/// Below this length of a direction `t` can leave the range of floats; such rays skip nothing. Nor do
/// those so fast that a [`STEP`] of `t`, by which slab tests may err, takes them farther than the padding.
const SHORTEST_DIR: f64 = 1e-30;

/// The distance between neighbouring parameters that are smaller than the normal numbers.
const STEP: f64 = f32::from_bits(1) as f64;

/// A ray and the padding of the boxes that balls enclose.
pub struct SphereRay {
    origin: DVec3,
    dir: DVec3,
    /// 1 / the square of the direction's length.
    inv_square: f64,
    /// A point that a padded box accepts is at most 1.1 paddings outside of it on each axis.
    more: f64,
    t_min: f64,
    skips_nothing: bool,
}

/// Whether a ray is so slow, or so fast, that volumes tested in `f64` must not keep it away.
#[inline]
pub(super) fn skips_nothing(dir: DVec3, pad: f64) -> bool {
    let square = dir.length_squared();
    square < SHORTEST_DIR * SHORTEST_DIR || square * (STEP * STEP) > pad * pad
}

impl SphereRay {
    #[inline]
    pub(super) fn new(ray: &Ray, box_ray: &BoxRay) -> Self {
        let dir = ray.dir.as_dvec3();
        let pad = f64::from(box_ray.pad);
        Self {
            origin: ray.origin.as_dvec3(),
            dir,
            inv_square: 1.0 / dir.length_squared(),
            more: 4.0 * pad,
            t_min: f64::from(ray.t_min),
            skips_nothing: skips_nothing(dir, pad),
        }
    }

    /// Where it enters a ball, if it meets that between its own begin and an end. Rays that skip nothing
    /// are said to enter before all.
    #[inline]
    pub(super) fn enters(&self, center: DVec3, radius: f64, end: f32) -> Option<f64> {
        if self.skips_nothing {
            return Some(f64::NEG_INFINITY);
        }
        let radius = radius + self.more;
        let to_origin = self.origin - center;
        let t_closest = -to_origin.dot(self.dir) * self.inv_square;
        let distance_squared = (to_origin + t_closest * self.dir).length_squared();
        let half_chord = ((radius * radius - distance_squared) * self.inv_square).sqrt();
        let begin = t_closest - half_chord;
        // The root of a negative number is NaN, and no comparison with it holds.
        (t_closest + half_chord >= self.t_min && begin <= f64::from(end)).then_some(begin)
    }
}

#[cfg(test)]
mod tests {
    use glam::{Vec3, Vec3A};

    use super::*;
    use crate::math::{Aabb, Padding, Random};

    #[test]
    fn what_the_padded_box_accepts_the_ball_around_its_corners_accepts() {
        let mut random = Random::new(&[19]);
        let mut met = 0;
        for number in 0..20_000 {
            let mut point = || Vec3A::from_array(std::array::from_fn(|_| random.next_f32() - 0.5));
            let aabb = Aabb::of_points([point(), point()]);
            let origin = [1.0, 3.0, 1e3][number % 3] * Vec3::from(point());
            let (a, b) = (Vec3::from(aabb.corners()[number % 8]), Vec3::from(point()));
            let ray = Ray::new(origin, a + [0.0, 1e-3, 0.3][number / 3 % 3] * b - origin);
            let box_ray = BoxRay::new(&ray, Padding::of_bounds(&aabb));
            let (near, far) = box_ray.interval(&aabb);
            let center = Vec3::from(aabb.center()).as_dvec3();
            let radius = Vec3::from(aabb.max).as_dvec3().distance(center);
            let radius = radius.max(Vec3::from(aabb.min).as_dvec3().distance(center));
            let sphere = SphereRay::new(&ray, &box_ray);
            if near.max(0.0) <= far {
                met += 1;
                let begin = sphere.enters(center, radius, near);
                assert!(begin.is_some_and(|begin| begin <= f64::from(near)), "{ray:?} {aabb:?}");
            }
        }
        assert!(met > 5_000, "{met}");
    }
}
