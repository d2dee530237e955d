//! Comparisons through the library: what is wrong is found and named, and all structures get the same
//! rays.

#![allow(clippy::unwrap_used, reason = "a panic is a failed test")]

mod broken;
mod conformance;
#[path = "../../examples/kd_tree/mod.rs"]
mod kd_tree;
mod same_rays;
mod sampling;
mod slow;

use std::ops::{ControlFlow, Range};
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use broken::{Panicking, Shrunken};
use slow::Forgetful;
use srt::accel::{Accel, Bounded, Build, Built, Bvh};
use srt::assets::generate::MeshKind;
use srt::compare::{ComparisonResult, Family, Observer, Plan, SceneInput, Silent, SweepPlan, run};
use srt::counters::Counters;
use srt::math::{BoxRay, Ray};
use srt::record::{RayClass, RoundRule, Status};
use srt::scene::{STRUCTURES, Scene, Structure, structure_named};
use srt::scene_file::{ParseOptions, parse};

const SCENE: &str = "sce1.0
eyepos 0 -6 2.5
eyedir 0 1 -0.35
eyeup 0 0 1
wdist 1
fovy_deg 45
nx 24
ny 18
max_recursion 2
background 0.4 0.6 0.9
triangle -9 -9 0  9 -9 0  0 9 0
{
cp 0.3 0.3 0.3
ball 0.8 -1.5 0 0.8
}
ball 0.5 1.5 0 0.5
ball 0.3 0 1 1.5
{
translate 0 -2 4
arealight 0.7 0.8 0.8 0.8
}
end
";

fn plan() -> Plan {
    let parsed = parse(SCENE, &ParseOptions::default()).unwrap();
    let scene = Scene::new(&parsed.description, vec![]).unwrap();
    let input =
        SceneInput { name: "balls".into(), path: "balls.sce".into(), hash: "0".into(), scene };
    Plan {
        budget: Some(Duration::from_secs(20)),
        rounds: RoundRule { warmup: 1, at_least: 3, relative_interval: 1e9 },
        threads: 2,
        rays_per_class: 2_000,
        classes: RayClass::ALL.to_vec(),
        ..Plan::of_scenes(vec![input])
    }
}

fn named(name: &str) -> Structure {
    *structure_named(name).unwrap()
}

fn compare(structures: &[Structure]) -> ComparisonResult {
    run(&plan(), structures, &Silent).unwrap()
}

#[test]
fn structures_that_keep_the_contract_agree() {
    let result = compare(STRUCTURES);
    assert!(result.holds());
    let scene = &result.comparison.scenes[0];
    let proof = scene.proof.as_ref().unwrap();
    let all = STRUCTURES.len();
    assert_eq!((proof.reference.as_str(), proof.structures.len()), ("none", all));
    for entry in &proof.structures {
        assert_eq!(entry.picture_equal, Some(true));
        assert_eq!(entry.picture_hash, Some(scene.picture.as_ref().unwrap().hash.clone()));
        assert!(entry.rays_checked > 100);
    }
    for row in &scene.structures {
        assert_eq!(row.status, Status::Ok);
        assert!(!row.build.one_thread_ns.is_empty() && !row.build.all_threads_ns.is_empty());
        assert!(!row.picture_rounds.is_empty());
        assert_eq!(row.classes.len(), RayClass::ALL.len() - 1, "there is no refraction");
        for class in &row.classes {
            assert!(class.rounds.len() >= 3, "{:?}", class.class);
            let same = scene.structures[0].class(class.class).unwrap();
            if same.rays == class.rays {
                assert_eq!(same.hits, class.hits, "{:?}", class.class);
            }
        }
    }
    let none = scene.structures[0].class(RayClass::View).unwrap();
    assert_eq!(none.primitives, Some(4 * none.rays), "every object for every ray");
    let heatmaps = result.pictures.iter().filter(|(name, _)| name.contains("heatmap"));
    assert_eq!(heatmaps.count(), all);
}

#[test]
fn a_structure_that_prunes_too_much_is_caught_with_a_ray() {
    let broken = Structure::new::<Shrunken, Shrunken>("shrunken", "boxes that are too small");
    let result = compare(&[named("none"), named("bvh"), broken]);
    assert!(!result.holds());
    let scene = &result.comparison.scenes[0];
    let proof = scene.proof.as_ref().unwrap();
    assert!(proof.structure("bvh").unwrap().holds());
    let entry = proof.structure("shrunken").unwrap();
    assert!(entry.differing_hits > 0 && !entry.holds());
    let ray = entry.first_difference.as_ref().unwrap();
    for part in ["ray: origin ", "direction ", "expected t ", "got "] {
        assert!(ray.contains(part), "{ray}");
    }
    let row = scene.structure("shrunken").unwrap();
    assert!(matches!(&row.status, Status::Failed { message } if message.contains(ray)));
    assert!(row.classes.is_empty(), "wrong results are not timed");
    assert!(!scene.structure("bvh").unwrap().classes.is_empty(), "the others go on");
}

