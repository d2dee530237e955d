//! The part of a triangle that lies within a box (Sutherland, Hodgman: *Reentrant polygon
//! clipping*, 1974), in `f64`.

use glam::{DVec3, Vec3A};
use smallvec::SmallVec;

use crate::math::{Aabb, round_down, round_up};

/// A triangle cut by six planes has at most nine corners.
type Polygon = SmallVec<[DVec3; 9]>;

/// The area of a triangle.
pub(super) fn area([a, b, c]: [DVec3; 3]) -> f64 {
    0.5 * (b - a).cross(c - a).length()
}

/// The area of the part of a triangle within a box. A triangle in the plane of a face is inside,
/// as it is for rays.
pub(super) fn area_within(corners: [DVec3; 3], bounds: &Aabb) -> f64 {
    let polygon = part_within(corners, bounds.min.as_dvec3(), bounds.max.as_dvec3());
    let Some(&first) = polygon.first() else { return 0.0 };
    let fan = polygon.windows(2).map(|edge| (edge[0] - first).cross(edge[1] - first));
    0.5 * fan.sum::<DVec3>().length()
}

/// How far the cuts by six planes move a point, at most, as a share of the largest coordinate: each
/// cut takes a few roundings of 2⁻⁵³, and may double what the one before it took. It is far below
/// the 2⁻²⁴ of what is rounded to `f32` in the end.
const CUT_ERROR: f64 = 1.0 / (1u64 << 40) as f64;

/// A box around the part of a triangle within a box, which it may exceed by rounding.
///
/// The planes are moved out by the error of the cuts, so that no point is lost where a plane nearly
/// runs along an edge, and so is the box of what they leave.
pub(super) fn bounds_within(corners: [Vec3A; 3], bounds: &Aabb) -> Aabb {
    let largest = Aabb::of_points(corners).largest_coordinate();
    let margin = DVec3::splat(f64::from(largest) * CUT_ERROR);
    let (min, max) = (bounds.min.as_dvec3() - margin, bounds.max.as_dvec3() + margin);
    let polygon = part_within(corners.map(Vec3A::as_dvec3), min, max);
    polygon.iter().fold(Aabb::EMPTY, |around, &point| Aabb {
        min: around.min.min(Vec3A::from_array((point - margin).to_array().map(round_down))),
        max: around.max.max(Vec3A::from_array((point + margin).to_array().map(round_up))),
    })
}

/// The part of a triangle between two corners of a box; a polygon without corners if there is none.
fn part_within(corners: [DVec3; 3], min: DVec3, max: DVec3) -> Polygon {
    let low = corners[0].min(corners[1]).min(corners[2]);
    let high = corners[0].max(corners[1]).max(corners[2]);
    if !(low.cmple(max).all() && min.cmple(high).all()) {
        return Polygon::new();
    }
    let mut polygon = Polygon::from_slice(&corners);
    for axis in 0..3 {
        // Planes that cut nothing off are left out.
        if low[axis] < min[axis] {
            polygon = above(&polygon, |p| p[axis] - min[axis]);
        }
        if high[axis] > max[axis] {
            polygon = above(&polygon, |p| max[axis] - p[axis]);
        }
    }
    polygon
}

/// The part of a convex polygon in which a linear function is not negative.
fn above(polygon: &Polygon, height: impl Fn(DVec3) -> f64) -> Polygon {
    let mut part = Polygon::new();
    let Some(&last) = polygon.last() else { return part };
    let mut from = (last, height(last));
    for &corner in polygon {
        let to = (corner, height(corner));
        if (from.1 < 0.0) != (to.1 < 0.0) {
            part.push(from.0.lerp(to.0, from.1 / (from.1 - to.1)));
        }
        if to.1 >= 0.0 {
            part.push(to.0);
        }
        from = to;
    }
    part
}

#[cfg(test)]
mod tests {
    use glam::Vec3A;

    use super::*;

    const CORNERS: [DVec3; 3] = [DVec3::ZERO, DVec3::new(2.0, 0.0, 0.0), DVec3::new(0.0, 2.0, 0.0)];

    fn within(min: [f32; 3], max: [f32; 3]) -> f64 {
        let bounds = Aabb { min: Vec3A::from_array(min), max: Vec3A::from_array(max) };
        area_within(CORNERS, &bounds)
    }

    /// Equal up to rounding.
    fn assert_close(a: f64, b: f64, what: &str) {
        assert!((a - b).abs() < 1e-12, "{what}: {a} is not {b}");
    }

    #[test]
    fn areas_are_those_of_closed_forms() {
        assert_eq!(area(CORNERS), 2.0);
        assert_close(within([-1.0; 3], [3.0; 3]), 2.0, "all of it");
        assert_close(within([0.0, 0.0, 0.0], [2.0, 2.0, 0.0]), 2.0, "in a box without height");
        assert_close(within([0.5, 0.5, -1.0], [2.5, 2.5, 1.0]), 0.5, "a corner of it");
        assert_close(within([0.5, 0.5, 0.0], [0.75, 0.75, 1.0]), 0.0625, "the whole of a box");
        assert_close(within([0.0, 0.0, 0.0], [1.5, 1.5, 1.0]), 1.75, "without two corners");
        assert_close(within([0.0, 0.0, 0.1], [2.0, 2.0, 1.0]), 0.0, "above it");
        assert_close(within([1.5, 1.5, -1.0], [2.0, 2.0, 1.0]), 0.0, "beside it, within its box");
        // A slope of 45 degrees through the middle of a unit cube: a square of height √2.
        let slope = [[-9.0, -9.0, -9.0], [9.0, 27.0, 9.0], [9.0, -45.0, 9.0]].map(DVec3::from);
        let cube = Aabb { min: Vec3A::splat(-0.5), max: Vec3A::splat(0.5) };
        assert_close(area_within(slope, &cube), 2f64.sqrt(), "a slope");
    }
}
