//! Rounds as replicates of one measurement: the value that they estimate, for the whole of what they sampled.
//!
//! Where each round measured everything, the rounds differ by the noise of the machine alone, and their median is the
//! estimate. Where each round drew a random sample of its own, the rounds are independent replicates whose mean is
//! unbiased for the whole, while a median is not. The differences between such rounds contain both the machine's noise
//! and what the choice of the sample adds, so an interval from the rounds includes both. This is the method of
//! independent random groups (K. M. Wolter: *Introduction to Variance Estimation*, 2nd edition, 2007, chapter 2), each
//! of them a stratified random sample (W. G. Cochran: *Sampling Techniques*, 3rd edition, 1977, chapter 5).
//!
//! Rounds that follow each other are not independent: they share the clock rate and the neighbours of that moment, and
//! the place in memory where a structure was built. So rounds come in passes, apart in time and each with structures
//! built anew, and where there are passes, these are the replicates: an interval comes from the differences between
//! them, as T. Kalibera and R. Jones advise (*Rigorous benchmarking in reasonable time*, ISMM 2013) for levels of
//! repetition. A few passes over skewed samples may happen to agree, all of them without the rare costly rays. So where
//! rounds are samples, they are looked at as replicates too, and the larger of both standard errors counts.
//!
//! A ratio is that of two such estimates. Its interval is the textbook's for a ratio estimator (Cochran, chapter 6):
//! Student's, from the residues of rounds of the same number, whose common part cancels. It is taken for the logarithm,
//! since a time cannot be negative.

use super::estimate::{all_finite, estimate, median};
use super::ratio::{paired_ratio, unpaired_ratio};
use crate::record::{Estimate, Interval};

/// The least number of replicates from which an interval is made: the spread of three values is itself hardly known.
const LEAST_REPLICATES: usize = 4;

/// What of the rounds is the estimate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Center {
    /// The median: each round measured everything.
    Median,
    /// The mean: each round measured a random sample of its own.
    Mean,
}

/// The rounds of a measurement.
#[derive(Clone, Debug, PartialEq)]
pub struct Rounds {
    /// A value for each round, in their order.
    pub values: Vec<f64>,
    /// What of them is the estimate.
    pub center: Center,
    /// How many of the values each pass has, in their order. Empty if they were measured without passes: each is a
    /// replicate then.
    pub passes: Vec<usize>,
}

impl Rounds {
    /// The estimated value. `None` without values, or if one is not finite.
    #[must_use]
    pub fn value(&self) -> Option<f64> {
        match self.center {
            Center::Median => median(&self.values),
            Center::Mean => all_finite(&self.values).then(|| mean(&self.values)).flatten(),
        }
    }

    /// The value and its interval. `None` without values, or if one is not finite.
    #[must_use]
    pub fn estimate(&self) -> Option<Estimate> {
        if self.is_plain() {
            return estimate(&self.values);
        }
        let value = self.value()?;
        let residues: Vec<f64> = self.values.iter().map(|own| own / value - 1.0).collect();
        Some(self.with_student_interval(value, &residues, self.center))
    }

    /// Whether each round is a replicate of everything: then there is an exact interval of the median.
    fn is_plain(&self) -> bool {
        self.center == Center::Median && self.passes.is_empty()
    }

    /// A value with Student's interval of its logarithm. `residues` are the relative errors of the rounds; those of a
    /// pass are one error, their median or mean.
    fn with_student_interval(&self, value: f64, residues: &[f64], center: Center) -> Estimate {
        let rounds = residues.len();
        let replicates = match self.passes.as_slice() {
            [] => residues.to_vec(),
            passes => errors_of_passes(residues, passes, center),
        };
        // Each round drew a sample of its own: what the choice adds is seen better in all rounds than in few passes.
        let of_rounds = if center == Center::Mean { standard_error(residues) } else { None };
        let reach = standard_error(&replicates)
            .map(|error| error.max(of_rounds.unwrap_or(0.0)))
            .map(|error| (student_quantile(replicates.len() - 1) * error).exp());
        let interval = reach
            .filter(|reach| reach.is_finite() && value.is_finite())
            .map(|reach| Interval { low: value / reach, high: value * reach });
        Estimate { value, interval, rounds }
    }
}

