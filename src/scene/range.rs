//! The range of lengths in which the formulas hold in single precision.
//!
//! The formulas multiply lengths before they divide. With L the largest coordinate of anything in
//! the world, differences and directions of shadow rays have coordinates of up to 2L:
//!
//! * a ball takes the root of |d|²·r² (see [`Ball::crossing`](crate::shapes::Ball::crossing)), up
//!   to 12L²·L²: finite up to L = 2.3·10⁹;
//! * a triangle's determinant and weights are sums of six products of three differences, up to
//!   48L³: finite up to L = 1.9·10¹².
//!
//! [`LARGEST`] is below both. Downwards products must not leave the normal numbers, or they lose
//! digits: [`SMALLEST`] leaves triangles a thousandth as large as their object with
//! (10⁻¹²)²·10⁻⁹ = 10⁻³³, and balls with the products of their formula at 10⁻³⁷ or more, where the
//! smallest normal number is 1.2·10⁻³⁸. Triangles much smaller than that are hit less precisely,
//! but every structure still finds the same hits.
//!
//! Under a transform the formulas are computed in the object's own space, and [`holds_in`] checks the
//! numbers there.

use glam::DVec3;

use crate::math::{Aabb, Transform};

/// The largest coordinate in the world: of objects' boxes, of the eye, of lights, of view rays.
pub(super) const LARGEST: f64 = 1e9;

/// The smallest length: of the largest side of an object's box, of view rays.
pub(super) const SMALLEST: f64 = 1e-9;

/// How much smaller than their mesh most triangles are, at the least.
const DETAIL: f64 = 1e-3;

/// Whether a point of the world is within the range.
pub(super) fn holds_at(point: DVec3) -> bool {
    // A NaN is not.
    point.abs().max_element() <= LARGEST && !point.is_nan()
}

/// Whether a box in the world is neither too large, too far away, nor too small. One of its sides
/// may be 0: that of a flat mesh.
pub(super) fn holds_for(bounds: &Aabb) -> bool {
    let reach = f64::from(bounds.largest_coordinate());
    let side = f64::from(bounds.size().max_element());
    !bounds.is_empty() && reach <= LARGEST && side >= SMALLEST
}

/// Whether the formulas hold in the own space of an object, of which `own` is its box there, for
/// rays that start up to `reach` from the world's origin.
pub(super) fn holds_in(transform: &Transform, own: &Aabb, reach: f64) -> bool {
    let back = &transform.object_from_world;
    let rays = (back.matrix3.abs() * DVec3::splat(2.0 * reach) + back.translation.abs())
        .max_element()
        .max(f64::from(own.largest_coordinate()));
    let size = f64::from(own.size().max_element());
    let forward = transform.world_from_object.matrix3.abs();
    let stretch = (forward * DVec3::ONE).max_element();
    // Six products of two differences that a ray spans, and an edge.
    let largest_product = 6.0 * rays * rays * size;
    // Two edges, and a direction of unit length in the world.
    let smallest_product = (DETAIL * size).powi(2) / stretch;
    largest_product <= f64::from(f32::MAX) && smallest_product >= f64::from(f32::MIN_POSITIVE)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Ray;
    use crate::shapes::{Ball, Triangle};
    use glam::{DAffine3, Vec3, Vec3A};

    fn cube(side: f32) -> Aabb {
        Aabb { min: Vec3A::ZERO, max: Vec3A::splat(side) }
    }

    #[test]
    fn boxes_and_points_within_the_range_hold() {
        assert!(holds_for(&cube(1e9)) && !holds_for(&cube(1.01e9)));
        assert!(holds_for(&cube(1.01e-9)) && !holds_for(&cube(0.99e-9)));
        assert!(!holds_for(&Aabb::EMPTY));
        assert!(!holds_for(&cube(f32::INFINITY)));
        assert!(holds_at(DVec3::splat(-1e9)) && !holds_at(DVec3::new(0.0, 0.0, 2e9)));
        assert!(!holds_at(DVec3::new(0.0, f64::NAN, 0.0)));
    }

    #[test]
    fn the_formulas_hold_at_the_ends_of_the_range() {
        for size in [1e-9f32, 1.0, 1e9] {
            let ball = Ball { center: Vec3::ZERO, radius: size };
            let triangle =
                Triangle::new([Vec3::new(-1.0, -1.0, 0.0), Vec3::X, Vec3::Y].map(|p| size * p));
            // As a shadow ray: what lies between its ends is at 0 < t < 1.
            let ray = Ray::new(Vec3::splat(size), Vec3::splat(-2.0 * size));
            let (enter, leave) = ball.crossing(&ray).unwrap();
            let exact = 0.5 - 0.5 / 3f32.sqrt();
            assert!((enter - exact).abs() < 1e-6 && (enter + leave - 1.0).abs() < 1e-6, "{size:e}");
            let (t, u, v) = triangle.intersect(&ray).unwrap();
            assert!((t - 0.5).abs() < 1e-6 && (u + v - 2.0 / 3.0).abs() < 1e-6, "{size:e}: {t}");
        }
    }

    #[test]
    fn own_spaces_hold_as_far_as_their_products_do() {
        let holds = |scale: f64, own: f32, reach| {
            let transform = Transform::new(DAffine3::from_scale(DVec3::splat(scale))).unwrap();
            holds_in(&transform, &cube(own), reach)
        };
        assert!(holds(1.0, 1.0, 1e9) && holds(1e-9, 1.0, 1.0) && holds(1e9, 1.0, 1e9));
        assert!(holds(1e-9, 1e9, 1.0), "a mesh in nanometres");
        assert!(!holds(1e-30, 1e30, 1.0) && !holds(1e30, 1e-30, 1.0));
        assert!(!holds(1e-20, 1.0, 1.0));
    }
}
