//! Deformed meshes: what a scene's `twist`, `wave` and `explode` make of one.
//!
//! The result is a function of the mesh and of the deformation, equal to the bit on every platform: the arithmetic is
//! that of `f64`, rounded once, with sines and cosines from `libm`.

use std::f64::consts::{PI, TAU};

use glam::{DQuat, DVec2, DVec3, Vec3};
use rayon::prelude::*;

use super::MeshData;
use crate::description::{Deformation, Wave};
use crate::math::Random;

/// How far triangles that fly apart stray from straight paths, as a share of the explosion's distance.
const STRAY: f64 = 0.35;

/// The most that they turn on their way, in radians for a distance of 1.
const TUMBLE: f64 = PI;

/// The bytes that a deformed mesh takes as it is made, for each triangle of the mesh: at most, if none share vertices.
pub(super) const BYTES_OF_TRIANGLE: u64 = 200;

/// The mesh as a deformation makes it. Triangles that lose their area are dropped and counted. `None` where a vertex
/// leaves single precision, or no triangle is left.
pub(super) fn deform(mesh: &MeshData, deformation: &Deformation) -> Option<MeshData> {
    let bent = bend(mesh, deformation);
    let deformed =
        if deformation.explosion == 0.0 { bent } else { explode(&bent, deformation.explosion) };
    if !deformed.positions.par_iter().all(|position| position.is_finite()) {
        return None;
    }
    let Surface { positions, triangles, normals, normal_indices } = deformed;
    let mut deformed = MeshData::with_normals(positions, triangles, normals, normal_indices);
    deformed.dropped += mesh.dropped;
    (!deformed.triangles.is_empty()).then_some(deformed)
}

/// A mesh that is not checked yet.
struct Surface {
    positions: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    normals: Vec<Vec3>,
    normal_indices: Vec<[u32; 3]>,
}

/// Twists a mesh and sends a wave through it: each point by itself, so triangles stay joined.
fn bend(mesh: &MeshData, deformation: &Deformation) -> Surface {
    let bend = Bend::new(deformation);
    let positions = mesh.positions.par_iter().map(|&p| bend.point(p.as_dvec3()).as_vec3());
    let triangles = mesh.triangles.clone();
    // A normal turns with the place that it is at. Where it is shared by several places, it is so no longer.
    let normal_at = |normal: u32, place: u32| {
        let [normal, place] = [mesh.normals[normal as usize], mesh.positions[place as usize]];
        bend.normal(normal.as_dvec3(), place.as_dvec3()).as_vec3()
    };
    let (normals, normal_indices) = if mesh.normal_indices == mesh.triangles {
        let all = 0..mesh.normals.len() as u32;
        (all.into_par_iter().map(|i| normal_at(i, i)).collect(), triangles.clone())
    } else {
        let corners = mesh.triangles.par_iter().zip(&mesh.normal_indices);
        let of_corners =
            corners.map(|(places, normals)| [0, 1, 2].map(|i| normal_at(normals[i], places[i])));
        separate(of_corners.collect())
    };
    Surface { positions: positions.collect(), triangles, normals, normal_indices }
}

/// Values of corners that share none, and the indices of the corners.
fn separate(of_corners: Vec<[Vec3; 3]>) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let first = |i: usize| 3 * i as u32;
    let indices = (0..of_corners.len()).map(|i| [first(i), first(i) + 1, first(i) + 2]).collect();
    (of_corners.into_flattened(), indices)
}

/// A twist about z, then a wave along x.
struct Bend {
    /// Radians for each unit of z.
    twist: f64,
    wave: Wave,
}

impl Bend {
    fn new(deformation: &Deformation) -> Self {
        Self { twist: deformation.twist.to_radians(), wave: deformation.wave }
    }

    /// A point after the twist.
    fn twisted(&self, point: DVec3) -> DVec3 {
        let (sin, cos) = libm::sincos(self.twist * point.z);
        DVec3::new(cos * point.x - sin * point.y, sin * point.x + cos * point.y, point.z)
    }

    /// How far along the wave a place is, in radians.
    fn angle(&self, x: f64) -> f64 {
        TAU * ((x / self.wave.length - self.wave.phase) % 1.0)
    }

    fn point(&self, point: DVec3) -> DVec3 {
        let mut point = self.twisted(point);
        point.z += self.wave.amplitude * libm::sin(self.angle(point.x));
        point
    }

    /// The direction of a normal at a point: by the transposed inverse of the derivative there. Of the twist that is
    /// \[R w; 0 1\], R the rotation and w how fast the point moves with z; of the wave it is the identity but for the
    /// slope of z along x.
    fn normal(&self, normal: DVec3, place: DVec3) -> DVec3 {
        let (sin, cos) = libm::sincos(self.twist * place.z);
        let place = self.twisted(place);
        let turned = DVec2::new(cos * normal.x - sin * normal.y, sin * normal.x + cos * normal.y);
        let along_z = self.twist * DVec2::new(-place.y, place.x);
        let normal = turned.extend(normal.z - along_z.dot(turned));
        let slope = self.wave.amplitude * TAU / self.wave.length * libm::cos(self.angle(place.x));
        DVec3::new(normal.x - slope * normal.z, normal.y, normal.z)
    }
}

