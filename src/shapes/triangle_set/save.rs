//! Triangles in bytes: each by its corners.

use std::io;

use glam::{Vec3, Vec3A};
use rayon::prelude::*;

use crate::accel::{Decoder, Encoder, LoadError, PortablePrimitives};
use crate::math::Padding;
use crate::shapes::Triangle;

use super::TriangleSet;
use super::pack::pack;

impl PortablePrimitives for TriangleSet {
    const NAME: &'static str = "triangles";

    fn id(&self, slot: u32) -> u32 {
        self.slot(slot).1
    }

    fn write(&self, slots: &[u32], out: &mut Encoder<'_>) -> io::Result<()> {
        out.vec3(self.mean_vertex.into())?;
        out.list(slots, |&slot| {
            let corners =
                self.slot(slot).0.corners.map(|corner| corner.to_array().map(f32::to_bits));
            std::array::from_fn::<_, 9, _>(|place| corners[place / 3][place % 3])
        })
    }

    fn read(count: u32, input: &mut Decoder<'_>) -> Result<Self, LoadError> {
        let mean_vertex = Vec3A::from(input.vec3()?);
        if !mean_vertex.is_finite() {
            return Err(LoadError::invalid("the mean of the vertices is not finite"));
        }
        let triangles = input.list(count, "triangles", |words: [u32; 9]| {
            let [a, b, c, d, e, f, g, h, i] = words.map(f32::from_bits);
            Triangle::new([Vec3::new(a, b, c), Vec3::new(d, e, f), Vec3::new(g, h, i)])
        })?;
        if !triangles.par_iter().all(Triangle::is_finite) {
            return Err(LoadError::invalid("a triangle is not finite"));
        }
        let packs = pack(triangles.len(), |slot| Some((*triangles.get(slot)?, slot as u32)));
        let padding = Padding { largest: 0.0, factor: 1.0 };
        let set = Self { packs, in_mesh_order: true, count, mean_vertex, padding };
        set.padded().map_err(|error| LoadError::invalid(error.to_string()))
    }
}
