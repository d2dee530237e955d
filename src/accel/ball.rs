//! One bounding ball around all primitives: the optimization of the course.
//!
//! Centre: the mean of the vertices. Radius: the largest distance from it. Here that is the
//! distance to the corners of the primitives' boxes, not only to the vertices: equal hits require
//! that nothing a primitive's own box accepts is skipped (see [`Accel`]). For the fine meshes that
//! a ball is meant for the two radii agree to within the size of a triangle.
//!
//! * *Idea*: What misses a ball around the whole misses each of its parts.
//! * *Paper*: Clark: *Hierarchical Geometric Models for Visible Surface Algorithms*, 1976, for the idea; Rubin,
//!   Whitted:
//!   *A 3-dimensional representation for fast rendering of complex scenes*, 1980, for rays.
//! * *Build*: O(n).
//! * *A ray*: one ball, and all n primitives if it is met.
//! * *Memory*: 16 bytes.
//! * *It wins*: over `none` where most rays miss the mesh. Over a tree never but for a few primitives.
//! * *Picture*: `docs/gallery/cells-ball.png`.

use std::io;
use std::ops::{ControlFlow, Range};

use glam::{DVec3, Vec3};

use crate::counters::Counters;
use crate::math::{Aabb, BoxRay, Ray};

use super::save::expect_dense;
use super::sphere_ray::SphereRay;
use super::{
    Accel, Bounded, Build, Built, Decoder, Encoder, LoadError, Portable, RegionForm, Regions,
    Slots, StructureShape,
};

/// Offers everything to the rays that hit the ball, nothing to the others.
#[derive(Clone, Copy, Debug)]
pub struct BoundingBall {
    center: DVec3,
    radius: f64,
    count: u32,
}

impl Accel for BoundingBall {
    const ONE_BY_ONE: bool = true;

    fn build(primitives: &impl Bounded, _: &mut Build<'_>) -> Built<Self> {
        Built { accel: Self::around(primitives), order: None }
    }

    #[inline]
    fn traverse<C: Counters>(
        &self,
        ray: &Ray,
        box_ray: &BoxRay,
        counters: &mut C,
        mut leaf: impl FnMut(Range<u32>, &mut C) -> ControlFlow<(), f32>,
    ) {
        counters.boxes(1);
        let enters = SphereRay::new(ray, box_ray).enters(self.center, self.radius, ray.end());
        if enters.is_some() {
            let _ = leaf(0..self.count, counters);
        }
    }

    fn bytes(&self) -> u64 {
        size_of::<Self>() as u64
    }

    fn regions(&self) -> Regions {
        let mut regions = Regions::default();
        if self.count > 0 {
            let (center, radius) = (self.center.as_vec3(), self.radius as f32);
            regions.push_leaf(RegionForm::Ball { center, radius }, 0, 0..self.count);
        }
        regions
    }

    fn shape(&self) -> StructureShape {
        let mut shape =
            StructureShape { nodes: 1, bytes: self.bytes(), ..StructureShape::default() };
        shape.add_leaf(self.count, 1);
        shape
    }
}

/// Nothing is saved: the ball follows from its primitives.
impl Portable for BoundingBall {
    const NAME: &'static str = "ball";

    fn write(&self, _: &mut Encoder<'_>) -> io::Result<()> {
        Ok(())
    }

    fn read(
        primitives: &impl Bounded,
        Slots { order, .. }: Slots<'_>,
        _: &mut Decoder<'_>,
    ) -> Result<Self, LoadError> {
        expect_dense(order, primitives.count())?;
        Ok(Self::around(primitives))
    }
}

impl BoundingBall {
    fn around(primitives: &impl Bounded) -> Self {
        let boxes = || (0..primitives.count()).map(|i| primitives.bounds(i));
        // A mean lies among the primitives; one that was read may not. From far away the test of the ball is too rough.
        let whole = boxes().fold(Aabb::EMPTY, Aabb::union);
        let center = primitives.mean_point().max(whole.min).min(whole.max);
        let center = Vec3::from(center).as_dvec3();
        let distance = |p: Vec3| p.as_dvec3().distance_squared(center);
        let radius_squared = boxes()
            .flat_map(|bounds| bounds.corners())
            .map(|corner| distance(corner.into()))
            .fold(0.0, f64::max);
        Self { center, radius: radius_squared.sqrt(), count: primitives.count() }
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3A;

    use super::*;

    /// A box whose mean point is said to be somewhere.
    struct Said(Vec3A);

    impl Bounded for Said {
        fn count(&self) -> u32 {
            1
        }

        fn bounds(&self, _: u32) -> Aabb {
            Aabb { min: Vec3A::ZERO, max: Vec3A::ONE }
        }

        fn mean_point(&self) -> Vec3A {
            self.0
        }
    }

    #[test]
    fn a_mean_far_outside_does_not_make_the_ball_large() {
        let ball = |mean: [f32; 3]| BoundingBall::around(&Said(Vec3A::from_array(mean)));
        let inside = ball([0.5, 0.25, 1.0]);
        assert_eq!(inside.center, DVec3::new(0.5, 0.25, 1.0));
        let outside = ball([0.5, -1e26, f32::INFINITY]);
        assert_eq!(outside.center, DVec3::new(0.5, 0.0, 1.0));
        assert_eq!(outside.radius, 2.25f64.sqrt());
    }
}
