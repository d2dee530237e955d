//! A teapot in a stadium: one fine thing in a large place of few, long triangles. What divides the whole evenly, as a
//! grid does, has nearly all of it in one cell (E. Haines, *Spline surface rendering, and what's wrong with octrees*,
//! Ray Tracing News 1(1), 1988).

use std::f64::consts::TAU;

use glam::{DVec2, DVec3, Vec3};

use super::MeshData;
use super::grid::CellGrid;
use super::teapot;

/// Half the axes of the stadium as seen from above, and its height.
const OUTER: DVec2 = DVec2::new(1.0, 0.75);
const HEIGHT: f64 = 0.25;
/// Where the stands begin, as a share of that, and how high the lowest row is.
const INNER: f64 = 0.62;
const PARAPET: f64 = 0.02;
/// The half breadth of the teapot.
const TEAPOT: f64 = 0.01;
/// The share of the stands in the triangles, and how many they have at most: they stay coarse.
const SHARE: u32 = 8;
const MOST: u32 = 6_000;

/// Stands, field and teapot; their normals are averaged, those of the steps flat.
pub(super) fn generate(triangles: u32) -> MeshData {
    let mut mesh = Mesh::default();
    add_stands(&mut mesh, (triangles / SHARE).min(MOST));
    let mut left = triangles.saturating_sub(mesh.triangles.len() as u32);
    let mut weight = teapot::WEIGHT;
    for part in &teapot::PARTS {
        let share = u64::from(left) * u64::from(part.weight) / u64::from(weight);
        let grid = part.grid(share as u32);
        mesh.add(grid, |u, v| TEAPOT / teapot::REACH * (part.surface)(u, v));
        left = left.saturating_sub(grid.triangle_count());
        weight -= part.weight;
    }
    MeshData::with_averaged_normals(mesh.positions, mesh.triangles)
}

#[derive(Default)]
struct Mesh {
    positions: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
}

impl Mesh {
    fn add(&mut self, grid: CellGrid, surface: impl Fn(f64, f64) -> DVec3 + Sync) {
        let first = self.positions.len() as u32;
        self.positions.extend(grid.vertices(&surface));
        self.triangles.extend(grid.triangles(first));
    }
}

/// The field of two triangles, and rows of steps around it: treads, the upper parts of risers and the wall outside,
/// each a band.
fn add_stands(mesh: &mut Mesh, triangles: u32) {
    let field = CellGrid { columns: 1, rows: 1, closed_columns: false, closed_rows: false };
    mesh.add(field, |u, v| (OUTER * DVec2::new(2.0 * u - 1.0, 2.0 * v - 1.0)).extend(0.0));
    // A band of a row has twice as many triangles as it has sides; a row is four times as long as it is deep.
    let rows = (f64::from(triangles) / 4.0 / 4.0).sqrt().clamp(2.0, 24.0) as u32;
    let sides = (triangles / (2 * (2 * rows + 1))).clamp(6, 120);
    let band = CellGrid { columns: sides, rows: 1, closed_columns: true, closed_rows: false };
    let at = |row: u32| f64::from(row) / f64::from(rows);
    let high = |row: u32| PARAPET + (HEIGHT - PARAPET) * at(row + 1) * at(row + 1);
    let wide = |row: u32| INNER + (0.98 - INNER) * at(row);
    for row in 0..rows {
        let below = if row == 0 { 0.0 } else { high(row - 1) };
        mesh.add(band, |u, v| ring(u, wide(row), below + (0.45 + 0.55 * v) * (high(row) - below)));
        mesh.add(band, |u, v| ring(u, wide(row) + v * (wide(row + 1) - wide(row)), high(row)));
    }
    mesh.add(band, |u, v| ring(u, 0.98, (1.0 - v) * high(rows - 1)));
}

/// A point of an ellipse at a height, as a share of the whole.
fn ring(u: f64, share: f64, z: f64) -> DVec3 {
    let (sin, cos) = libm::sincos(TAU * u);
    (share * OUTER * DVec2::new(cos, sin)).extend(z)
}
