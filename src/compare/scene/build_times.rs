//! The seventh step: how long builds and their stages take, on one thread and on all, in interleaved rounds.

use std::time::Duration;

use crate::analysis::statistics::median;
use crate::compare::budget::Budget;
use crate::compare::candidate::Candidate;
use crate::compare::clock::{nanoseconds, timed};
use crate::compare::context::SceneContext;
use crate::compare::panics::catch_panic;
use crate::compare::rounds::interleaved;
use crate::record::BuildStage;

use super::building::build_stages;

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
    let rounds = interleaved(2 * fit.len(), &context.rounds_after_warmup(budget), |task, _| {
        let candidate = &mut candidates[fit[task / 2]];
        let pool = if task % 2 == 0 { &pools.one } else { &pools.all };
        let build = || timed(|| candidate.structure.build(scene, &plan.build));
        match pool.install(|| catch_panic(build)) {
            Ok((world, round)) => {
                let stages = build_stages(&world.build_report());
                drop(world);
                Some(((round.wall_ns, stages), round.wall_ns))
            }
            Err(message) => {
                candidate.fail(message);
                None
            }
        }
    });
    for (task, rounds) in rounds.into_iter().enumerate() {
        let build = &mut candidates[fit[task / 2]].record.build;
        let (times, stages): (Vec<u64>, Vec<Vec<BuildStage>>) = rounds.into_iter().unzip();
        match task % 2 {
            0 => build.one_thread_ns = times,
            _ => {
                build.all_threads_ns = times;
                build.stages = medians(&stages).unwrap_or(std::mem::take(&mut build.stages));
            }
        }
    }
}

/// The median of each stage over some builds; `None` without builds.
fn medians(builds: &[Vec<BuildStage>]) -> Option<Vec<BuildStage>> {
    let stage = |(place, stage): (usize, &BuildStage)| {
        let times = builds.iter().filter_map(|build| build.get(place));
        let times: Vec<f64> = times.map(|stage| stage.ns as f64).collect();
        let ns = median(&times).unwrap_or_default().round() as u64;
        BuildStage { name: stage.name.clone(), ns }
    };
    Some(builds.first()?.iter().enumerate().map(stage).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stage_takes_the_median_of_its_times() {
        let stage = |(name, ns): (&str, u64)| BuildStage { name: name.to_owned(), ns };
        let build = |a, b| [("bin", a), ("pack", b)].map(stage).to_vec();
        let builds = [build(10, 1), build(90, 2), build(20, 9)];
        assert_eq!(medians(&builds), Some(build(20, 2)));
        assert_eq!(medians(&[]), None);
    }
}