#[test]
fn a_sweep_compares_hits_and_drops_a_structure_that_differs() {
    let broken = Structure::new::<Bvh, Forgetful>("lossy", "loses half of the triangles");
    let plan = Plan {
        sweep: Some(SweepPlan { family: Family::Mesh(MeshKind::Icosphere), sizes: vec![80, 320] }),
        scenes: vec![],
        budget: Some(Duration::from_secs(6)),
        ..plan()
    };
    let result = run(&plan, &[named("none"), broken, named("bvh")], &Silent).unwrap();
    let sweep = &result.comparison.sweeps[0];
    assert!(!result.holds() && sweep.rays_checked > 100, "{}", sweep.rays_checked);
    let [dropped] = &sweep.dropped[..] else { panic!("{:?}", sweep.dropped) };
    assert_eq!((dropped.structure.as_str(), dropped.failed), ("lossy", true));
    assert!(dropped.reason.contains("its results differ: "), "{}", dropped.reason);
    assert!(sweep.points.iter().all(|point| point.structure != "lossy"));
}

#[test]
fn a_panic_is_a_row() {
    let building = Structure::new::<Panicking<true>, Bvh>("builder", "panics in its build");
    let tracing = Structure::new::<Panicking<false>, Bvh>("tracer", "panics in its search");
    let result = compare(&[building, tracing, named("bvh")]);
    assert!(!result.holds());
    let scene = &result.comparison.scenes[0];
    for name in ["builder", "tracer"] {
        let status = &scene.structure(name).unwrap().status;
        let failed = matches!(status, Status::Failed { message } if message.contains("on purpose"));
        assert!(failed, "{name}: {status:?}");
    }
    assert_eq!(scene.structure("bvh").unwrap().status, Status::Ok);
    assert_eq!(scene.proof.as_ref().unwrap().reference, "bvh");
}

/// A tree that adds up the bits of all rays that it traces, whatever their order.
struct Summing(Bvh);

static SUM: AtomicU64 = AtomicU64::new(0);

impl Accel for Summing {
    fn build(primitives: &impl Bounded, build: &mut Build<'_>) -> Built<Self> {
        let built = Bvh::build(primitives, build);
        Built { accel: Self(built.accel), order: built.order }
    }

    fn traverse<C: Counters>(
        &self,
        ray: &Ray,
        box_ray: &BoxRay,
        counters: &mut C,
        leaf: impl FnMut(Range<u32>, &mut C) -> ControlFlow<(), f32>,
    ) {
        let parts = ray.origin.to_array().into_iter().chain(ray.dir.to_array());
        let sum = parts.map(|x| u64::from(x.to_bits())).sum();
        SUM.fetch_add(sum, Ordering::Relaxed);
        self.0.traverse(ray, box_ray, counters, leaf);
    }

    fn bytes(&self) -> u64 {
        self.0.bytes()
    }
}

#[test]
fn the_same_rays_are_recorded_in_every_run() {
    // Without replays all rays come from the proof, the pictures and the heatmaps.
    let proof = || {
        SUM.store(0, Ordering::Relaxed);
        let summing = Structure::new::<Summing, Bvh>("summing", "adds up its rays");
        let plan = Plan { classes: vec![], ..plan() };
        let result = run(&plan, &[summing], &Silent).unwrap();
        let row = &result.comparison.scenes[0].structures[0];
        (result.comparison.scenes[0].proof.clone(), row.status.clone())
    };
    let (first, status) = proof();
    assert_eq!(status, Status::Ok);
    assert!(SUM.load(Ordering::Relaxed) > 0);
    assert_eq!(proof().0, first);
}

/// Stops a comparison at a step.
struct StopAt(&'static str, AtomicU64);

impl Observer for StopAt {
    fn begins(&self, what: &str) {
        if what.ends_with(self.0) {
            self.1.store(1, Ordering::Relaxed);
        }
    }
    fn advanced(&self, share: f64) {
        assert!((0.0..=1.0).contains(&share));
    }
    fn cancelled(&self) -> bool {
        self.1.load(Ordering::Relaxed) > 0
    }
}

#[test]
fn what_is_done_before_a_stop_is_kept() {
    let stop = StopAt("timing rays", AtomicU64::new(0));
    let result = run(&plan(), &["none", "bvh"].map(named), &stop).unwrap();
    assert!(result.comparison.run.partial);
    let scene = &result.comparison.scenes[0];
    assert!(scene.proof.as_ref().unwrap().holds());
    for row in &scene.structures {
        assert_eq!(row.status, Status::Stopped);
        assert!(row.classes.is_empty() && !row.build.all_threads_ns.is_empty());
    }
}

#[test]
fn names_must_differ() {
    assert!(run(&plan(), &[], &Silent).is_err());
    let error = run(&plan(), &["bvh", "bvh"].map(named), &Silent).unwrap_err();
    assert_eq!(error.to_string(), "`bvh` was named twice");
}
