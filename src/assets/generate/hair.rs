//! Strands on a ball: strips of long, thin triangles that lie every way but along an axis.

use std::f64::consts::{PI, TAU};

use glam::{DVec3, Vec3};
use rayon::prelude::*;

use super::MeshData;
use crate::math::Random;

/// Separates the random stream of a strand from other uses of the same numbers.
const STREAM: u64 = 0x6861_6972;
/// Squares of a strand, two triangles each.
const SQUARES: u32 = 8;
/// The radius of the ball in which the strands are rooted.
const SCALP: f64 = 0.42;
/// How long they are, at most, and how far they fall.
const LENGTH: f64 = 0.36;
const FALL: f64 = 0.24;
/// All strands together are as broad as so many turns around the ball, however many there are.
const TURNS: f64 = 16.0;
/// The broadest strand.
const BROADEST: f64 = 0.03;

/// Strands of 16 triangles each, evenly spread, each a function of the seed, its index and their number.
pub(super) fn generate(triangles: u32, seed: u64) -> MeshData {
    let of_one = 2 * SQUARES;
    let strands = ((triangles + of_one / 2) / of_one).max(1);
    let positions: Vec<Vec3> =
        (0..strands).into_par_iter().flat_map_iter(|i| strand(seed, i, strands)).collect();
    let split = (0..strands).flat_map(|strand| {
        let first = strand * 2 * (SQUARES + 1);
        (0..SQUARES).flat_map(move |square| {
            let [a, b, c, d] = [0, 1, 2, 3].map(|i| first + 2 * square + i);
            [[a, b, d], [a, d, c]]
        })
    });
    MeshData::with_averaged_normals(positions, split.collect())
}

/// The points of a strand, from its root to its tip, left and right.
fn strand(seed: u64, index: u32, strands: u32) -> Vec<Vec3> {
    let mut random = Random::new(&[STREAM, seed, u64::from(index)]);
    let mut between = |low: f64, high: f64| low + (high - low) * f64::from(random.next_f32());
    // A spiral of equal areas (E. B. Saff and A. B. J. Kuijlaars, *Distributing many points on a sphere*, 1997).
    let turn = f64::from(index) * PI * (3.0 - 5f64.sqrt());
    let height = 1.0 - (2.0 * f64::from(index) + 1.0) / f64::from(strands);
    let around = (1.0 - height * height).sqrt();
    let (sin, cos) = libm::sincos(turn);
    let out = DVec3::new(around * cos, around * sin, height);
    let root = SCALP * out;
    // Combed around the axis, with a lock of its own.
    let comb = DVec3::Z.cross(out) + 0.35 * DVec3::from_array([0; 3].map(|_| between(-1.0, 1.0)));
    let (length, curl, phase) =
        (LENGTH * between(0.6, 1.0), between(0.02, 0.05), between(0.0, 1.0));
    let half = (0.5 * BROADEST).min(PI * TURNS * SCALP / f64::from(strands));
    let center = |t: f64| {
        let (sin, cos) = libm::sincos(TAU * (2.0 * t + phase));
        let along = out * (t - 0.3 * t * t) + 0.6 * t * t * comb;
        let wave = curl * t * (sin * comb + cos * out.cross(comb));
        root + length * along + wave - FALL * t * t * t * DVec3::Z
    };
    let mut points = Vec::with_capacity(2 * (SQUARES as usize + 1));
    for i in 0..=SQUARES {
        let t = f64::from(i) / f64::from(SQUARES);
        let tangent = center(t + 0.01) - center(t - 0.01);
        let side = tangent.cross(out + 0.01 * DVec3::X).normalize_or(DVec3::X);
        // The tip is a third as broad as the root.
        let aside = half * (1.0 - 0.67 * t) * side;
        points.extend([center(t) - aside, center(t) + aside].map(DVec3::as_vec3));
    }
    points
}
