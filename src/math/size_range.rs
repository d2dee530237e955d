//! The range of lengths in which the formulas hold in single precision.
//!
//! The formulas multiply lengths before they divide. With L the largest coordinate of anything that is
//! traced, differences and directions of rays between two points have coordinates of up to 2L:
//!
//! * a ball takes the root of |d|²·r² (see [`Ball::crossing`](crate::shapes::Ball::crossing)), up
//!   to 12L²·L²: finite up to L = 2.3·10⁹;
//! * a triangle's determinant and weights are sums of six products of three differences, up to
//!   48L³: finite up to L = 1.9·10¹².
//!
//! Downwards products must not leave the normal numbers, or they lose digits, and in the end all of
//! them. With s the largest side of what it belongs to, a triangle a thousandth as large, met from a
//! distance of s, has a product of (10⁻³·s)²·s: 10⁻³⁶ where s is 10⁻¹⁰, and the smallest normal number is
//! 1.2·10⁻³⁸. The world's range leaves it with (10⁻¹²)²·10⁻⁹ = 10⁻³³, and balls with the products of their
//! formula at 10⁻³⁷ or more. Triangles much smaller than that are hit less precisely, but every structure
//! still finds the same hits.

use glam::DVec3;

use super::Aabb;

/// How far away and how small something may be to be traced.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SizeRange {
    /// The largest coordinate.
    pub largest: f64,
    /// The smallest length of the largest side of its box.
    pub smallest: f64,
}

impl SizeRange {
    /// Of everything in the world of a scene, whatever its shape: objects' boxes, the eye, lights, view
    /// rays.
    pub const WORLD: Self = Self { largest: 1e9, smallest: 1e-9 };

    /// Of the triangles of a mesh in their own space.
    pub const TRIANGLES: Self = Self { largest: 1e12, smallest: 1e-10 };

    /// Whether a point is not too far away.
    #[must_use]
    pub fn holds_at(&self, point: DVec3) -> bool {
        // A NaN is not.
        point.abs().max_element() <= self.largest && !point.is_nan()
    }

    /// Whether a box is neither too large, too far away, nor too small. Other sides than the largest may
    /// be 0: one of a flat mesh is.
    #[must_use]
    pub fn holds_for(&self, bounds: &Aabb) -> bool {
        let reach = f64::from(bounds.largest_coordinate());
        let side = f64::from(bounds.size().max_element());
        !bounds.is_empty() && reach <= self.largest && side >= self.smallest
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3A;

    fn cube(side: f32) -> Aabb {
        Aabb { min: Vec3A::ZERO, max: Vec3A::splat(side) }
    }

    #[test]
    fn boxes_and_points_within_the_range_hold() {
        let world = SizeRange::WORLD;
        let holds = |side| world.holds_for(&cube(side));
        assert!(holds(1e9) && !holds(1.01e9));
        assert!(holds(1.01e-9) && !holds(0.99e-9));
        assert!(!world.holds_for(&Aabb::EMPTY));
        assert!(!holds(f32::INFINITY));
        assert!(world.holds_at(DVec3::splat(-1e9)) && !world.holds_at(DVec3::new(0.0, 0.0, 2e9)));
        assert!(!world.holds_at(DVec3::new(0.0, f64::NAN, 0.0)));
    }
}
