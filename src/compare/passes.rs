//! Passes over all classes of rays, apart in time, each with structures that were built anew.
//!
//! What a structure's place in memory and the state of the machine do to it for seconds is the same for all rounds that
//! follow each other. A pass after others sees another state, and a structure built anew lies elsewhere. So intervals
//! come from the differences between passes (`analysis/statistics/replicates.rs`).

use std::time::Duration;

use crate::record::{Round, RoundRule};

use super::block_sample::Block;
use super::budget::Budget;
use super::class_rounds::{ClassRounds, LEAST_PASSES, least_rounds_of_pass};
use super::rounds::Repeat;

/// The share of the time for rays that building anew may take, in as many passes as there are at least.
const SHARE_OF_BUILDS: f64 = 0.25;

/// A pass has so many times the least number of rounds at most: more passes say more than longer ones.
const LONGEST_PASS: u32 = 5;

/// What is measured in passes.
pub(super) trait Measured {
    /// Builds all structures anew, each elsewhere in memory than before.
    fn build_anew(&mut self);

    /// Traces blocks of a class with a task's structure; `None` if it fails.
    fn trace(&mut self, class: usize, task: usize, blocks: &[Block]) -> Option<Round>;
}

/// When passes end, and how long their parts take.
pub(super) struct Passes<'a> {
    pub(super) rule: RoundRule,
    pub(super) budget: Budget,
    /// Whether to stop at once.
    pub(super) cancelled: &'a dyn Fn() -> bool,
    /// The time to build all structures anew; `None` if that is too long to be repeated.
    pub(super) build_time: Option<Duration>,
}

/// The time that building anew takes in each pass but the first, if that is not too much.
pub(super) fn affordable_builds(build_time: Duration, budget: Budget) -> Option<Duration> {
    let all = build_time.saturating_mul(LEAST_PASSES - 1);
    (all <= budget.left().mul_f64(SHARE_OF_BUILDS)).then_some(build_time)
}

impl Passes<'_> {
    /// What the builds of the fewest passes leave of the budget.
    pub(super) fn time_for_rounds(&self) -> Duration {
        let builds = self.build_time.unwrap_or_default() * (LEAST_PASSES - 1);
        self.budget.left().saturating_sub(builds)
    }

    /// Runs passes over classes until each has enough or the budget is spent, but at least one. `false` if it was
    /// cancelled.
    pub(super) fn run(&self, classes: &mut [ClassRounds], measured: &mut impl Measured) -> bool {
        let mut open: Vec<usize> = (0..classes.len()).collect();
        for pass in 0.. {
            if open.is_empty() || (pass > 0 && self.budget.is_spent()) {
                break;
            }
            if pass > 0 && self.build_time.is_some() {
                measured.build_anew();
            }
            // The rounds of a pass take at least as long as what makes it a pass.
            let least = self.build_time.unwrap_or_default().div_f64(open.len() as f64);
            for &class in &open {
                if (self.cancelled)() {
                    return false;
                }
                self.run_class(&mut classes[class], least, |task, blocks| {
                    measured.trace(class, task, blocks)
                });
            }
            open.retain(|&class| !classes[class].has_enough(&self.rule));
        }
        !(self.cancelled)()
    }

    /// The rounds of a class in a pass: as many as the rule asks for, then more for up to `least`.
    fn run_class(
        &self,
        class: &mut ClassRounds,
        least: Duration,
        run: impl FnMut(usize, &[Block]) -> Option<Round>,
    ) {
        let at_least = least_rounds_of_pass(&self.rule);
        let wanted = least.as_secs_f64() / class.round_time.as_secs_f64().max(1e-9);
        let rounds = (wanted as u32).clamp(at_least, LONGEST_PASS * at_least);
        let rule = RoundRule { at_least: rounds, ..self.rule.clone() };
        let repeat =
            Repeat { at_most: rounds as usize, ..Repeat::new(rule, self.budget, self.cancelled) };
        class.run_pass(&repeat, run);
    }
}

#[cfg(test)]
mod tests;
