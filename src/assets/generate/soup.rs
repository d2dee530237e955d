//! Random triangles in a cube.

use glam::Vec3;
use rayon::prelude::*;

use super::MeshData;
use crate::math::Random;

/// Separates the random stream of a triangle from other uses of the same numbers.
const STREAM: u64 = 0x736F_7570;

/// `triangles` triangles, each a function of the seed and its own index, with flat normals.
pub(super) fn generate(triangles: u32, seed: u64) -> MeshData {
    // Half the edge of the cube in which the corners of one triangle lie.
    let reach = (libm::pow(f64::from(triangles), -1.0 / 3.0) as f32).min(0.5);
    let corners: Vec<[Vec3; 3]> =
        (0..triangles).into_par_iter().map(|i| triangle(seed, i, reach)).collect();
    let numbered: Vec<_> = (0..triangles).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    MeshData {
        normals: corners.iter().map(|c| normal(c).unwrap_or(Vec3::Z)).collect(),
        positions: corners.into_flattened(),
        triangles: numbered,
        normal_indices: (0..triangles).map(|i| [i; 3]).collect(),
        dropped: 0,
    }
}

fn triangle(seed: u64, index: u32, reach: f32) -> [Vec3; 3] {
    let mut random = Random::new(&[STREAM, seed, u64::from(index)]);
    loop {
        let center = (1.0 - reach) * in_cube(&mut random);
        let corners = [(); 3].map(|()| center + reach * in_cube(&mut random));
        // Three points on a line are next to impossible, and another try is next to free.
        if normal(&corners).is_some() {
            return corners;
        }
    }
}

/// A point of [−1, 1)³.
fn in_cube(random: &mut Random) -> Vec3 {
    let mut coordinate = || 2.0 * random.next_f32() - 1.0;
    Vec3::new(coordinate(), coordinate(), coordinate())
}

/// The unit normal; `None` if there is no area.
fn normal(corners: &[Vec3; 3]) -> Option<Vec3> {
    let [a, b, c] = corners.map(Vec3::as_dvec3);
    (b - a).cross(c - a).try_normalize().map(|n| n.as_vec3())
}
