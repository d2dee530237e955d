//! Triangles: one watertight formula, for one triangle or for several lanes of them.
//!
//! S. Woop, C. Benthin, I. Wald: *Watertight Ray/Triangle Intersection*, JCGT 2(1), 2013. Space is
//! sheared so that the ray runs along an axis ([`ShearedRay`]). What is left is a point, the ray, in a
//! triangle of the plane.
//!
//! # No ray gets between two triangles
//! 1. A corner's place in the sheared plane is rounded, but by the corner and the ray alone: triangles
//!    that share a corner see it in one place. So a mesh is a mesh in the sheared plane too, and
//!    wherever the exact triangles between these places cover the ray, one of them contains it.
//! 2. For an edge from `p` to `q` the sign of `p × q = p.x·q.y − p.y·q.x` says on which side of it the
//!    ray lies. Both products are rounded, and rounding is monotone: if `p.x·q.y ≥ p.y·q.x`, that holds
//!    for the rounded products too. Their difference is rounded as well, with its sign kept (there are
//!    denormal numbers). So the sign computed is never the wrong one; it may be zero instead. Nothing is
//!    fused.
//! 3. Zero counts for either side. So every triangle that contains the ray is hit, at its edges and
//!    corners too, perhaps together with its neighbours: these give one another the same number with
//!    opposite signs. Of equal hits the smaller id counts, as ever.
//! 4. Where all three products are zero, and so the area, the same is computed in `f64`, where the
//!    products are exact. If the area is still zero, the triangle is seen from its very edge; then it
//!    covers no more than its neighbours do.
//! 5. The own-box rule does not refuse the hit. The formula is right about whether the ray hits, but a
//!    triangle seen from its edge has weights, and so a `t`, that are all rounding, and its box may begin
//!    behind that. Then the hit counts where the box begins ([`not_before`]). The box itself is never
//!    missed. Let `R` be the largest distance of its planes from the origin along an axis, and `u` a unit
//!    of rounding. A place in the sheared plane is off by at most `7u·R`: the corner relative to the origin
//!    by `u·R`, its product with the slope by `4u·R`, their difference by `2u·R`. The weights that make
//!    the ray of the places make a point of the exact triangle that is no farther from the ray's line,
//!    along each axis. Padding is `32u·R` or more, so this point lies `25u·R` within the padded box. The
//!    slab test is off by at most `3u·R` along each axis: no plane is computed to lie beyond the point.

use glam::{DVec3, Vec3, Vec3A};

use crate::accel::PackHits;
use crate::math::slab::{finite_reciprocal, not_before};
use crate::math::{Aabb, Hit, Lanes, Lanes3, Mask as _, NONE, Ray, UNIT_ROUNDOFF, ones, within};
use crate::simd::{LANES, Simd};

use super::SurfacePoint;
use super::clip::bounds_within;
use super::ray_group::RayGroup;
use super::sheared_ray::{ShearedRay, TriangleRay, TriangleRays};
use super::single_shape::{Found, Reach, SingleShape};

/// The formula up to the division by the determinant, twice the area in the sheared plane and of either
/// sign, for corners in the order of the ray's axes. Where a number is NaN, so is
/// `t`, whatever `inside` says. Where it is
/// [`flat`](PackHits::flat), it takes [`flat_hit`] to know.
#[inline(always)]
pub(super) fn scaled_hit<L: Lanes>(ray: &ShearedRay<L>, [a, b, c]: [Lanes3<L>; 3]) -> PackHits<L> {
    let (a, b, c) = (ray.see(a), ray.see(b), ray.see(c));
    // The corners' weights, times the determinant.
    let (of_a, of_b, of_c) = (side(c, b), side(a, c), side(b, a));
    let det = of_a + of_b + of_c;
    let zero = L::splat(0.0);
    let (least, most) = (of_a.min(of_b).min(of_c), of_a.max(of_b).max(of_c));
    PackHits {
        inside: zero.le(least) | most.le(zero),
        u: of_b,
        v: of_c,
        t: ray.parameter(of_a * a[2] + (of_b * b[2] + of_c * c[2])),
        scale: det,
    }
}

