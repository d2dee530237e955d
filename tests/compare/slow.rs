//! Structures whose rays take long: a small budget is kept, ratios are those of equal rays, and a
//! witness shows what few rays of the reference do not.

use std::ops::{ControlFlow, Range};
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use srt::accel::{Accel, Bounded, Build, Built, Exhaustive};
use srt::analysis::Analysis;
use srt::compare::{Plan, Silent, run};
use srt::counters::Counters;
use srt::math::{BoxRay, Ray};
use srt::record::{RayClass, RoundRule, Status};
use srt::scene::Structure;

use crate::{named, plan};

/// Tests everything, after work of so many microseconds a ray, and counts its rays.
struct Slow<const MICROSECONDS: u64>(Exhaustive);

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
    let slow = Structure::new::<Slow<100_000>, Exhaustive>("slow", "a tenth of a second a ray");
    let result = run(&short_plan(0.5), &[named("bvh"), slow], &Silent).unwrap();
    let scene = &result.comparison.scenes[0];
    let row = scene.structure("slow").unwrap();
    assert!(matches!(row.status, Status::TooSlow { .. }), "{:?}", row.status);
    // One trial of one ray, for all classes; a second one where another program had the processor for
    // nearly all of the first.
    let rays = RAYS.load(Ordering::Relaxed);
    assert!(rays <= 2, "{rays} rays");
    assert!(!scene.structure("bvh").unwrap().classes.is_empty());
}

#[test]
fn a_ratio_is_that_of_rays_that_both_traced() {
    let slow = Structure::new::<Slow<2_000>, Exhaustive>("none", "two milliseconds a ray");
    let result = run(&view_plan(), &[named("bvh"), slow], &Silent).unwrap();
    let scene = &result.comparison.scenes[0];
    let (bvh, slow) = (scene.structure("bvh").unwrap(), scene.structure("none").unwrap());
    let figures = Analysis::of(&result.comparison);
    let (base, own) = (slow.class(RayClass::View).unwrap(), bvh.class(RayClass::View).unwrap());
    assert!(base.rays < own.rays, "{} and {}", base.rays, own.rays);
    let common = own.common.as_ref().unwrap();
    assert_eq!(common.rays, base.rays);
    assert_eq!((common.own.len(), &common.base), (own.rounds.len(), &base.rounds));
    assert_eq!(base.common, None);
    let speedup = figures.scenes[0].structure("bvh").unwrap().class(RayClass::View).unwrap();
    assert_eq!(speedup.speedup_rays, Some(base.rays));
}

#[test]
fn the_base_traces_the_rays_of_slower_ones_too() {
    let slow = Structure::new::<Slow<2_000>, Exhaustive>("slow", "two milliseconds a ray");
    let result = run(&view_plan(), &[named("bvh"), slow], &Silent).unwrap();
    let scene = &result.comparison.scenes[0];
    let own = scene.structure("slow").unwrap().class(RayClass::View).unwrap();
    let common = own.common.as_ref().unwrap();
    assert_eq!((common.rays, &common.own), (own.rays, &own.rounds));
    assert_eq!(common.base.len(), own.rounds.len());
}

#[test]
fn where_the_reference_has_time_for_few_rays_a_witness_traces_the_others() {
    let none = Structure::new::<Slow<500>, Exhaustive>("none", "half a millisecond a ray");
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
