//! The recorded rays of a class through all structures, in interleaved rounds on one thread.
//!
//! A structure that would take too long for all rays in every round traces a sample of them, drawn anew for each
//! (`block_sample.rs`). One that has no time for even two small blocks is left out of the class, and its row notes
//! that.

use std::time::Duration;

use crate::accel::Tracer;
use crate::counters::Counts;
use crate::record::{ClassRecord, RayClass, Round};

use super::block_sample::{Block, Sample};
use super::budget::Budget;
use super::candidate::Candidate;
use super::class_rounds::{Samples, class_rounds, round_shares};
use super::clock::timed;
use super::context::SceneContext;
use super::hardware::Hardware;
use super::record_rays::RaySet;
use super::trace::{RayResults, trace};
use super::trial::RayTimes;

/// Measures the classes of the plan; each structure's row gets them. `times` are the structures'
/// trials with all sets. `false` if it was cancelled before the last class.
pub(super) fn replay_all(
    context: &SceneContext<'_>,
    candidates: &mut [Candidate<'_>],
    sets: &[RaySet],
    times: &[RayTimes],
    budget: Budget,
) -> bool {
    let classes = &context.plan.classes;
    let wanted: Vec<usize> =
        (0..sets.len()).filter(|&i| classes.contains(&sets[i].class)).collect();
    for (done, &index) in wanted.iter().enumerate() {
        if (context.cancelled)() {
            return false;
        }
        let times: RayTimes = times.iter().map(|times| times[index]).collect();
        let share = budget.share(1.0 / (wanted.len() - done) as f64);
        replay(context, candidates, &sets[index], &times, share);
    }
    true
}

/// A structure's part in the rounds of a class.
struct Task {
    candidate: usize,
    samples: Samples,
    results: RayResults,
}

/// Measures one class. `times` are the times of a ray of it, of each structure.
fn replay(
    context: &SceneContext<'_>,
    candidates: &mut [Candidate<'_>],
    set: &RaySet,
    times: &[Option<Duration>],
    budget: Budget,
) {
    let seed = seed_of(context.plan.picture.seed, set.class);
    let mut tasks = tasks(context, candidates, set, times, budget);
    let samples: Vec<Sample> = tasks.iter().map(|task| task.samples.timed).collect();
    let mut hardware = Hardware::of_this_thread();
    let repeat = context.rounds(budget);
    let rounds = class_rounds(&samples, set.rays.len(), seed, &repeat, |task, blocks| {
        let Task { candidate, results, .. } = &mut tasks[task];
        let candidate = &mut candidates[*candidate];
        candidate.attempt(|tracer| run(tracer, set, blocks, results, &mut hardware))
    });
    for (task, rounds) in tasks.into_iter().zip(rounds) {
        if !rounds.is_empty() {
            note(&mut candidates[task.candidate], set, &task, seed, rounds);
        }
    }
}

/// The same blocks for all structures and in every run, others for each class.
fn seed_of(seed: u64, class: RayClass) -> u64 {
    seed ^ (class as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15)
}

/// The structures that have time for the class, with as many rays as they have time for.
fn tasks(
    context: &SceneContext<'_>,
    candidates: &mut [Candidate<'_>],
    set: &RaySet,
    times: &[Option<Duration>],
    budget: Budget,
) -> Vec<Task> {
    let able: Vec<(usize, Duration)> = candidates
        .iter()
        .zip(times)
        .enumerate()
        .filter_map(|(index, (candidate, time))| candidate.can_trace().then_some((index, (*time)?)))
        .collect();
    let times: Vec<Duration> = able.iter().map(|&(_, time)| time).collect();
    let shares = round_shares(&times, set.rays.len(), &context.plan.rounds, budget);
    let mut tasks = Vec::new();
    for ((candidate, _), share) in able.into_iter().zip(shares) {
        match share.samples {
            Some(samples) => tasks.push(Task { candidate, samples, results: set.results() }),
            None => candidates[candidate].mark_too_slow(share.time),
        }
    }
    tasks
}

/// Traces the blocks of a round: what warms up is neither timed nor counted.
fn run(
    tracer: &dyn Tracer,
    set: &RaySet,
    blocks: &[Block],
    results: &mut RayResults,
    hardware: &mut Hardware,
) -> Round {
    let of_block = |block: &Block| {
        trace(tracer, &set.rays[block.warmup.clone()], results, None);
        // The counters are started outside of what is timed.
        let work = || timed(|| trace(tracer, &set.rays[block.timed.clone()], results, None));
        let (((), round), counts) = hardware.count(work);
        Round { hardware: counts, ..round }
    };
    blocks.iter().map(of_block).reduce(Round::plus).unwrap_or_default()
}

/// Counts what the rays test, and adds the class to the structure's row.
fn note(candidate: &mut Candidate<'_>, set: &RaySet, task: &Task, seed: u64, rounds: Vec<Round>) {
    let all = set.rays.len();
    let blocks = task.samples.counted.draw(all, seed, 0);
    let counted = candidate.attempt(|tracer| {
        let (mut results, mut counts, mut hits) = (set.results(), Counts::default(), 0);
        for block in &blocks {
            trace(tracer, &set.rays[block.timed.clone()], &mut results, Some(&mut counts));
            hits += results.hit_count();
        }
        (hits, counts)
    });
    let tests = counted.filter(|_| !candidate.is_peer()).map(|(_, counts)| counts);
    candidate.record.classes.push(ClassRecord {
        class: set.class,
        rays: task.samples.timed.timed_rays(all) as u64,
        sample: task.samples.timed.record(all),
        counted_rays: task.samples.counted.timed_rays(all) as u64,
        hits: counted.map_or(0, |(hits, _)| hits),
        boxes: tests.map(|counts| counts.boxes),
        primitives: tests.map(|counts| counts.primitives),
        rounds,
    });
}
