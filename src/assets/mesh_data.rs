//! A triangle mesh in memory.

use glam::Vec3;

/// A mesh of triangles with a normal at each corner.
///
/// `triangles` and `normal_indices` are of the same length, every index is in range, and no
/// triangle is degenerate.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeshData {
    /// Vertex positions; finite.
    pub positions: Vec<Vec3>,
    /// Three indices into `positions` for each triangle.
    pub triangles: Vec<[u32; 3]>,
    /// Unit vectors.
    pub normals: Vec<Vec3>,
    /// Three indices into `normals` for each triangle.
    pub normal_indices: Vec<[u32; 3]>,
    /// How many degenerate triangles (of no area) were dropped as the mesh was made.
    pub dropped: usize,
}
