//! How much of the whole plan is done, reported as one part of it advances.

use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, Thread};
use std::time::Duration;

use super::budget::Budget;
use super::observer::Observer;

/// How often an observer is informed while a part is under way.
const EVERY: Duration = Duration::from_millis(100);

/// One part of the plan: that which lies between two shares of the whole.
pub(super) struct PartProgress<'a> {
    pub(super) observer: &'a dyn Observer,
    pub(super) from: f64,
    pub(super) to: f64,
}

impl PartProgress<'_> {
    /// Whether to stop.
    pub(super) fn cancelled(&self) -> bool {
        self.observer.cancelled()
    }

    /// A step begins, when so much of the part's time is spent.
    pub(super) fn step(&self, what: &str, budget: Budget) {
        self.observer.begins(what);
        self.report(budget);
    }

    /// Reports how much is done by the time that the part has taken.
    fn report(&self, budget: Budget) {
        self.observer.advanced(self.from + (self.to - self.from) * budget.spent());
    }

    /// Runs the part, and reports at intervals meanwhile.
    pub(super) fn watch<T>(&self, budget: Budget, work: impl FnOnce() -> T) -> T {
        let done = AtomicBool::new(false);
        let result = thread::scope(|scope| {
            let reporter = scope.spawn(|| {
                while !done.load(Ordering::Relaxed) {
                    thread::park_timeout(EVERY);
                    self.report(budget);
                }
            });
            let _end = End { done: &done, reporter: reporter.thread().clone() };
            work()
        });
        self.observer.advanced(self.to);
        result
    }
}

/// Ends the reports however the part ends: a scope waits for its threads even in a panic.
struct End<'a> {
    done: &'a AtomicBool,
    reporter: Thread,
}

impl Drop for End<'_> {
    fn drop(&mut self) {
        self.done.store(true, Ordering::Relaxed);
        self.reporter.unpark();
    }
}
