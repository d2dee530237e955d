//! Triangles: the formula of Möller and Trumbore, for one triangle or for several lanes of them.
//!
//! T. Möller, B. Trumbore: *Fast, Minimum Storage Ray/Triangle Intersection*, 1997; here on a
//! corner and two edges, with the determinant's sign taken out so that the inside test needs no
//! division. A triangle is defined by its stored corner and edges: its other corners are `v0 + e1`
//! and `v0 + e2` in `f32`, and its box is the box of these.

use glam::{DVec3, Vec3, Vec3A};

use crate::accel::PackHits;
use crate::math::{Aabb, Lanes, Lanes3, Ray, UNIT_ROUNDOFF, cross, dot, sub, within};

use super::SurfacePoint;

/// The ray's hit on the triangle's plane, times the determinant.
#[derive(Clone, Copy, Debug)]
pub(super) struct ScaledHit<L> {
    /// Barycentric weight of the second corner, times `det`.
    pub(super) u: L,
    /// Barycentric weight of the third corner, times `det`.
    pub(super) v: L,
    /// Ray parameter, times `det`.
    pub(super) t: L,
    /// The determinant's absolute value. Degenerate triangles have 0, and an infinite or undefined
    /// `t / det`.
    pub(super) det: L,
}

/// Möller-Trumbore up to the division. NaNs fail every comparison.
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

/// Whether weights that are scaled by `det` lie in the triangle, edges and corners included.
#[inline(always)]
fn inside<L: Lanes>(u: L, v: L, det: L) -> L::Mask {
    let zero = L::splat(0.0);
    zero.le(u) & zero.le(v) & (u + v).le(det)
}

impl<L: Lanes> ScaledHit<L> {
    /// Whether the ray's line meets the triangle.
    #[inline(always)]
    pub(super) fn inside(&self) -> L::Mask {
        inside(self.u, self.v, self.det)
    }
}

impl<L: Lanes> From<ScaledHit<L>> for PackHits<L> {
    #[inline(always)]
    fn from(hit: ScaledHit<L>) -> Self {
        let ScaledHit { u, v, t, det } = hit;
        Self { inside: hit.inside(), t, u, v, scale: det }
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
    /// the triangle within its interval. The triangle's own box is not tested: that is left to the
    /// caller, who has the padding.
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
        if !inside(u, v, size) {
            return None;
        }
        let t = t / size;
        within(t, [ray.t_min, ray.t_max]).then(|| (t, u / size, v / size))
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
    use crate::math::Mask as _;

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
            let inside = h.inside().bits() >> 3 & 1 != 0;
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
}
