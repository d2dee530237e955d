//! How cost grows with the size of a scene: a family of generated meshes or of scattered objects, built and traced.
//!
//! A structure is dropped at the size at which not even a few rays of a class fit into its share of
//! the time, and the record notes that: linear ones are dropped first. Slopes are computed from the
//! record.

use crate::record::{Conformance, Dropped, Status, Sweep, SweepPoint};
use crate::render::Settings;
use crate::scene::Structure;

use super::budget::Budget;
use super::candidate::Candidate;
use super::clock::nanoseconds;
use super::context::SceneContext;
use super::plan::{Plan, SweepPlan};
use super::pools::Pools;
use super::progress::PartProgress;
use super::proof;
use super::record_rays::{RaySet, record, recording_tracer};
use super::replay::replay_all;
use super::trial::{RayTimes, ray_times, time_of_all};

/// Rays that the recording of a size may trace, whatever the budget: figures are of the rays, so these must not depend
/// on it.
const TRACED: u64 = 100_000;

/// Builds and traces all sizes. `checked` is what the check of conformance showed.
pub(super) fn sweep(
    sweep: &SweepPlan,
    structures: &[Structure],
    checked: &[Conformance],
    plan: &Plan,
    pools: &Pools,
    budget: Budget,
    progress: &PartProgress<'_>,
) -> Sweep {
    let family = sweep.family;
    let mut record = Sweep {
        mesh: family.name().to_owned(),
        unit: family.unit().to_owned(),
        ..Sweep::default()
    };
    let mut left: Vec<&Structure> = structures.iter().collect();
    for (done, &size) in sweep.sizes.iter().enumerate() {
        if progress.cancelled() || left.is_empty() {
            break;
        }
        progress.step(&format!("{family} of {size} {}", family.unit()), budget);
        let Ok(scene) = pools.all.install(|| family.scene(size, plan.picture.seed)) else {
            continue;
        };
        let cancelled = || progress.cancelled();
        let context = SceneContext { scene: &scene, plan, pools, cancelled: &cancelled };
        let share = budget.share(share_of_first(&sweep.sizes[done..]));
        let candidates = measure(&context, &left, checked, share, &mut record.rays_checked);
        let size = family.size_of(&scene);
        left.retain(|structure| {
            let own = candidates.iter().find(|candidate| candidate.name() == structure.name);
            own.is_none_or(|own| note(&mut record, own, size))
        });
    }
    record
}

/// The first size's share of the time for all that are left: larger meshes take longer to make and
/// to build, though not to trace.
fn share_of_first(sizes: &[u32]) -> f64 {
    let weights = sizes.iter().map(|&size| f64::from(size).sqrt());
    let first = weights.clone().next().unwrap_or(1.0);
    first / weights.sum::<f64>()
}

/// One size, traced by the structures that are left.
fn measure<'a>(
    context: &SceneContext<'_>,
    left: &[&'a Structure],
    checked: &[Conformance],
    budget: Budget,
    rays_checked: &mut u64,
) -> Vec<Candidate<'a>> {
    let sets = rays(context);
    let candidate = |&own: &&'a Structure| Candidate::new(own).judged_by(checked);
    let mut candidates: Vec<Candidate<'_>> = left.iter().map(candidate).collect();
    for candidate in &mut candidates {
        context.pools.all.install(|| candidate.build(context.scene, &context.plan.build));
    }
    let times: Vec<RayTimes> = candidates.iter_mut().map(|own| ray_times(own, &sets)).collect();
    *rays_checked += compare_hits(&mut candidates, &sets, &times, budget);
    candidates.iter_mut().for_each(Candidate::fail_if_unfit);
    if !replay_all(context, &mut candidates, &sets, &times, budget).whole {
        candidates.iter_mut().for_each(Candidate::mark_stopped);
    }
    candidates
}

/// Compares all results with those of the quickest structure of the library, on as many rays as
/// there is time for, and returns their number. A structure that differs is not timed.
fn compare_hits(
    candidates: &mut [Candidate<'_>],
    sets: &[RaySet],
    times: &[RayTimes],
    budget: Budget,
) -> u64 {
    let can_be = |i: &usize| {
        let own = &candidates[*i];
        own.can_trace() && !own.is_peer() && own.is_fit()
    };
    let order = |i: &usize| (!candidates[*i].is_of_library(), time_of_all(&times[*i], sets));
    let Some(reference) = (0..candidates.len()).filter(can_be).min_by_key(order) else { return 0 };
    let time = proof::time_for_class(budget.left(), candidates.len(), sets.len());
    let expected = proof::expected(&mut candidates[reference], sets, &times[reference], time);
    let mut checked = 0;
    for (index, candidate) in candidates.iter_mut().enumerate() {
        if index != reference && !candidate.is_peer() {
            checked += proof::check_rays(candidate, &expected, &times[index], time).rays_checked;
        }
    }
    checked
}

/// The rays of a small rendering, of the classes of the plan.
fn rays(context: &SceneContext<'_>) -> Vec<RaySet> {
    let SceneContext { scene, plan, .. } = context;
    let tracer = recording_tracer(context);
    let settings = Settings { seed: plan.picture.seed, ..Settings::of_scene(scene) };
    let mut sets = record(context, &*tracer, &settings, TRACED).sets;
    sets.retain(|set| plan.classes.contains(&set.class));
    sets
}

/// Adds what a structure did at a size; whether it takes part in the next.
fn note(record: &mut Sweep, candidate: &Candidate<'_>, size: u64) -> bool {
    let report = candidate.build_report().unwrap_or_default();
    let name = candidate.name();
    for class in &candidate.record.classes {
        record.points.push(SweepPoint {
            triangles: size,
            structure: name.to_owned(),
            class: class.class,
            rays: class.rays,
            sample: class.sample,
            rounds: class.rounds.clone(),
            passes: class.passes.clone(),
            build_ns: nanoseconds(report.time),
            index_bytes: report.objects.bytes + report.meshes.bytes,
        });
    }
    let reason = match &candidate.record.status {
        Status::Ok => return true,
        Status::Failed { message } => message.clone(),
        Status::TooSlow { after_seconds } => {
            format!(
                "a few rays take longer than its share of the time, {after_seconds:.3} s a round"
            )
        }
        Status::Stopped => "the comparison was stopped".to_owned(),
    };
    let failed = candidate.record.has_failed() && !candidate.is_peer();
    record.dropped.push(Dropped { structure: name.to_owned(), triangles: size, reason, failed });
    false
}