/// The error of each pass. Rounds beyond the residues are left out, as are passes without any.
fn errors_of_passes(residues: &[f64], passes: &[usize], center: Center) -> Vec<f64> {
    let mut left = residues;
    let mut error = |&rounds: &usize| {
        let (own, rest) = left.split_at(rounds.min(left.len()));
        left = rest;
        match center {
            Center::Median => median(own),
            Center::Mean => mean(own),
        }
    };
    passes.iter().filter_map(&mut error).collect()
}

/// How many times as fast as the base: the base's estimate over the own one, for rounds that were interleaved.
///
/// Rounds that only one of both has are left out of a median's ratios and of the interval. `None` if one has no value,
/// or if the ratio is not finite.
#[must_use]
pub fn ratio_of_estimates(base: &Rounds, own: &Rounds) -> Option<Estimate> {
    let values = || base.values.iter().zip(&own.values);
    if base.center == Center::Median && own.center == Center::Median {
        let plain = paired_ratio(&base.values, &own.values)?;
        if own.is_plain() {
            return Some(plain);
        }
        let residues: Vec<f64> = values().map(|(b, o)| b / o / plain.value - 1.0).collect();
        return Some(own.with_student_interval(plain.value, &residues, Center::Median));
    }
    let (base_value, own_value) = (base.value()?, own.value()?);
    let ratio = base_value / own_value;
    let residues: Vec<f64> = values().map(|(b, o)| b / base_value - o / own_value).collect();
    ratio.is_finite().then(|| own.with_student_interval(ratio, &residues, Center::Mean))
}

/// The same for rounds that were not interleaved, such as those of two runs.
#[must_use]
pub fn unpaired_ratio_of_estimates(base: &Rounds, own: &Rounds) -> Option<Estimate> {
    if base.is_plain() && own.is_plain() {
        return unpaired_ratio(&base.values, &own.values);
    }
    let (base, own) = (base.estimate()?, own.estimate()?);
    let value = base.value / own.value;
    // Independent errors of logarithms: their squares add up. Each end of the quotient takes the end of the base on its
    // own side, and the opposite one of the other.
    let reach = |a: f64, b: f64| a.ln().hypot(b.ln()).exp();
    let interval = base.interval.zip(own.interval).map(|(b, o)| Interval {
        low: value / reach(base.value / b.low, o.high / own.value),
        high: value * reach(b.high / base.value, own.value / o.low),
    });
    let interval = interval.filter(|i| i.low.is_finite() && i.high.is_finite());
    value.is_finite().then_some(Estimate { value, interval, rounds: base.rounds.min(own.rounds) })
}

/// The standard error of the mean of some values; `None` for too few.
fn standard_error(values: &[f64]) -> Option<f64> {
    let mean = mean(values).filter(|_| values.len() >= LEAST_REPLICATES)?;
    let n = values.len() as f64;
    let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    Some((squares / (n - 1.0) / n).sqrt())
}

