//! A number that was measured several times: its median and how uncertain that is.

use serde::{Deserialize, Serialize};

/// A 95 % interval.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Interval {
    /// The lower end: the value lies below it with a probability of at most 2.5 %.
    pub low: f64,
    /// The upper end: the value lies above it with a probability of at most 2.5 %.
    pub high: f64,
}

/// A median and its interval.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Estimate {
    /// The median.
    pub median: f64,
    /// The 95 % interval of the median; absent where there were too few values for one.
    pub interval: Option<Interval>,
    /// How many values there were.
    pub rounds: usize,
}

impl Estimate {
    /// Half the interval's width, as a share of the median.
    #[must_use]
    pub fn relative_half_width(&self) -> Option<f64> {
        let interval = self.interval?;
        (self.median != 0.0).then(|| (interval.high - interval.low) / 2.0 / self.median.abs())
    }

    /// The estimate of a monotone function of the value: the function maps median and quantiles to
    /// median and quantiles.
    #[must_use]
    pub fn map(&self, f: impl Fn(f64) -> f64) -> Self {
        let interval = self.interval.map(|interval| {
            let (a, b) = (f(interval.low), f(interval.high));
            Interval { low: a.min(b), high: a.max(b) }
        });
        Self { median: f(self.median), interval, rounds: self.rounds }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_falling_function_swaps_the_ends_of_the_interval() {
        let interval = Some(Interval { low: 2.0, high: 5.0 });
        let inverse = Estimate { median: 4.0, interval, rounds: 9 }.map(|x| 1.0 / x);
        assert_eq!(inverse.interval, Some(Interval { low: 0.2, high: 0.5 }));
        assert_eq!((inverse.median, inverse.rounds), (0.25, 9));
    }

    #[test]
    fn the_half_width_is_a_share_of_the_median() {
        let estimate = |interval| Estimate { median: -4.0, interval, rounds: 9 };
        let interval = Interval { low: -5.0, high: -3.0 };
        assert_eq!(estimate(Some(interval)).relative_half_width(), Some(0.25));
        assert_eq!(estimate(None).relative_half_width(), None);
    }
}
