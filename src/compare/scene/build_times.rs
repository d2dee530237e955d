//! The seventh step: how long builds take, on one thread and on all, in interleaved rounds.

use std::time::Duration;

use crate::compare::budget::Budget;
use crate::compare::candidate::Candidate;
use crate::compare::clock::{nanoseconds, timed};
use crate::compare::context::SceneContext;
use crate::compare::panics::catch_panic;
use crate::compare::rounds::interleaved;

/// A round of builds may take so many times as long as there is time for all of them.
const MOST_BUDGETS: u32 = 2;

/// Measures builds. The builds of the first step have warmed everything up; where not even one
/// round fits, those are the measurement.
pub(super) fn measure(
    context: &SceneContext<'_>,
    candidates: &mut [Candidate<'_>],
    budget: Budget,
) {
    let built: Vec<Option<Duration>> =
        candidates.iter().map(|own| own.build_report().map(|report| report.time)).collect();
    // A round builds on one thread and on all.
    let builds = u32::try_from(context.plan.threads).unwrap_or(u32::MAX).saturating_add(1);
    let round: Duration = built.iter().flatten().map(|time| time.saturating_mul(builds)).sum();
    if round > budget.left().saturating_mul(MOST_BUDGETS) {
        for (candidate, time) in candidates.iter_mut().zip(built) {
            candidate.record.build.all_threads_ns.extend(time.map(nanoseconds));
        }
        return;
    }
    measure_rounds(context, candidates, budget);
}

/// Builds in interleaved rounds: task 2i is the i-th structure on one thread, task 2i + 1 on all.
fn measure_rounds(context: &SceneContext<'_>, candidates: &mut [Candidate<'_>], budget: Budget) {
    let SceneContext { scene, plan, pools, .. } = context;
    let fit: Vec<usize> = (0..candidates.len()).filter(|&i| candidates[i].can_trace()).collect();
    let rounds = interleaved(2 * fit.len(), &context.rounds_after_warmup(budget), |task| {
        let candidate = &mut candidates[fit[task / 2]];
        let pool = if task % 2 == 0 { &pools.one } else { &pools.all };
        let build = || timed(|| candidate.structure.build(scene, &plan.build));
        match pool.install(|| catch_panic(build)) {
            Ok((world, round)) => {
                drop(world);
                Some((round.wall_ns, round.wall_ns))
            }
            Err(message) => {
                candidate.fail(message);
                None
            }
        }
    });
    for (task, rounds) in rounds.into_iter().enumerate() {
        let build = &mut candidates[fit[task / 2]].record.build;
        match task % 2 {
            0 => build.one_thread_ns = rounds,
            _ => build.all_threads_ns = rounds,
        }
    }
}
