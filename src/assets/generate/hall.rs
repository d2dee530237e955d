//! A columned hall: huge triangles beside tiny ones, as in models of buildings.

use std::f64::consts::{PI, TAU};

use glam::{DVec3, Vec3};

use super::MeshData;
use super::grid::CellGrid;

/// Half the length (x) and half the width (y) of the room, and its height.
const ROOM: DVec3 = DVec3::new(1.0, 0.6, 0.8);
/// Columns in each of the two rows, and the distance from one to the next.
const COLUMNS: u32 = 5;
const PITCH: f64 = 0.4;
/// The distance of the rows from the middle.
const ROW: f64 = 0.35;
const COLUMN_RADIUS: f64 = 0.045;
const COLUMN_HEIGHT: f64 = 0.45;
const FLUTES: f64 = 20.0;
const ARCH_RADIUS: f64 = 0.035;
const VASE_RADIUS: f64 = 0.06;
const VASE_HEIGHT: f64 = 0.16;

/// Two triangles for each face of the room, the rest shared out among columns, arches and vases.
pub(super) fn generate(triangles: u32) -> MeshData {
    let mut parts = Parts { left: triangles, weight: total_weight(), ..Parts::default() };
    add_room(&mut parts);
    for side in [-ROW, ROW] {
        for i in 0..COLUMNS {
            let x = PITCH * (f64::from(i) - f64::from(COLUMNS - 1) / 2.0);
            parts.add(HallPart::Column, |u, v| DVec3::new(x, side, 0.0) + column(u, v));
            if i + 1 < COLUMNS {
                let between = DVec3::new(x + PITCH / 2.0, side, 0.0);
                parts.add(HallPart::Arch, |u, v| between + arch(u, v));
                parts.add(HallPart::Vase, |u, v| between + vase(u, v));
            }
        }
    }
    MeshData::with_averaged_normals(parts.positions, parts.triangles)
}

/// What is finely tessellated.
#[derive(Clone, Copy)]
enum HallPart {
    Column,
    Arch,
    Vase,
}

impl HallPart {
    /// Its share of the triangles.
    fn weight(self) -> u32 {
        match self {
            Self::Column => 3,
            Self::Arch | Self::Vase => 2,
        }
    }

    /// Cells around for each cell along.
    fn aspect(self) -> f64 {
        match self {
            Self::Column => 2.0, // the flutes want them
            Self::Arch => 0.6,
            Self::Vase => 1.5,
        }
    }
}

/// The weights of everything that is finely tessellated.
fn total_weight() -> u32 {
    let gaps = COLUMNS - 1;
    2 * (COLUMNS * HallPart::Column.weight()
        + gaps * (HallPart::Arch.weight() + HallPart::Vase.weight()))
}

/// The mesh so far, and what is left to spend on the parts to come.
#[derive(Default)]
struct Parts {
    positions: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    left: u32,
    weight: u32,
}

impl Parts {
    /// Adds a part with its share of what is left: what rounding takes from one, the next ones get.
    fn add(&mut self, part: HallPart, surface: impl Fn(f64, f64) -> DVec3 + Sync) {
        let share = u64::from(self.left) * u64::from(part.weight()) / u64::from(self.weight);
        self.weight -= part.weight();
        self.append(CellGrid::tube(share as u32, part.aspect()), surface);
    }

    fn append(&mut self, grid: CellGrid, surface: impl Fn(f64, f64) -> DVec3 + Sync) {
        self.left = self.left.saturating_sub(grid.triangle_count());
        let first = self.positions.len() as u32;
        self.positions.extend(grid.vertices(&surface));
        self.triangles.extend(grid.triangles(first));
    }
}

/// Floor, ceiling and walls, facing inwards; they share no vertices, so their normals are flat.
fn add_room(parts: &mut Parts) {
    let (across, up) = (2.0 * ROOM.truncate().extend(0.0), ROOM.z * DVec3::Z);
    let (x, y) = (across.x * DVec3::X, across.y * DVec3::Y);
    let low = DVec3::new(-ROOM.x, -ROOM.y, 0.0);
    let high = low + across + up;
    for (origin, a, b) in
        [(low, x, y), (low, y, up), (low, up, x), (high, -y, -x), (high, -up, -y), (high, -x, -up)]
    {
        let quad = CellGrid { columns: 1, rows: 1, closed_columns: false, closed_rows: false };
        parts.append(quad, |u, v| origin + u * a + v * b);
    }
}

/// A fluted column about the z axis, wider at its foot and head.
fn column(u: f64, v: f64) -> DVec3 {
    let from_end = v.min(1.0 - v);
    let flare = 0.25 * (1.0 - 8.0 * from_end).max(0.0);
    let fluting = if from_end < 0.125 { 0.0 } else { 0.04 * libm::cos(TAU * FLUTES * u) };
    around(u, COLUMN_RADIUS * (1.0 + flare + fluting), COLUMN_HEIGHT * v)
}

/// Half a ring between the heads of two columns, in the plane y = 0.
fn arch(u: f64, v: f64) -> DVec3 {
    let (sin_arc, cos_arc) = libm::sincos(PI * v);
    let (sin_tube, cos_tube) = libm::sincos(TAU * u);
    let radius = PITCH / 2.0 + ARCH_RADIUS * cos_tube;
    DVec3::new(-radius * cos_arc, -ARCH_RADIUS * sin_tube, COLUMN_HEIGHT + radius * sin_arc)
}

/// A bellied vase on the floor, open at the top.
fn vase(u: f64, v: f64) -> DVec3 {
    let profile = 0.62 + 0.38 * libm::sin(PI * (1.7 * v - 0.1));
    around(u, VASE_RADIUS * profile, VASE_HEIGHT * v)
}

fn around(u: f64, radius: f64, z: f64) -> DVec3 {
    let (sin, cos) = libm::sincos(TAU * u);
    DVec3::new(radius * cos, radius * sin, z)
}
