//! Time to spend, in shares. Knows nothing of what it is spent on.

use std::sync::OnceLock;
use std::time::{Duration, Instant};

/// The time that shares are taken of where there is no limit: rounds then end by their rule.
const UNLIMITED: Duration = Duration::from_secs(600);

/// The time since some moment.
pub(super) type Clock = fn() -> Duration;

/// A part of the time of a comparison.
#[derive(Clone, Copy, Debug)]
pub(super) struct Budget {
    clock: Clock,
    start: Duration,
    length: Duration,
}

/// The time since this was called first.
fn system_clock() -> Duration {
    static FIRST: OnceLock<Instant> = OnceLock::new();
    FIRST.get_or_init(Instant::now).elapsed()
}

impl Budget {
    /// All of it, from now on; `None` has room for every round of the rule.
    pub(super) fn from_now(length: Option<Duration>) -> Self {
        Self::by(system_clock, length.unwrap_or(UNLIMITED))
    }

    /// One that is never spent.
    pub(super) fn endless() -> Self {
        Self::by(system_clock, Duration::MAX)
    }

    /// All of it, from now on by some clock.
    pub(super) fn by(clock: Clock, length: Duration) -> Self {
        Self { clock, start: clock(), length }
    }

    /// What is left.
    pub(super) fn left(&self) -> Duration {
        self.length.saturating_sub(self.elapsed())
    }

    /// Whether nothing is left.
    pub(super) fn is_spent(&self) -> bool {
        self.left().is_zero()
    }

    /// A share of what is left, from now on.
    pub(super) fn share(&self, share: f64) -> Self {
        Self::by(self.clock, self.left().mul_f64(share.clamp(0.0, 1.0)))
    }

    /// The share of it that is spent, from 0 to 1.
    pub(super) fn spent(&self) -> f64 {
        let length = self.length.as_secs_f64();
        if length > 0.0 { (self.elapsed().as_secs_f64() / length).min(1.0) } else { 1.0 }
    }

    fn elapsed(&self) -> Duration {
        (self.clock)().saturating_sub(self.start)
    }
}
