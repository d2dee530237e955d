//! Triangles: the formula of Möller and Trumbore, for one triangle or for several lanes of them.
//!
//! T. Möller, B. Trumbore: *Fast, Minimum Storage Ray/Triangle Intersection*, 1997; here on a
//! corner and two edges, with the determinant's sign taken out so that the inside test needs no
//! division. A triangle is what its stored corner and edges say: its other corners are `v0 + e1`
//! and `v0 + e2` in `f32`, and its box is the box of these.

use glam::{DVec3, Vec3, Vec3A};

use crate::accel::ScaledHit;
use crate::math::{Aabb, Hit, NONE, Ray, UNIT_ROUNDOFF};
use crate::simd::{Lanes, Lanes3, Mask, Row, Simd, cross, dot, splat3, sub};

use super::SurfacePoint;
use super::ray_group::Group;
use super::single_shape::{Found, SingleShape};

/// Möller-Trumbore up to the division.
///
/// The ray is inside the triangle if `u ≥ 0`, `v ≥ 0` and `u + v ≤ det`; then it is hit at
/// `t / det`. Degenerate triangles have `det = 0` and an infinite or undefined `t / det`. NaNs
/// fail every comparison.
#[inline(always)]
pub(super) fn scaled_hit<L: Lanes>(
    origin: Lanes3<L>,
    dir: Lanes3<L>,
    v0: Lanes3<L>,
    e1: Lanes3<L>,
    e2: Lanes3<L>,
) -> ScaledHit<L> {
    let h = cross(dir, e2);
    let det = dot(e1, h);
    let s = sub(origin, v0);
    let q = cross(s, e1);
    ScaledHit {
        u: dot(s, h).flipped_by(det),
        v: dot(dir, q).flipped_by(det),
        t: dot(e2, q).flipped_by(det),
        det: det.abs(),
    }
}

/// One triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    /// First corner.
    pub v0: Vec3,
    /// Second corner minus first.
    pub e1: Vec3,
    /// Third corner minus first.
    pub e2: Vec3,
}

impl Triangle {
    /// The triangle with these corners, rounded as stored.
    #[must_use]
    pub fn new([a, b, c]: [Vec3; 3]) -> Self {
        Self { v0: a, e1: b - a, e2: c - a }
    }

    /// Whether nothing of it is infinite or NaN, its far corners as they are stored included.
    pub(super) fn is_finite(&self) -> bool {
        let Self { v0, e1, e2 } = *self;
        v0.is_finite() && (v0 + e1).is_finite() && (v0 + e2).is_finite()
    }

    /// The box of the stored triangle.
    #[inline]
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        let v0 = Vec3A::from(self.v0);
        Aabb::of_points([v0, v0 + Vec3A::from(self.e1), v0 + Vec3A::from(self.e2)])
    }

    /// The parameter and the barycentric weights of the second and third corner at which a ray hits
    /// the triangle within its interval. The triangle's own box is not asked: that is left to the
    /// caller, who knows the padding.
    #[inline]
    #[must_use]
    pub fn intersect(&self, ray: &Ray) -> Option<(f32, f32, f32)> {
        let [origin, dir, v0, e1, e2] =
            [ray.origin, ray.dir, self.v0, self.e1, self.e2].map(|v| v.to_array());
        // The steps of `scaled_hit`, left as soon as the ray is known to miss. The parameter comes
        // first: most rays that leave a surface have it behind them.
        let h = cross(dir, e2);
        let det = dot(e1, h);
        let size = det.abs();
        let s = sub(origin, v0);
        let q = cross(s, e1);
        let t = dot(e2, q).flipped_by(det);
        let u = dot(s, h).flipped_by(det);
        if !(t >= 0.0 && u >= 0.0 && u <= size) {
            return None;
        }
        let v = dot(dir, q).flipped_by(det);
        if !(v >= 0.0 && u + v <= size) {
            return None;
        }
        let t = t / size;
        (ray.t_min <= t && t <= ray.t_max).then(|| (t, u / size, v / size))
    }

    /// The point at barycentric weights `u` (second corner) and `v` (third corner).
    #[inline]
    #[must_use]
    pub fn surface_point(&self, u: f32, v: f32) -> SurfacePoint {
        let [v0, e1, e2] = [self.v0, self.e1, self.e2].map(Vec3::as_dvec3);
        let normal = e1.cross(e2);
        let area_recip = normal.length_recip();
        SurfacePoint {
            position: v0 + f64::from(u) * e1 + f64::from(v) * e2,
            normal: normal * area_recip,
            clearance: clearance(e1, e2, area_recip),
        }
    }
}

impl SingleShape for Triangle {
    const NAME: &'static str = "triangle";

    fn bounds(&self) -> Aabb {
        self.bounds()
    }

    #[inline]
    fn first_hit(&self, ray: &Ray, counts: impl Fn(f32) -> bool) -> Option<Hit> {
        let (t, u, v) = self.intersect(ray)?;
        counts(t).then_some(Hit { t, object: NONE, prim: 0, u, v })
    }

