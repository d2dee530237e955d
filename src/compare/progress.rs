//! How far the whole plan is, told as parts of it advance.

use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, Thread};
use std::time::Duration;

use super::budget::Budget;
use super::observer::Observer;

/// How often an observer hears how far a part is.
const EVERY: Duration = Duration::from_millis(100);

/// Tells an observer of one part of the plan: that which lies between two shares of the whole.
pub(super) struct Progress<'a> {
    pub(super) observer: &'a dyn Observer,
    pub(super) from: f64,
    pub(super) to: f64,
}

impl Progress<'_> {
    /// Whether to stop.
    pub(super) fn cancelled(&self) -> bool {
        self.observer.cancelled()
    }

    /// A step begins, when so much of the part's time is spent.
    pub(super) fn step(&self, what: &str, budget: Budget) {
        self.observer.begins(what);
        self.tell(budget);
    }

    /// Tells how far the part is by the time that it has taken.
    fn tell(&self, budget: Budget) {
        self.observer.advanced(self.from + (self.to - self.from) * budget.spent());
    }

    /// Runs the part, and goes on telling meanwhile.
    pub(super) fn watch<T>(&self, budget: Budget, work: impl FnOnce() -> T) -> T {
        let done = AtomicBool::new(false);
        let result = thread::scope(|scope| {
            let teller = scope.spawn(|| {
                while !done.load(Ordering::Relaxed) {
                    thread::park_timeout(EVERY);
                    self.tell(budget);
                }
            });
            let _end = End { done: &done, teller: teller.thread().clone() };
            work()
        });
        self.observer.advanced(self.to);
        result
    }
}

/// Ends the telling however the part ends: a scope waits for its threads even in a panic.
struct End<'a> {
    done: &'a AtomicBool,
    teller: Thread,
}

impl Drop for End<'_> {
    fn drop(&mut self) {
        self.done.store(true, Ordering::Relaxed);
        self.teller.unpark();
    }
}
