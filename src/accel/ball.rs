//! One bounding ball around all primitives: the optimization of the course.
//!
//! Centre: the mean of the vertices. Radius: the largest distance from it. Here that is the
//! distance to the corners of the primitives' boxes, not only to the vertices: equal hits require
//! that nothing a primitive's own box accepts is skipped (see [`Accel`]). For the fine meshes that
//! a ball is meant for the two radii agree to within the size of a triangle.

use std::io;
use std::ops::{ControlFlow, Range};

use glam::{DVec3, Vec3};

use crate::counters::Counters;
use crate::math::{BoxRay, Ray};

use super::save::expect_dense;
use super::{
    Accel, Bounded, Build, Built, Decoder, Encoder, LoadError, Portable, Slots, StructureShape,
};

/// Below this length of a direction `t` can leave the range of floats; such rays skip nothing. Nor do
/// those so fast that a [`STEP`] of `t`, by which slab tests may err, takes them farther than the padding.
const SHORTEST_DIR: f64 = 1e-30;

/// The distance between neighbouring parameters that are smaller than the normal numbers.
const STEP: f64 = f32::from_bits(1) as f64;

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
        if self.may_hit(ray, box_ray.pad) {
            let _ = leaf(0..self.count, counters);
        }
    }

    fn bytes(&self) -> u64 {
        size_of::<Self>() as u64
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
        let center = Vec3::from(primitives.mean_point()).as_dvec3();
        let distance = |p: Vec3| p.as_dvec3().distance_squared(center);
        let radius_squared = (0..primitives.count())
            .flat_map(|i| primitives.bounds(i).corners())
            .map(|corner| distance(corner.into()))
            .fold(0.0, f64::max);
        Self { center, radius: radius_squared.sqrt(), count: primitives.count() }
    }

    /// Whether the ray's segment meets the ball, widened so far that no point of a padded box is
    /// outside. In `f64`, where the rounding of the test itself vanishes beside the padding.
    #[inline]
    fn may_hit(&self, ray: &Ray, pad: f32) -> bool {
        let dir = ray.dir.as_dvec3();
        let dir_squared = dir.length_squared();
        let square_pad = f64::from(pad) * f64::from(pad);
        if dir_squared < SHORTEST_DIR * SHORTEST_DIR || dir_squared * (STEP * STEP) > square_pad {
            return true;
        }
        // A point that a padded box accepts is at most 1.1 paddings outside of it on each axis.
        let radius = self.radius + 4.0 * f64::from(pad);
        let to_origin = ray.origin.as_dvec3() - self.center;
        let t_closest = -to_origin.dot(dir) / dir_squared;
        let distance_squared = (to_origin + t_closest * dir).length_squared();
        let half_chord = ((radius * radius - distance_squared) / dir_squared).sqrt();
        // The root of a negative number is NaN, and no comparison with it holds.
        t_closest + half_chord >= f64::from(ray.t_min)
            && t_closest - half_chord <= f64::from(ray.t_max)
    }
}
