//! Embree agrees with the structures on nearly all rays, and names what it cannot trace. Version 3 must be
//! installed; version 4 is tested where it is, too.

#![allow(clippy::unwrap_used, reason = "a panic is a failed test")]

mod common;

use glam::Vec3;
use srt::accel::{Answers, BuildConfig, Scratch, Tracer};
use srt::compare::{Plan, SceneInput, Silent, run};
use srt::math::{Hit, Random, Ray};
use srt::record::Status;
use srt::scene::{PEERS, Scene, Structure, structure_named};

/// The share of the rays that may be answered otherwise.
const LARGEST_SHARE: f64 = 1e-4;

const VIEW: &str = "eyepos 0.3 -2.5 1.1\neyedir -0.3 2.5 -1\neyeup 0 0 1\nwdist 1\nfovy_deg 50\n\
                    nx 200\nny 200\n";

fn scene(objects: &str) -> Scene {
    common::scene(&format!("{VIEW}{objects}\nend\n"))
}

/// View rays of all pixels, and random ones through the scene's box; their number is no multiple of
/// sixteen.
fn rays(scene: &Scene) -> Vec<Ray> {
    let pixels = (0..200).flat_map(|y| (0..200).map(move |x| (f64::from(x), f64::from(y))));
    let view = pixels.map(|(x, y)| scene.camera.ray(x, y));
    let bounds = scene.bounds();
    let mut random = Random::new(&[7]);
    let mut point = || Vec3::from_array(std::array::from_fn(|_| random.next_f32()));
    let mut through = || {
        let origin = Vec3::from(bounds.min) + point() * Vec3::from(bounds.size());
        Ray::new(origin, 2.0 * point() - 1.0)
    };
    view.chain((0..40_003).map(|_| through())).collect()
}

fn answers(tracer: &dyn Tracer, rays: &[Ray]) -> (Vec<Hit>, Vec<bool>) {
    let (mut hits, mut blocked) = (vec![Hit::MISS; rays.len()], vec![false; rays.len()]);
    tracer.trace(rays, Answers::ClosestHit(&mut hits), &mut Scratch::default(), None);
    tracer.trace(rays, Answers::AnyHit(&mut blocked), &mut Scratch::default(), None);
    (hits, blocked)
}

/// The peers whose library is installed.
fn peers() -> impl Iterator<Item = &'static Structure> {
    let own = PEERS.iter().filter(|peer| peer.name.starts_with("embree"));
    let (three, four): (Vec<_>, Vec<_>) = own.partition(|peer| !peer.name.starts_with("embree4"));
    let is_there = |peer: &&Structure| match peer.try_build(&scene(""), &BuildConfig::default()) {
        Ok(_) => true,
        Err(error) => {
            let text = error.to_string();
            assert!(text.contains("Embree 4 is not installed"), "{text}");
            false
        }
    };
    three.into_iter().chain(four.into_iter().filter(is_there))
}

/// Holds all ways of tracing against `bvh`.
fn assert_agreement(scene: &Scene) {
    let rays = rays(scene);
    let build = |name| structure_named(name).unwrap().build(scene, &BuildConfig::default());
    let (hits, blocked) = answers(&*build("bvh"), &rays);
    let found = hits.iter().filter(|hit| hit.is_hit()).count();
    assert!(10 * found > rays.len(), "{found} hits say nothing");
    for name in peers().map(|peer| peer.name) {
        let own = answers(&*build(name), &rays);
        let hits = hits.iter().zip(&own.0).filter(|(a, b)| !a.agrees(b)).count();
        let blocked = blocked.iter().zip(&own.1).filter(|(a, b)| a != b).count();
        let allowed = LARGEST_SHARE * rays.len() as f64;
        assert!((hits.max(blocked) as f64) <= allowed, "{name}: {hits} and {blocked} disagree");
    }
}

#[test]
fn hits_agree_on_generated_meshes() {
    for mesh in ["icosphere:20000", "hall:20000", "terrain:20000"] {
        assert_agreement(&scene(&format!("object_flat generate:{mesh}")));
    }
}

#[test]
fn hits_agree_on_transformed_meshes_and_single_triangles() {
    assert_agreement(&scene(
        "triangle -3 -3 -1  3 -3 -1  0 3 -1\n\
         {\ntranslate 0.2 0.3 0\nrotate 40 1 2 3\nscale 0.5 0.7 0.3\nobject_flat generate:icosphere:5000\n}\n\
         object_flat generate:terrain:5000\n\
         {\ntranslate -0.6 0 0.5\nobject_flat generate:icosphere:5000\n}",
    ));
}

#[test]
fn an_empty_scene_has_no_hits() {
    let scene = scene("");
    let rays = [Ray::new(Vec3::ZERO, Vec3::X); 17];
    for peer in peers() {
        let world = peer.build(&scene, &BuildConfig::default());
        let (hits, blocked) = answers(&*world, &rays);
        assert!(hits.iter().all(|hit| !hit.is_hit()) && !blocked.contains(&true));
    }
}

#[test]
fn memory_grows_with_the_scene() {
    let embree = structure_named("embree").unwrap();
    let report = |objects: &str| {
        let world = embree.build(&scene(objects), &BuildConfig::default());
        world.build_report()
    };
    let (small, large) =
        (report("object_flat generate:terrain:5000"), report("object_flat generate:terrain:50000"));
    assert!(small.meshes.bytes > 5_000 * 36 && large.meshes.bytes > 5 * small.meshes.bytes);
    assert!(large.triangle_bytes > 5 * small.triangle_bytes);
    assert!(large.triangles.abs_diff(50_000) < 1_500);
}

