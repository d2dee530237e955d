//! What differs from run to run, and is seen by none of the rounds of one run.
//!
//! The neighbours of a virtual machine, the temperature, where the system put the program in memory: all passes of a
//! run share them. T. Kalibera and R. Jones (*Rigorous benchmarking in reasonable time*, ISMM 2013) measure such a
//! level by repeating it. A single run cannot. It takes the standard deviation from elsewhere, and adds it to what it
//! saw itself by the sum of squares: an evaluation of type B in the terms of JCGM 100:2008, *Guide to the expression of
//! uncertainty in measurement*, 4.3 and 5.1.

use super::risk::Risk;
use crate::record::{Estimate, Interval};

/// The relative standard deviation of a time, or of a ratio of times, between runs of the same program on the same
/// machine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BetweenRuns(pub f64);

impl BetweenRuns {
    /// The same estimate with an interval for any run. One without an interval gets none: too little was seen.
    #[must_use]
    pub fn widen(self, estimate: Estimate) -> Estimate {
        self.widen_at(estimate, Risk::USUAL)
    }

    /// The same for an interval of another risk.
    #[must_use]
    pub fn widen_at(self, estimate: Estimate, risk: Risk) -> Estimate {
        let allowance = risk.normal() * self.0;
        let reach = |end: f64| (end / estimate.value).ln().hypot(allowance).exp();
        let interval = estimate.interval.filter(|_| self.0 > 0.0).map(|own| Interval {
            low: estimate.value / reach(own.low),
            high: estimate.value * reach(own.high),
        });
        // The logarithm of a time of nothing is no number: such an interval stays.
        let finite = |interval: &Interval| interval.low.is_finite() && interval.high.is_finite();
        Estimate { interval: interval.filter(finite).or(estimate.interval), ..estimate }
    }

    /// For what is compared of two runs, each with a deviation of its own.
    #[must_use]
    pub fn of_two_runs(self) -> Self {
        Self(self.0 * std::f64::consts::SQRT_2)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Random;

    /// Half the width of a normal distribution's 95 % interval, in standard deviations.
    const NORMAL: f64 = 1.959_963_984_540_054;

    fn estimate(low: f64, value: f64, high: f64) -> Estimate {
        Estimate { value, interval: Some(Interval { low, high }), rounds: 9 }
    }

    #[test]
    fn squares_of_the_logarithms_add_up_at_each_end() {
        let own = estimate(100.0 / 1.03, 100.0, 100.0 * 1.08);
        let widened = BetweenRuns(0.02).widen(own).interval.unwrap();
        let allowance = (0.02 * NORMAL).powi(2);
        let low = (1.03_f64.ln().powi(2) + allowance).sqrt().exp();
        let high = (1.08_f64.ln().powi(2) + allowance).sqrt().exp();
        assert!((widened.low * low / 100.0 - 1.0).abs() < 1e-12, "{widened:?}");
        assert!((widened.high / high / 100.0 - 1.0).abs() < 1e-12, "{widened:?}");
        assert_eq!(BetweenRuns(0.0).widen(own), own);
    }

    #[test]
    fn nothing_is_made_of_no_interval_and_of_no_time() {
        let unknown = Estimate { interval: None, ..estimate(1.0, 1.0, 1.0) };
        assert_eq!(BetweenRuns(0.1).widen(unknown), unknown);
        let nothing = estimate(0.0, 0.0, 0.0);
        assert_eq!(BetweenRuns(0.1).widen(nothing), nothing);
    }

    /// Runs whose own rounds agree within 1 % while the runs differ by 3 %: intervals of one run cover the truth with
    /// the allowance, and hardly half as often without. Of two runs, the ratio covers 1.
    #[test]
    fn intervals_cover_the_truth_of_any_run() {
        let mut random = Random::new(&[11]);
        // The sum of twelve even numbers less six has a deviation of 1.
        let mut normal = || (0..12).map(|_| f64::from(random.next_f32())).sum::<f64>() - 6.0;
        let allowed = BetweenRuns(0.03);
        let covers = |estimate: Estimate| {
            let interval = estimate.interval.unwrap();
            usize::from(interval.low <= 1.0 && 1.0 <= interval.high)
        };
        let (mut plain, mut widened, mut pairs) = (0, 0, 0);
        for _ in 0..1_000 {
            let mut run = || (0.03 * normal() + 0.01 * normal()).exp();
            let within = (0.01 * NORMAL).exp();
            let (own, other) = (run(), run());
            let seen = estimate(own / within, own, own * within);
            plain += covers(seen);
            widened += covers(allowed.widen(seen));
            let of_two = (0.01 * NORMAL * std::f64::consts::SQRT_2).exp();
            let ratio = own / other;
            let ratio = estimate(ratio / of_two, ratio, ratio * of_two);
            pairs += covers(allowed.of_two_runs().widen(ratio));
        }
        assert!(plain < 600, "{plain} of 1000");
        assert!((930..=970).contains(&widened), "{widened} of 1000");
        assert!((930..=970).contains(&pairs), "{pairs} of 1000");
    }
}
