//! A library from outside the crate, brought in by a small file: its rays agree with those of the
//! structures, it is compared as a peer, and what it cannot trace is refused by name.

#![allow(clippy::unwrap_used, reason = "a panic is a failed test")]

#[path = "../examples/brute_force/mod.rs"]
mod brute_force;
mod common;

use std::time::Duration;

use srt::accel::{Answers, BuildConfig, Scratch};
use srt::compare::{ComparisonResult, Plan, SceneInput, Silent, run};
use srt::math::Hit;
use srt::record::Status;
use srt::scene::{ForeignBuild, ForeignTracer, Scene, Structure, TriangleObject, structure_named};

use brute_force::BruteForce;

const VIEW: &str = "eyepos 0.3 -2.5 1.1\neyedir -0.3 2.5 -1\neyeup 0 0 1\nwdist 1\nfovy_deg 50\n\
                    nx 60\nny 60\n";

/// Two transformed instances of a mesh, a mesh in the world, a triangle.
const OBJECTS: &str = "triangle -3 -3 -1  3 -3 -1  0 3 -1\n\
    {\ntranslate 0.4 0.3 0\nrotate 40 1 2 3\nscale 0.5 0.7 0.3\nobject_flat generate:icosphere:300\n}\n\
    {\ntranslate -0.6 0 0.5\nscale 0.3 0.3 0.3\nobject_flat generate:icosphere:300\n}\n\
    object_flat generate:terrain:300\n";

const BRUTE: Structure = Structure::foreign::<BruteForce>("brute", "a list, tested in doubles");

fn scene(objects: &str) -> Scene {
    common::scene(&format!("{VIEW}{objects}pointlight 0 -2 4 1 1 1\nend\n"))
}

fn compared(scene: Scene, others: &[Structure]) -> ComparisonResult {
    let input = SceneInput { name: "a".into(), path: "a.sce".into(), hash: "0".into(), scene };
    let mut plan = Plan::of_scenes(vec![input]);
    plan.budget = Some(Duration::from_secs(4));
    plan.rays_per_class = 2_000;
    let bvh = *structure_named("bvh").unwrap();
    run(&plan, &[&[bvh], others].concat(), &Silent).unwrap()
}

#[test]
fn objects_and_triangles_have_the_ids_of_the_scene() {
    let scene = scene(OBJECTS);
    let rays: Vec<_> =
        (0..3_600).map(|i| scene.camera.ray(f64::from(i % 60), f64::from(i / 60))).collect();
    let hits = |structure: &Structure| {
        let mut hits = vec![Hit::MISS; rays.len()];
        let world = structure.build(&scene, &BuildConfig::default());
        world.trace(&rays, Answers::ClosestHit(&mut hits), &mut Scratch::default(), None);
        hits
    };
    let (own, foreign) = (hits(structure_named("bvh").unwrap()), hits(&BRUTE));
    for object in 0..4 {
        assert!(own.iter().any(|hit| hit.object == object), "object {object} is seen");
    }
    let ids = |hit: &Hit| (hit.object, hit.prim);
    let equal = own.iter().zip(&foreign).filter(|(a, b)| ids(a) == ids(b)).count();
    assert!(1000 * equal >= 995 * rays.len(), "{equal} of {} have the same ids", rays.len());
}

#[test]
fn it_is_compared_as_a_peer() {
    let outcome = compared(scene(OBJECTS), &[BRUTE]);
    assert!(outcome.holds());
    let scene = &outcome.comparison.scenes[0];
    let row = scene.structure("brute").unwrap();
    assert!(row.status == Status::Ok && row.shape.is_none(), "{:?}", row.status);
    assert!(!row.classes.is_empty() && row.memory.is_some());
    assert!(scene.proof.as_ref().unwrap().structure("brute").is_none(), "it claims no equality");
}

/// A library that hits nothing, or that cannot build.
struct Useless<const BUILDS: bool>;

impl<const BUILDS: bool> ForeignTracer for Useless<BUILDS> {
    fn build<'a>(
        _: impl ExactSizeIterator<Item = TriangleObject<'a>>,
        build: &ForeignBuild<'_>,
    ) -> Result<Self, Box<dyn std::error::Error + Send + Sync>> {
        if BUILDS { Ok(Self) } else { Err(format!("no licence for {} threads", build.threads))? }
    }

    fn trace(&self, _: &[srt::math::Ray], answers: Answers<'_>) {
        match answers {
            Answers::ClosestHit(hits) => hits.fill(Hit::MISS),
            Answers::AnyHit(blocked) => blocked.fill(false),
        }
    }
}

#[test]
fn one_whose_hits_are_others_takes_no_part() {
    let useless = Structure::foreign::<Useless<true>>("useless", "hits nothing");
    let outcome = compared(scene(OBJECTS), &[useless]);
    let Status::Failed { message } =
        &outcome.comparison.scenes[0].structure("useless").unwrap().status
    else {
        panic!("it is timed");
    };
    assert!(message.starts_with("only ") && message.ends_with("of its results agree"), "{message}");
}

#[test]
fn what_it_cannot_do_is_an_error_in_plain_words() {
    let failure = |structure: &Structure, objects: &str| {
        structure.try_build(&scene(objects), &BuildConfig::default()).err().unwrap().to_string()
    };
    for (object, form) in [("ball 1 0 0 0\n", "a ball"), ("cylinder\n", "a cylinder")] {
        let text = failure(&BRUTE, &format!("triangle 0 0 0  1 0 0  0 1 0\n{object}"));
        assert!(text.starts_with(&format!("object 1 is {form}: ")), "{text}");
    }
    let broken = Structure::foreign::<Useless<false>>("broken", "does not build");
    assert!(failure(&broken, OBJECTS).starts_with("no licence for "));
}

#[test]
fn an_empty_scene_has_no_hits() {
    let world = BRUTE.build(&scene(""), &BuildConfig::default());
    let rays = [srt::math::Ray::new(glam::Vec3::ZERO, glam::Vec3::X); 3];
    let mut hits = [Hit { t: 1.0, ..Hit::MISS }; 3];
    world.trace(&rays, Answers::ClosestHit(&mut hits), &mut Scratch::default(), None);
    assert!(hits.iter().all(|hit| !hit.is_hit()));
}
