//! The triangles of a mesh, as whoever made the mesh holds them.

pub(super) mod extent;

use glam::{Vec3, Vec3A};

use crate::accel::{Bounded, IntoPrimitives, PACK};
use crate::math::{Aabb, NONE, Padding};
use crate::simd::{Cache, prefetch};

use super::{MeshError, Triangle, TriangleSet};

/// So many slots later, the corners of a triangle are asked for: the order is that of a structure, and what comes next
/// stands anywhere in the mesh.
const CORNERS_AHEAD: usize = 4 * PACK;
/// So many slots later, their positions are.
const POSITIONS_AHEAD: usize = 2 * PACK;

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
        let (mean_vertex, bounds) =
            extent.ok_or_else(|| MeshError::of_first(positions, triangles))?;
        match MeshError::of_bounds(&bounds) {
            Some(error) => Err(error),
            None => Ok(Self { positions, triangles, mean_vertex, bounds }),
        }
    }

    #[inline(always)]
    fn triangle(&self, index: u32) -> Triangle {
        Triangle::of_mesh(self.positions, &self.triangles[index as usize])
    }

    /// How far boxes are padded.
    pub(super) fn padding(&self) -> Padding {
        Padding::of_bounds(&self.bounds)
    }

    /// The triangle in a slot of an order, and its index.
    #[inline]
    fn in_slot(&self, order: &[u32], slot: usize) -> Option<(Triangle, u32)> {
        let &index = order.get(slot).filter(|&&index| index != NONE)?;
        Some((self.triangle(index), index))
    }

    /// Asks the caches for what comes some slots later.
    #[inline]
    fn prefetch_ahead(&self, order: &[u32], slot: usize) {
        let corners_in = |slot: usize| {
            let &index = order.get(slot)?;
            self.triangles.get(index as usize)
        };
        if let Some(corners) = corners_in(slot + CORNERS_AHEAD) {
            prefetch(corners, Cache::First);
        }
        for &corner in corners_in(slot + POSITIONS_AHEAD).into_iter().flatten() {
            prefetch(&self.positions[corner as usize], Cache::First);
        }
    }
}

impl Bounded for TriangleMesh<'_> {
    const SOUND_BOXES: bool = true;

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
        let Some(order) = order else {
            let slots = self.triangles.len();
            return TriangleSet::of_mesh(&self, true, slots, |slot| {
                (slot < slots).then(|| (self.triangle(slot as u32), slot as u32))
            });
        };
        TriangleSet::of_mesh(&self, false, order.len(), |slot| {
            self.prefetch_ahead(order, slot);
            self.in_slot(order, slot)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::{
        Accel, BuildConfig, BuildOptions, Bvh, Bvh8, Exhaustive, Indexed, KdTree, Primitives,
        Quality,
    };
    use crate::math::Random;

    type Arrays = (Vec<Vec3>, Vec<[u32; 3]>);

    /// Triangles between any vertices, all over a cube around the origin.
    fn cloud(triangles: usize) -> Arrays {
        let mut random = Random::new(&[3]);
        let mut coordinate = || 200.0 * random.next_f32() - 100.0;
        let positions: Vec<_> =
            (0..400).map(|_| Vec3::from_array(std::array::from_fn(|_| coordinate()))).collect();
        let mut corner = || random.below(positions.len() as u32);
        let triangles = (0..triangles).map(|_| std::array::from_fn(|_| corner())).collect();
        (positions, triangles)
    }

    /// All that is kept of triangles.
    fn kept(triangles: &TriangleSet) -> String {
        format!("{triangles:?}")
    }

    #[test]
    fn boxes_of_a_mesh_are_those_of_its_packs() {
        let (positions, triangles) = cloud(203);
        let mesh = TriangleMesh::new(&positions, &triangles);
        let packs = TriangleSet::new(&positions, &triangles);
        let part = Aabb { min: Vec3A::splat(-50.0), max: Vec3A::splat(20.0) };
        for index in 0..mesh.count() {
            assert_eq!(mesh.bounds(index), packs.bounds(index));
            assert_eq!(mesh.clipped_bounds(index, &part), packs.clipped_bounds(index, &part));
        }
        assert_eq!(mesh.total_bounds(), packs.total_bounds());
        assert_eq!(mesh.mean_point(), packs.mean_point());
        assert_eq!(mesh.padding(), Primitives::padding(&packs));
    }

    /// The triangles from the last to the first, three to a pack and the first of these twice.
    fn in_disorder((positions, triangles): &Arrays) -> TriangleSet {
        let mut set = TriangleSet::new(positions, triangles);
        let last: Vec<_> = (0..set.count()).rev().collect();
        let order: Vec<_> =
            last.chunks(3).flat_map(|some| [some, &[NONE; 4], &some[..1]].concat()).collect();
        set.reorder(&order);
        set
    }

    fn same<A: Accel>(arrays: &Arrays, options: &BuildOptions) {
        let (positions, triangles) = arrays;
        for quality in [Quality::Fastest, Quality::Medium] {
            let config =
                BuildConfig { quality, options: options.clone(), ..BuildConfig::default() };
            let of_mesh: Indexed<_, A> =
                Indexed::build(TriangleMesh::new(positions, triangles), &config);
            let of_packs: Indexed<_, A> =
                Indexed::build(TriangleSet::new(positions, triangles), &config);
            assert_eq!(kept(of_mesh.primitives()), kept(of_packs.primitives()));
            assert_eq!(of_mesh.tree(), of_packs.tree());
            // In the order of another structure, with empty slots and copies.
            let of_ordered: Indexed<_, A> = Indexed::build(in_disorder(arrays), &config);
            assert_eq!(kept(of_mesh.primitives()), kept(of_ordered.primitives()));
            assert_eq!(of_mesh.tree(), of_ordered.tree());
        }
    }

    #[test]
    fn structures_over_a_mesh_are_those_over_its_packs() {
        let none = &BuildOptions::NONE;
        let cutting = &BuildOptions::of::<Bvh8>("builder=sbvh").unwrap();
        for arrays in [(vec![], vec![]), cloud(1), cloud(3000)] {
            same::<Exhaustive>(&arrays, none);
            same::<Bvh>(&arrays, none);
            same::<Bvh8>(&arrays, none);
            // Some triangles are in several leaves.
            same::<Bvh8>(&arrays, cutting);
            same::<KdTree>(&arrays, none);
        }
    }
}
