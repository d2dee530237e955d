//! The ball.

use glam::{DAffine3, DMat3, DVec3, Vec3};

use crate::math::{Aabb, Hit, Lanes, Lanes3, Mask as _, Ray, UNIT_ROUNDOFF, dot, outward_box, sub};
use crate::simd::{Simd, splat3};

use super::SurfacePoint;
use super::ray_group::RayGroup;
use super::single_shape::{Found, SingleShape, hit_of_part};

/// How a line comes by a ball: what decides whether they meet, and where.
///
/// After Haines, Günther, Akenine-Möller: *Precision Improvements for Ray/Sphere Intersection*, Ray
/// Tracing Gems, 2019, chapter 7: the discriminant from the distance between the centre and the
/// line, which does not cancel for small or far balls, and the nearer root from the product of
/// both.
#[derive(Clone, Copy, Debug)]
pub(super) struct Approach<L> {
    /// |d|².
    pub(super) a: L,
    /// The way to the centre along the direction, times |d|².
    pub(super) b: L,
    /// The square of the distance to the centre, less r²: negative inside.
    pub(super) c: L,
    /// r² less the square of the distance between centre and line: they meet if it is not negative.
    pub(super) discriminant: L,
}

impl<L: Lanes> Approach<L> {
    #[inline(always)]
    pub(super) fn new(to_center: Lanes3<L>, dir: Lanes3<L>, radius_squared: L) -> Self {
        let a = dot(dir, dir);
        let b = dot(to_center, dir);
        let along = b / a;
        let to_line = sub(to_center, [along * dir[0], along * dir[1], along * dir[2]]);
        Self {
            a,
            b,
            c: dot(to_center, to_center) - radius_squared,
            discriminant: radius_squared - dot(to_line, to_line),
        }
    }

    /// Both parameters, in no order.
    #[inline(always)]
    pub(super) fn roots(&self) -> (L, L) {
        let q = self.b + (self.a * self.discriminant).sqrt().flipped_by(self.b);
        (self.c / q, q / self.a)
    }
}

impl Approach<f32> {
    /// The roots, if line and ball meet and not all of that lies behind the ray's origin: outside
    /// and on the way out, both parameters are negative.
    #[inline(always)]
    pub(super) fn roots_if_met(&self) -> Option<(f32, f32)> {
        let ahead = self.c <= 0.0 || self.b >= 0.0;
        (ahead && self.discriminant >= 0.0).then(|| self.roots())
    }
}

/// A ball in its own space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ball {
    /// Its centre.
    pub center: Vec3,
    /// Its radius; positive.
    pub radius: f32,
}

impl Ball {
    /// The parameters at which a ray's line enters and leaves the ball, or `None` if the line
    /// passes by or the ball lies behind the ray's origin.
    #[inline]
    #[must_use]
    pub fn crossing(&self, ray: &Ray) -> Option<(f32, f32)> {
        let to_center = (self.center - ray.origin).to_array();
        let approach = Approach::new(to_center, ray.dir.to_array(), self.radius * self.radius);
        let (t0, t1) = approach.roots_if_met()?;
        Some(if t0 <= t1 { (t0, t1) } else { (t1, t0) })
    }

    /// A ball, given in an object's space, under the object's transform: the ball, and what is left of
    /// the transform.
    ///
    /// A transform that keeps its form leaves a ball in the world; any other is left to the unit ball
    /// about the origin, which it takes there.
    #[must_use]
    pub fn transformed(center: DVec3, radius: f64, transform: &DAffine3) -> (Self, DAffine3) {
        if let Some(scale) = uniform_scale(transform) {
            let center = transform.transform_point3(center).as_vec3();
            return (Self { center, radius: (radius * scale) as f32 }, DAffine3::IDENTITY);
        }
        let own = DAffine3::from_translation(center) * DAffine3::from_scale(DVec3::splat(radius));
        (Self { center: Vec3::ZERO, radius: 1.0 }, *transform * own)
    }
}

/// The factor by which a transform scales lengths, if it is the same in all directions.
fn uniform_scale(transform: &DAffine3) -> Option<f64> {
    let m = transform.matrix3;
    let gram = m.transpose() * m;
    let scale_squared = gram.x_axis.x;
    let difference = gram - DMat3::from_diagonal(DVec3::splat(scale_squared));
    let largest = difference.abs().to_cols_array().into_iter().fold(0.0, f64::max);
    (scale_squared > 0.0 && largest <= 1e-12 * scale_squared).then(|| scale_squared.sqrt())
}

impl SingleShape for Ball {
    const NAME: &'static str = "ball";

    fn bounds(&self) -> Aabb {
        let (center, radius) = (self.center.as_dvec3(), f64::from(self.radius));
        outward_box(center - radius, center + radius)
    }

    /// Its diameter: the box of a small ball far from the origin is larger, since it is rounded
    /// outwards.
    fn size(&self) -> f64 {
        2.0 * f64::from(self.radius)
    }

    #[inline]
    fn offer_hits(&self, ray: &Ray, mut take: impl FnMut(Hit) -> bool) {
        let Some((enter, leave)) = self.crossing(ray) else { return };
        let _ = take(hit_of_part(enter, 0)) || take(hit_of_part(leave, 0));
    }

    #[inline(always)]
    fn first_hits<S: Simd>(&self, rays: &RayGroup<S>) -> Found<S::F16> {
        let center: Lanes3<S::F16> = splat3(self.center.to_array());
        let origin = rays.origin;
        let to_center = [center[0] - origin[0], center[1] - origin[1], center[2] - origin[2]];
        let line = Approach::new(to_center, rays.dir, S::F16::splat(self.radius * self.radius));
        let (enter, leave) = in_order::<S>(line.roots());
        let first = rays.accepts(enter);
        let zero = S::F16::splat(0.0);
        let lanes = (first | rays.accepts(leave)) & met::<S>(&line);
        Found { t: enter.select(first, leave), u: zero, v: zero, lanes, part: [0; 2] }
    }

