//! Interleaved rounds: what slows the machine for a while slows all that are compared.
//!
//! Round n of one lane runs beside round n of every other, and each round begins with another
//! lane. Knows nothing of rays or structures: a lane is a number.

use crate::analysis::statistics::estimate;
use crate::record::RoundRule;

use super::budget::Budget;

/// Rounds after which more are no longer worth waiting for.
const MOST_ROUNDS: usize = 400;

/// Intervals are computed anew after so many rounds; that takes some time of its own.
const CHECK_EVERY: usize = 5;

/// How a repetition ends.
pub(super) struct Repeat<'a> {
    pub(super) rule: &'a RoundRule,
    pub(super) budget: Budget,
    /// Whether to stop at once.
    pub(super) cancelled: &'a dyn Fn() -> bool,
}

/// Runs rounds of `lanes` lanes, and keeps every one but those that warm up: entry `[lane][n]` is
/// round n of a lane.
///
/// Rounds end when the rule is met or the budget is spent, but not before the first round that
/// counts is whole. `run` is given the lane, and gives its round and the time of it; a lane that
/// gives `None` leaves, with what it has.
pub(super) fn interleaved<R>(
    lanes: usize,
    repeat: &Repeat<'_>,
    mut run: impl FnMut(usize) -> Option<(R, u64)>,
) -> Vec<Vec<R>> {
    let mut rounds: Vec<Vec<R>> = (0..lanes).map(|_| Vec::new()).collect();
    let mut times: Vec<Vec<f64>> = vec![Vec::new(); lanes];
    let mut left: Vec<bool> = vec![false; lanes];
    let warmup = repeat.rule.warmup as usize;
    for number in 0.. {
        let kept = number.max(warmup) - warmup;
        let done = left.iter().all(|&left| left)
            || (kept > 0
                && (repeat.budget.is_spent() || is_enough(repeat.rule, kept, &times, &left)));
        if done || (repeat.cancelled)() {
            break;
        }
        let mut round: Vec<Option<(R, u64)>> = (0..lanes).map(|_| None).collect();
        for place in 0..lanes {
            let lane = (number + place) % lanes;
            if left[lane] {
                continue;
            }
            // A round that is not whole has no partner to be compared with.
            if (repeat.cancelled)() {
                return rounds;
            }
            round[lane] = run(lane);
            left[lane] = round[lane].is_none();
        }
        if number >= warmup {
            for (lane, result) in round.into_iter().enumerate() {
                if let Some((round, time)) = result {
                    rounds[lane].push(round);
                    times[lane].push(time as f64);
                }
            }
        }
    }
    rounds
}

/// Whether there are enough rounds, and every lane's median is known well enough.
fn is_enough(rule: &RoundRule, kept: usize, times: &[Vec<f64>], left: &[bool]) -> bool {
    if kept < rule.at_least as usize {
        return false;
    }
    let narrow = |times: &[f64]| {
        let width = estimate(times).and_then(|estimate| estimate.relative_half_width());
        width.is_some_and(|width| width <= rule.relative_interval)
    };
    let lanes = || times.iter().zip(left).filter(|(_, left)| !**left);
    kept >= MOST_ROUNDS
        || (kept.is_multiple_of(CHECK_EVERY) && lanes().all(|(times, _)| narrow(times)))
}

#[cfg(test)]
mod tests {
    use std::cell::{Cell, RefCell};
    use std::time::Duration;

    use super::*;

    fn rule(warmup: u32, at_least: u32) -> RoundRule {
        RoundRule { warmup, at_least, relative_interval: 0.02 }
    }

    #[test]
    fn rounds_are_interleaved_rotated_and_kept() {
        let rule = rule(1, 10);
        let repeat = Repeat { rule: &rule, budget: Budget::from_now(None), cancelled: &|| false };
        let order = RefCell::new(Vec::new());
        let rounds = interleaved(3, &repeat, |lane| {
            order.borrow_mut().push(lane);
            Some((order.borrow().len(), 1_000))
        });
        // Equal times have an interval of no width: ten rounds, and one to warm up.
        assert_eq!(order.borrow()[..9], [0, 1, 2, 1, 2, 0, 2, 0, 1]);
        assert_eq!(order.borrow().len(), 33);
        assert!(rounds.iter().all(|lane| lane.len() == 10));
        assert_eq!(rounds[1][..2], [4, 9], "the first round is dropped, every other kept in order");
    }

    #[test]
    fn a_spent_budget_leaves_one_round() {
        let rule = rule(0, 10);
        let budget = Budget::from_now(Some(Duration::ZERO));
        let repeat = Repeat { rule: &rule, budget, cancelled: &|| false };
        assert_eq!(interleaved(2, &repeat, |lane| Some((lane, 1))), [[0], [1]]);
    }

    #[test]
    fn whoever_fails_leaves_and_the_others_go_on() {
        let rule = rule(0, 10);
        let repeat = Repeat { rule: &rule, budget: Budget::from_now(None), cancelled: &|| false };
        let calls = Cell::new(0);
        let rounds = interleaved(2, &repeat, |lane| {
            calls.set(calls.get() + 1);
            (lane == 1 || calls.get() < 4).then_some(((), 5))
        });
        assert_eq!((rounds[0].len(), rounds[1].len()), (1, 10));
    }

    #[test]
    fn a_round_that_was_cut_off_is_not_kept() {
        let rule = rule(0, 10);
        let calls = Cell::new(0);
        let cancelled = || calls.get() == 3;
        let repeat = Repeat { rule: &rule, budget: Budget::from_now(None), cancelled: &cancelled };
        let rounds = interleaved(2, &repeat, |_| {
            calls.set(calls.get() + 1);
            Some(((), 5))
        });
        assert_eq!((rounds[0].len(), rounds[1].len()), (1, 1));
    }
}
