//! The recorded rays of a class through all structures, in interleaved rounds on one thread.
//!
//! Where a structure would take too long for all rays, it traces as many of them, evenly spread,
//! as its share of the budget allows. For the ratio, the quicker of it and the base then traces the
//! rays of the slower too, in every round. A structure that has no time for even a few rays is left
//! out of the class, and its row notes that.

use std::time::Duration;

use crate::counters::Counts;
use crate::math::Ray;
use crate::record::{ClassRecord, CommonRays, Round};

use super::budget::Budget;
use super::candidate::Candidate;
use super::clock::timed;
use super::context::SceneContext;
use super::hardware::Hardware;
use super::record_rays::{RaySet, spread};
use super::rounds::interleaved;
use super::trace::{RayResults, trace};
use super::trial::{RayTimes, affordable};

/// With fewer rays than this a class is not measured.
const FEWEST_RAYS: usize = 16;

/// A round may always take this long, even if the budget is spent: a quick structure is not left
/// out because others were slow.
const LEAST_ROUND: Duration = Duration::from_millis(2);

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
    rays: Vec<Ray>,
    /// The rays of other tasks that it traces too, for ratios on equal rays: of one task only,
    /// unless it is the base's.
    common: Vec<Common>,
    results: RayResults,
}

/// Rays that the base and another structure both trace, where one of them traces more.
struct Common {
    /// The task of the other, which is not the base.
    task: usize,
    rays: Vec<Ray>,
}

/// A round of a task: with all its rays, and with the rays of other tasks.
struct TaskRound {
    all: Round,
    common: Vec<Round>,
}

/// Measures one class. `times` are the times of a ray of it, of each structure.
fn replay(
    context: &SceneContext<'_>,
    candidates: &mut [Candidate<'_>],
    set: &RaySet,
    times: &[Option<Duration>],
    budget: Budget,
) {
    let rule = &context.plan.rounds;
    let whole_rounds = rule.at_least + rule.warmup + 1; // one more to count
    let share = budget.left().div_f64(f64::from(whole_rounds) * candidates.len().max(1) as f64);
    let mut tasks = tasks(candidates, set, times, share.max(LEAST_ROUND));
    let is_base = |task: &Task| candidates[task.candidate].name() == context.base;
    let base = tasks.iter().position(is_base).unwrap_or_default();
    pair_with_base(&mut tasks, base);
    let mut hardware = Hardware::of_this_thread();
    let rounds = interleaved(tasks.len(), &context.rounds(budget), |task| {
        let task = &mut tasks[task];
        let round = run(&mut candidates[task.candidate], task, &mut hardware)?;
        let time = round.all.own_ns();
        Some((round, time))
    });
    for (task, own) in tasks.iter().enumerate() {
        let all = rounds[task].iter().map(|round| round.all).collect();
        let common = common_rays(&tasks, &rounds, task, base);
        note(&mut candidates[own.candidate], set, &own.rays, all, common);
    }
}

/// The structures that have time for the class in rounds of `round_time`, with as many rays as they
/// have time for.
fn tasks(
    candidates: &mut [Candidate<'_>],
    set: &RaySet,
    times: &[Option<Duration>],
    round_time: Duration,
) -> Vec<Task> {
    let mut tasks = Vec::new();
    for (index, candidate) in candidates.iter_mut().enumerate() {
        let Some(time) = times[index].filter(|_| candidate.can_trace()) else { continue };
        let count = affordable(Some(time), round_time);
        if count < FEWEST_RAYS.min(set.rays.len()) {
            candidate.mark_too_slow(round_time);
            continue;
        }
        let rays = spread(&set.rays, count);
        tasks.push(Task { candidate: index, rays, common: Vec::new(), results: set.results() });
    }
    tasks
}

/// For the base and each other structure: gives the task with more rays the rays of the other too.
fn pair_with_base(tasks: &mut [Task], base: usize) {
    for task in (0..tasks.len()).filter(|&task| task != base) {
        let (own, of_base) = (tasks[task].rays.len(), tasks[base].rays.len());
        let (more, fewer) = if own > of_base { (task, base) } else { (base, task) };
        if own != of_base {
            let rays = tasks[fewer].rays.clone();
            tasks[more].common.push(Common { task, rays });
        }
    }
}

/// A round of a task; `None` if the structure fails.
fn run(
    candidate: &mut Candidate<'_>,
    task: &mut Task,
    hardware: &mut Hardware,
) -> Option<TaskRound> {
    let Task { rays, common, results, .. } = task;
    candidate.attempt(|tracer| {
        // The counters are started outside of what is timed.
        let work = || timed(|| trace(tracer, rays, results, None));
        let (((), all), counts) = hardware.count(work);
        let common = common
            .iter()
            .map(|common| timed(|| trace(tracer, &common.rays, results, None)).1)
            .collect();
        TaskRound { all: Round { hardware: counts, ..all }, common }
    })
}

/// What a task and the base's did with the rays that both traced, where these are not all.
fn common_rays(
    tasks: &[Task],
    rounds: &[Vec<TaskRound>],
    task: usize,
    base: usize,
) -> Option<CommonRays> {
    let of = |tracing: usize| {
        let place = tasks[tracing].common.iter().position(|common| common.task == task)?;
        Some(rounds[tracing].iter().map(|round| round.common[place]).collect())
    };
    let all = |tracing: usize| rounds[tracing].iter().map(|round| round.all).collect();
    if task == base || tasks[task].rays.len() == tasks[base].rays.len() {
        return None;
    }
    let rays = tasks[task].rays.len().min(tasks[base].rays.len()) as u64;
    let (own, base) = match of(task) {
        Some(own) => (own, all(base)),
        None => (all(task), of(base)?),
    };
    Some(CommonRays { rays, own, base })
}

/// Counts what the rays test, and adds the class to the structure's row.
fn note(
    candidate: &mut Candidate<'_>,
    set: &RaySet,
    rays: &[Ray],
    rounds: Vec<Round>,
    common: Option<CommonRays>,
) {
    if rounds.is_empty() {
        return;
    }
    let counted = candidate.attempt(|tracer| {
        let (mut results, mut counts) = (set.results(), Counts::default());
        trace(tracer, rays, &mut results, Some(&mut counts));
        (results.hit_count(), counts)
    });
    let tests = counted.filter(|_| !candidate.is_peer()).map(|(_, counts)| counts);
    candidate.record.classes.push(ClassRecord {
        class: set.class,
        rays: rays.len() as u64,
        hits: counted.map_or(0, |(hits, _)| hits),
        boxes: tests.map(|counts| counts.boxes),
        primitives: tests.map(|counts| counts.primitives),
        rounds,
        common,
    });
}
