//! Structures whose rays take long: a small budget is kept, their rays are samples of all, and a
//! witness shows what few rays of the reference do not.

use std::ops::{ControlFlow, Range};
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use srt::accel::{Accel, Bounded, Build, Built, Exhaustive};
use srt::analysis::Analysis;
use srt::compare::{Plan, Silent, run};
use srt::counters::Counters;
use srt::math::{BoxRay, Ray};
use srt::record::{ClassRecord, RayClass, Round, RoundRule, Status};
use srt::scene::Structure;

use crate::{named, plan};

/// Tests everything, after work of so many microseconds a ray, and counts its rays.
pub(crate) struct Slow<const MICROSECONDS: u64>(Exhaustive);

static RAYS: AtomicU64 = AtomicU64::new(0);

impl<const MICROSECONDS: u64> Accel for Slow<MICROSECONDS> {
    fn build(primitives: &impl Bounded, build: &mut Build<'_>) -> Built<Self> {
        let Built { accel, order } = Exhaustive::build(primitives, build);
        Built { accel: Self(accel), order }
    }

    fn traverse<C: Counters>(
        &self,
        ray: &Ray,
        box_ray: &BoxRay,
        counters: &mut C,
        leaf: impl FnMut(Range<u32>, &mut C) -> ControlFlow<(), f32>,
    ) {
        RAYS.fetch_add(u64::from(MICROSECONDS > 10_000), Ordering::Relaxed);
        let start = Instant::now();
        while start.elapsed() < Duration::from_micros(MICROSECONDS) {
            std::hint::spin_loop();
        }
        self.0.traverse(ray, box_ray, counters, leaf);
    }

    fn bytes(&self) -> u64 {
        self.0.bytes()
    }
}

/// Offers the first half of the primitives.
pub(crate) struct Forgetful(u32);

impl Accel for Forgetful {
    fn build(primitives: &impl Bounded, _: &mut Build<'_>) -> Built<Self> {
        Built { accel: Self(primitives.count() / 2), order: None }
    }

    fn traverse<C: Counters>(
        &self,
        _: &Ray,
        _: &BoxRay,
        counters: &mut C,
        mut leaf: impl FnMut(Range<u32>, &mut C) -> ControlFlow<(), f32>,
    ) {
        let _ = leaf(0..self.0, counters);
    }

    fn bytes(&self) -> u64 {
        0
    }
}

fn short_plan(seconds: f64) -> Plan {
    Plan {
        budget: Some(Duration::from_secs_f64(seconds)),
        rounds: RoundRule { warmup: 0, at_least: 6, relative_interval: 1e9 },
        ..plan()
    }
}

/// View rays alone, with time for some of them at two milliseconds each.
fn view_plan() -> Plan {
    Plan { classes: vec![RayClass::View], ..short_plan(8.0) }
}

#[test]
fn a_ray_that_is_beyond_the_budget_is_traced_once() {
    // With a name of the program's own, it is not checked for conformance first.
    let slow = Structure::new::<Slow<100_000>, Exhaustive>("ball", "a tenth of a second a ray");
    let result = run(&short_plan(0.5), &[named("bvh"), slow], &Silent).unwrap();
    let scene = &result.comparison.scenes[0];
    let row = scene.structure("ball").unwrap();
    assert!(matches!(row.status, Status::TooSlow { .. }), "{:?}", row.status);
    // One trial of one ray, for all classes; a second one where another program had the processor for
    // nearly all of the first.
    let rays = RAYS.load(Ordering::Relaxed);
    assert!(rays <= 2, "{rays} rays");
    assert!(!scene.structure("bvh").unwrap().classes.is_empty());
}

#[test]
fn a_slow_structure_traces_samples_and_its_ratio_is_that_of_all_rays() {
    let slow = Structure::new::<Slow<2_000>, Exhaustive>("none", "two milliseconds a ray");
    let result = run(&view_plan(), &[named("bvh"), slow], &Silent).unwrap();
    let scene = &result.comparison.scenes[0];
    let class = |name: &str| scene.structure(name).unwrap().class(RayClass::View).unwrap();
    let (own, base) = (class("bvh"), class("none"));
    assert_eq!(own.sample, None, "it has time for all rays");
    let sample = base.sample.unwrap();
    assert_eq!((base.rays, sample.of_rays), (sample.blocks * sample.rays_per_block, own.rays));
    assert!(base.rays >= 16 && 2 * base.rays <= own.rays, "{} and {}", base.rays, own.rays);
    assert!(base.counted_rays >= base.rays);
    assert_eq!(base.primitives, Some(4 * base.counted_rays), "every object for every ray");
    // The ratio is one of two means.
    let mean = |class: &ClassRecord| {
        let ns: u64 = class.rounds.iter().map(Round::own_ns).sum();
        ns as f64 / (class.rounds.len() as u64 * class.rays) as f64
    };
    let ratio = mean(base) / mean(own);
    let figures = Analysis::of(&result.comparison);
    let of = |name: &str| figures.scenes[0].structure(name).unwrap().class(RayClass::View).unwrap();
    let (own, base) = (of("bvh"), of("none"));
    assert!((own.speedup.unwrap().value / ratio - 1.0).abs() < 1e-9, "{own:?}");
    assert!(base.ns_per_ray.unwrap().value > 2e6, "{base:?}");
}

#[test]
fn where_the_reference_has_time_for_few_rays_a_witness_traces_the_others() {
    let none = Structure::new::<Slow<1_000>, Exhaustive>("none", "a millisecond a ray");
    let lossy = Structure::new::<Forgetful, Forgetful>("lossy", "loses half of the primitives");
    let plan = Plan { classes: vec![], ..short_plan(20.0) };
    let structures = [none, lossy, named("bvh"), named("cwbvh")];
    let result = run(&plan, &structures, &Silent).unwrap();
    let proof = result.comparison.scenes[0].proof.as_ref().unwrap();
    assert_eq!((proof.reference.as_str(), proof.witness.as_deref()), ("none", Some("bvh")));
    let [lossy, bvh, cwbvh] = ["lossy", "bvh", "cwbvh"].map(|name| proof.structure(name).unwrap());
    assert!(bvh.holds() && bvh.rays_checked > 0, "{bvh:?}");
    assert!(cwbvh.holds() && cwbvh.rays_checked > 2 * bvh.rays_checked, "{cwbvh:?}");
    assert!(lossy.differing_hits > 0 && !result.holds(), "{lossy:?}");
}
