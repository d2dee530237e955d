//! A trefoil: a round tube along a curve that winds about a torus.

use std::f64::consts::TAU;

use glam::{DVec3, Vec3};

use super::MeshData;
use super::grid::CellGrid;

/// Turns about the axis, and about the core of the torus.
const TURNS: f64 = 2.0;
const WINDINGS: f64 = 3.0;
/// Radii of the torus: of its core, of its surface about the core.
const CORE: f64 = 0.6;
const AROUND: f64 = 0.25;
/// Radius of the tube; the strands pass at more than twice as much from each other.
const TUBE: f64 = 0.12;
/// How much longer the curve is than the tube is round: about 9.7 to 0.75.
const SLENDERNESS: f64 = 12.9;

/// A closed tube; its normals are those of the smooth surface.
pub(super) fn generate(triangles: u32) -> MeshData {
    let grid = CellGrid::torus(triangles, 1.0 / SLENDERNESS);
    let triangles: Vec<_> = grid.triangles(0).collect();
    let normals: Vec<Vec3> = grid.vertices(&|u, v| normal(u, &frame(v)));
    let positions = grid.vertices(&|u, v| {
        let frame = frame(v);
        frame.point + TUBE * normal(u, &frame)
    });
    MeshData { positions, normal_indices: triangles.clone(), triangles, normals, dropped: 0 }
}

/// A point of the curve, and two unit vectors that span the plane across it.
struct Frame {
    point: DVec3,
    out: DVec3,
    side: DVec3,
}

/// The frame at `v` of the way, from the torus: its normal is perpendicular to every curve on it,
/// turns smoothly and comes back to its start, which the curve's own principal normal need not.
fn frame(v: f64) -> Frame {
    let (sin_turn, cos_turn) = libm::sincos(TAU * TURNS * v);
    let (sin_wind, cos_wind) = libm::sincos(TAU * WINDINGS * v);
    let radial = DVec3::new(cos_turn, sin_turn, 0.0);
    let forward = DVec3::new(-sin_turn, cos_turn, 0.0);
    let out = cos_wind * radial + sin_wind * DVec3::Z;
    let up = cos_wind * DVec3::Z - sin_wind * radial;
    // d/dv of CORE·radial + AROUND·out, without the factor 2π.
    let tangent = TURNS * (CORE + AROUND * cos_wind) * forward + WINDINGS * AROUND * up;
    Frame { point: CORE * radial + AROUND * out, out, side: tangent.normalize().cross(out) }
}

/// The direction from the curve at `u` of the way around the tube.
fn normal(u: f64, frame: &Frame) -> DVec3 {
    let (sin, cos) = libm::sincos(TAU * u);
    cos * frame.out + sin * frame.side
}