/// On which side of the edge between two places the ray lies: twice the area of the triangle that it
/// makes with them. The same for the edge backwards, but for the sign.
#[inline(always)]
fn side<L: Lanes>(p: Lanes3<L>, q: Lanes3<L>) -> L {
    p[0] * q[1] - p[1] * q[0]
}

/// `t`, `u` and `v` of a hit whose determinant is rounded to zero, computed in `f64`; `t` is NaN if there
/// is none.
#[cold]
#[inline(never)]
pub(super) fn flat_hit(ray: &Ray, corners: [Vec3; 3]) -> [f32; 3] {
    let of_triangles = TriangleRay::from(ray);
    let (axes, ray) = (of_triangles.axes(), of_triangles.splat::<f32>());
    let see = |corner: Vec3| ray.see(axes.arrange(&corner.to_array())).map(f64::from);
    let [a, b, c] = corners.map(see);
    let side = |p: [f64; 3], q: [f64; 3]| p[0] * q[1] - p[1] * q[0];
    let (of_a, of_b, of_c) = (side(c, b), side(a, c), side(b, a));
    let det = of_a + of_b + of_c;
    if det == 0.0 || [of_a, of_b, of_c].iter().any(|of| of * det.signum() < 0.0) {
        return [f32::NAN; 3];
    }
    let ahead = (of_a * a[2] + (of_b * b[2] + of_c * c[2])) / det;
    let [ahead, u, v] = [ahead, of_b / det, of_c / det].map(|x| x as f32);
    [ray.parameter(ahead), u, v]
}

/// One triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triangle {
    /// Its corners.
    pub corners: [Vec3; 3],
}

impl Triangle {
    /// The triangle with these corners.
    #[must_use]
    pub fn new(corners: [Vec3; 3]) -> Self {
        Self { corners }
    }

    /// Whether nothing of it is infinite or NaN.
    pub(super) fn is_finite(&self) -> bool {
        self.corners.iter().all(|corner| corner.is_finite())
    }

    /// The smallest box around it.
    #[inline]
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        Aabb::of_points(self.corners.map(Vec3A::from))
    }

    /// A box around the part of the triangle within a box; empty where there is none. It lies
    /// within both boxes, and is larger than it must be by rounding alone.
    #[must_use]
    pub fn clipped_bounds(&self, to: &Aabb) -> Aabb {
        let own = self.bounds().intersection(*to);
        let corners = self.corners.map(Vec3A::from);
        if own.is_empty() { own } else { own.intersection(bounds_within(corners, to)) }
    }

    /// The parameter and the barycentric weights of the second and third corner at which a ray hits
    /// the triangle within its interval. The triangle's own box is not consulted: that is left to the
    /// caller, who has the padding.
    #[inline]
    #[must_use]
    pub fn intersect(&self, ray: &Ray) -> Option<(f32, f32, f32)> {
        let of_triangles = TriangleRay::from(ray);
        let sheared = of_triangles.splat::<f32>();
        let corners = self.corners.map(|corner| of_triangles.axes().arrange(&corner.to_array()));
        let mut hit = scaled_hit(&sheared, corners);
        if !hit.inside {
            return None;
        }
        if hit.flat() != 0 {
            hit.replace(0, flat_hit(ray, self.corners));
        }
        let t = hit.t / hit.scale;
        within(t, [ray.t_min, ray.t_max]).then(|| (t, hit.u / hit.scale, hit.v / hit.scale))
    }

    /// The point at barycentric weights `u` (second corner) and `v` (third corner).
    #[inline]
    #[must_use]
    pub fn surface_point(&self, u: f32, v: f32) -> SurfacePoint {
        let [a, b, c] = self.corners.map(|corner| corner.as_dvec3());
        let (e1, e2) = (b - a, c - a);
        let normal = e1.cross(e2);
        let area_recip = normal.length_recip();
        SurfacePoint {
            position: a + f64::from(u) * e1 + f64::from(v) * e2,
            normal: normal * area_recip,
            clearance: clearance(e1, e2, area_recip),
        }
    }
}

