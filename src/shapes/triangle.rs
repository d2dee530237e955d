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
    /// One of a mesh, by the indices of its corners.
    #[inline(always)]
    pub(super) fn of_mesh(positions: &[Vec3], corners: &[u32; 3]) -> Self {
        Self::new(corners.map(|corner| positions[corner as usize]))
    }

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
        within(t, [ray.t_min, ray.end()]).then(|| (t, hit.u / hit.scale, hit.v / hit.scale))
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
        let mut hits = of_triangles.scaled_hit(|corner, axis| corners[corner][axis as usize]);
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
mod tests;
