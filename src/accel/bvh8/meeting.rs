//! How many rays meet a box, of those that begin within the scene.
//!
//! Of straight lines through the root's box, as many meet a box in it as its surface is a share of the root's: this is
//! the surface area heuristic. A ray is the part of a line behind its origin, which may be anywhere on the line with
//! equal chance. A thin box is met by those that begin before it, half of the rays on a line that meets it; a thick one
//! by those that begin within it, too. So a ray meets a box with a chance of half the share of its surface, and of half
//! of what the line has in common with the box, as a share of the line, which in the mean of all lines is about the
//! share of its volume. The flat walls of a hall are met by half as many rays as their surfaces say, and a box as large
//! as the hall by all of them. The question is put by Fabianowski, Fowler, Dingliana: *A Cost Metric for Scene-Interior
//! Ray Origins*, 2009.

use glam::Vec3A;
use obvhs::aabb::Aabb;

/// Surfaces are cut to this, so that no sum of costs leaves what `f32` can hold.
const LARGEST_AREA: f32 = 1e30;

/// The share of the rays that meet a box.
pub(super) struct Meeting {
    /// One over the extents of the root; 0 if it has none.
    inv_size: Vec3A,
    /// Half of the surface of the root.
    area: f32,
}

impl Meeting {
    /// Of rays that begin within a box.
    pub(super) fn within(root: &Aabb) -> Self {
        let size = root.diagonal();
        let inv_size = Vec3A::select(size.cmpgt(Vec3A::ZERO), size.recip(), Vec3A::ZERO);
        Self { inv_size, area: root.half_area().min(LARGEST_AREA) }
    }

    /// How many they are, in units of surface: as many as all rays are the surface of the root.
    #[inline(always)]
    pub(super) fn of(&self, aabb: &Aabb) -> f32 {
        let [x, y, z] = (aabb.diagonal() * self.inv_size).to_array();
        // The smaller one, even if the other is not a number, as where the root is as large as floats can be.
        aabb.half_area().min(LARGEST_AREA) + self.area * (x * y * z).min(1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Random;

    /// Whether the ray from a point meets a box.
    fn meets(origin: Vec3A, dir: Vec3A, aabb: &Aabb) -> bool {
        let (a, b) = ((aabb.min - origin) / dir, (aabb.max - origin) / dir);
        a.min(b).max_element().max(0.0) <= a.max(b).min_element()
    }

    #[test]
    fn as_many_rays_meet_a_box_as_are_expected() {
        let of = |min: [f32; 3], max: [f32; 3]| Aabb { min: min.into(), max: max.into() };
        let hall = of([0.0; 3], [3.0, 1.0, 2.0]);
        let boxes = [
            hall,
            of([0.0; 3], [3.0, 0.0, 2.0]),
            of([0.0; 3], [3.0, 1.0, 0.0]),
            of([1.0, 0.2, 0.5], [2.0, 0.6, 1.3]),
            of([0.0; 3], [1.5, 1.0, 2.0]),
            of([0.1, 0.4, 0.2], [2.9, 0.5, 1.8]),
        ];
        let mut random = Random::new(&[77]);
        let mut point = || Vec3A::from_array(std::array::from_fn(|_| random.next_f32()));
        let (mut lines, mut met) = (0.0, [0.0; 6]);
        while lines < 20_000.0 {
            // Lines that are spread evenly: through a disk that is turned at random, around the middle.
            let (dir, across) = (2.0 * point() - 1.0, 2.0 * point() - 1.0);
            if dir.length() > 1.0 || across.length() > 1.0 {
                continue;
            }
            let dir = dir.normalize();
            let start = hall.center() + 2.0 * (across - across.dot(dir) * dir);
            // Points on it, from before the hall to behind it: those within are origins.
            let along = (0..100).map(|step| start + (0.04 * step as f32 - 2.0) * dir);
            let within = |p: &Vec3A| p.cmpge(hall.min).all() && p.cmple(hall.max).all();
            let origins: Vec<_> = along.filter(within).collect();
            for (aabb, met) in boxes.iter().zip(&mut met) {
                let count = origins.iter().filter(|&&origin| meets(origin, dir, aabb)).count();
                *met += count as f32 / origins.len().max(1) as f32;
            }
            lines += f32::from(u8::from(!origins.is_empty()));
        }
        let meeting = Meeting::within(&hall);
        for (aabb, met) in boxes.iter().zip(met) {
            let (found, expected) = (met / lines, meeting.of(aabb) / meeting.of(&hall));
            assert!((found - expected).abs() < 0.15 * found, "{aabb:?}: {found} and {expected}");
        }
    }

    #[test]
    fn roots_without_a_volume_or_with_one_that_is_no_float_have_surfaces_alone() {
        let flat = Aabb { min: Vec3A::ZERO, max: Vec3A::new(2.0, 0.0, 3.0) };
        let part = Aabb { min: Vec3A::ZERO, max: Vec3A::new(1.0, 0.0, 3.0) };
        assert_eq!(Meeting::within(&flat).of(&part), part.half_area());
        let huge = Aabb { min: Vec3A::splat(f32::MIN), max: Vec3A::splat(f32::MAX) };
        assert!(Meeting::within(&huge).of(&huge).is_finite());
        assert!(Meeting::within(&huge).of(&part).is_finite());
    }
}
