//! The triangles of a mesh, as whoever made the mesh holds them.

pub(super) mod extent;

use glam::{Vec3, Vec3A};

use crate::accel::{Bounded, IntoPrimitives, PACK};
use crate::math::{Aabb, Padding};
use crate::simd::{Cache, prefetch};

use super::{MeshError, Triangle, TriangleSet};

/// Slots whose triangle, and whose vertices, are read ahead: packs are in the order of a structure, and what comes next
/// stands anywhere in the mesh.
const TRIANGLES_AHEAD: usize = 4 * PACK;
const VERTICES_AHEAD: usize = 2 * PACK;

/// The triangles of a mesh: positions, and triples of indices of these. A structure is built over them where they are,
/// and they are put into packs once, in the order of the structure.
///
/// ```
/// use srt::accel::{BuildConfig, Bvh8, Indexed};
/// use srt::glam::Vec3;
/// use srt::math::Ray;
/// use srt::shapes::TriangleMesh;
///
/// let mesh = TriangleMesh::new(&[Vec3::ZERO, Vec3::X, Vec3::Y], &[[0, 1, 2]]);
/// let bvh: Indexed<_, Bvh8> = Indexed::build(mesh, &BuildConfig::default());
/// assert_eq!(bvh.hit(&Ray::new(Vec3::new(0.2, 0.2, 5.0), Vec3::NEG_Z)).prim, 0);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct TriangleMesh<'a> {
    positions: &'a [Vec3],
    triangles: &'a [[u32; 3]],
    mean_vertex: Vec3A,
    bounds: Aabb,
}

impl<'a> TriangleMesh<'a> {
    /// The triangles of a mesh. Vertices that no triangle names may be anything.
    ///
    /// # Panics
    /// With the message of the error, where [`try_new`](Self::try_new) gives one.
    #[must_use]
    pub fn new(positions: &'a [Vec3], triangles: &'a [[u32; 3]]) -> Self {
        Self::try_new(positions, triangles).unwrap_or_else(|error| panic!("{error}"))
    }

    /// The triangles of a mesh, if they can be traced. A single NaN in a box would take other
    /// triangles out of a tree.
    ///
    /// # Errors
    /// If an index is out of range, a corner is not finite, or there are more than 2³² − 1 triangles;
    /// if they reach too far, or all together are too small, to be hit in single precision:
    /// coordinates may be up to 10¹², and the longest side of the box around them from 10⁻¹⁰
    /// ([`SizeRange::TRIANGLES`](crate::math::SizeRange::TRIANGLES)).
    pub fn try_new(positions: &'a [Vec3], triangles: &'a [[u32; 3]]) -> Result<Self, MeshError> {
        if u32::try_from(triangles.len()).is_err() {
            return Err(MeshError::TooMany { triangles: triangles.len() });
        }
        let extent = extent::mean_and_bounds(positions, triangles);
        let (mean_vertex, bounds) = extent.ok_or_else(|| {
            // Only that something is wrong is known so far.
            let first = MeshError::of_first(positions, triangles);
            first.expect("a vertex is missing or not finite")
        })?;
        match MeshError::of_bounds(&bounds) {
            Some(error) => Err(error),
            None => Ok(Self { positions, triangles, mean_vertex, bounds }),
        }
    }

    #[inline(always)]
    fn triangle(&self, index: u32) -> Triangle {
        self.triangle_of(&self.triangles[index as usize])
    }

    #[inline(always)]
    fn triangle_of(&self, corners: &[u32; 3]) -> Triangle {
        Triangle::new(corners.map(|corner| self.positions[corner as usize]))
    }

    /// How far boxes are padded.
    pub(super) fn padding(&self) -> Padding {
        Padding::of_bounds(&self.bounds)
    }