    /// The point that is nearest to the ray's point at the hit's parameter.
    fn surface_point(&self, ray: &Ray, hit: &Hit) -> SurfacePoint {
        let center = self.center.as_dvec3();
        let on_ray = ray.origin.as_dvec3() + f64::from(hit.t) * ray.dir.as_dvec3();
        let outward = (on_ray - center).try_normalize();
        let normal = outward.unwrap_or_else(|| -ray.dir.as_dvec3().normalize());
        let radius = f64::from(self.radius);
        SurfacePoint {
            position: center + radius * normal,
            normal,
            // The side is read off |f|² − r², whose error is at most 8u·r²: a distance of 4u·r.
            clearance: 16.0 * UNIT_ROUNDOFF * radius,
        }
    }
}

/// Two parameters, the smaller one first.
#[inline(always)]
pub(super) fn in_order<S: Simd>((t0, t1): (S::F16, S::F16)) -> (S::F16, S::F16) {
    let ordered = t0.le(t1);
    (t0.select_where(ordered, t1), t1.select_where(ordered, t0))
}

/// Which lines meet the ball, not all of it behind their origin: [`Approach::roots_if_met`].
#[inline(always)]
pub(super) fn met<S: Simd>(line: &Approach<S::F16>) -> u32 {
    let zero = S::F16::splat(0.0);
    let ahead = line.c.le(zero).bits() | zero.le(line.b).bits();
    ahead & zero.le(line.discriminant).bits()
}

#[cfg(test)]
mod tests {
    use glam::DQuat;

    use super::*;
    use crate::shapes::Single;
    use crate::shapes::single_many::tests::assert_same_bits;

    #[test]
    fn a_line_through_the_centre_crosses_at_the_radius() {
        let ball = Ball { center: Vec3::new(1.0, 2.0, 3.0), radius: 0.5 };
        let ray = Ray::new(Vec3::new(1.0, 2.0, -7.0), Vec3::new(0.0, 0.0, 2.0));
        assert_eq!(ball.crossing(&ray), Some((4.75, 5.25)));
        let inside = Ray::new(ball.center, Vec3::X);
        assert_eq!(ball.crossing(&inside), Some((-0.5, 0.5)));
        let away = Ray::new(Vec3::new(1.0, 2.0, -7.0), -Vec3::Z);
        assert_eq!(ball.crossing(&away), None);
    }

    #[test]
    fn the_silhouette_is_where_trigonometry_puts_it() {
        let ball = Ball { center: Vec3::ZERO, radius: 1.0 };
        let eye = Vec3::new(0.0, 0.0, 3.0);
        let tangent_angle = (1.0f64 / 3.0).asin();
        for (factor, seen) in [(0.9999, true), (1.0001, false)] {
            let angle = (tangent_angle * factor) as f32;
            let ray = Ray::new(eye, Vec3::new(angle.sin(), 0.0, -angle.cos()));
            assert_eq!(ball.crossing(&ray).is_some(), seen);
        }
    }

    #[test]
    fn a_small_ball_far_away_keeps_its_shape() {
        let ball = Ball { center: Vec3::ZERO, radius: 1.0 };
        let origin = Vec3::new(0.0, 0.7, 10_000.0);
        let (t0, t1) = ball.crossing(&Ray::new(origin, -Vec3::Z)).unwrap();
        let half_chord = (1.0f32 - 0.49).sqrt();
        assert!(((t1 - t0) / 2.0 - half_chord).abs() < 2e-3);
    }

    #[test]
    fn the_surface_point_is_at_the_radius() {
        let ball = Ball { center: Vec3::new(5.0, 0.0, 0.0), radius: 2.0 };
        let ray = Ray::new(Vec3::new(5.1, 0.2, 9.0), -Vec3::Z);
        let (t, _) = ball.crossing(&ray).unwrap();
        let p = ball.surface_point(&ray, &hit_of_part(t, 0));
        assert!((p.position.distance(ball.center.as_dvec3()) - 2.0).abs() < 1e-12);
        assert!(p.normal.z > 0.9);
    }

    #[test]
    fn sixteen_rays_find_what_each_of_them_finds() {
        let ball = Ball { center: Vec3::new(0.1, -0.2, 0.3), radius: 0.9 };
        assert_same_bits(&Single::Ball(ball));
    }

    #[test]
    fn turned_and_evenly_scaled_balls_stay_balls() {
        let m = DAffine3::from_scale_rotation_translation(
            DVec3::new(2.0, -2.0, 2.0),
            DQuat::from_rotation_x(0.4),
            DVec3::new(1.0, 0.0, 0.0),
        );
        let (ball, transform) = Ball::transformed(DVec3::ZERO, 0.5, &m);
        assert_eq!(ball, Ball { center: Vec3::X, radius: 1.0 });
        assert_eq!(transform, DAffine3::IDENTITY);
    }

    #[test]
    fn an_ellipsoid_is_the_unit_ball_transformed() {
        let m = DAffine3::from_scale(DVec3::new(2.0, 1.0, 1.0));
        let (ball, transform) = Ball::transformed(DVec3::new(1.0, 0.0, 0.0), 3.0, &m);
        assert_eq!(ball, Ball { center: Vec3::ZERO, radius: 1.0 });
        assert_eq!(transform.transform_point3(DVec3::X), DVec3::new(8.0, 0.0, 0.0));
    }
}
