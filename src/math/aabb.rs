//! Axis-aligned bounding boxes.

use glam::Vec3A;

/// The points between two corners, faces included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// The corner with the smallest coordinates.
    pub min: Vec3A,
    /// The corner with the largest coordinates.
    pub max: Vec3A,
}

impl Aabb {
    /// The box of no points: the neutral element of [`union`](Self::union).
    pub const EMPTY: Self = Self { min: Vec3A::INFINITY, max: Vec3A::NEG_INFINITY };

    /// The smallest box around some points.
    #[must_use]
    pub fn of_points(points: impl IntoIterator<Item = Vec3A>) -> Self {
        points.into_iter().fold(Self::EMPTY, |b, p| Self { min: b.min.min(p), max: b.max.max(p) })
    }

    /// The smallest box around two boxes.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// The points of both boxes: [`EMPTY`](Self::EMPTY) where there are none.
    #[must_use]
    pub fn intersection(self, other: Self) -> Self {
        let both = Self { min: self.min.max(other.min), max: self.max.min(other.max) };
        if both.is_empty() { Self::EMPTY } else { both }
    }

    /// Whether it holds no point.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        !self.min.cmple(self.max).all()
    }

    /// The middle of the box; NaN for the [empty](Self::EMPTY) one.
    #[must_use]
    pub fn center(&self) -> Vec3A {
        // Halved before they are added: the sum of two large coordinates could overflow.
        0.5 * self.min + 0.5 * self.max
    }

    /// Edge lengths; −∞ for the [empty](Self::EMPTY) box.
    #[must_use]
    pub fn size(&self) -> Vec3A {
        self.max - self.min
    }

    /// Half of its surface, in `f64`: proportional to the chance that a random line meets it.
    /// Infinite for the [empty](Self::EMPTY) box: ask [`is_empty`](Self::is_empty) before.
    #[must_use]
    pub fn half_area(&self) -> f64 {
        let [x, y, z] = self.size().to_array().map(f64::from);
        x * y + y * z + z * x
    }

    /// The largest absolute coordinate of any of its points; 0 for the empty box.
    #[must_use]
    pub fn largest_coordinate(&self) -> f32 {
        if self.is_empty() { 0.0 } else { self.min.abs().max(self.max.abs()).max_element() }
    }

    /// The eight corners.
    #[must_use]
    pub fn corners(&self) -> [Vec3A; 8] {
        std::array::from_fn(|i| {
            let pick =
                |axis: usize| if i >> axis & 1 == 0 { self.min[axis] } else { self.max[axis] };
            Vec3A::new(pick(0), pick(1), pick(2))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn union_and_corners_are_those_of_the_points() {
        let a = Aabb::of_points([Vec3A::new(1.0, 2.0, 3.0), Vec3A::new(-1.0, 5.0, 0.0)]);
        assert_eq!(a.min, Vec3A::new(-1.0, 2.0, 0.0));
        assert_eq!(a.max, Vec3A::new(1.0, 5.0, 3.0));
        assert_eq!(Aabb::of_points(a.corners()), a);
        assert_eq!(a.union(Aabb::EMPTY), a);
        assert_eq!(a.largest_coordinate(), 5.0);
        assert_eq!(a.half_area(), 2.0 * 3.0 + 3.0 * 3.0 + 3.0 * 2.0);
        assert!(Aabb::EMPTY.is_empty() && !a.is_empty());
        assert_eq!(Aabb::EMPTY.largest_coordinate(), 0.0);
    }

    #[test]
    fn boxes_that_touch_meet_in_a_face_and_others_nowhere() {
        let unit = Aabb { min: Vec3A::ZERO, max: Vec3A::ONE };
        let beside = |x: f32| Aabb { min: Vec3A::new(x, 0.5, -1.0), max: Vec3A::splat(3.0) };
        let face = Aabb { min: Vec3A::new(1.0, 0.5, 0.0), max: Vec3A::ONE };
        assert_eq!(unit.intersection(beside(1.0)), face);
        assert_eq!(unit.intersection(beside(2.0)), Aabb::EMPTY);
        assert_eq!(unit.intersection(Aabb::EMPTY), Aabb::EMPTY);
    }
}
