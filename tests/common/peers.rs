//! What is asked of every library that is a peer: it agrees with srt's structures on nearly all rays, has the ids of
//! the scene, and names what it cannot trace.
#![allow(
    dead_code,
    clippy::unwrap_used,
    reason = "each test uses its part of this; a panic is a failed test"
)]

use glam::Vec3;
use srt::accel::{Answers, BuildConfig, Scratch, Tracer};
use srt::compare::{Plan, SceneInput, Silent, run};
use srt::math::{Hit, Random, Ray};
use srt::record::Status;
use srt::scene::{Scene, Structure, structure_named};

/// The share of the rays that may be answered otherwise.
const LARGEST_SHARE: f64 = 1e-4;

const VIEW: &str = "eyepos 0.3 -2.5 1.1\neyedir -0.3 2.5 -1\neyeup 0 0 1\nwdist 1\nfovy_deg 50\n\
                    nx 200\nny 200\n";

/// Two meshes in the world and a third that is transformed, between single triangles.
const OBJECTS: &str = "triangle -3 -3 -1  3 -3 -1  0 3 -1\n\
    {\ntranslate 0.2 0.3 0\nrotate 40 1 2 3\nscale 0.5 0.7 0.3\nobject_flat generate:icosphere:5000\n}\n\
    object_flat generate:terrain:5000\n\
    triangle -3 3 2  3 3 2  0 3 -2\n\
    {\ntranslate -0.6 0 0.5\nobject_flat generate:icosphere:5000\n}";

/// A scene of objects, looked at from where most of the libraries' meshes are in view.
pub(crate) fn scene(objects: &str) -> Scene {
    super::scene(&format!("{VIEW}{objects}\nend\n"))
}

/// View rays of all pixels, random ones through the scene's box, and parts of these that begin and end within it.
pub(crate) fn rays(scene: &Scene) -> Vec<Ray> {
    let pixels = (0..200).flat_map(|y| (0..200).map(move |x| (f64::from(x), f64::from(y))));
    let view = pixels.map(|(x, y)| scene.camera.ray(x, y));
    let bounds = scene.bounds();
    let mut random = Random::new(&[7]);
    let mut point = || Vec3::from_array(std::array::from_fn(|_| random.next_f32()));
    let through = |n: u32| {
        let origin = Vec3::from(bounds.min) + point() * Vec3::from(bounds.size());
        let dir = 2.0 * point() - 1.0;
        match n % 4 {
            0 => Ray::new(origin, dir),
            2 => Ray::with_interval(origin, dir, 0.0, f32::INFINITY),
            _ => Ray::with_interval(origin, dir, 0.1, 0.8),
        }
    };
    view.chain((0..40_003).map(through)).collect()
}

/// The closest hits of rays, and which of the rays are blocked.
pub(crate) fn answers(tracer: &dyn Tracer, rays: &[Ray]) -> (Vec<Hit>, Vec<bool>) {
    let (mut hits, mut blocked) = (vec![Hit::MISS; rays.len()], vec![false; rays.len()]);
    tracer.trace(rays, Answers::ClosestHit(&mut hits), &mut Scratch::default(), None);
    tracer.trace(rays, Answers::AnyHit(&mut blocked), &mut Scratch::default(), None);
    (hits, blocked)
}

