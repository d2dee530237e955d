//! Where the triangles of a mesh are: the box around them and the mean of their vertices.

use std::sync::atomic::{AtomicBool, Ordering};

use glam::{DVec3, Vec3, Vec3A};
use rayon::prelude::*;

use crate::math::Aabb;

/// Vertices, or corners, that a thread takes together.
const CHUNK: usize = 1 << 13;

/// The mean of the vertices that some triangles use, each counted once, and the box around them: a file may hold
/// others, and these are no part of the mesh. None if a vertex is not there or not finite.
pub(in super::super) fn mean_and_bounds(
    positions: &[Vec3],
    triangles: &[[u32; 3]],
) -> Option<(Vec3A, Aabb)> {
    let used: Vec<_> = positions.iter().map(|_| AtomicBool::new(false)).collect();
    let note = |&corner: &u32| match used.get(corner as usize) {
        Some(used) => {
            used.store(true, Ordering::Relaxed);
            true
        }
        None => false,
    };
    // To the end, even where one is missing, which is hardly ever.
    let all = |corners: &[u32]| corners.iter().fold(true, |all, corner| note(corner) & all);
    if !triangles.as_flattened().par_chunks(CHUNK).all(all) {
        return None;
    }
    let of_chunk = |(positions, used): (&[Vec3], &[AtomicBool])| {
        let mut sum = (DVec3::ZERO, 0u32);
        let mut bounds = Aabb::EMPTY;
        for (&position, used) in positions.iter().zip(used) {
            if used.load(Ordering::Relaxed) {
                sum = (sum.0 + position.as_dvec3(), sum.1 + 1);
                let point = Vec3A::from(position);
                bounds = Aabb { min: bounds.min.min(point), max: bounds.max.max(point) };
            }
        }
        (sum, bounds)
    };
    // Added up in one order, whatever the number of threads.
    let chunks: Vec<_> =
        positions.par_chunks(CHUNK).zip(used.par_chunks(CHUNK)).map(of_chunk).collect();
    let (sum, count) = chunks.iter().fold((DVec3::ZERO, 0), |a, (b, _)| (a.0 + b.0, a.1 + b.1));
    let bounds = chunks.iter().fold(Aabb::EMPTY, |all, (_, bounds)| all.union(*bounds));
    // Sums of 2³² numbers in single precision are finite in double precision, if all of them are.
    sum.is_finite().then(|| ((sum / f64::from(1.max(count))).as_vec3a(), bounds))
}

#[cfg(test)]
pub(in super::super) mod tests {
    use super::*;

    /// So many triangles, each of vertices of its own.
    pub(in super::super::super) fn apart(triangles: usize) -> (Vec<Vec3>, Vec<[u32; 3]>) {
        let at = |i: usize| Vec3::new(i as f32, (i % 100) as f32 - 60.0, -2.0 - (i % 7) as f32);
        let corners = (0..triangles as u32).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]);
        ((0..3 * triangles).map(at).collect(), corners.collect())
    }

    #[test]
    fn boxes_and_means_are_those_of_a_plain_sum() {
        for count in [0, 1, 7, 8, 9, 30_001] {
            let (positions, triangles) = apart(count);
            let (mean, bounds) = mean_and_bounds(&positions, &triangles).unwrap();
            assert_eq!(bounds, Aabb::of_points(positions.iter().map(|&p| p.into())), "{count}");
            let sum: DVec3 = positions.iter().map(|p| p.as_dvec3()).sum();
            let expected = sum / positions.len().max(1) as f64;
            let error = (mean.as_dvec3() - expected).length();
            assert!(error <= 1e-6 * expected.length(), "{count}: {error}");
        }
    }

    #[test]
    fn corners_that_are_missing_or_not_finite_are_found_wherever_they_are() {
        let mut positions: Vec<_> = (0..20_000).map(|i| Vec3::splat(i as f32)).collect();
        let mut triangles: Vec<_> = (0..19_998).map(|i| [i, i + 1, i + 2]).collect();
        assert!(mean_and_bounds(&positions, &triangles).is_some());
        for place in [0, 9_000, 19_997] {
            let before = std::mem::replace(&mut triangles[place], [0, 20_000, 1]);
            assert_eq!(mean_and_bounds(&positions, &triangles), None);
            triangles[place] = before;
            for value in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
                let before = std::mem::replace(&mut positions[place], Vec3::new(0.0, value, 0.0));
                assert_eq!(mean_and_bounds(&positions, &triangles), None);
                positions[place] = before;
            }
        }
    }
}
