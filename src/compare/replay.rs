//! The recorded rays of all classes through all structures, in passes of interleaved rounds on one thread.
//!
//! A structure that would take too long for all rays in every round traces a sample of them, drawn anew for each
//! (`block_sample.rs`). One that has no time for even two small blocks is left out of the class, and its row notes
//! that.

use std::time::Duration;

use crate::accel::Tracer;
use crate::counters::Counts;
use crate::math::Random;
use crate::ray_file::RayAnswers;
use crate::record::{ClassRecord, RayClass, Round};

use super::block_sample::{Block, Sample};
use super::budget::Budget;
use super::candidate::Candidate;
use super::class_rounds::{ClassRounds, Samples, Work, round_shares};
use super::clock::timed;
use super::context::SceneContext;
use super::hardware::Hardware;
use super::passes::{Measured, Passes, affordable_builds};
use super::record_rays::RaySet;
use super::trace::trace;
use super::trial::RayTimes;

/// Measures the classes of the plan; each structure's row gets them. `times` are the structures' trials with all sets.
pub(super) fn replay_all(
    context: &SceneContext<'_>,
    candidates: &mut [Candidate<'_>],
    sets: &[RaySet],
    times: &[RayTimes],
    budget: Budget,
) -> Replayed {
    let wanted = (0..sets.len()).filter(|&i| context.plan.classes.contains(&sets[i].class));
    let works: Vec<Planned> =
        wanted.flat_map(|set| works_of(candidates, sets, times, set)).collect();
    let builds = candidates.iter().filter_map(Candidate::build_report).map(|report| report.time);
    let build_time = affordable_builds(builds.sum(), budget);
    let passes = Passes {
        rule: context.plan.rounds.clone(),
        budget,
        cancelled: context.cancelled,
        build_time,
    };
    let tasks = tasks(context, candidates, sets, works, passes.time_for_rounds());
    let mut classes: Vec<ClassRounds> =
        tasks.iter().map(|class| class.rounds(sets, context.plan.picture.seed)).collect();
    let hardware = Hardware::of_this_thread();
    let shifts = Random::new(&[context.plan.picture.seed, PLACES]);
    let mut replay =
        Replay { context, candidates, sets, classes: tasks, hardware, shifts, spacer: Vec::new() };
    let whole = passes.run(&mut classes, &mut replay);
    let Replay { candidates, classes: tasks, .. } = replay;
    for (class, rounds) in tasks.iter().zip(classes) {
        class.note(candidates, sets, context.plan.picture.seed, rounds);
    }
    Replayed { whole, built_anew: build_time.is_some() }
}

/// How the measurement of rays ended.
#[derive(Clone, Copy, Debug)]
pub(super) struct Replayed {
    /// Whether it was not cancelled before its end.
    pub(super) whole: bool,
    /// Whether structures were built anew for each pass.
    pub(super) built_anew: bool,
}

/// All rays of a set with a structure.
struct Planned {
    set: usize,
    candidate: usize,
    work: Work,
}

/// The works of the structures that can trace a set.
fn works_of(
    candidates: &[Candidate<'_>],
    sets: &[RaySet],
    times: &[RayTimes],
    set: usize,
) -> Vec<Planned> {
    let work = |(candidate, times): (usize, &RayTimes)| {
        let work = Work { ray_time: times[set]?, rays: sets[set].rays.len() };
        candidates[candidate].can_trace().then_some(Planned { set, candidate, work })
    };
    times.iter().enumerate().filter_map(work).collect()
}

/// A class of rays and the structures that have time for it.
struct Class {
    set: usize,
    tasks: Vec<Task>,
}

/// A structure's part in the rounds of a class.
struct Task {
    candidate: usize,
    ray_time: Duration,
    samples: Samples,
    results: RayAnswers,
}

/// The structures that have time for each class, with as many rays as they have time for.
fn tasks(
    context: &SceneContext<'_>,
    candidates: &mut [Candidate<'_>],
    sets: &[RaySet],
    planned: Vec<Planned>,
    time: Duration,
) -> Vec<Class> {
    let works: Vec<Work> = planned.iter().map(|planned| planned.work).collect();
    let shares = round_shares(&works, &context.plan.rounds, time);
    let mut classes: Vec<Class> = Vec::new();
    for (Planned { set, candidate, work }, share) in planned.into_iter().zip(shares) {
        if classes.last().is_none_or(|class| class.set != set) {
            classes.push(Class { set, tasks: Vec::new() });
        }
        match (share.samples, classes.last_mut()) {
            (Some(samples), Some(class)) => class.tasks.push(Task {
                candidate,
                ray_time: work.ray_time,
                samples,
                results: sets[set].results(),
            }),
            _ => candidates[candidate].mark_too_slow(share.time),
        }
    }
    classes
}

impl Class {
    /// Its rounds, before the first.
    fn rounds(&self, sets: &[RaySet], seed: u64) -> ClassRounds {
        let set = &sets[self.set];
        let tasks: Vec<(Sample, Duration)> =
            self.tasks.iter().map(|task| (task.samples.timed, task.ray_time)).collect();
        ClassRounds::new(set.rays.len(), seed_of(seed, set.class), &tasks)
    }

    /// Counts what the rays test, and adds the class to the rows of its structures.
    fn note(
        &self,
        candidates: &mut [Candidate<'_>],
        sets: &[RaySet],
        seed: u64,
        measured: ClassRounds,
    ) {
        let set = &sets[self.set];
        let passes: Vec<u64> = measured.passes.iter().map(|&rounds| rounds as u64).collect();
        for (task, rounds) in self.tasks.iter().zip(measured.rounds) {
            if !rounds.is_empty() {
                let candidate = &mut candidates[task.candidate];
                note(candidate, set, task, seed_of(seed, set.class), rounds, passes.clone());
            }
        }
    }
}

/// The structures and their rays, as passes measure them.
struct Replay<'a, 'b> {
    context: &'a SceneContext<'a>,
    candidates: &'a mut [Candidate<'b>],
    sets: &'a [RaySet],
    classes: Vec<Class>,
    hardware: Hardware,
    /// How far structures lie from where they lay in the pass before.
    shifts: Random,
    spacer: Vec<u8>,
}

/// Keeps these random numbers apart from others of the same seed.
const PLACES: u64 = 0x706c_6163_6573;

/// The largest shift, in cache lines: 64 KiB, which allocators still take from the memory that structures lie in.
const LARGEST_SHIFT: u32 = 1024;

impl Measured for Replay<'_, '_> {
    fn build_anew(&mut self) {
        // A structure that is built anew gets the memory that the last one left, to the byte. All passes would measure
        // one place of many, which differ by some percent (T. Mytkowicz et al., *Producing Wrong Data Without Doing
        // Anything Obviously Wrong!*, ASPLOS 2009).
        self.spacer = Vec::with_capacity(64 * self.shifts.below(LARGEST_SHIFT) as usize);
        let SceneContext { scene, plan, pools, .. } = self.context;
        for candidate in self.candidates.iter_mut().filter(|candidate| candidate.can_trace()) {
            pools.all.install(|| candidate.build(scene, &plan.build));
        }
    }

    fn trace(&mut self, class: usize, task: usize, blocks: &[Block]) -> Option<Round> {
        let Class { set, tasks } = &mut self.classes[class];
        let Task { candidate, results, .. } = &mut tasks[task];
        let (set, hardware) = (&self.sets[*set], &mut self.hardware);
        let candidate = &mut self.candidates[*candidate];
        candidate.attempt(|tracer| run(tracer, set, blocks, results, hardware))
    }
}

/// The same blocks for all structures and in every run, others for each class.
fn seed_of(seed: u64, class: RayClass) -> u64 {
    seed ^ (class as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15)
}

/// Traces the blocks of a round: what warms up is neither timed nor counted.
fn run(
    tracer: &dyn Tracer,
    set: &RaySet,
    blocks: &[Block],
    results: &mut RayAnswers,
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
fn note(
    candidate: &mut Candidate<'_>,
    set: &RaySet,
    task: &Task,
    seed: u64,
    rounds: Vec<Round>,
    passes: Vec<u64>,
) {
    let all = set.rays.len();
    let blocks = task.samples.counted.draw(all, seed, 0);
    let counted = candidate.attempt(|tracer| {
        let (mut results, mut counts, mut hits) = (set.results(), Counts::default(), 0);
        for block in &blocks {
            trace(tracer, &set.rays[block.timed.clone()], &mut results, Some(&mut counts));
            hits += results.hit_count() as u64;
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
        passes,
    });
}
