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
                MeshKind::Icosphere | MeshKind::Scan => (20.0 / f64::from(count)).sqrt() * 1.05,
                MeshKind::Box => (12.0 / f64::from(count)).sqrt() * 1.05,
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
        use MeshKind::{Hair, Scan, Soup, Terrain};
        assert_eq!(seeded, matches!(kind, Terrain | Soup | Scan | Hair), "{kind}");
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

#[test]
fn the_scan_is_closed_and_furrowed() {
    for seed in [0, 4] {
        let coral = generate(MeshKind::Scan, 20_000, seed);
        assert_eq!(euler_characteristic(&coral), 2);
        assert!(is_closed(&coral));
        let radii = || coral.positions.iter().map(|p| p.length());
        let (low, high) = (radii().fold(1.0, f32::min), radii().fold(0.0, f32::max));
        assert!(low > 0.5 && high <= 1.0 && high - low > 0.1, "from {low} to {high}");
    }
}

#[test]
fn the_teapot_is_fine_and_the_stadium_coarse() {
    for triangles in [5_000, 100_000, 1_000_000] {
        let stadium = generate(MeshKind::Stadium, triangles, 0);
        let is_of_teapot = |t: &&[u32; 3]| {
            t.iter().all(|&i| stadium.positions[i as usize].truncate().length() < 0.011)
        };
        let fine = stadium.triangles.iter().filter(is_of_teapot).count();
        assert!(8 * fine > 6 * stadium.triangles.len(), "{fine} of {triangles}");
        assert!(stadium.triangles.len() - fine < 6_200, "the stands stay coarse");
        let bounds = stadium.bounds();
        assert_eq!((bounds.min.x, bounds.max.y, bounds.min.z), (-1.0, 0.75, 0.0));
        assert!(bounds.max.z > 0.2 && bounds.max.z <= 0.25);
    }
}

#[test]
fn strands_are_long_and_thin() {
    let hair = generate(MeshKind::Hair, 160_000, 1);
    assert_eq!(hair.triangles.len(), 160_000);
    let slenderness = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|i| hair.positions[i as usize].as_dvec3());
        let longest = (b - a).length().max((c - b).length()).max((a - c).length());
        longest * longest / (b - a).cross(c - a).length()
    };
    let mut all: Vec<f64> = hair.triangles.iter().map(slenderness).collect();
    all.sort_by(f64::total_cmp);
    assert!(all[all.len() / 2] > 10.0, "{}", all[all.len() / 2]);
    // Strands share no vertices with each other, and the squares of one share theirs.
    assert_eq!(hair.positions.len(), 10_000 * 18);
}

#[test]
fn the_box_is_the_cube() {
    let block = generate(MeshKind::Box, 12 * 25, 0);
    assert_eq!((block.triangles.len(), block.positions.len()), (300, 6 * 36));
    assert!((area(&block) - 24.0).abs() < 1e-6);
    for (triangle, normals) in block.triangles.iter().zip(&block.normal_indices) {
        let out = triangle.iter().map(|&i| block.positions[i as usize]).sum::<Vec3>();
        assert!(normals.iter().all(|&n| block.normals[n as usize].dot(out) > 0.0), "outwards");
    }
}
