//! The bytes of a Wavefront OBJ file → a mesh, or an error at a line.
#![no_main]

use std::path::Path;

use libfuzzer_sys::{fuzz_mutator, fuzz_target};
use srt::assets::{AssetError, MeshData, read_obj};

const TETRAHEDRON: &str =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\nvn 1 1 0\nf 1 2 3\nf 1//1 2//2 4\n";

const LINES: [&str; 10] = [
    "v 1 0 2",
    "v -1 2 0 1",
    "v 0 3 1 1 0 0",
    "vn 0 1 0",
    "f 1 3 4",
    "f 2 3 4 1",
    "f -1 -2 -3",
    "f 1//1 2//1 3//-1",
    "f 1/1/2 2/1 3",
    "g a",
];

fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
    srt_fuzz::mutate_lines(data, (size, max_size, seed), TETRAHEDRON, &LINES)
});

fuzz_target!(|data: &[u8]| {
    let read = read_obj(data.to_vec(), Path::new("fuzz.obj"));
    match &read {
        Ok(mesh) => {
            check_mesh(mesh);
            if srt_fuzz::is_one_of(4, data) {
                check_round_trip(mesh);
            }
        }
        Err(error) => check_error(data, error),
    }
    srt_fuzz::count(read.is_ok());
});

/// What stands at the fields of a mesh.
fn check_mesh(mesh: &MeshData) {
    assert!(!mesh.triangles.is_empty());
    assert_eq!(mesh.triangles.len(), mesh.normal_indices.len());
    assert!(mesh.positions.iter().all(|position| position.is_finite()));
    let is_unit = |length: f32| (length - 1.0).abs() < 1e-5;
    assert!(mesh.normals.iter().all(|normal| is_unit(normal.length())), "{:?}", mesh.normals);
    let within = |indices: &[[u32; 3]], length: usize| {
        indices.iter().flatten().all(|&index| (index as usize) < length)
    };
    assert!(within(&mesh.triangles, mesh.positions.len()));
    assert!(within(&mesh.normal_indices, mesh.normals.len()));
    assert!(!mesh.bounds().is_empty());
}

/// A mesh that is written reads back as the same triangles, corners and normals, in the same order.
fn check_round_trip(mesh: &MeshData) {
    let mut text = Vec::new();
    mesh.to_obj(&mut text).expect("memory takes what is written");
    let again = read_obj(text, Path::new("again.obj")).expect("what was written can be read");
    assert_eq!(again.dropped, 0);
    assert_eq!(corners(&again), corners(mesh));
}

/// The bits of each corner's position and normal, triangle by triangle.
fn corners(mesh: &MeshData) -> Vec<[u32; 6]> {
    let all = mesh.triangles.iter().flatten().zip(mesh.normal_indices.iter().flatten());
    let bits = |(&p, &n): (&u32, &u32)| {
        let (p, n) = (mesh.positions[p as usize], mesh.normals[n as usize]);
        [p.x, p.y, p.z, n.x, n.y, n.z].map(f32::to_bits)
    };
    all.map(bits).collect()
}

/// The place of an error is a line of the text.
fn check_error(data: &[u8], error: &AssetError) {
    assert_eq!(error.reference, 0);
    assert!(!error.to_string().is_empty());
    let Some(place) = &error.place else { return };
    let lines = data.split(|&byte| byte == b'\n').count();
    assert!((1..=lines).contains(&place.line), "line {} of {lines}", place.line);
}