impl SingleShape for Triangle {
    const NAME: &'static str = "triangle";

    /// A hit counts where the formula puts it, or where the box begins if that is later; the box does not
    /// refuse it. See the head of this file.
    #[inline(always)]
    fn placed<L: Lanes>(t: L, reach: &Reach<L>) -> (L, u32) {
        let [begin, end] = reach.in_box;
        (not_before(t, begin), (within(t, reach.of_ray) & begin.le(end)).bits())
    }

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
        let [x, y, z] = rays.dir;
        let inv_dir = [finite_reciprocal(x), finite_reciprocal(y), finite_reciprocal(z)];
        let of_triangles = TriangleRays::new(&rays.origin, &rays.dir, &inv_dir);
        let corners = &self.corners;
        let places = of_triangles.arrange(|corner, axis| corners[corner][axis as usize]);
        let mut hits = scaled_hit(&of_triangles.sheared, places);
        let flat = hits.flat();
        if flat != 0 {
            let rays = rays.rays();
            for lane in ones(flat) {
                hits.replace(lane, flat_hit(&rays[lane % LANES], self.corners));
            }
        }
        let (t, counts) = Self::placed(hits.t / hits.scale, &rays.reach);
        let lanes = hits.inside.bits() & counts;
        Found { t, u: hits.u / hits.scale, v: hits.v / hits.scale, lanes, part: [0; 2] }
    }

    #[inline]
    fn surface_point(&self, _: &Ray, hit: &Hit) -> SurfacePoint {
        self.surface_point(hit.u, hit.v)
    }
}

