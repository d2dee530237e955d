//! What a single formula costs: a ray against a ball, a cylinder, a triangle, and four triangles
//! at once. About half of the rays hit.

use std::hint::black_box;
use std::path::Path;

use criterion::{Criterion, Throughput};
use glam::Vec3;
use srt::accel::{Answers, BuildConfig, Exhaustive, Indexed, Scratch};
use srt::assets::load_meshes;
use srt::math::{Hit, Random, Ray};
use srt::scene::{Scene, structure_named};
use srt::scene_file::{ParseOptions, parse};
use srt::shapes::{Ball, Cylinder, Triangle, TriangleSet};

use crate::table::Row;

/// Rays in an iteration: few enough to stay in the nearest cache.
const RAYS: usize = 256;

const CORNERS: [Vec3; 3] =
    [Vec3::new(-1.0, -1.0, 0.0), Vec3::new(1.0, -1.0, 0.0), Vec3::new(0.0, 1.0, 0.5)];

pub(crate) fn group(criterion: &mut Criterion, rows: &mut Vec<Row>) {
    let rays = rays();
    let ball = Ball { center: Vec3::ZERO, radius: 1.0 };
    let triangle = Triangle::new(CORNERS);
    let four: Vec<Vec3> = (0..4).flat_map(|i| CORNERS.map(|p| p + Vec3::Z * i as f32)).collect();
    let pack = TriangleSet::new(&four, &[[0, 1, 2], [3, 4, 5], [6, 7, 8], [9, 10, 11]]);
    let pack: Indexed<TriangleSet, Exhaustive> = Indexed::build(pack, &BuildConfig::default());

    let ahead = |crossings: [f32; 2]| crossings.into_iter().find(|&t| t >= 0.0);
    let on_ball = |ray: &Ray| ball.crossing(ray).and_then(|(a, b)| ahead([a, b]));
    let on_cylinder = |ray: &Ray| Cylinder::crossing(ray).and_then(|c| ahead(c.map(|(t, _)| t)));
    let on_triangle = |ray: &Ray| triangle.intersect(ray).map(|(t, ..)| t);
    let on_pack = |ray: &Ray| {
        let hit = pack.hit(ray);
        hit.is_hit().then_some(hit.t)
    };
    let triangles: String = four
        .chunks(3)
        .map(|p| {
            let numbers: Vec<String> =
                p.iter().flat_map(|p| p.to_array()).map(|x| x.to_string()).collect();
            format!("triangle {}\n", numbers.join(" "))
        })
        .collect();
    let first = triangles.lines().next().unwrap_or_default();
    check("ball 1 0 0 0", &rays, on_ball);
    check("cylinder", &rays, on_cylinder);
    check(first, &rays, on_triangle);
    check(&triangles, &rays, on_pack);

    let mut group = criterion.benchmark_group("shapes");
    group.throughput(Throughput::Elements(RAYS as u64));
    let mut measure = |name: &str, hit: &dyn Fn(&[Ray]) -> f32| {
        group.bench_function(name, |b| b.iter(|| hit(black_box(&rays))));
        rows.push(Row::new("shapes", name, None, RAYS as u64, "rays"));
    };
    // The loops are within the calls, and the formulas within the loops.
    measure("ball", &|rays| rays.iter().filter_map(on_ball).sum());
    measure("cylinder", &|rays| rays.iter().filter_map(on_cylinder).sum());
    measure("triangle", &|rays| rays.iter().filter_map(on_triangle).sum());
    measure("four-triangles", &|rays| rays.iter().filter_map(on_pack).sum());
    group.finish();
}

/// Rays from all around through points near the origin.
fn rays() -> Vec<Ray> {
    let mut random = Random::new(&[1]);
    let mut point = || Vec3::from_array(std::array::from_fn(|_| 2.0 * random.next_f32() - 1.0));
    let mut ray = || {
        let origin = 4.0 * point().normalize_or(Vec3::X);
        Ray::new(origin, 1.6 * point() - origin)
    };
    (0..RAYS).map(|_| ray()).collect()
}

/// Compares the distances of hits with those that `none` finds in a scene of the shape.
fn check(shape: &str, rays: &[Ray], hit: impl Fn(&Ray) -> Option<f32>) {
    let camera = "eyepos 0 -5 0\neyedir 0 1 0\neyeup 0 0 1\nwdist 1\nfovy_deg 40\nnx 9\nny 9\n";
    let text = format!("sce1.0\n{camera}{shape}\nend\n");
    let parsed = parse(&text, &ParseOptions::default()).expect("the scene is valid");
    let meshes = load_meshes(&parsed.description.meshes, Path::new(".")).expect("there are none");
    let scene = Scene::new(&parsed.description, meshes).expect("the scene can be traced");
    let none = structure_named("none").expect("none is a structure");
    let mut hits = vec![Hit::MISS; rays.len()];
    let world = none.build(&scene, &BuildConfig::default());
    world.trace(rays, Answers::ClosestHit(&mut hits), &mut Scratch::default(), None);
    for (ray, expected) in rays.iter().zip(&hits) {
        let expected = expected.is_hit().then_some(expected.t);
        assert_eq!(hit(ray), expected, "{shape}: the hits differ from those of `none`");
    }
    let share = hits.iter().filter(|hit| hit.is_hit()).count();
    assert!((RAYS / 8..RAYS).contains(&share), "{shape}: {share} of {RAYS} rays hit");
}
