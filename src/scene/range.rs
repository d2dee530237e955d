//! The range of lengths in which the formulas hold in single precision, under a transform: they are
//! computed in the object's own space, and the numbers there count. Without one, see
//! [`SizeRange`](crate::math::SizeRange).

use glam::DVec3;

use crate::math::{Aabb, Transform};

/// How much smaller than their mesh most triangles are, at the least.
const DETAIL: f64 = 1e-3;

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
    use crate::math::{Ray, SizeRange};
    use crate::shapes::{Ball, Triangle};
    use glam::{DAffine3, Vec3, Vec3A};

    fn cube(side: f32) -> Aabb {
        Aabb { min: Vec3A::ZERO, max: Vec3A::splat(side) }
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

    fn triangle(size: f32) -> Triangle {
        Triangle::new([Vec3::new(-1.0, -1.0, 0.0), Vec3::X, Vec3::Y].map(|p| size * p))
    }

    #[test]
    fn the_formulas_hold_at_the_ends_of_the_range() {
        for size in [1e-9f32, 1.0, 1e9] {
            let ball = Ball { center: Vec3::ZERO, radius: size };
            // As a shadow ray: what lies between its ends is at 0 < t < 1.
            let ray = Ray::new(Vec3::splat(size), Vec3::splat(-2.0 * size));
            let (enter, leave) = ball.crossing(&ray).unwrap();
            let exact = 0.5 - 0.5 / 3f32.sqrt();
            assert!((enter - exact).abs() < 1e-6 && (enter + leave - 1.0).abs() < 1e-6, "{size:e}");
            let (t, u, v) = triangle(size).intersect(&ray).unwrap();
            assert!((t - 0.5).abs() < 1e-6 && (u + v - 2.0 / 3.0).abs() < 1e-6, "{size:e}: {t}");
        }
    }

    #[test]
    fn triangles_are_hit_at_the_ends_of_their_range() {
        let SizeRange { largest, smallest } = SizeRange::TRIANGLES;
        let (largest, smallest) = (largest as f32, smallest as f32);
        for (size, distance) in [(1e-3 * smallest, smallest), (1.0, 1.0), (largest, largest)] {
            let ray = Ray::new(Vec3::splat(distance), Vec3::splat(-1.0));
            let (t, u, v) = triangle(size).intersect(&ray).unwrap();
            assert!((t / distance - 1.0).abs() < 1e-5, "{size:e}: {t}");
            assert!((u + v - 2.0 / 3.0).abs() < 1e-3, "{size:e}: {u} {v}");
        }
    }
}