/// How far from the plane the sign of `t` is certain.
///
/// Let `L` be the longest edge, `N` the cross product of two, and `u` a unit of rounding. A ray that begins
/// near the triangle and hits it sees corners within `L`; `t·det` is its distance times `|N|`. Three errors
/// add up:
/// * Places in the sheared plane are off by at most `2u` of what a corner lies aside and `5u` of what it
///   lies ahead, along two axes. This moves the plane, where the ray meets it, by at most `7.3u·L`.
/// * Sides are off by `u` times the product of two places' distances from the ray. From a point of a
///   triangle, the three products are together at most 1.2 times the square of its longest edge. With
///   the shear, and times the depth of the third corner, that is at most `3.2u·L³`.
/// * The sum of three products is off by at most `3u·L·|N|`.
///
/// As `|N| ≤ L²`, all of it is less than `14u·L³/|N|`. For slivers, whose area is all rounding, the
/// distance is cut to a thousandth of the longest edge: beyond it the offset itself would show.
fn clearance(e1: DVec3, e2: DVec3, double_area_recip: f64) -> f64 {
    const FACTOR: f64 = 14.0 * UNIT_ROUNDOFF;
    let square = e1.length_squared().max(e2.length_squared()).max((e2 - e1).length_squared());
    square.sqrt() * (FACTOR * double_area_recip * square).min(1e-3)
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
            let of_triangles = TriangleRay::from(&ray);
            let corners = t.corners.map(|corner| {
                of_triangles.axes().arrange(&corner.to_array()).map(glam::Vec4::splat)
            });
            let h = scaled_hit(&of_triangles.splat::<glam::Vec4>(), corners);
            let inside = h.inside.bits() >> 3 & 1 != 0;
            let time = h.t[3] / h.scale[3];
            let lanes = (inside && (0.0..=f32::MAX).contains(&time))
                .then(|| (time, h.u[3] / h.scale[3], h.v[3] / h.scale[3]));
            let bits = |h: Option<(f32, f32, f32)>| {
                h.map(|(t, u, v)| [t.to_bits(), u.to_bits(), v.to_bits()])
            };
            assert_eq!(bits(t.intersect(&ray)), bits(lanes));
            hits += u32::from(lanes.is_some());
        }
        assert!(hits > 100, "{hits}");
    }

    #[test]
    fn every_ray_in_a_fan_around_a_corner_is_in_one_of_its_triangles() {
        let mut random = Random::new(&[41]);
        let mut hits = [0; 4];
        for number in 0..40_000u32 {
            let scale = [1.0, 1e-6, 1e6, 1e-3][number as usize % 4];
            let mut point = || Vec3::from_array(std::array::from_fn(|_| random.next_f32() - 0.5));
            let (hub, origin) = (scale * point(), 10.0 * scale * point());
            // Corners around the hub as the ray sees it: what they enclose contains the hub.
            let dir = (hub - origin).normalize();
            let across = dir.any_orthonormal_vector();
            let up = dir.cross(across);
            let rim: [Vec3; 5] = std::array::from_fn(|i| {
                let (sin, cos) = (std::f32::consts::TAU * (i as f32 / 5.0)).sin_cos();
                hub + scale * (cos * across + sin * up + 0.5 * point())
            });
            let to = if number % 3 == 0 { hub } else { hub.lerp(rim[0], 0.3 * random.next_f32()) };
            let ray = Ray::new(origin, to - origin);
            let count = (0..5)
                .filter(|&i| {
                    Triangle::new([hub, rim[i], rim[(i + 1) % 5]]).intersect(&ray).is_some()
                })
                .count();
            assert!(count > 0, "{ray:?} gets through a corner at {hub}");
            hits[count.min(3)] += 1;
        }
        assert!(hits[1] > 0 && hits[2] > 0, "on edges, too: {hits:?}");
    }

    #[test]
    fn a_triangle_whose_area_is_rounded_to_nothing_is_hit_if_it_contains_the_ray() {
        let mut random = Random::new(&[43]);
        let (mut inside, mut beside) = (0, 0);
        for _ in 0..100_000 {
            // Nearly on a line through the ray, on both sides of it.
            let mut near = |size: f32| size * (1.0 + random.below(6) as f32 * f32::EPSILON);
            let corners =
                [[near(1.0), near(1.0)], [near(-1.0), near(-1.0)], [near(0.75), near(0.75)]];
            let triangle = Triangle::new(corners.map(|[x, y]| Vec3::new(x, y, 2.0)));
            let ray = Ray::new(Vec3::ZERO, Vec3::Z);
            let corners = triangle.corners.map(|corner| corner.to_array());
            let hit = scaled_hit(&TriangleRay::from(&ray).splat::<f32>(), corners);
            if hit.flat() == 0 {
                continue;
            }
            let [a, b, c] = triangle.corners.map(|corner| corner.as_dvec3().truncate());
            let sides = [a.perp_dot(b), b.perp_dot(c), c.perp_dot(a)];
            let area: f64 = sides.iter().sum();
            let contains = area != 0.0 && sides.iter().all(|side| side * area >= 0.0);
            let hit = triangle.intersect(&ray);
            assert_eq!(hit.is_some(), contains, "{triangle:?}");
            if let Some((t, u, v)) = hit {
                assert!(t == 2.0 && u >= 0.0 && v >= 0.0 && u + v <= 1.0, "{t} {u} {v}");
                inside += 1;
            } else {
                beside += 1;
            }
        }
        assert!(inside > 100 && beside > 100, "{inside} {beside}");
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
            let corners = triangle.corners.map(|corner| Vec3A::from(corner).as_dvec3());
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
        let plane_distance = (p.position - t.corners[0].as_dvec3()).dot(p.normal.normalize());
        assert!(plane_distance.abs() < 1e-12);
        assert!(p.clearance > 0.0 && p.clearance < 1e-4);
    }

    #[test]
    fn sixteen_rays_find_what_each_of_them_finds() {
        let corners = [Vec3::new(-2.0, -1.0, 0.0), Vec3::X, Vec3::splat(1.5)];
        assert_same_bits(&Single::Triangle(Triangle::new(corners)));
    }
}
