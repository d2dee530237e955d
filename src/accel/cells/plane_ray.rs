//! A ray as the planes between cells see it.

use crate::math::slab::crossing;
use crate::math::{BoxRay, Ray};

/// Where a ray crosses planes, measured as [`BoxRay::interval`] measures the sides of boxes: for the
/// cell that it leaves there, and for the one that it enters. It never leaves before it enters, since
/// both are padded.
pub(in super::super) struct PlaneRay {
    leave: [f32; 3],
    enter: [f32; 3],
    inv_dir: [f32; 3],
    origin: [f32; 3],
    dir: [f32; 3],
    /// Whether it runs upwards along an axis.
    pub(in super::super) upwards: [bool; 3],
}

impl PlaneRay {
    #[inline(always)]
    pub(in super::super) fn new(ray: &Ray, box_ray: &BoxRay) -> Self {
        let (plus, minus) = (box_ray.origin_plus.to_array(), box_ray.origin_minus.to_array());
        let inv_dir = box_ray.inv_dir.to_array();
        let upwards = inv_dir.map(|inv| inv > 0.0);
        // Upwards, a plane is the high side of the cell that is left, and the low side of the one that
        // is entered.
        let pick = |up: [f32; 3], down: [f32; 3]| {
            std::array::from_fn(|axis| if upwards[axis] { up[axis] } else { down[axis] })
        };
        let (leave, enter) = (pick(minus, plus), pick(plus, minus));
        let (origin, dir) = (ray.origin.to_array(), ray.dir.to_array());
        Self { leave, enter, inv_dir, origin, dir, upwards }
    }

    /// About where it is along an axis.
    #[inline(always)]
    pub(in super::super) fn coordinate(&self, axis: usize, t: f32) -> f32 {
        self.origin[axis] + t * self.dir[axis]
    }

    /// When it leaves the cell before a plane.
    #[inline(always)]
    pub(in super::super) fn leaves(&self, axis: usize, plane: f32) -> f32 {
        crossing(plane, self.leave[axis], self.inv_dir[axis])
    }

    /// When it enters the cell behind a plane.
    #[inline(always)]
    pub(in super::super) fn enters(&self, axis: usize, plane: f32) -> f32 {
        crossing(plane, self.enter[axis], self.inv_dir[axis])
    }
}

#[cfg(test)]
mod tests {
    use glam::{Vec3, Vec3A};

    use super::*;
    use crate::math::{Aabb, Padding, Random};

    #[test]
    fn the_planes_of_a_box_give_its_interval_to_the_bit() {
        let mut random = Random::new(&[61]);
        for number in 0..2_000 {
            let mut point = || Vec3A::from_array(std::array::from_fn(|_| random.next_f32() - 0.5));
            let cell = Aabb::of_points([point(), point()]);
            let (origin, mut dir) = (3.0 * Vec3::from(point()), Vec3::from(point()));
            dir[number % 3] *= [1.0, 0.0, -0.0, 1e-40][number / 3 % 4];
            let ray = Ray::new(origin, dir);
            let box_ray = BoxRay::new(&ray, Padding::of_bounds(&cell));
            let ray = PlaneRay::new(&ray, &box_ray);
            let sides = |axis: usize| {
                let (low, high) = (cell.min[axis], cell.max[axis]);
                if ray.upwards[axis] { (low, high) } else { (high, low) }
            };
            let near = (0..3).map(|axis| ray.enters(axis, sides(axis).0));
            let far = (0..3).map(|axis| ray.leaves(axis, sides(axis).1));
            let interval =
                (near.fold(f32::NEG_INFINITY, f32::max), far.fold(f32::INFINITY, f32::min));
            assert_eq!(interval, box_ray.interval(&cell));
            let plane = cell.center().x;
            assert!(ray.enters(0, plane) <= ray.leaves(0, plane));
        }
    }
}