/// Holds all libraries against `bvh`: hits and ids, and the weights where the triangle is the same.
fn assert_agreement(peers: &[Structure], scene: &Scene) {
    let rays = rays(scene);
    let build = |structure: &Structure| structure.build(scene, &BuildConfig::default());
    let (hits, blocked) = answers(&*build(structure_named("bvh").unwrap()), &rays);
    let found = hits.iter().filter(|hit| hit.is_hit()).count();
    assert!(10 * found > rays.len(), "{found} hits say nothing");
    for peer in peers {
        let (own, name) = (answers(&*build(peer), &rays), peer.name);
        let pairs = || hits.iter().zip(&own.0);
        let differ = pairs().filter(|(a, b)| !a.agrees(b)).count();
        let blocked = blocked.iter().zip(&own.1).filter(|(a, b)| a != b).count();
        let allowed = LARGEST_SHARE * rays.len() as f64;
        assert!((differ.max(blocked) as f64) <= allowed, "{name}: {differ} and {blocked} disagree");
        let same = |(a, b): &(&Hit, &Hit)| a.is_hit() && (a.object, a.prim) == (b.object, b.prim);
        let same: Vec<(&Hit, &Hit)> = pairs().filter(same).collect();
        assert!(same.len() as f64 > 0.999 * found as f64, "{name}: {} of {found}", same.len());
        let off = |(a, b): &&(&Hit, &Hit)| (a.u - b.u).abs().max((a.v - b.v).abs()) > 0.01;
        let off = same.iter().filter(off).count();
        assert!(off as f64 <= 0.001 * found as f64, "{name}: {off} weights are others");
    }
}

pub(crate) fn assert_hits_agree_on_meshes(peers: &[Structure], meshes: &[&str]) {
    for mesh in meshes {
        assert_agreement(peers, &scene(&format!("object_flat generate:{mesh}")));
    }
}

pub(crate) fn assert_hits_agree_on_transformed_meshes_and_single_triangles(peers: &[Structure]) {
    assert_agreement(peers, &scene(OBJECTS));
}

pub(crate) fn assert_an_empty_scene_and_a_single_triangle_are_scenes(peers: &[Structure]) {
    let rays = [Ray::new(Vec3::new(0.2, -1.0, 0.2), Vec3::Y); 17];
    for (objects, hit) in [("", false), ("triangle 0 0 0  1 0 0  0 0 1", true)] {
        let scene = scene(objects);
        for peer in peers {
            let name = peer.name;
            let (hits, blocked) = answers(&*peer.build(&scene, &BuildConfig::default()), &rays);
            assert!(hits.iter().all(|own| own.is_hit() == hit), "{name}: {:?}", hits[0]);
            assert!(blocked.iter().all(|&own| own == hit), "{name}");
        }
    }
}

/// Bytes of the index and of the triangles beside it, of 5,000 triangles and of 50,000.
pub(crate) fn bytes(peer: &Structure) -> [[u64; 2]; 2] {
    ["object_flat generate:terrain:5000", "object_flat generate:terrain:50000"].map(|objects| {
        let report = peer.build(&scene(objects), &BuildConfig::default()).build_report();
        [report.meshes.bytes, report.triangle_bytes]
    })
}

pub(crate) fn assert_compared_as_peers(peers: &[Structure]) {
    let input = |name: &str, scene| SceneInput {
        name: name.into(),
        path: format!("{name}.sce"),
        hash: "0".into(),
        scene,
    };
    let balls = input("balls", scene("ball 1 0 0 0\ntriangle 0 0 0  1 0 0  0 1 0"));
    let mut plan =
        Plan::of_scenes(vec![input("terrain", scene("object_flat generate:terrain:5000")), balls]);
    plan.budget = Some(std::time::Duration::from_secs(8));
    plan.rays_per_class = 2_000;
    let structures: Vec<_> =
        [structure_named("bvh").unwrap()].into_iter().chain(peers).copied().collect();
    let outcome = run(&plan, &structures, &Silent).unwrap();
    assert!(outcome.holds(), "a scene that a peer cannot trace is no failure");
    for name in peers.iter().map(|peer| peer.name) {
        let [terrain, balls] = &outcome.comparison.scenes[..] else { panic!("two scenes") };
        let entry = terrain.proof.as_ref().unwrap().peer(name).unwrap();
        assert!(entry.rays_checked > 100 && entry.share().unwrap() >= 0.9999, "{name}: {entry:?}");
        let row = terrain.structure(name).unwrap();
        assert!(row.peer && row.status == Status::Ok && !row.classes.is_empty(), "{name}");
        let refused = &balls.structure(name).unwrap().status;
        let reason = matches!(refused, Status::Failed { message } if message.contains("is a ball"));
        assert!(reason, "{name}: {refused:?}");
    }
}