fn mean(values: &[f64]) -> Option<f64> {
    (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
}

/// The 97.5 % quantile of Student's distribution: the expansion in the normal quantile of Abramowitz, Stegun:
/// *Handbook of Mathematical Functions*, 26.7.5, within 0.3 % from three degrees of freedom on.
fn student_quantile(degrees: usize) -> f64 {
    const NORMAL: f64 = 1.959_963_984_540_054;
    let (x, n) = (NORMAL, degrees as f64);
    let terms = [
        (x.powi(3) + x) / 4.0,
        (5.0 * x.powi(5) + 16.0 * x.powi(3) + 3.0 * x) / 96.0,
        (3.0 * x.powi(7) + 19.0 * x.powi(5) + 17.0 * x.powi(3) - 15.0 * x) / 384.0,
        (79.0 * x.powi(9) + 776.0 * x.powi(7) + 1_482.0 * x.powi(5)
            - 1_920.0 * x.powi(3)
            - 945.0 * x)
            / 92_160.0,
    ];
    let of_term = |(term, power): (&f64, i32)| term / n.powi(power);
    x + terms.iter().zip(1..).map(of_term).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Random;

    fn means(values: &[f64]) -> Rounds {
        Rounds { values: values.to_vec(), center: Center::Mean, passes: Vec::new() }
    }

    fn medians(values: &[f64]) -> Rounds {
        Rounds { values: values.to_vec(), center: Center::Median, passes: Vec::new() }
    }

    #[test]
    fn quantiles_are_those_of_the_tables() {
        let tables = [(3, 3.182), (4, 2.776), (5, 2.571), (9, 2.262), (30, 2.042), (400, 1.966)];
        for (degrees, quantile) in tables {
            let own = student_quantile(degrees);
            assert!((own / quantile - 1.0).abs() < 0.004, "{degrees}: {own}");
        }
    }

    #[test]
    fn the_estimate_of_samples_is_their_mean_whatever_their_distribution() {
        let estimate = means(&[1.0, 1.0, 1.0, 9.0]).estimate().unwrap();
        assert_eq!((estimate.value, estimate.rounds), (3.0, 4));
        let interval = estimate.interval.unwrap();
        assert!(interval.low > 0.0 && interval.low < 1.0 && interval.high > 9.0, "{interval:?}");
        assert_eq!(means(&[1.0, 2.0, 3.0]).estimate().unwrap().interval, None);
        assert_eq!(means(&[]).estimate(), None);
        assert_eq!(means(&[1.0, f64::NAN]).estimate(), None);
    }

    #[test]
    fn what_two_samples_share_cancels_in_their_ratio() {
        let own = means(&[1.0, 4.0, 2.0, 8.0, 5.0]);
        let base = means(&[3.0, 12.0, 6.0, 24.0, 15.0]);
        let ratio = ratio_of_estimates(&base, &own).unwrap();
        let interval = ratio.interval.unwrap();
        assert!((ratio.value - 3.0).abs() < 1e-12);
        assert!((interval.high / interval.low - 1.0).abs() < 1e-12, "{interval:?}");
        let unpaired = unpaired_ratio_of_estimates(&base, &own).unwrap().interval.unwrap();
        assert!(unpaired.low < 1.5 && unpaired.high > 6.0, "{unpaired:?}");
    }

    #[test]
    fn a_ratio_to_a_whole_is_that_of_mean_and_median() {
        let ratio = ratio_of_estimates(&means(&[8.0, 12.0, 8.0, 12.0]), &medians(&[2.0; 4]));
        assert_eq!(ratio.unwrap().value, 5.0);
        assert_eq!(ratio_of_estimates(&means(&[1.0; 4]), &medians(&[0.0; 4])), None);
        assert_eq!(ratio_of_estimates(&means(&[]), &medians(&[1.0; 4])), None);
    }

    #[test]
    fn what_a_pass_shares_widens_the_interval_though_its_rounds_agree() {
        let values: Vec<f64> = [1.0, 1.2, 0.9, 1.1, 1.0].into_iter().flat_map(|v| [v; 4]).collect();
        for center in [Center::Median, Center::Mean] {
            let rounds = Rounds { values: values.clone(), center, passes: vec![4; 5] };
            let apart = Rounds { passes: Vec::new(), ..rounds.clone() };
            let width = |rounds: &Rounds| {
                let estimate = rounds.estimate().unwrap();
                assert!((estimate.value - 1.02).abs() < 0.03 && estimate.rounds == 20);
                estimate.relative_half_width().unwrap()
            };
            assert!((0.13..0.17).contains(&width(&rounds)), "{}", width(&rounds));
            assert!(width(&apart) < 0.11, "{}", width(&apart));
            // Two passes are too few, however many rounds they have.
            let few = Rounds { passes: vec![10, 10], ..rounds.clone() };
            assert_eq!(few.estimate().unwrap().interval, None);
            // What both share cancels in the ratio.
            let twice =
                Rounds { values: values.iter().map(|v| 2.0 * v).collect(), ..rounds.clone() };
            let ratio = ratio_of_estimates(&twice, &rounds).unwrap();
            assert!((ratio.value - 2.0).abs() < 1e-12, "{ratio:?}");
            assert!(ratio.relative_half_width().unwrap() < 1e-12, "{ratio:?}");
            let unpaired = unpaired_ratio_of_estimates(&twice, &rounds).unwrap();
            assert!(unpaired.relative_half_width().unwrap() > 0.15, "{unpaired:?}");
        }
    }

    /// Of 95 % intervals about nineteen in twenty contain the truth, for costs as skewed as those of rays.
    #[test]
    fn intervals_cover_the_truth_as_often_as_they_claim() {
        let mut random = Random::new(&[5]);
        let mut covered = 0;
        for _ in 0..1_000 {
            // Each round is the mean of sixteen costs, exponentially distributed with mean 1.
            let mut cost = || -f64::from(1.0 - random.next_f32()).ln();
            let round = |_| (0..16).map(|_| cost()).sum::<f64>() / 16.0;
            let interval = means(&(0..10).map(round).collect::<Vec<_>>()).estimate().unwrap();
            let interval = interval.interval.unwrap();
            covered += usize::from(interval.low <= 1.0 && 1.0 <= interval.high);
        }
        assert!((930..=970).contains(&covered), "{covered} of 1000");
    }

    /// Where a twentieth of the samples holds half of the cost, five passes of four rounds may miss it.
    #[test]
    fn passes_over_skewed_samples_cover_the_truth() {
        let mut random = Random::new(&[7]);
        let (mut covered, mut without_rounds) = (0, 0);
        for _ in 0..1_000 {
            let round = |_| {
                let blocks = (0..8).map(|_| if random.next_f32() < 0.05 { 10.5 } else { 0.5 });
                blocks.sum::<f64>() / 8.0
            };
            let values: Vec<f64> = (0..20).map(round).collect();
            let of_passes: Vec<f64> =
                values.chunks(4).map(|pass| pass.iter().sum::<f64>() / 4.0).collect();
            let rounds = Rounds { values, center: Center::Mean, passes: vec![4; 5] };
            let covers = |rounds: &Rounds| {
                let interval = rounds.estimate().unwrap().interval.unwrap();
                usize::from(interval.low <= 1.0 && 1.0 <= interval.high)
            };
            covered += covers(&rounds);
            without_rounds += covers(&means(&of_passes));
        }
        assert!(covered >= 930 && covered > without_rounds, "{covered}, {without_rounds} of 1000");
    }

    /// What rounds of a pass share, such as a place in memory, is not to be told from four rounds of five passes taken
    /// as twenty; from the passes it is.
    #[test]
    fn passes_cover_the_truth_where_rounds_as_replicates_do_not() {
        let mut random = Random::new(&[6]);
        let (mut by_passes, mut by_rounds) = (0, 0);
        for _ in 0..1_000 {
            let mut error = |reach: f64| reach * (2.0 * f64::from(random.next_f32()) - 1.0);
            let mut values = Vec::new();
            for _ in 0..5 {
                let shared = error(0.05);
                values.extend((0..4).map(|_| 1.0 + shared + error(0.01)));
            }
            let rounds = Rounds { values, center: Center::Mean, passes: vec![4; 5] };
            let apart = Rounds { passes: Vec::new(), ..rounds.clone() };
            let covers = |rounds: &Rounds| {
                let interval = rounds.estimate().unwrap().interval.unwrap();
                usize::from(interval.low <= 1.0 && 1.0 <= interval.high)
            };
            by_passes += covers(&rounds);
            by_rounds += covers(&apart);
        }
        assert!((930..=975).contains(&by_passes), "{by_passes} of 1000");
        assert!(by_rounds < 800, "{by_rounds} of 1000");
    }
}
