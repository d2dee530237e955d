//! Interleaved rounds: what slows the machine for a while slows all that are compared.
//!
//! Round n of one task runs beside round n of every other, and each round begins with another
//! task. Knows nothing of rays or structures: a task is a number.

use crate::analysis::statistics::estimate;
use crate::record::RoundRule;

use super::budget::Budget;

/// Rounds after which more of them add too little.
pub(super) const MOST_ROUNDS: usize = 400;

/// The intervals are computed after every so many rounds, because that takes time too.
const CHECK_EVERY: usize = 5;

/// When a repetition ends.
#[derive(Clone)]
pub(super) struct Repeat<'a> {
    pub(super) rule: RoundRule,
    /// Rounds at most, whatever the intervals are.
    pub(super) at_most: usize,
    pub(super) budget: Budget,
    /// Whether to stop at once.
    pub(super) cancelled: &'a dyn Fn() -> bool,
}

impl<'a> Repeat<'a> {
    /// Rounds by a rule, while the budget lasts.
    pub(super) fn new(rule: RoundRule, budget: Budget, cancelled: &'a dyn Fn() -> bool) -> Self {
        Self { rule, at_most: MOST_ROUNDS, budget, cancelled }
    }
}

/// Runs a number of rounds of `tasks` tasks, after one round that warms up: entry `[task][n]` of
/// what is returned is round n of a task. `run` is given the task.
///
/// Round n of each task runs beside round n of every other, each round beginning with another task,
/// so ratios are to be taken between rounds of the same number.
pub fn fixed_rounds<R>(
    tasks: usize,
    rounds: usize,
    mut run: impl FnMut(usize) -> R,
) -> Vec<Vec<R>> {
    let at_least = u32::try_from(rounds).unwrap_or(u32::MAX);
    let rule = RoundRule { warmup: 1, at_least, relative_interval: 0.0 };
    let repeat = Repeat { at_most: rounds, ..Repeat::new(rule, Budget::endless(), &|| false) };
    interleaved(tasks, &repeat, |task, _| Some((run(task), 0)))
}

/// Runs rounds of `tasks` tasks, and keeps every one but those that warm up: entry `[task][n]` is
/// round n of a task.
///
/// Rounds end when the rule is met or the budget is spent, but not before the first round that
/// counts is whole. `run` is given the task and the number of the round, and returns its round and the
/// time of it, or `None` for a task that takes no part in further rounds.
pub(super) fn interleaved<R>(
    tasks: usize,
    repeat: &Repeat<'_>,
    mut run: impl FnMut(usize, usize) -> Option<(R, u64)>,
) -> Vec<Vec<R>> {
    let mut rounds: Vec<Vec<R>> = (0..tasks).map(|_| Vec::new()).collect();
    let mut times: Vec<Vec<f64>> = vec![Vec::new(); tasks];
    let mut ended: Vec<bool> = vec![false; tasks];
    let warmup = repeat.rule.warmup as usize;
    for number in 0.. {
        let kept = number.max(warmup) - warmup;
        let done = ended.iter().all(|&ended| ended)
            || (kept > 0 && (repeat.budget.is_spent() || is_enough(repeat, kept, &times, &ended)));
        if done || (repeat.cancelled)() {
            break;
        }
        let mut round: Vec<Option<(R, u64)>> = (0..tasks).map(|_| None).collect();
        for place in 0..tasks {
            let task = (number + place) % tasks;
            if ended[task] {
                continue;
            }
            // A round that is not whole has no partner to be compared with.
            if (repeat.cancelled)() {
                return rounds;
            }
            round[task] = run(task, number);
            ended[task] = round[task].is_none();
        }
        if number >= warmup {
            for (task, result) in round.into_iter().enumerate() {
                if let Some((round, time)) = result {
                    rounds[task].push(round);
                    times[task].push(time as f64);
                }
            }
        }
    }
    rounds
}

/// Whether there are enough rounds, and the interval of every task's median is narrow enough.
fn is_enough(repeat: &Repeat<'_>, kept: usize, times: &[Vec<f64>], ended: &[bool]) -> bool {
    let rule = &repeat.rule;
    if kept < rule.at_least as usize {
        return false;
    }
    let narrow = |times: &[f64]| {
        let width = estimate(times).and_then(|estimate| estimate.relative_half_width());
        width.is_some_and(|width| width <= rule.relative_interval)
    };
    let tasks = || times.iter().zip(ended).filter(|(_, ended)| !**ended);
    kept >= repeat.at_most
        || (kept.is_multiple_of(CHECK_EVERY) && tasks().all(|(times, _)| narrow(times)))
}

#[cfg(test)]
mod tests {
    use std::cell::{Cell, RefCell};
    use std::time::Duration;

    use super::*;

    fn repeat(warmup: u32, at_least: u32) -> Repeat<'static> {
        let rule = RoundRule { warmup, at_least, relative_interval: 0.02 };
        Repeat::new(rule, Budget::from_now(None), &|| false)
    }

    #[test]
    fn rounds_are_interleaved_rotated_and_kept() {
        let order = RefCell::new(Vec::new());
        let rounds = interleaved(3, &repeat(1, 10), |task, _| {
            order.borrow_mut().push(task);
            Some((order.borrow().len(), 1_000))
        });
        // Equal times have an interval of no width: ten rounds, and one to warm up.
        assert_eq!(order.borrow()[..9], [0, 1, 2, 1, 2, 0, 2, 0, 1]);
        assert_eq!(order.borrow().len(), 33);
        assert!(rounds.iter().all(|task| task.len() == 10));
        assert_eq!(rounds[1][..2], [4, 9], "the first round is dropped, every other kept in order");
    }

    #[test]
    fn a_fixed_number_of_rounds_follows_one_that_warms_up() {
        for count in [1, 7, 401] {
            let mut calls = 0;
            let rounds = fixed_rounds(2, count, |task| {
                calls += 1;
                (task, calls)
            });
            assert_eq!(calls, 2 * (count + 1));
            assert!(rounds.iter().all(|task| task.len() == count));
            assert_eq!((rounds[0][0], rounds[1][0]), ((0, 4), (1, 3)), "the second begins");
        }
    }

    #[test]
    fn a_spent_budget_leaves_one_round() {
        let repeat = Repeat { budget: Budget::from_now(Some(Duration::ZERO)), ..repeat(0, 10) };
        assert_eq!(interleaved(2, &repeat, |task, _| Some((task, 1))), [[0], [1]]);
    }

    #[test]
    fn a_task_that_fails_ends_and_the_others_go_on() {
        let calls = Cell::new(0);
        let rounds = interleaved(2, &repeat(0, 10), |task, _| {
            calls.set(calls.get() + 1);
            (task == 1 || calls.get() < 4).then_some(((), 5))
        });
        assert_eq!((rounds[0].len(), rounds[1].len()), (1, 10));
    }

    #[test]
    fn a_round_that_was_cut_off_is_not_kept() {
        let calls = Cell::new(0);
        let cancelled = || calls.get() == 3;
        let repeat = Repeat { cancelled: &cancelled, ..repeat(0, 10) };
        let rounds = interleaved(2, &repeat, |_, _| {
            calls.set(calls.get() + 1);
            Some(((), 5))
        });
        assert_eq!((rounds[0].len(), rounds[1].len()), (1, 1));
    }
}
