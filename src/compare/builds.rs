//! What building takes, on one thread and on all, in interleaved rounds.

use std::time::Duration;

use crate::record::RoundRule;

use super::Stage;
use super::budget::Budget;
use super::clock::{nanoseconds, timed};
use super::entrant::Entrant;
use super::guard::guarded;
use super::machine::{forget_peak, peak_resident_bytes};
use super::plan::Plan;
use super::quality;
use super::rounds::{Repeat, interleaved};

/// Builds all structures on all threads, to be traced, and notes what they are.
pub(super) fn build_all(entrants: &mut [Entrant<'_>], stage: &Stage<'_>) {
    for entrant in entrants {
        let anew = forget_peak();
        stage.pools.all.install(|| entrant.build(stage.scene, &stage.plan.build));
        let peak = if anew { peak_resident_bytes() } else { None };
        if let Some(report) = entrant.report() {
            let known = !entrant.structure.peer;
            entrant.record.shape = known.then(|| quality::shape(&report, stage.scene));
            entrant.record.build.stages = quality::build_stages(&report);
            entrant.record.memory = Some(quality::memory(&report, peak));
        }
    }
}

/// A round of builds may take so many times as long as there is time for all of them.
const OVERDRAWN: u32 = 2;

fn threads(plan: &Plan) -> u32 {
    u32::try_from(plan.threads).unwrap_or(u32::MAX)
}

/// Measures builds; the ones that [`build_all`] made have warmed everything up. Where not even one
/// round fits, those are the measurement.
pub(super) fn measure(entrants: &mut [Entrant<'_>], stage: &Stage<'_>, budget: Budget) {
    let Stage { scene, plan, pools, .. } = stage;
    let fit: Vec<usize> = (0..entrants.len()).filter(|&i| entrants[i].is_fit()).collect();
    let built: Vec<Option<Duration>> =
        entrants.iter().map(|entrant| entrant.report().map(|report| report.time)).collect();
    // A round builds on one thread and on all.
    let round: Duration = built.iter().flatten().map(|time| *time * (1 + threads(plan))).sum();
    if round > budget.left().saturating_mul(OVERDRAWN) {
        for (entrant, time) in entrants.iter_mut().zip(built) {
            entrant.record.build.all_threads_ns.extend(time.map(nanoseconds));
        }
        return;
    }
    let rule = RoundRule { warmup: 0, ..plan.rounds.clone() };
    let repeat = Repeat { rule: &rule, budget, cancelled: &|| (stage.cancelled)() };
    // Lane 2i is the i-th on one thread, lane 2i + 1 on all.
    let rounds = interleaved(2 * fit.len(), &repeat, |lane| {
        let entrant = &mut entrants[fit[lane / 2]];
        let pool = if lane % 2 == 0 { &pools.one } else { &pools.all };
        let build = || timed(|| entrant.structure.build(scene, &plan.build));
        match pool.install(|| guarded(build)) {
            Ok((world, round)) => {
                drop(world);
                Some((round.wall_ns, round.wall_ns))
            }
            Err(message) => {
                entrant.fail(message);
                None
            }
        }
    });
    for (lane, rounds) in rounds.into_iter().enumerate() {
        let build = &mut entrants[fit[lane / 2]].record.build;
        match lane % 2 {
            0 => build.one_thread_ns = rounds,
            _ => build.all_threads_ns = rounds,
        }
    }
}
