//! tinybvh agrees with the structures on nearly all rays, builds as it was told, and refuses what would be beyond its
//! stacks. Where the processor has no AVX2, it says so, and nothing else is tested.

#![allow(clippy::unwrap_used, reason = "a panic is a failed test")]

mod common;

use common::peers;
use glam::Vec3;
use srt::accel::BuildConfig;
use srt::math::{Hit, Ray};
use srt::scene::{Structure, structure_named};
use srt::tinybvh::{Builder, Quality, TinyBvhError};

const QUALITIES: [Quality; 2] = [Quality::Default, Quality::High];

/// As it is built without options, and with each; none where the processor is another.
fn all() -> Vec<Structure> {
    if let Err(error) = Builder::new() {
        assert_eq!(error, TinyBvhError::Processor);
        return vec![];
    }
    let tinybvh = *structure_named("tinybvh").unwrap();
    let with = |options| tinybvh.with_options(options).unwrap();
    vec![tinybvh, with("quality=default"), with("quality=hq")]
}

fn can_build() -> bool {
    !all().is_empty()
}

/// A square of `n × n` fields, each of two triangles, on the plane of x and y.
fn square(n: u32) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let corner = |i: u32| Vec3::new((i % (n + 1)) as f32, (i / (n + 1)) as f32, 0.0);
    let positions = (0..(n + 1) * (n + 1)).map(corner).collect();
    let field = |i: u32| {
        let first = i / n * (n + 1) + i % n;
        [[first, first + 1, first + n + 2], [first, first + n + 2, first + n + 1]]
    };
    (positions, (0..n * n).flat_map(field).collect())
}

#[test]
fn hits_agree_on_generated_meshes() {
    peers::assert_hits_agree_on_meshes(
        &all(),
        &["icosphere:20000", "terrain:60000", "hall:20000", "scan:20000"],
    );
}

#[test]
fn hits_agree_on_transformed_meshes_and_single_triangles() {
    peers::assert_hits_agree_on_transformed_meshes_and_single_triangles(&all());
}

#[test]
fn an_empty_scene_and_a_single_triangle_are_scenes() {
    peers::assert_an_empty_scene_and_a_single_triangle_are_scenes(&all());
}

#[test]
fn memory_grows_with_the_scene() {
    for peer in all() {
        let [[small, _], [large, _]] = peers::bytes(&peer);
        // A leaf of four triangles takes 192 bytes.
        assert!(small > 5_000 * 48 && large > 5 * small, "{}: {small} {large}", peer.name);
    }
}

#[test]
fn they_are_compared_as_peers() {
    if can_build() {
        peers::assert_compared_as_peers(&all());
    }
}

#[test]
fn builders_and_threads_are_those_that_were_asked_for() {
    if !can_build() {
        return;
    }
    for (quality, n, threads) in
        QUALITIES.into_iter().flat_map(|q| [(q, 100, 2), (q, 160, 1), (q, 160, 2), (q, 160, 64)])
    {
        let (positions, triangles) = square(n);
        let mut builder = Builder::new().unwrap();
        builder.add(&positions, &triangles);
        let built = builder.build(quality, threads).unwrap();
        assert_eq!(built.quality(), Some(quality));
        let several = threads > 1 && triangles.len() >= 50_000 && cfg!(target_os = "linux");
        assert_eq!(built.was_built_on_threads(), several, "{quality:?} {n} {threads}");
    }
}

#[test]
fn builds_on_several_threads_end_and_leave_no_thread() {
    if !can_build() || !cfg!(target_os = "linux") {
        return;
    }
    let threads = || std::fs::read_dir("/proc/self/task").unwrap().count();
    let (positions, triangles) = square(160);
    for quality in QUALITIES {
        for _ in 0..20 {
            let mut builder = Builder::new().unwrap();
            builder.add(&positions, &triangles);
            builder.build(quality, 2).unwrap();
        }
    }
    // Other tests have a few pools at the same time; these had eighty.
    let processors = std::thread::available_parallelism().unwrap().get();
    assert!(threads() < 20 * (processors + 1), "{}", threads());
}