    #[inline(always)]
    fn first_hits<S: Simd>(&self, rays: &Group<S>) -> Found<S::F16> {
        let zero = S::F16::splat(0.0);
        let hit = scaled_hit(
            rays.origin,
            rays.dir,
            splat3::<S::F16, _>(self.v0.to_array()),
            splat3::<S::F16, _>(self.e1.to_array()),
            splat3::<S::F16, _>(self.e2.to_array()),
        );
        let inside = zero.le(hit.u) & zero.le(hit.v) & (hit.u + hit.v).le(hit.det) & zero.le(hit.t);
        let t = hit.t / hit.det;
        let lanes = inside.bits() & rays.accepts(t);
        Found { t, u: hit.u / hit.det, v: hit.v / hit.det, lanes, part: [0; 2] }
    }

    #[inline]
    fn surface_point(&self, _: &Ray, hit: &Hit) -> SurfacePoint {
        self.surface_point(hit.u, hit.v)
    }
}

/// How far from the plane the sign of `t` is certain.
///
/// `t·det = e2·(s × e1)` is the distance times |e1 × e2|. Each of its products passes five
/// roundings on the way, so its error is at most 5u·3·|e1||e2||s|, and |s| is at most about the
/// longest edge. For slivers, whose area is all rounding, the distance is cut to a thousandth of
/// that edge: beyond it the offset itself would show.
fn clearance(e1: DVec3, e2: DVec3, double_area_recip: f64) -> f64 {
    const FACTOR: f64 = 15.0 * UNIT_ROUNDOFF;
    let (a, b) = (e1.length_squared(), e2.length_squared());
    // With squares, there is one root to draw.
    let error = FACTOR * double_area_recip;
    (a.max(b) * (error * error * (a * b)).min(1e-3 * 1e-3)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shapes::Single;
    use crate::shapes::single_many::tests::assert_same_bits;

    fn hit(origin: [f32; 3], dir: [f32; 3], t: &Triangle) -> Option<(f32, f32, f32)> {
        t.intersect(&Ray::new(origin.into(), dir.into()))
    }

    #[test]
    fn a_hit_has_the_parameter_and_weights_of_its_point() {
        let t = Triangle::new([Vec3::ZERO, Vec3::X, Vec3::Y]);
        for (z, dz) in [(2.0, -1.0), (-2.0, 1.0)] {
            let (time, u, v) = hit([0.25, 0.5, z], [0.0, 0.0, dz], &t).unwrap();
            assert_eq!((time, u, v), (2.0, 0.25, 0.5), "both sides are hit alike");
        }
        assert!(hit([0.75, 0.5, 2.0], [0.0, 0.0, -1.0], &t).is_none());
    }

    #[test]
    fn edges_and_corners_belong_to_the_triangle() {
        let t = Triangle::new([Vec3::ZERO, Vec3::X, Vec3::Y]);
        for p in [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.5, 0.5], [0.5, 0.0], [0.0, 0.5]] {
            assert!(hit([p[0], p[1], 1.0], [0.0, 0.0, -1.0], &t).is_some(), "{p:?}");
        }
    }

    #[test]
    fn a_degenerate_triangle_has_no_finite_parameter() {
        let t = Triangle::new([Vec3::ZERO, Vec3::X, Vec3::X]);
        assert_eq!(hit([0.5, 0.0, 1.0], [0.0, 0.0, -1.0], &t), None);
    }

    #[test]
    fn one_triangle_and_four_lanes_give_the_same_bits() {
        let mut random = crate::math::Random::new(&[17]);
        let mut point = || Vec3::from_array(std::array::from_fn(|_| random.next_f32() - 0.5));
        let mut hits = 0;
        for _ in 0..20_000 {
            let t = Triangle::new([point(), point(), point()]);
            let origin = 4.0 * point();
            let ray = Ray::new(origin, point() - origin);
            let rows = |v: Vec3| v.to_array().map(glam::Vec4::splat);
            let h = scaled_hit(rows(ray.origin), rows(ray.dir), rows(t.v0), rows(t.e1), rows(t.e2));
            let inside = h.u[3] >= 0.0 && h.v[3] >= 0.0 && h.u[3] + h.v[3] <= h.det[3];
            let time = h.t[3] / h.det[3];
            let lanes = (inside && (0.0..=f32::MAX).contains(&time))
                .then(|| (time, h.u[3] / h.det[3], h.v[3] / h.det[3]));
            let bits = |h: Option<(f32, f32, f32)>| {
                h.map(|(t, u, v)| [t.to_bits(), u.to_bits(), v.to_bits()])
            };
            assert_eq!(bits(t.intersect(&ray)), bits(lanes));
            hits += u32::from(lanes.is_some());
        }
        assert!(hits > 100, "{hits}");
    }

    #[test]
    fn the_surface_point_lies_in_the_plane_and_its_clearance_is_tiny() {
        let t = Triangle::new([Vec3::ONE, Vec3::new(4.0, 2.0, 0.0), Vec3::new(0.0, 5.0, 3.0)]);
        let p = t.surface_point(0.3, 0.2);
        let plane_distance = (p.position - t.v0.as_dvec3()).dot(p.normal.normalize());
        assert!(plane_distance.abs() < 1e-12);
        assert!(p.clearance > 0.0 && p.clearance < 1e-4);
    }

    #[test]
    fn sixteen_rays_find_what_each_of_them_finds() {
        let corners = [Vec3::new(-2.0, -1.0, 0.0), Vec3::X, Vec3::splat(1.5)];
        assert_same_bits(&Single::Triangle(Triangle::new(corners)));
    }
}
