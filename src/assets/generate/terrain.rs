//! A square of land.

use glam::DVec3;

use super::MeshData;
use super::grid::CellGrid;
use super::noise::fractal;

/// The largest height, and depth.
const HEIGHT: f64 = 0.35;
/// How many of the largest hills lie along a side.
const HILLS: f64 = 6.0;

/// The square [−1, 1]², displaced along z; its normals are averaged.
pub(super) fn generate(triangles: u32, seed: u64) -> MeshData {
    let grid = CellGrid::open(triangles, 1.0);
    let positions = grid.vertices(&|u, v| {
        DVec3::new(2.0 * u - 1.0, 2.0 * v - 1.0, HEIGHT * fractal(seed, HILLS * u, HILLS * v))
    });
    MeshData::with_averaged_normals(positions, grid.triangles(0).collect())
}