/// Rays of any length, along axes and with components that are zero, from before a triangle and from behind it.
#[test]
fn parameters_are_in_units_of_the_direction() {
    if !can_build() {
        return;
    }
    let mut builder = Builder::new().unwrap();
    let (positions, triangles) = square(1);
    // Objects without triangles have ids, too.
    builder.add(&[], &[]);
    builder.add(&positions, &triangles);
    builder.add(&[], &[]);
    let scene = builder.build(Quality::High, 1).unwrap();
    let from = Vec3::new(0.75, 0.25, 3.0);
    for length in [1e-18, 1e-9, 1.0, 3.0, 1e12, 1e25] {
        let down = |t_min: f32, t_max: f32| {
            Ray::with_interval(from, Vec3::NEG_Z * length, t_min / length, t_max / length)
        };
        let diagonal = Ray::new(from - Vec3::splat(3.0), Vec3::ONE * length);
        let rays = [down(0.0, 9.0), down(2.5, 9.0), down(3.5, 9.0), down(0.0, 2.5), diagonal];
        let (mut hits, mut blocked) = ([Hit::MISS; 5], [false; 5]);
        scene.intersect(&rays, &mut hits);
        scene.occluded(&rays, &mut blocked);
        for (hit, expected) in hits.iter().zip([true, true, false, false, false]) {
            assert_eq!(hit.is_hit(), expected, "{length} {hits:?}");
            if expected {
                assert!((hit.t * length - 3.0).abs() < 1e-5, "{length}: {}", hit.t);
                assert_eq!((hit.object, hit.prim), (1, 0));
                assert!((hit.u - 0.5).abs() < 1e-6 && (hit.v - 0.25).abs() < 1e-6, "{hit:?}");
            }
        }
        assert_eq!(blocked, [true, true, false, false, false], "{length}");
    }
    // What is no ray of a length, or comes from beyond all scenes, hits nothing: tinybvh would end the process.
    let none = [
        Ray::new(from, Vec3::ZERO),
        Ray::new(Vec3::NAN, Vec3::X),
        Ray::new(from, Vec3::NAN),
        Ray::new(from, Vec3::INFINITY),
        Ray { t_max: f32::NAN, ..Ray::new(from, Vec3::NEG_Z) },
        Ray::new(Vec3::new(1e30, 1e30, -1e29), Vec3::Z),
        Ray::new(Vec3::new(1e10, 1e10, 3.0), Vec3::Z),
    ];
    let mut hits = [Hit { object: 0, ..Hit::MISS }; 7];
    let mut blocked = [true; 7];
    scene.intersect(&none, &mut hits);
    scene.occluded(&none, &mut blocked);
    assert!(hits.iter().all(|hit| !hit.is_hit()) && !blocked.contains(&true));
}

/// Triangles in one place cannot be separated: its leaves become a chain that its search has no stack for.
#[test]
fn a_tree_beyond_its_stacks_is_refused() {
    if !can_build() {
        return;
    }
    let corners = [Vec3::ZERO, Vec3::X, Vec3::Y];
    for quality in QUALITIES {
        let build = |count: usize| {
            let mut builder = Builder::new().unwrap();
            builder.add(&corners, &vec![[0, 1, 2]; count]);
            builder.build(quality, 1)
        };
        let few = build(100).unwrap();
        let mut hits = [Hit::MISS];
        few.intersect(&[Ray::new(Vec3::new(0.2, 0.2, 1.0), Vec3::NEG_Z)], &mut hits);
        assert!((hits[0].t - 1.0).abs() < 1e-6, "{hits:?}");
        let error = build(100_000).err().unwrap();
        assert_eq!(error, TinyBvhError::Deep { triangles: 100_000 });
        assert!(error.to_string().contains("100000 triangles is too deep"), "{error}");
    }
}

#[test]
fn its_name_has_the_version_that_was_compiled() {
    if !cfg!(target_arch = "x86_64") {
        return;
    }
    let summary = structure_named("tinybvh").unwrap().summary;
    let digits = summary.split(' ').nth(1).unwrap().trim_end_matches("'s");
    let numbers = digits.split('.').map(|number| number.parse::<u32>().unwrap());
    assert_eq!(numbers.count(), 3, "{summary}");
}

#[test]
fn an_option_that_it_does_not_have_is_refused() {
    let tinybvh = structure_named("tinybvh").unwrap();
    let error = tinybvh.with_options("quality=best").unwrap_err().to_string();
    assert!(
        error.contains("`best`") && error.contains("default") && error.contains("hq"),
        "{error}"
    );
    let config = BuildConfig::default();
    let balls = tinybvh.try_build(&peers::scene("ball 1 0 0 0"), &config).err().unwrap();
    assert!(balls.to_string().contains("is a ball"), "{balls}");
}
