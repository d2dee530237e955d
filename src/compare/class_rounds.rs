//! The rounds of the classes of rays: how many rays each structure traces in one, which, and in how many passes.
//!
//! Knows neither structures nor rays: a task is a number, a ray is a place. So a test can run it by a clock of its own.

use std::time::Duration;

use crate::analysis::statistics::{Center, Rounds};
use crate::record::{BlockSample, Round, RoundRule};

use super::block_sample::{Block, Sample, shares};
use super::rounds::{MOST_ROUNDS, Repeat, interleaved};
use super::trial::affordable;

/// The least number of passes over all classes. They are what an interval comes from: with five, Student's is 2.8
/// standard errors wide on either side, with four 3.2, and each pass costs rounds that warm up and perhaps builds.
pub(super) const LEAST_PASSES: u32 = 5;

/// A round may always take this long, even if the budget is spent: a quick structure is not left
/// out because others were slow.
const LEAST_ROUND: Duration = Duration::from_millis(2);

/// How many rays are counted for each that a structure has time for in a round: counting happens once.
const COUNTED_ROUNDS: usize = 4;

/// All rays of a class with a structure.
#[derive(Clone, Copy, Debug)]
pub(super) struct Work {
    /// The time of a ray, by a trial.
    pub(super) ray_time: Duration,
    /// How many rays there are.
    pub(super) rays: usize,
}

/// A task's part in each round.
#[derive(Clone, Copy, Debug)]
pub(super) struct RoundShare {
    /// The time for it.
    pub(super) time: Duration,
    /// The rays for which that suffices; `None` if they are too few.
    pub(super) samples: Option<Samples>,
}

/// The rays of a task.
#[derive(Clone, Copy, Debug)]
pub(super) struct Samples {
    /// Those of each round.
    pub(super) timed: Sample,
    /// Those whose tests are counted, once.
    pub(super) counted: Sample,
}

/// The rounds of a pass that count, at least: together with those of the other passes as many as the rule asks for.
pub(super) fn least_rounds_of_pass(rule: &RoundRule) -> u32 {
    rule.at_least.div_ceil(LEAST_PASSES).max(1)
}

/// The part of each work in its rounds: as many rays as its share of the time allows for in as many passes and rounds
/// as the rule asks for. What quick ones leave goes to the slow ones, of whatever class.
pub(super) fn round_shares(works: &[Work], rule: &RoundRule, time: Duration) -> Vec<RoundShare> {
    let rounds = LEAST_PASSES * (least_rounds_of_pass(rule) + rule.warmup) + 1; // one more to count
    let needs: Vec<Duration> = works.iter().map(Work::time).collect();
    let times = shares(&needs, time / rounds);
    let share = |(time, work): (Duration, &Work)| {
        let time = time.max(LEAST_ROUND);
        let affordable = affordable(Some(work.ray_time), time);
        let sample = |affordable| Sample::that_fits(work.rays, affordable, work.ray_time);
        let timed = sample(affordable);
        let counted = sample(affordable.saturating_mul(COUNTED_ROUNDS));
        RoundShare {
            time,
            samples: timed.zip(counted).map(|(timed, counted)| Samples { timed, counted }),
        }
    };
    times.into_iter().zip(works).map(share).collect()
}

impl Work {
    /// The time of all of it, with what warms up.
    fn time(&self) -> Duration {
        let rays = Sample::Whole.traced_rays(self.rays);
        self.ray_time.saturating_mul(u32::try_from(rays).unwrap_or(u32::MAX))
    }
}

/// The rounds of a class, pass by pass.
pub(super) struct ClassRounds {
    /// How many rays the class has.
    rays: usize,
    /// What its samples are drawn by.
    seed: u64,
    /// What each task traces in a round.
    samples: Vec<Sample>,
    /// How long a round of all tasks takes, by trials.
    pub(super) round_time: Duration,
    /// How many rounds were run, those that warmed up included: each draws a sample of its own.
    begun: usize,
    /// Entry `[task][n]` is round n of a task.
    pub(super) rounds: Vec<Vec<Round>>,
    /// How many rounds each pass had.
    pub(super) passes: Vec<usize>,
}

impl ClassRounds {
    /// A class without rounds, of which each task traces a sample and has a time for a ray.
    pub(super) fn new(rays: usize, seed: u64, tasks: &[(Sample, Duration)]) -> Self {
        let time = |(sample, ray_time): &(Sample, Duration)| {
            ray_time.mul_f64(sample.traced_rays(rays) as f64)
        };
        Self {
            rays,
            seed,
            samples: tasks.iter().map(|task| task.0).collect(),
            round_time: tasks.iter().map(time).sum(),
            begun: 0,
            rounds: tasks.iter().map(|_| Vec::new()).collect(),
            passes: Vec::new(),
        }
    }

    /// Runs the rounds of a pass, by the rule of `repeat`. `run` traces a task's blocks and returns the round, or
    /// `None` if the structure fails.
    pub(super) fn run_pass(
        &mut self,
        repeat: &Repeat<'_>,
        mut run: impl FnMut(usize, &[Block]) -> Option<Round>,
    ) {
        let mut last = self.begun;
        let rounds = interleaved(self.samples.len(), repeat, |task, number| {
            last = last.max(self.begun + number + 1);
            let sample = self.samples[task];
            let mut blocks = sample.draw(self.rays, self.seed, self.begun + number);
            if number < repeat.rule.warmup as usize && sample != Sample::Whole {
                // Each block is warmed up by the one before it; the first also brings the code and the structure back.
                blocks.truncate(1);
            }
            let round = run(task, &blocks)?;
            Some((round, round.own_ns()))
        });
        self.begun = last;
        // A task that failed has fewer rounds than the others, in this pass and in all that follow.
        self.passes.push(rounds.iter().map(Vec::len).max().unwrap_or(0));
        for (all, own) in self.rounds.iter_mut().zip(rounds) {
            all.extend(own);
        }
    }

    /// Whether there are enough passes, and the interval of every task's time is as narrow as the rule asks for.
    pub(super) fn has_enough(&self, rule: &RoundRule) -> bool {
        let narrow = |(rounds, sample): (&Vec<Round>, &Sample)| {
            let values = rounds.iter().map(|round| round.own_ns() as f64).collect();
            let rounds = Rounds { values, center: sample.center(), passes: self.passes.clone() };
            let width = rounds.estimate().and_then(|estimate| estimate.relative_half_width());
            width.is_some_and(|width| width <= rule.relative_interval)
        };
        let tasks =
            || self.rounds.iter().zip(&self.samples).filter(|(rounds, _)| !rounds.is_empty());
        self.passes.len() >= LEAST_PASSES as usize
            && (self.passes.iter().sum::<usize>() >= MOST_ROUNDS || tasks().all(narrow))
    }
}

impl Sample {
    /// What of rounds with such samples is the estimate for all rays.
    fn center(self) -> Center {
        match self {
            Self::Whole => Center::Median,
            Self::Blocks { .. } => Center::Mean,
        }
    }

    /// What a record notes of it.
    pub(super) fn record(self, rays: usize) -> Option<BlockSample> {
        match self {
            Self::Whole => None,
            Self::Blocks { size, count, .. } => Some(BlockSample {
                blocks: count as u64,
                rays_per_block: size as u64,
                of_rays: rays as u64,
            }),
        }
    }
}
