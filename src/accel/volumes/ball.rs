//! Bounding balls.
//!
//! * *Idea*: As a tree of boxes, but a node has a ball around it: a test without a direction's sign or
//!   order, and the same from all sides.
//! * *Paper*: Rubin, Whitted: *A 3-dimensional representation for fast rendering of complex scenes*,
//!   1980, for the hierarchy; Weghorst, Hooper, Greenberg: *Improved computational methods for ray
//!   tracing*, 1984, for what a volume's form costs and gives.
//! * *Build*: that of the binary tree (`builder=`), and O(n · depth) for the balls.
//! * *A ray*: O(log n) nodes in the mean, two balls each.
//! * *Memory*: 48 bytes a node: of each child centre, radius and place.
//! * *It wins*: seldom: where objects are round. Balls around flat or long parts are much larger than
//!   boxes, and overlap.
//! * *Picture*: `docs/gallery/cells-balls.png`.

use glam::Vec3;
use rayon::prelude::*;

use crate::math::{Aabb, BoxRay, NONE, Ray, round_up};

use super::super::RegionForm;
use super::super::sphere_ray::SphereRay;
use super::Volume;

/// A ball.
#[derive(Clone, Copy, Debug, Default)]
pub struct Ball {
    center: Vec3,
    /// Not less than the distance of any corner of a box inside.
    radius: f32,
}

impl Volume for Ball {
    type Ray = SphereRay;

    fn ray(ray: &Ray, box_ray: &BoxRay) -> SphereRay {
        SphereRay::new(ray, box_ray)
    }

    fn around(bounds: &Aabb, boxes: &[Aabb], some: &[u32]) -> Self {
        let center = Vec3::from(0.5 * bounds.min + 0.5 * bounds.max);
        let middle = center.as_dvec3();
        let square = |&index: &u32| {
            // Of a box the corner that is farther along each axis.
            let bounds = boxes[index as usize];
            let [low, high] = [bounds.min, bounds.max].map(|corner| Vec3::from(corner).as_dvec3());
            (low - middle).abs().max((high - middle).abs()).length_squared()
        };
        let all = some.par_iter().with_min_len(1 << 12).filter(|&&index| index != NONE);
        let largest = all.map(square).reduce(|| 0.0, f64::max);
        let radius = round_up(largest.sqrt() * (1.0 + 4.0 * f64::EPSILON));
        Self { center, radius }
    }

    fn form(&self) -> RegionForm {
        RegionForm::Ball { center: self.center, radius: self.radius }
    }

    #[inline(always)]
    fn entered(&self, ray: &SphereRay, end: f32) -> Option<f64> {
        ray.enters(self.center.as_dvec3(), f64::from(self.radius), end)
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::*;
    use super::*;

    #[test]
    fn balls_hold_the_corners_of_all_boxes_below() {
        assert_volumes_hold_what_is_below(|ball: &Ball, bounds| {
            let (center, radius) = (ball.center.as_dvec3(), f64::from(ball.radius));
            let corners = bounds.corners().map(|corner| Vec3::from(corner).as_dvec3());
            corners.iter().all(|corner| corner.distance_squared(center) <= radius * radius)
        });
    }

    #[test]
    fn what_the_padded_box_accepts_the_ball_accepts() {
        assert_what_the_box_accepts_the_volume_accepts::<Ball>();
    }
}
