//! A number that was measured several times, and how uncertain that is.

use serde::{Deserialize, Serialize};

/// A 95 % interval.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Interval {
    /// The lower end: the value lies below it with a probability of at most 2.5 %.
    pub low: f64,
    /// The upper end: the value lies above it with a probability of at most 2.5 %.
    pub high: f64,
}

/// A value and its interval.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Estimate {
    /// Where each round measured all of a thing, the geometric mean of the passes' medians, or the median of the rounds
    /// where there are no passes. Where each measured a random sample, their mean.
    #[serde(alias = "median")]
    pub value: f64,
    /// The 95 % interval of the value; absent where there were too few rounds or passes for one.
    pub interval: Option<Interval>,
    /// How many rounds there were.
    pub rounds: usize,
}

impl Estimate {
    /// An interval that reaches further from its value than by this factor supports no statement.
    pub const WIDEST: f64 = 2.0;

    /// Whether it has an interval that is narrow enough to support a statement: only then it is charted, ranked and
    /// averaged.
    #[must_use]
    pub fn supports_a_statement(&self) -> bool {
        let within =
            |i: Interval| i.low * Self::WIDEST >= self.value && i.high <= self.value * Self::WIDEST;
        self.interval.is_some_and(within)
    }

    /// Half the interval's width, as a share of the value.
    #[must_use]
    pub fn relative_half_width(&self) -> Option<f64> {
        let interval = self.interval?;
        (self.value != 0.0).then(|| (interval.high - interval.low) / 2.0 / self.value.abs())
    }

    /// The estimate of a monotone function of the value: the function maps the ends of the interval, too.
    #[must_use]
    pub fn map(&self, f: impl Fn(f64) -> f64) -> Self {
        let interval = self.interval.map(|interval| {
            let (a, b) = (f(interval.low), f(interval.high));
            Interval { low: a.min(b), high: a.max(b) }
        });
        Self { value: f(self.value), interval, rounds: self.rounds }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_falling_function_swaps_the_ends_of_the_interval() {
        let interval = Some(Interval { low: 2.0, high: 5.0 });
        let inverse = Estimate { value: 4.0, interval, rounds: 9 }.map(|x| 1.0 / x);
        assert_eq!(inverse.interval, Some(Interval { low: 0.2, high: 0.5 }));
        assert_eq!((inverse.value, inverse.rounds), (0.25, 9));
    }

    #[test]
    fn the_half_width_is_a_share_of_the_value() {
        let estimate = |interval| Estimate { value: -4.0, interval, rounds: 9 };
        let interval = Interval { low: -5.0, high: -3.0 };
        assert_eq!(estimate(Some(interval)).relative_half_width(), Some(0.25));
        assert_eq!(estimate(None).relative_half_width(), None);
    }

    #[test]
    fn an_interval_beyond_a_factor_of_two_supports_no_statement() {
        let estimate = |low, high| {
            let interval = Some(Interval { low, high });
            Estimate { value: 10.0, interval, rounds: 9 }
        };
        assert!(estimate(5.0, 20.0).supports_a_statement());
        assert!(!estimate(4.9, 11.0).supports_a_statement());
        assert!(!estimate(9.0, 20.1).supports_a_statement());
        assert!(!Estimate { interval: None, ..estimate(10.0, 10.0) }.supports_a_statement());
    }
}