    /// The triangle of a slot, and its index; what comes soon is asked for.
    #[inline]
    fn slot(&self, order: &[u32], slot: usize) -> Option<(Triangle, u32)> {
        let triangle = |slot| {
            let &index: &u32 = order.get(slot)?;
            self.triangles.get(index as usize)
        };
        if let Some(triangle) = triangle(slot + TRIANGLES_AHEAD) {
            prefetch(triangle, Cache::First);
        }
        for &corner in triangle(slot + VERTICES_AHEAD).into_iter().flatten() {
            prefetch(&self.positions[corner as usize], Cache::First);
        }
        // What is `NONE` names none of them.
        Some((self.triangle_of(triangle(slot)?), order[slot]))
    }
}

impl Bounded for TriangleMesh<'_> {
    fn count(&self) -> u32 {
        self.triangles.len() as u32
    }

    #[inline]
    fn bounds(&self, index: u32) -> Aabb {
        self.triangle(index).bounds()
    }

    fn clipped_bounds(&self, index: u32, to: &Aabb) -> Aabb {
        self.triangle(index).clipped_bounds(to)
    }

    fn mean_point(&self) -> Vec3A {
        self.mean_vertex
    }

    fn total_bounds(&self) -> Aabb {
        self.bounds
    }
}

impl IntoPrimitives for TriangleMesh<'_> {
    type Primitives = TriangleSet;

    fn into_primitives(self, order: Option<&[u32]>) -> TriangleSet {
        match order {
            Some(order) => TriangleSet::of_mesh(&self, order.len(), |slot| self.slot(order, slot)),
            None => TriangleSet::of_mesh(&self, self.triangles.len(), |slot| {
                let corners = self.triangles.get(slot)?;
                Some((self.triangle_of(corners), slot as u32))
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::{BuildConfig, Bvh, Bvh8, Exhaustive, Indexed, Quality};
    use crate::math::Random;

    #[test]
    fn structures_over_a_mesh_are_those_over_its_packs() {
        let mut random = Random::new(&[3]);
        let mut below = |n: u32| (random.next_f32() * n as f32) as u32;
        let positions: Vec<_> = (0..4000)
            .map(|_| Vec3::from_array(std::array::from_fn(|_| below(1000) as f32 / 7.0)))
            .collect();
        let triangles: Vec<_> = (0..20_003).map(|_| std::array::from_fn(|_| below(4000))).collect();
        let mesh = TriangleMesh::new(&positions, &triangles);
        let packs = TriangleSet::new(&positions, &triangles);
        let boxes =
            |bounded: &dyn Fn(u32) -> Aabb| (0..mesh.count()).map(bounded).collect::<Vec<_>>();
        assert_eq!(boxes(&|index| mesh.bounds(index)), boxes(&|index| packs.bounds(index)));
        assert_eq!(
            (mesh.total_bounds(), mesh.mean_point()),
            (packs.total_bounds(), packs.mean_point())
        );
        for quality in [Quality::Fastest, Quality::Medium] {
            let config = BuildConfig { quality, ..BuildConfig::default() };
            let of_mesh: Indexed<TriangleSet, Bvh8> = Indexed::build(mesh, &config);
            let of_packs: Indexed<TriangleSet, Bvh8> = Indexed::build(packs.clone(), &config);
            assert_eq!(
                format!("{:?}", of_mesh.primitives()),
                format!("{:?}", of_packs.primitives())
            );
            assert_eq!(of_mesh.shape(), of_packs.shape());
            let of_mesh: Indexed<TriangleSet, Bvh> = Indexed::build(mesh, &config);
            let of_packs: Indexed<TriangleSet, Bvh> = Indexed::build(packs.clone(), &config);
            assert_eq!(
                format!("{:?}", of_mesh.primitives()),
                format!("{:?}", of_packs.primitives())
            );
        }
        // Without an order they stand as in the mesh.
        let none: Indexed<TriangleSet, Exhaustive> = Indexed::build(mesh, &BuildConfig::default());
        assert_eq!(format!("{:?}", none.primitives()), format!("{packs:?}"));
    }
}
