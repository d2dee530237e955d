//! Triangles: the formula of Möller and Trumbore, for one triangle or for several lanes of them.
//!
//! T. Möller, B. Trumbore: *Fast, Minimum Storage Ray/Triangle Intersection*, 1997; here on a
//! corner and two edges, with the determinant's sign taken out so that the inside test needs no
//! division. A triangle is defined by its stored corner and edges: its other corners are `v0 + e1`
//! and `v0 + e2` in `f32`, and its box is the box of these.

use glam::{DVec3, Vec3, Vec3A};

use crate::accel::PackHits;
use crate::math::{
    Aabb, Hit, Lanes, Lanes3, Mask as _, NONE, Ray, UNIT_ROUNDOFF, cross, dot, sub, within,
};
use crate::simd::{Simd, splat3};

use super::SurfacePoint;
use super::clip::bounds_within;
use super::ray_group::RayGroup;
use super::single_shape::{Found, SingleShape};

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
        Aabb::of_points(self.corners())
    }

    /// A box around the part of the stored triangle within a box; empty where there is none. It lies
    /// within both boxes, and is larger than it must be by rounding alone.
    #[must_use]
    pub fn clipped_bounds(&self, to: &Aabb) -> Aabb {
        let own = self.bounds().intersection(*to);
        if own.is_empty() { own } else { own.intersection(bounds_within(self.corners(), to)) }
    }

    #[inline]
    fn corners(&self) -> [Vec3A; 3] {
        let v0 = Vec3A::from(self.v0);
        [v0, v0 + Vec3A::from(self.e1), v0 + Vec3A::from(self.e2)]
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

impl SingleShape for Triangle {
    const NAME: &'static str = "triangle";

    fn bounds(&self) -> Aabb {
        self.bounds()
    }

    #[inline]
    fn offer_hits(&self, ray: &Ray, mut take: impl FnMut(Hit) -> bool) {
        let Some((t, u, v)) = self.intersect(ray) else { return };
        take(Hit { t, object: NONE, prim: 0, u, v });
    }

    #[inline(always)]
    fn first_hits<S: Simd>(&self, rays: &RayGroup<S>) -> Found<S::F16> {
        let zero = S::F16::splat(0.0);
        let hit = scaled_hit(
            rays.origin,
            rays.dir,
            splat3(self.v0.to_array()),
            splat3(self.e1.to_array()),
            splat3(self.e2.to_array()),
        );
        let inside = hit.inside() & zero.le(hit.t);
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
    use crate::math::Random;
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
        let mut random = Random::new(&[17]);
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

    /// Triangles of all kinds with boxes that cut them: far from the origin, slivers, flat; planes
    /// anywhere, through a corner, or next to an edge that nearly lies in them.
    fn cut_triangles() -> impl Iterator<Item = (Triangle, Aabb, Random)> {
        let mut random = Random::new(&[29]);
        (0..4_000u32).map(move |number| {
            let mut point = || Vec3::from_array(std::array::from_fn(|_| random.next_f32() - 0.5));
            let [a, mut b, mut c] = [point(), point(), point()];
            match number % 4 {
                0 => c = a + 1.000_001 * (b - a),
                1 => b.z = a.z.next_up(),
                2 => (b.x, c.x) = (a.x, a.x),
                _ => {}
            }
            let far = [0.0, 1.0, 1e4][number as usize / 4 % 3];
            let corners = [a, b, c].map(|corner| corner + Vec3::new(far, -far, 0.5 * far));
            let triangle = Triangle::new(corners);
            let mut to = Aabb::of_points([point(), point()].map(|p| Vec3A::from(p + corners[0])));
            if number % 5 < 3 {
                let axis = number as usize % 5;
                to.max[axis] = corners[1][axis].max(to.min[axis]);
            }
            (triangle, to, random.clone())
        })
    }

    #[test]
    fn the_box_of_a_part_holds_every_point_of_it_and_no_more_than_both_boxes() {
        let (mut inside, mut smaller) = (0, 0);
        for (triangle, to, mut random) in cut_triangles() {
            let (own, part) = (triangle.bounds(), triangle.clipped_bounds(&to));
            let default = own.intersection(to);
            assert_eq!(part.union(default), default);
            smaller += u32::from(part != default);
            let corners = triangle.corners().map(Vec3A::as_dvec3);
            for _ in 0..50 {
                let [u, v] = random.next_pair().map(f64::from);
                let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
                let point = corners[0] * (1.0 - u - v) + corners[1] * u + corners[2] * v;
                // Its own rounding does not count.
                let point = point.clamp(own.min.as_dvec3(), own.max.as_dvec3());
                let is_in = |bounds: &Aabb| {
                    let [min, max] = [bounds.min, bounds.max].map(Vec3A::as_dvec3);
                    min.cmple(point).all() && point.cmple(max).all()
                };
                if is_in(&to) {
                    inside += 1;
                    assert!(is_in(&part), "{triangle:?} in {to:?}: {point} is not in {part:?}");
                }
            }
        }
        assert!(inside > 10_000 && smaller > 500, "{inside} {smaller}");
    }

    #[test]
    fn the_boxes_of_two_parts_cover_that_of_the_whole() {
        for (triangle, to, _) in cut_triangles() {
            let own = triangle.bounds();
            for (axis, plane) in [(0, to.max.x), (1, to.max.y), (2, to.min.z)] {
                let plane = plane.clamp(own.min[axis], own.max[axis]);
                let (mut below, mut above) = (own, own);
                below.max[axis] = plane;
                above.min[axis] = plane;
                let parts = [below, above].map(|half| triangle.clipped_bounds(&half));
                assert_eq!(parts[0].union(parts[1]), own, "{triangle:?} at {plane}");
            }
        }
    }

    #[test]
    fn the_box_of_a_part_is_tight() {
        // In the plane x = y: what lies left of x = 0.25 lies below y = 0.25.
        let triangle = Triangle::new([Vec3::ZERO, Vec3::ONE, Vec3::new(1.0, 1.0, 0.0)]);
        let to = Aabb { min: Vec3A::splat(-1.0), max: Vec3A::new(0.25, 2.0, 2.0) };
        let part = triangle.clipped_bounds(&to);
        assert_eq!((part.min, part.max.x), (Vec3A::ZERO, 0.25));
        assert!((part.max - Vec3A::splat(0.25)).abs().max_element() < 1e-7, "{part:?}");
        // A box that only the triangle's box touches.
        let corner = Aabb { min: Vec3A::new(0.0, 0.5, 0.0), max: Vec3A::new(0.25, 1.0, 1.0) };
        assert_eq!(triangle.clipped_bounds(&corner), Aabb::EMPTY);
    }

    #[test]
    fn a_part_as_thin_as_a_line_is_not_lost() {
        // In the plane x = y: where x is at least m and y at most m, a line is left.
        for (n, m) in (2..60u16).flat_map(|n| (1..n).map(move |m| (f32::from(n), f32::from(m)))) {
            let corners = [Vec3::ZERO, Vec3::new(n, n, 0.0), Vec3::splat(n)];
            let to = Aabb { min: Vec3A::new(m, 0.0, 0.0), max: Vec3A::new(n, m, n) };
            let part = Triangle::new(corners).clipped_bounds(&to);
            let line = Aabb { min: Vec3A::new(m, m, 0.0), max: Vec3A::splat(m) };
            assert_eq!(part.union(line), part, "{m} of {n}");
        }
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