/// Moves triangles apart: each away from the origin, a little astray, and tumbling about its own middle.
fn explode(mesh: &Surface, distance: f64) -> Surface {
    let fly = |(index, (places, normals)): (usize, (&[u32; 3], &[u32; 3]))| {
        let corners = places.map(|i| mesh.positions[i as usize].as_dvec3());
        let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
        let mut random = Random::new(&[index as u64]);
        let mut next = || f64::from(2.0 * random.next_f32() - 1.0);
        let stray = STRAY * DVec3::new(next(), next(), next());
        let turn = rotation(DVec3::new(next(), next(), next()), TUMBLE * distance * next());
        let moved = middle + distance * (middle + stray);
        let normals = normals.map(|i| (turn * mesh.normals[i as usize].as_dvec3()).as_vec3());
        (corners.map(|corner| (moved + turn * (corner - middle)).as_vec3()), normals)
    };
    let triangles = mesh.triangles.par_iter().zip(&mesh.normal_indices).enumerate();
    let (corners, normals): (Vec<_>, Vec<_>) = triangles.map(fly).unzip();
    let (positions, triangles) = separate(corners);
    let (normals, normal_indices) = separate(normals);
    Surface { positions, triangles, normals, normal_indices }
}

/// The rotation about an axis; none about one without a direction.
fn rotation(axis: DVec3, radians: f64) -> DQuat {
    let (sin, cos) = libm::sincos(0.5 * (radians % (2.0 * TAU)));
    let axis = axis.normalize_or_zero();
    if axis == DVec3::ZERO { DQuat::IDENTITY } else { DQuat::from_vec4((axis * sin).extend(cos)) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::assets::generate::{MeshKind, generate};

    const WAVE: Wave = Wave { amplitude: 0.2, length: 0.7, phase: 0.3 };

    fn ball() -> MeshData {
        generate(MeshKind::Icosphere, 2000, 0)
    }

    #[test]
    fn a_mesh_that_is_not_deformed_is_the_same() {
        let mesh = ball();
        assert_eq!(deform(&mesh, &Deformation::default()).unwrap().positions, mesh.positions);
    }

    #[test]
    fn a_twist_turns_each_height_by_its_own_angle() {
        let bend = Bend::new(&Deformation { twist: 90.0, ..Deformation::default() });
        assert!(
            (bend.point(DVec3::new(1.0, 0.0, 1.0)) - DVec3::new(0.0, 1.0, 1.0)).length() < 1e-15
        );
        assert!(
            (bend.point(DVec3::new(0.0, 2.0, -1.0)) - DVec3::new(2.0, 0.0, -1.0)).length() < 1e-15
        );
        assert_eq!(bend.point(DVec3::X), DVec3::X);
    }

    #[test]
    fn normals_stand_on_the_surface_that_was_bent() {
        // Two tangents at each vertex of a ball, by differences: the bent normal stands on the bent tangents.
        let bend = Bend::new(&Deformation { twist: 70.0, wave: WAVE, explosion: 0.0 });
        for place in ball().positions.iter().step_by(7).map(|p| p.as_dvec3()) {
            let tangents = [place.cross(DVec3::new(0.3, 0.2, 1.0)), place.cross(DVec3::X)];
            let normal = bend.normal(place, place).normalize();
            for tangent in tangents {
                let step = 1e-6 * tangent;
                let along = (bend.point(place + step) - bend.point(place - step)) / 2e-6;
                assert!(normal.dot(along).abs() < 1e-6, "{place}: {}", normal.dot(along));
            }
        }
    }

    #[test]
    fn an_explosion_keeps_the_triangles_as_they_are() {
        let mesh = ball();
        let deformed =
            deform(&mesh, &Deformation { explosion: 1.0, ..Deformation::default() }).unwrap();
        let sides = |mesh: &MeshData, triangle: usize| {
            let corner = |i: usize| mesh.positions[mesh.triangles[triangle][i] as usize];
            [0, 1, 2].map(|i| corner(i).distance(corner((i + 1) % 3)))
        };
        assert_eq!(deformed.triangles.len(), mesh.triangles.len());
        for triangle in 0..mesh.triangles.len() {
            let (before, after) = (sides(&mesh, triangle), sides(&deformed, triangle));
            assert!((0..3).all(|i| (before[i] - after[i]).abs() < 1e-6));
        }
        let size = |mesh: &MeshData| mesh.bounds().max.x;
        assert!(size(&deformed) > 1.7 * size(&mesh));
    }

    #[test]
    fn what_leaves_single_precision_is_refused() {
        let wave = Wave { amplitude: 3e38, ..WAVE };
        let far = Deformation { wave, explosion: 10.0, ..Deformation::default() };
        assert!(deform(&ball(), &far).is_none());
    }

    #[test]
    fn a_deformed_mesh_has_the_same_bits_on_every_machine() {
        let deformation = Deformation { twist: 70.0, wave: WAVE, explosion: 0.25 };
        let mesh = deform(&ball(), &deformation).unwrap();
        let add =
            |sum: u64, value: &f32| sum.wrapping_mul(31).wrapping_add(u64::from(value.to_bits()));
        let hash = |vectors: &[Vec3]| {
            vectors.iter().flat_map(|v| v.to_array()).fold(0, |sum, value| add(sum, &value))
        };
        assert_eq!(
            [hash(&mesh.positions), hash(&mesh.normals)],
            [2_326_487_249_475_287_471, 5_070_983_979_863_555_757]
        );
    }
}
