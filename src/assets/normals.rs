//! Vertex normals: those of a file brought to unit length, averages where there are none.

use glam::{DVec3, Vec3};

use super::MeshData;

/// How far from 1 the length of a normal may be to count as 1: two roundings of each coordinate.
/// Such normals keep their bits, so that files written from unit normals read back unchanged.
const UNIT_TOLERANCE: f64 = 4.0 / 16_777_216.0;

/// The normal of each vertex, averaged from the faces around it.
///
/// A face with edges **a** and **b** from the vertex weighs **a** × **b** / (|**a**|²|**b**|²), after
/// N. Max, *Weights for computing vertex normals from facet normals* (Journal of Graphics Tools
/// 4(2), 1999). The average is exact where the vertices lie on a ball, a flat polygon weighs the
/// same however it is cut into triangles, and the arithmetic is the same on every platform, unlike that
/// of weights by angles.
///
/// Where the faces cancel each other, the first face around the vertex decides; a vertex without
/// faces gets the z axis.
pub(super) fn average(positions: &[Vec3], triangles: &[[u32; 3]]) -> Vec<Vec3> {
    let mut sums = vec![DVec3::ZERO; positions.len()];
    for triangle in triangles {
        let p = triangle.map(|i| positions[i as usize].as_dvec3());
        for i in 0..3 {
            sums[triangle[i] as usize] += weighted(p[(i + 1) % 3] - p[i], p[(i + 2) % 3] - p[i]);
        }
    }
    let mut normals: Vec<Vec3> = sums.into_iter().map(|s| unit(s).unwrap_or(Vec3::ZERO)).collect();
    replace_missing(&mut normals, positions, triangles);
    normals
}

/// **a** × **b** / (|**a**|²|**b**|²), computed so that the squares neither overflow nor vanish.
fn weighted(a: DVec3, b: DVec3) -> DVec3 {
    (a / a.length_squared()).cross(b / b.length_squared())
}

/// Gives vertices whose faces cancelled each other the normal of the first of those faces.
fn replace_missing(normals: &mut [Vec3], positions: &[Vec3], triangles: &[[u32; 3]]) {
    if normals.iter().all(|&n| n != Vec3::ZERO) {
        return;
    }
    for triangle in triangles {
        for &i in triangle {
            if normals[i as usize] == Vec3::ZERO {
                let [a, b, c] = triangle.map(|i| positions[i as usize].as_dvec3());
                normals[i as usize] = unit((b - a).cross(c - a)).unwrap_or(Vec3::Z);
            }
        }
    }
    for normal in normals.iter_mut().filter(|n| **n == Vec3::ZERO) {
        *normal = Vec3::Z;
    }
}

/// Brings the normals of a mesh to unit length, and gives every corner whose normal has no length
/// the average of the faces around its vertex.
pub(super) fn complete(mesh: &mut MeshData) {
    let mut missing = vec![false; mesh.normals.len()];
    for (normal, missing) in mesh.normals.iter_mut().zip(&mut missing) {
        match normalized(*normal) {
            Some(n) => *normal = n,
            None => (*normal, *missing) = (Vec3::Z, true),
        }
    }
    let lacks = |corner: &u32| missing[*corner as usize];
    if !mesh.normal_indices.iter().flatten().any(lacks) {
        return;
    }
    let averages = average(&mesh.positions, &mesh.triangles);
    // Position index → index of its average among the normals, once a corner uses it.
    let mut added = vec![u32::MAX; mesh.positions.len()];
    for (corners, normal_corners) in mesh.triangles.iter().zip(&mut mesh.normal_indices) {
        for (&vertex, normal) in corners.iter().zip(normal_corners) {
            if missing[*normal as usize] {
                let slot = &mut added[vertex as usize];
                if *slot == u32::MAX {
                    *slot = mesh.normals.len() as u32;
                    mesh.normals.push(averages[vertex as usize]);
                }
                *normal = *slot;
            }
        }
    }
}

/// The vector at unit length; itself where it has that already, `None` where it has no direction.
fn normalized(n: Vec3) -> Option<Vec3> {
    let length = n.as_dvec3().length();
    if (length - 1.0).abs() <= UNIT_TOLERANCE { Some(n) } else { unit(n.as_dvec3()) }
}

/// The vector at unit length; `None` where it has no direction.
fn unit(v: DVec3) -> Option<Vec3> {
    // Scaled first: the square of the smallest and of the largest weights is out of range.
    let largest = v.abs().max_element();
    let direction = (v / largest).normalize_or_zero();
    (direction != DVec3::ZERO && direction.is_finite()).then(|| direction.as_vec3())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assets::generate::{MeshKind, generate};

    #[test]
    fn on_a_ball_the_average_is_exact() {
        // Convex, with triangles of unequal sizes: the weights of Max give the radius.
        let ball = generate(MeshKind::Icosphere, 1000, 0);
        for (p, n) in ball.positions.iter().zip(average(&ball.positions, &ball.triangles)) {
            assert!((*p - n).length() < 2e-6, "{p} {n}");
        }
    }

    #[test]
    fn a_corner_of_a_cube_is_exact_however_its_faces_are_cut() {
        let p = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z, Vec3::new(1.0, 1.0, 0.0)];
        // The face z = 0 in two triangles at the corner, the other two faces in one.
        let triangles = [[0, 4, 1], [0, 2, 4], [0, 1, 3], [0, 3, 2]];
        let expected = Vec3::splat(-1.0 / 3f32.sqrt());
        assert!((average(&p, &triangles)[0] - expected).length() < 1e-7);
    }

    #[test]
    fn faces_that_cancel_leave_the_first() {
        let p = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::ONE];
        let normals = average(&p, &[[0, 1, 2], [0, 2, 1]]);
        assert_eq!(normals, [Vec3::Z; 4]);
    }

    #[test]
    fn given_normals_become_unit_and_missing_ones_averages() {
        let mesh = MeshData::with_normals(
            vec![Vec3::ZERO, Vec3::X, Vec3::Y],
            vec![[0, 1, 2]],
            vec![Vec3::ZERO, Vec3::new(0.0, 3e30, 4e30), Vec3::NAN],
            vec![[0, 1, 2]],
        );
        assert!((mesh.normals[1] - Vec3::new(0.0, 0.6, 0.8)).length() < 1e-7);
        assert_eq!(mesh.normal_indices, [[3, 1, 4]]);
        assert_eq!(mesh.normals[3..], [Vec3::Z, Vec3::Z]);
        assert!(mesh.normals.iter().all(|n| n.is_normalized()));
    }
}
