//! The rounds of a class of rays: how many rays each structure traces in one, and which.
//!
//! Knows neither structures nor rays: a task is a number, a ray is a place. So a test can run it by a clock of its own.

use std::time::Duration;

use crate::analysis::statistics::Center;
use crate::record::{BlockSample, Round, RoundRule};

use super::block_sample::{Block, Sample, shares};
use super::budget::Budget;
use super::rounds::{Repeat, interleaved};
use super::trial::affordable;

/// A round may always take this long, even if the budget is spent: a quick structure is not left
/// out because others were slow.
const LEAST_ROUND: Duration = Duration::from_millis(2);

/// How many rays are counted for each that a structure has time for in a round: counting happens once.
const COUNTED_ROUNDS: usize = 4;

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

/// The part of each task in the rounds of a class of `rays` rays: as many rays as its share of the budget allows for in
/// as many rounds as the rule asks for. `ray_times` are the times of a ray of each task.
pub(super) fn round_shares(
    ray_times: &[Duration],
    rays: usize,
    rule: &RoundRule,
    budget: Budget,
) -> Vec<RoundShare> {
    let rounds = rule.at_least + rule.warmup + 1; // one more to count
    let all = u32::try_from(rays).unwrap_or(u32::MAX);
    let needs: Vec<Duration> = ray_times.iter().map(|time| time.saturating_mul(all)).collect();
    let times = shares(&needs, budget.left() / rounds);
    let share = |(time, ray_time): (Duration, &Duration)| {
        let time = time.max(LEAST_ROUND);
        let affordable = affordable(Some(*ray_time), time);
        let timed = Sample::that_fits(rays, affordable);
        let counted = Sample::that_fits(rays, affordable.saturating_mul(COUNTED_ROUNDS));
        RoundShare {
            time,
            samples: timed.zip(counted).map(|(timed, counted)| Samples { timed, counted }),
        }
    };
    times.into_iter().zip(ray_times).map(share).collect()
}

/// Runs rounds of tasks, each with its sample of `rays` rays, drawn by the seed. `run` traces a task's blocks and
/// returns the round, or `None` if the structure fails.
pub(super) fn class_rounds(
    samples: &[Sample],
    rays: usize,
    seed: u64,
    repeat: &Repeat<'_>,
    mut run: impl FnMut(usize, &[Block]) -> Option<Round>,
) -> Vec<Vec<Round>> {
    let center = |sample: &Sample| match sample {
        Sample::Whole => Center::Median,
        Sample::Blocks { .. } => Center::Mean,
    };
    let centers: Vec<Center> = samples.iter().map(center).collect();
    let repeat = Repeat { centers: &centers, ..repeat.clone() };
    interleaved(samples.len(), &repeat, |task, number| {
        let round = run(task, &samples[task].draw(rays, seed, number))?;
        Some((round, round.own_ns()))
    })
}

impl Sample {
    /// What a record notes of it.
    pub(super) fn record(self, rays: usize) -> Option<BlockSample> {
        match self {
            Self::Whole => None,
            Self::Blocks { size, count } => Some(BlockSample {
                blocks: count as u64,
                rays_per_block: size as u64,
                of_rays: rays as u64,
            }),
        }
    }
}

#[cfg(test)]
mod tests;