#[test]
fn what_it_does_not_know_is_refused_by_name() {
    for (object, form) in [("ball 1 0 0 0", "a ball"), ("cylinder", "a cylinder")] {
        let scene = scene(&format!("triangle 0 0 0  1 0 0  0 1 0\n{object}"));
        for peer in peers() {
            let error = peer.try_build(&scene, &BuildConfig::default()).err().unwrap();
            let text = error.to_string();
            assert!(text.starts_with(&format!("object 1 is {form}: ")), "{text}");
        }
    }
}

/// A comparison of all peers with two structures.
fn compared(scene: Scene) -> srt::compare::ComparisonResult {
    let input = SceneInput { name: "a".into(), path: "a.sce".into(), hash: "0".into(), scene };
    let mut plan = Plan::of_scenes(vec![input]);
    plan.budget = Some(std::time::Duration::from_secs(4));
    plan.rays_per_class = 2_000;
    let named = |name| *structure_named(name).unwrap();
    run(&plan, &["embree", "bvh", "cwbvh", "embree16"].map(named), &Silent).unwrap()
}

#[test]
fn a_comparison_tells_how_many_rays_agree_and_claims_no_equality() {
    let outcome = compared(scene("object_flat generate:terrain:5000"));
    assert!(outcome.holds());
    let scene = &outcome.comparison.scenes[0];
    let proof = scene.proof.as_ref().unwrap();
    assert_eq!(proof.structures.len(), 2);
    assert!(["bvh", "cwbvh"].contains(&proof.reference.as_str()));
    for name in ["embree", "embree16"] {
        let entry = proof.peer(name).unwrap();
        assert!(proof.structure(name).is_none());
        assert!(entry.rays_checked > 100 && entry.share().unwrap() >= 0.9999, "{entry:?}");
        let row = scene.structure(name).unwrap();
        assert!(row.peer && row.status == Status::Ok);
        assert!(row.shape.is_none() && row.heatmap.is_none() && row.memory.is_some());
        assert!(!row.classes.is_empty() && !row.picture_rounds.is_empty());
        assert!(row.classes.iter().all(|class| class.boxes.is_none()));
        assert!(row.classes.iter().all(|class| class.primitives.is_none()));
    }
    let text = srt::report::Report::new(&outcome.comparison).terminal();
    assert!(text.contains("as shipped: "), "{text}");
}

#[test]
fn a_scene_that_it_does_not_know_is_a_row_that_says_so() {
    let outcome = compared(scene("ball 1 0 0 0"));
    assert!(outcome.holds(), "the structures did their work");
    let scene = &outcome.comparison.scenes[0];
    let status = &scene.structure("embree").unwrap().status;
    assert!(matches!(status, Status::Failed { message } if message.contains("is a ball")));
    assert_eq!(scene.structure("bvh").unwrap().status, Status::Ok);
}

#[test]
fn a_library_that_is_not_there_is_an_error_that_says_how_to_name_it() {
    let folder = tempfile::tempdir().unwrap();
    let (scene, picture) = (folder.path().join("a.sce"), folder.path().join("a.png"));
    std::fs::write(&scene, format!("sce1.0\n{VIEW}triangle 0 0 0  1 0 0  0 1 0\nend\n")).unwrap();
    for (name, variable) in [("embree", "SRT_EMBREE3"), ("embree4x16", "SRT_EMBREE4")] {
        let mut command = assert_cmd::Command::new(env!("CARGO_BIN_EXE_srt"));
        command.args(["--accel", name]).args([&scene, &picture]).env(variable, "/no/embree.so");
        let output = command.output().unwrap();
        let text = String::from_utf8_lossy(&output.stderr);
        assert!(!output.status.success() && !picture.exists());
        assert!(text.contains("is not installed") && text.contains(variable), "{text}");
        assert!(text.contains("/no/embree.so"), "{text}");
    }
}

#[test]
fn the_list_of_structures_names_the_library_that_is_found_or_how_to_name_one() {
    let listed = |variable: Option<&str>| {
        let mut command = assert_cmd::Command::new(env!("CARGO_BIN_EXE_srt"));
        command.arg("accels").envs(variable.map(|variable| (variable, "/no/embree.so")));
        String::from_utf8(command.output().unwrap().stdout).unwrap()
    };
    // The line below the manner.
    let of = |text: &str, name: &str| {
        let line = text.lines().position(|line| line.split(' ').next() == Some(name)).unwrap();
        text.lines().nth(line + 2).unwrap().trim().to_owned()
    };
    let text = listed(None);
    for name in ["embree", "embree16"] {
        assert!(of(&text, name).starts_with("found: Embree 3."), "{text}");
    }
    for (names, variable) in
        [(["embree", "embree16"], "SRT_EMBREE3"), (["embree4", "embree4x16"], "SRT_EMBREE4")]
    {
        let text = listed(Some(variable));
        for name in names {
            let line = of(&text, name);
            assert!(line.starts_with("not found: ") && line.contains("is not installed"), "{line}");
            assert!(line.contains(variable) && line.contains("/no/embree.so"), "{line}");
        }
    }
}
