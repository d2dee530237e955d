//! Every kind against closed forms: counts, extents, areas, Euler characteristics.

use std::collections::HashSet;

use glam::Vec3;

use super::*;

const COUNTS: [u32; 5] = [1000, 1131, 5000, 70_000, 300_000];

fn area(mesh: &MeshData) -> f64 {
    let corners = mesh.triangles.iter().map(|t| t.map(|i| mesh.positions[i as usize].as_dvec3()));
    corners.map(|[a, b, c]| (b - a).cross(c - a).length() / 2.0).sum()
}

/// Vertices − edges + faces.
fn euler_characteristic(mesh: &MeshData) -> i64 {
    let edges: HashSet<_> = mesh
        .triangles
        .iter()
        .flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)])
        .map(|(a, b)| (a.min(b), a.max(b)))
        .collect();
    mesh.positions.len() as i64 - edges.len() as i64 + mesh.triangles.len() as i64
}

/// Whether every edge has exactly two faces, which run along it in opposite directions.
fn is_closed(mesh: &MeshData) -> bool {
    let edges = mesh.triangles.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
    let mut seen = HashSet::new();
    edges.clone().all(|edge| seen.insert(edge))
        && edges.clone().all(|(a, b)| seen.contains(&(b, a)))
}

#[test]
fn every_mesh_satisfies_the_invariants_of_mesh_data() {
    for kind in MeshKind::ALL {
        for count in (1..60).chain(COUNTS) {
            let mesh = generate(kind, count, 3);
            assert_eq!(mesh.dropped, 0, "{kind} {count}");
            assert_eq!(mesh.triangles.len(), mesh.normal_indices.len());
            let in_range =
                |list: &[[u32; 3]], n: usize| list.iter().flatten().all(|&i| (i as usize) < n);
            assert!(in_range(&mesh.triangles, mesh.positions.len()));
            assert!(in_range(&mesh.normal_indices, mesh.normals.len()));
            assert!(mesh.normals.iter().all(|n| n.is_normalized()));
            assert!(mesh.positions.iter().all(|p| p.abs().max_element() <= 1.0), "{kind} {count}");
            let clean = MeshData::with_averaged_normals(mesh.positions, mesh.triangles);
            assert_eq!(clean.dropped, 0, "{kind} {count}");
        }
    }
}

#[test]
fn the_number_of_triangles_is_about_the_requested_one() {
    for kind in MeshKind::ALL {
        for count in COUNTS {
            let got = generate(kind, count, 0).triangles.len() as f64;
            let miss = (got / f64::from(count) - 1.0).abs();
            let allowed = match kind {
                MeshKind::Icosphere => (20.0 / f64::from(count)).sqrt() * 1.05,
                MeshKind::Soup => 0.0,
                _ => 0.03,
            };
            assert!(miss <= allowed, "{kind}: {got} for {count}");
        }
    }
}

#[test]
fn the_same_numbers_give_the_same_mesh_and_seeds_others() {
    for kind in MeshKind::ALL {
        assert_eq!(generate(kind, 5000, 7), generate(kind, 5000, 7));
        let seeded = generate(kind, 5000, 8) != generate(kind, 5000, 7);
        assert_eq!(seeded, matches!(kind, MeshKind::Terrain | MeshKind::Soup), "{kind}");
    }
}

#[test]
fn the_icosphere_is_a_closed_ball() {
    let mut last_miss = f64::INFINITY;
    for k in [1, 2, 3, 7, 30] {
        let ball = generate(MeshKind::Icosphere, 20 * k * k, 0);
        assert_eq!(ball.triangles.len(), (20 * k * k) as usize);
        assert_eq!(ball.positions.len(), (10 * k * k + 2) as usize);
        assert_eq!(euler_characteristic(&ball), 2);
        assert!(is_closed(&ball));
        let miss = 4.0 * std::f64::consts::PI - area(&ball);
        assert!(miss > 0.0 && miss < last_miss, "k = {k}: {miss}");
        last_miss = miss;
    }
    assert!(last_miss < 0.01);
}

#[test]
fn the_knot_is_a_closed_tube() {
    let knot = generate(MeshKind::TorusKnot, 70_000, 0);
    assert_eq!(euler_characteristic(&knot), 0);
    assert!(is_closed(&knot));
    // Pappus: the area of a tube about a curve is its length times its circumference.
    let length: f64 = {
        let point = |i: u32| {
            let v = std::f64::consts::TAU * f64::from(i) / 100_000.0;
            let r = 0.6 + 0.25 * (3.0 * v).cos();
            glam::DVec3::new(r * (2.0 * v).cos(), r * (2.0 * v).sin(), 0.25 * (3.0 * v).sin())
        };
        (0..100_000).map(|i| point(i).distance(point(i + 1))).sum()
    };
    let expected = length * std::f64::consts::TAU * 0.12;
    assert!((area(&knot) / expected - 1.0).abs() < 1e-3, "{} {expected}", area(&knot));
    let averaged = MeshData::with_averaged_normals(knot.positions, knot.triangles);
    let worst = knot.normals.iter().zip(&averaged.normals).map(|(a, b)| a.dot(*b));
    assert!(worst.fold(1.0, f32::min) > 0.999, "faces outwards, as the averages do");
}

#[test]
fn terrain_spans_its_square_and_faces_up() {
    let land = generate(MeshKind::Terrain, 20_000, 1);
    let bounds = land.bounds();
    assert_eq!((bounds.min.x, bounds.max.x, bounds.min.y, bounds.max.y), (-1.0, 1.0, -1.0, 1.0));
    assert!(bounds.min.z >= -0.35 && bounds.max.z <= 0.35 && bounds.size().z > 0.1);
    assert!(land.normals.iter().all(|n| n.z > 0.0));
    assert_eq!(euler_characteristic(&land), 1);
}

#[test]
fn the_hall_stands_on_the_floor_and_its_room_faces_inwards() {
    let hall = generate(MeshKind::Hall, 50_000, 0);
    let bounds = hall.bounds();
    assert_eq!(Vec3::from(bounds.min), Vec3::new(-1.0, -0.6, 0.0));
    assert_eq!(Vec3::from(bounds.max), Vec3::new(1.0, 0.6, 0.8));
    let middle = Vec3::new(0.0, 0.0, 0.4);
    for (triangle, normals) in hall.triangles.iter().zip(&hall.normal_indices).take(12) {
        let inwards = middle - hall.positions[triangle[0] as usize];
        assert!(normals.iter().all(|&n| hall.normals[n as usize].dot(inwards) > 0.0));
    }
    let size = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|i| hall.positions[i as usize]);
        (b - a).cross(c - a).length()
    };
    let mut sizes: Vec<f32> = hall.triangles.iter().map(size).collect();
    sizes.sort_by(f32::total_cmp);
    assert!(sizes[sizes.len() - 1] / sizes[sizes.len() / 2] > 1e4, "coarse and fine together");
}

#[test]
fn soup_shrinks_with_its_number() {
    let mean_area = |n: u32| area(&generate(MeshKind::Soup, n, 1)) / f64::from(n);
    let ratio = mean_area(1000) / mean_area(64_000);
    assert!((ratio / 16.0 - 1.0).abs() < 0.1, "64 times as many, a 16th of the area: {ratio}");
}
