//! Triangles in bytes: each by its corners.

use std::io;
#[cfg(feature = "program")]
use std::sync::atomic::{AtomicBool, Ordering};

use glam::{Vec3, Vec3A};
use rayon::prelude::*;

use crate::accel::{Decoder, Encoder, LoadError, PACK, PortablePrimitives};
use crate::math::Padding;
use crate::shapes::Triangle;

use super::TriangleSet;
use super::pack::pack;
#[cfg(feature = "program")]
use super::{MeshError, NONE, extent};

impl PortablePrimitives for TriangleSet {
    const NAME: &'static str = "triangles";

    fn slot_count(&self) -> u32 {
        (self.packs.len() * PACK) as u32
    }

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
        let set = Self { packs, count, mean_vertex, padding };
        set.padded().map_err(|error| LoadError::invalid(error.to_string()))
    }
}

#[cfg(feature = "program")]
impl TriangleSet {
    /// The triangles of a mesh in the order of a structure: slot `i` holds triangle `order[i]`, or
    /// nothing where that is [`NONE`]; each triangle has one slot. `mean_vertex` is the mean of the
    /// vertices that they use.
    ///
    /// # Errors
    /// As of [`try_new`](Self::try_new).
    pub(crate) fn in_order(
        (positions, triangles): (&[Vec3], &[[u32; 3]]),
        order: &[u32],
        mean_vertex: Vec3A,
    ) -> Result<Self, MeshError> {
        let too_many = |_| MeshError::TooMany { triangles: triangles.len() };
        let count = u32::try_from(triangles.len()).map_err(too_many)?;
        let sound = AtomicBool::new(true);
        let triangle = |slot: usize| {
            let &id = order.get(slot).filter(|&&id| id != NONE)?;
            let corners = triangles.get(id as usize).and_then(|corners| {
                let [a, b, c] = corners.map(|corner| positions.get(corner as usize).copied());
                Some(Triangle::new([a?, b?, c?])).filter(Triangle::is_finite)
            });
            if corners.is_none() {
                sound.store(false, Ordering::Relaxed);
            }
            Some((corners?, id))
        };
        let packs = pack(order.len(), triangle);
        if !sound.into_inner() {
            let wrong = MeshError::of_first(positions, triangles);
            let (triangles, before) = (triangles.len(), order.len());
            return Err(wrong.unwrap_or(MeshError::OtherTriangles { triangles, before }));
        }
        let padding = Padding { largest: 0.0, factor: 1.0 };
        let mut set = Self { packs, count, mean_vertex, padding };
        let bounds = extent::bounds_of_slots(&set);
        set.settle(&bounds)?;
        Ok(set)
    }
}
