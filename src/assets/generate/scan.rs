//! A coral like a brain: a closed surface with detail all over, in triangles of about one size, as a scanner of solid
//! things gives them.

use glam::DVec3;
use rayon::prelude::*;

use super::noise::fractal_in_space;
use super::{MeshData, icosphere};

/// The radius to the ground of the furrows, without the lumps.
const RADIUS: f64 = 0.80;
/// How far the lumps reach, and how many lie along a diameter.
const LUMP: f64 = 0.16;
const LUMPS: f64 = 1.6;
/// How deep the furrows are, how many of them one crosses, and how much they wind.
const FURROW: f64 = 0.11;
const FURROWS: f64 = 15.0;
const WINDING: f64 = 1.5;
/// What a scanner adds: grain.
const GRAIN: f64 = 0.004;

/// The icosphere, each vertex moved along its radius; its normals are averaged.
pub(super) fn generate(triangles: u32, seed: u64) -> MeshData {
    let MeshData { positions, triangles, .. } = icosphere::generate(triangles);
    let moved = positions.par_iter().map(|p| {
        let direction = p.as_dvec3().normalize();
        (radius(seed, direction) * direction).as_vec3()
    });
    MeshData::with_averaged_normals(moved.collect(), triangles)
}

/// How far the surface is from the middle; at most 1.
fn radius(seed: u64, direction: DVec3) -> f64 {
    let noise =
        |stream: u64, scale: f64| fractal_in_space(seed ^ (stream << 32), scale * direction);
    // Ridges where a winding function of place passes through whole numbers, round on top.
    let winding = noise(1, WINDING);
    let ridge = libm::sin(std::f64::consts::PI * FURROWS * 0.5 * winding).abs();
    let ridge = 1.0 - (1.0 - ridge) * (1.0 - ridge);
    let radius = RADIUS + LUMP * noise(2, LUMPS) + FURROW * ridge + GRAIN * noise(3, 60.0);
    // The groove between the two halves.
    let across = direction.y / 0.06;
    let radius = radius - 0.12 * direction.z.max(0.0) / (1.0 + across * across);
    radius.min(1.0)
}
