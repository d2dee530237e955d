//! The measurements.

use std::hint::black_box;
use std::sync::Arc;
use std::time::Duration;

use criterion::{Bencher, BenchmarkId, Criterion, Throughput};
use glam::{DAffine3, DVec3, Vec3};
use srt::accel::{BuildConfig, Tracer};
use srt::assets::generate::{Kind, generate};
use srt::description::{
    Camera, Material, MeshReference, Normals, Object, Options, SceneDescription, Shape,
};
use srt::math::{Color, Hit, Ray};
use srt::scene::{STRUCTURES, Scene, structure_named};
use srt::scene_file::{ParseOptions, parse};

use crate::rays::{RaySet, ray_sets};
use crate::table::Row;

/// Rays of a class that trees trace in an iteration.
const RAYS: u32 = 40_000;

/// Primitive tests that an iteration of a linear structure may take; it traces fewer rays.
const LINEAR_TESTS: usize = 20_000_000;

const LIGHT: Vec3 = Vec3::new(-3.0, -2.0, 4.0);

/// Parsing a scene of a thousand objects.
pub(crate) fn parsing(criterion: &mut Criterion, rows: &mut Vec<Row>) {
    let object = "{\n  translate 1 2 3\n  rotate 30 0 0 1\n  cr .5 .5 .5\n  ball 1 0 0 0\n}\n";
    let camera = "eyepos 0 -5 0\neyedir 0 1 0\neyeup 0 0 1\nwdist 1\nfovy_deg 40\nnx 9\nny 9\n";
    let scene = format!("sce1.0\n{camera}{}end\n", object.repeat(1000));
    let lines = scene.lines().count() as u64;
    let options = ParseOptions::default();
    let parsed = parse(&scene, &options).expect("the scene is valid");
    assert_eq!(parsed.description.objects.len(), 1000);
    let mut group = criterion.benchmark_group("parse");
    group.throughput(Throughput::Elements(lines));
    group.bench_function("scene", |b| b.iter(|| parse(black_box(&scene), &options)));
    group.finish();
    rows.push(Row::new("parse", "scene", None, lines, "lines"));
}

/// Building every structure over a torus knot, and tracing rays of each class.
pub(crate) fn mesh(criterion: &mut Criterion, triangles: u32, rows: &mut Vec<Row>) {
    let scene = knot(triangles);
    let count = scene.triangle_count();
    building(criterion, &scene, triangles, count, rows);
    let bvh = structure_named("bvh").expect("bvh is a structure");
    let bvh = bvh.build(&scene, &BuildConfig::default());
    let sets = ray_sets(&scene, &*bvh, LIGHT, RAYS);
    for structure in STRUCTURES {
        let world = structure.build(&scene, &BuildConfig::default());
        let linear = matches!(structure.name, "none" | "ball");
        let limit = if linear { LINEAR_TESTS / count as usize } else { RAYS as usize };
        for set in &sets {
            let rays = spread(&set.rays, limit.max(16));
            check(&scene, &*world, set, &rays);
            let group = format!("{}-{triangles}", set.class);
            tracing(criterion, &group, structure.name, &*world, set.is_shadow(), &rays);
            let row = Row::new(&group, structure.name, Some(count), rays.len() as u64, "rays");
            rows.push(row);
        }
    }
}

fn building(
    criterion: &mut Criterion,
    scene: &Scene,
    triangles: u32,
    count: u64,
    rows: &mut Vec<Row>,
) {
    let name = format!("build-{triangles}");
    let mut group = criterion.benchmark_group(&name);
    group.sample_size(10).throughput(Throughput::Elements(count));
    group.warm_up_time(Duration::from_millis(500)).measurement_time(Duration::from_secs(3));
    for structure in STRUCTURES {
        let config = BuildConfig::default();
        group.bench_function(structure.name, |b| b.iter(|| structure.build(scene, &config)));
        rows.push(Row::new(&name, structure.name, Some(count), count, "triangles"));
    }
    group.finish();
}

fn tracing(
    criterion: &mut Criterion,
    name: &str,
    structure: &str,
    tracer: &dyn Tracer,
    shadow: bool,
    rays: &[Ray],
) {
    let mut group = criterion.benchmark_group(name);
    group.sample_size(10).throughput(Throughput::Elements(rays.len() as u64));
    group.warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(1));
    let mut hits = vec![Hit::MISS; rays.len()];
    let mut blocked = vec![false; rays.len()];
    let closest = |b: &mut Bencher<'_>| b.iter(|| tracer.intersect(rays, &mut hits, None));
    let any = |b: &mut Bencher<'_>| b.iter(|| tracer.occluded(rays, &mut blocked, None));
    let id = BenchmarkId::from_parameter(structure);
    if shadow {
        group.bench_function(id, any)
    } else {
        group.bench_function(id, closest)
    };
    group.finish();
}

/// Compares the answers with those of `none` on as many rays as that can trace.
fn check(scene: &Scene, world: &dyn Tracer, set: &RaySet, rays: &[Ray]) {
    let none = structure_named("none").expect("none is a structure");
    let none = none.build(scene, &BuildConfig::default());
    let rays = spread(rays, (LINEAR_TESTS / scene.triangle_count() as usize).max(16));
    let answers = |tracer: &dyn Tracer| {
        let (mut hits, mut blocked) = (vec![Hit::MISS; rays.len()], vec![false; rays.len()]);
        tracer.intersect(&rays, &mut hits, None);
        tracer.occluded(&rays, &mut blocked, None);
        (hits, blocked)
    };
    let (expected, got) = (answers(&*none), answers(world));
    let equal = expected.0.iter().zip(&got.0).all(|(a, b)| a.same_bits(b)) && expected.1 == got.1;
    assert!(equal, "{} rays: the hits differ from those of `none`", set.class);
}

/// At most `count` rays, evenly chosen.
fn spread(rays: &[Ray], count: usize) -> Vec<Ray> {
    rays.iter().step_by(rays.len().div_ceil(count)).copied().collect()
}

/// A torus knot seen from the front.
fn knot(triangles: u32) -> Scene {
    let description = SceneDescription {
        camera: Camera {
            eye: DVec3::new(0.3, -3.2, 1.4),
            direction: DVec3::new(-0.3, 3.2, -1.4),
            up: DVec3::Z,
            distance: 1.0,
            fovy_degrees: 38.0,
            width: 200,
            height: 200,
        },
        options: Options { max_recursion: 0, aa: 0, background: Color::ZERO },
        materials: vec![Material::default()],
        meshes: vec![MeshReference { name: "knot".into(), span: 0..0 }],
        objects: vec![Object {
            shape: Shape::Mesh { mesh: 0, normals: Normals::Flat },
            transform: DAffine3::IDENTITY,
            material: 0,
            span: 0..0,
        }],
        lights: vec![],
    };
    let mesh = Arc::new(generate(Kind::TorusKnot, triangles, 1));
    Scene::new(&description, vec![mesh]).expect("the scene can be traced")
}
