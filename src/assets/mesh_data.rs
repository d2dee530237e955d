//! A triangle mesh in memory.

use std::io::{self, BufWriter, Write};

use glam::{Vec3, Vec3A};

use super::normals;
use crate::math::Aabb;

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

impl MeshData {
    /// A mesh whose normals are averaged from the faces around each vertex; degenerate triangles
    /// are dropped and counted.
    ///
    /// The average is weighted after N. Max, *Weights for computing vertex normals from facet
    /// normals* (Journal of Graphics Tools 4(2), 1999): exact where the vertices lie on a ball.
    ///
    /// Positions must be finite and indices in range.
    #[must_use]
    pub fn with_averaged_normals(positions: Vec<Vec3>, mut triangles: Vec<[u32; 3]>) -> Self {
        let before = triangles.len();
        triangles.retain(|triangle| !is_degenerate(&positions, triangle));
        let dropped = before - triangles.len();
        let normals = normals::average(&positions, &triangles);
        Self { normal_indices: triangles.clone(), positions, triangles, normals, dropped }
    }

    /// A mesh with given normals; degenerate triangles are dropped and counted.
    ///
    /// Normals are brought to unit length. Where one has none (of length 0, or not finite), the
    /// corner gets the average of the faces around its vertex instead.
    ///
    /// Positions must be finite, indices in range, and both index lists of the same length.
    #[must_use]
    pub fn with_normals(
        positions: Vec<Vec3>,
        triangles: Vec<[u32; 3]>,
        normals: Vec<Vec3>,
        normal_indices: Vec<[u32; 3]>,
    ) -> Self {
        let mut mesh = Self { positions, triangles, normals, normal_indices, dropped: 0 };
        mesh.drop_degenerate();
        normals::complete(&mut mesh);
        mesh
    }

    /// The smallest box around its triangles; empty if there are none.
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        // By the triangles: a vertex of dropped triangles alone is not part of the surface.
        let corners = self.triangles.iter().flatten();
        Aabb::of_points(corners.map(|&i| Vec3A::from(self.positions[i as usize])))
    }

    /// Writes the mesh as a Wavefront OBJ file with positions, normals and faces.
    ///
    /// Floats are written as the shortest decimals that read back as the same bits, so a reader
    /// gets the same triangles with the same corners and normals, in the same order. (The reader here
    /// numbers vertices by first use, so the lists of vertices may come back permuted.)
    ///
    /// # Errors
    /// Those of the writer.
    pub fn to_obj(&self, writer: &mut impl Write) -> io::Result<()> {
        let mut out = BufWriter::with_capacity(1 << 18, writer);
        for p in &self.positions {
            writeln!(out, "v {} {} {}", p.x, p.y, p.z)?;
        }
        for n in &self.normals {
            writeln!(out, "vn {} {} {}", n.x, n.y, n.z)?;
        }
        for (triangle, normals) in self.triangles.iter().zip(&self.normal_indices) {
            // 64 bits: counted from 1, the last of 2³² indices does not fit in 32.
            let [a, b, c] = triangle.map(|i| u64::from(i) + 1);
            let [na, nb, nc] = normals.map(|i| u64::from(i) + 1);
            writeln!(out, "f {a}//{na} {b}//{nb} {c}//{nc}")?;
        }
        out.flush()
    }

    /// Removes triangles without area, and their normal indices with them.
    fn drop_degenerate(&mut self) {
        let mut kept = 0;
        for i in 0..self.triangles.len() {
            if !is_degenerate(&self.positions, &self.triangles[i]) {
                self.triangles[kept] = self.triangles[i];
                self.normal_indices[kept] = self.normal_indices[i];
                kept += 1;
            }
        }
        self.dropped += self.triangles.len() - kept;
        self.triangles.truncate(kept);
        self.normal_indices.truncate(kept);
    }
}

/// Whether a triangle has no area: two equal corners, or all three on a line, as far as `f64` can
/// resolve it (products of differences of `f32` neither overflow nor vanish there).
fn is_degenerate(positions: &[Vec3], triangle: &[u32; 3]) -> bool {
    let [a, b, c] = triangle.map(|i| positions[i as usize].as_dvec3());
    (b - a).cross(c - a) == glam::DVec3::ZERO
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square() -> Vec<Vec3> {
        vec![Vec3::ZERO, Vec3::X, Vec3::ONE - Vec3::Z, Vec3::Y, 2.0 * Vec3::X]
    }

    #[test]
    fn triangles_without_area_are_dropped_and_counted() {
        let triangles = vec![[0, 1, 2], [0, 1, 4], [1, 1, 2], [0, 2, 3]];
        let mesh = MeshData::with_averaged_normals(square(), triangles.clone());
        assert_eq!((mesh.triangles.len(), mesh.dropped), (2, 2));
        assert!(mesh.normals[..4].iter().all(|&n| n == Vec3::Z));
        let same = MeshData::with_normals(square(), triangles.clone(), vec![Vec3::Z; 5], triangles);
        assert_eq!(same, mesh);
        assert_eq!(mesh.bounds().max, Vec3A::new(1.0, 1.0, 0.0), "the fifth vertex is unused");
    }

    #[test]
    fn tiny_and_huge_triangles_are_kept() {
        for scale in [1e-45, 1e-30, 1e38] {
            let positions = square().into_iter().map(|p| p * scale).collect();
            let mesh = MeshData::with_averaged_normals(positions, vec![[0, 1, 2]]);
            assert_eq!((mesh.dropped, mesh.normals[0]), (0, Vec3::Z), "{scale:e}");
        }
    }
}
