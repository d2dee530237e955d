//! Rounds as replicates of one measurement: the value that they estimate, for the whole of what they sampled.
//!
//! Where each round measured everything, the rounds differ by the noise of the machine alone, and their median is the
//! estimate, which a disturbed round does not move. Where each round drew a random sample of its own, the rounds are
//! independent replicates whose mean is unbiased for the whole, while a median is not. The differences between such
//! rounds contain both the machine's noise and what the choice of the sample adds, so an interval from the rounds
//! includes both. This is the method of independent random groups (K. M. Wolter: *Introduction to Variance Estimation*,
//! 2nd edition, 2007, chapter 2), each of them a stratified random sample (W. G. Cochran: *Sampling Techniques*, 3rd
//! edition, 1977, chapter 5).
//!
//! Rounds that follow each other are not independent: they share the clock rate and the neighbours of that moment, and
//! the place in memory where a structure was built. So rounds come in passes, apart in time and each with structures
//! built anew, and where there are passes, these are the replicates: an interval comes from the differences between
//! them, as T. Kalibera and R. Jones advise (*Rigorous benchmarking in reasonable time*, ISMM 2013) for levels of
//! repetition. Of rounds that measured everything, the estimate is then the geometric mean of the passes' medians: the
//! centre of what the interval is made of. (The median of all rounds is not: where passes fall into two groups, it lies
//! within one of them.) A few passes over skewed samples may happen to agree, all of them without the rare costly rays.
//! So where rounds are samples, they are looked at as replicates too, and the larger of both standard errors counts.
//!
//! A ratio is that of two such estimates. Its interval is the textbook's for a ratio estimator (Cochran, chapter 6):
//! Student's, from the residues of rounds of the same number, whose common part cancels. It is taken for the logarithm,
//! since a time cannot be negative. Where one of both is a mean over samples, the other is a mean, too: the few slow
//! rounds that a machine has are in both, or the ratio would favour the one whose median leaves them out.

use super::estimate::{all_finite, estimate, estimate_at, median};
use super::ratio::unpaired_ratio;
use super::risk::Risk;
use crate::record::{Estimate, Interval};

/// The least number of replicates from which an interval is made: the spread of three values is itself hardly known.
const LEAST_REPLICATES: usize = 4;

/// What of the rounds is the estimate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Center {
    /// The median, of each pass where there are passes: each round measured everything.
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
    /// The value and its interval. `None` without values, or if one is not finite.
    #[must_use]
    pub fn estimate(&self) -> Option<Estimate> {
        if self.is_plain() {
            return estimate(&self.values);
        }
        if !all_finite(&self.values) {
            return None;
        }
        match self.center {
            Center::Median => self.of_passes(&self.values, Risk::USUAL),
            Center::Mean => {
                let value = mean(&self.values)?;
                let residues: Vec<f64> = self.values.iter().map(|own| own / value - 1.0).collect();
                Some(self.of_samples(value, &residues, Risk::USUAL))
            }
        }
    }

    /// Whether each round is a replicate of everything: then there is an exact interval of the median.
    fn is_plain(&self) -> bool {
        self.center == Center::Median && self.passes.is_empty()
    }

    /// The geometric mean of the medians of the passes, for values of these rounds. `None` without values.
    fn of_passes(&self, values: &[f64], risk: Risk) -> Option<Estimate> {
        let logarithm = |pass: &[f64]| median(pass).map(f64::ln);
        let logarithms = self.each_pass(values, logarithm);
        let value = mean(&logarithms)?.exp();
        let reach = reach(&logarithms, standard_error(&logarithms), risk);
        Some(with_interval(value, reach, values.len()))
    }

    /// The value of rounds that are samples. `residues` are their relative errors, whose means are those of passes.
    fn of_samples(&self, value: f64, residues: &[f64], risk: Risk) -> Estimate {
        let replicates = match self.passes.as_slice() {
            [] => residues.to_vec(),
            _ => self.each_pass(residues, mean),
        };
        // Each round drew a sample of its own: what the choice adds is seen better in all rounds than in few passes.
        let of_rounds = standard_error(residues).unwrap_or(0.0);
        let error = standard_error(&replicates).map(|error| error.max(of_rounds));
        with_interval(value, reach(&replicates, error, risk), residues.len())
    }

    /// A value for each pass. Rounds beyond the given ones are left out, as are passes without any.
    fn each_pass(&self, of_rounds: &[f64], value: impl Fn(&[f64]) -> Option<f64>) -> Vec<f64> {
        let mut left = of_rounds;
        let mut of_pass = |&rounds: &usize| {
            let (own, rest) = left.split_at(rounds.min(left.len()));
            left = rest;
            value(own)
        };
        self.passes.iter().filter_map(&mut of_pass).collect()
    }
}

/// The factor by which an interval of a logarithm reaches up and down, by the error of the mean of replicates.
fn reach(replicates: &[f64], error: Option<f64>, risk: Risk) -> Option<f64> {
    error.map(|error| (risk.student(replicates.len() - 1) * error).exp())
}

fn with_interval(value: f64, reach: Option<f64>, rounds: usize) -> Estimate {
    let interval = reach
        .filter(|reach| reach.is_finite() && value.is_finite())
        .map(|reach| Interval { low: value / reach, high: value * reach });
    Estimate { value, interval, rounds }
}

/// How many times as fast as the base: the base's estimate over the own one, for rounds that were interleaved.
///
/// Rounds that only one of both has are left out of a median's ratios and of the interval. `None` if one has no value,
/// or if the ratio is not finite.
#[must_use]
pub fn ratio_of_estimates(base: &Rounds, own: &Rounds, risk: Risk) -> Option<Estimate> {
    let values = || base.values.iter().zip(&own.values);
    if base.center == Center::Median && own.center == Center::Median {
        let ratios: Vec<f64> = values().map(|(base, own)| base / own).collect();
        return match own.is_plain() {
            true => estimate_at(&ratios, risk),
            false if all_finite(&ratios) => own.of_passes(&ratios, risk),
            false => None,
        };
    }
    let finite_mean = |rounds: &Rounds| mean(&rounds.values).filter(|mean| mean.is_finite());
    let (of_base, of_own) = (finite_mean(base)?, finite_mean(own)?);
    let ratio = of_base / of_own;
    let residues: Vec<f64> = values().map(|(b, o)| b / of_base - o / of_own).collect();
    ratio.is_finite().then(|| own.of_samples(ratio, &residues, risk))
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
        let ratio = ratio_of_estimates(&base, &own, Risk::USUAL).unwrap();
        let interval = ratio.interval.unwrap();
        assert!((ratio.value - 3.0).abs() < 1e-12);
        assert!((interval.high / interval.low - 1.0).abs() < 1e-12, "{interval:?}");
        let unpaired = unpaired_ratio_of_estimates(&base, &own).unwrap().interval.unwrap();
        assert!(unpaired.low < 1.5 && unpaired.high > 6.0, "{unpaired:?}");
    }

    #[test]
    fn a_ratio_to_a_whole_is_that_of_two_means() {
        let ratio = |base: &[f64], own: &[f64]| {
            ratio_of_estimates(&means(base), &medians(own), Risk::USUAL).map(|own| own.value)
        };
        assert_eq!(ratio(&[8.0, 12.0, 8.0, 12.0], &[2.0; 4]), Some(5.0));
        assert_eq!(ratio(&[8.0, 12.0, 8.0, 12.0], &[1.0, 1.0, 1.0, 5.0]), Some(5.0));
        assert_eq!(ratio(&[1.0; 4], &[0.0; 4]), None);
        assert_eq!(ratio(&[], &[1.0; 4]), None);
    }

    #[test]
    fn an_interval_that_is_one_of_many_is_wider() {
        let own = Rounds { passes: vec![1; 5], ..medians(&[1.0, 1.1, 0.9, 1.0, 1.0]) };
        let base = Rounds { passes: vec![1; 5], ..medians(&[2.0; 5]) };
        let width = |risk| {
            let ratio = ratio_of_estimates(&base, &own, risk).unwrap();
            ratio.interval.map(|own| (own.high / own.low).ln()).unwrap()
        };
        let factor = width(Risk::USUAL.shared_by(50)) / width(Risk::USUAL);
        assert!((factor - 8.610 / 2.776).abs() < 1e-2, "{factor}");
    }

    /// Passes of two groups, as places in memory make them: the median of all rounds lies within one of them.
    #[test]
    fn the_interval_is_that_of_its_centre() {
        let mut random = Random::new(&[8]);
        let (mut covered, mut of_medians) = (0, 0);
        for _ in 0..1_000 {
            let slow = |random: &mut Random| if random.next_f32() < 0.5 { 1.0 } else { 1.1 };
            let values: Vec<f64> = (0..12)
                .flat_map(|_| {
                    let place = slow(&mut random);
                    [place, place * (1.0 + 0.01 * f64::from(random.next_f32()))]
                })
                .collect();
            let all = median(&values).unwrap();
            let rounds = Rounds { values, center: Center::Median, passes: vec![2; 12] };
            let estimate = rounds.estimate().unwrap();
            let interval = estimate.interval.unwrap();
            let truth = (1.0_f64 * 1.1).sqrt() * 1.0025;
            let covers = |shift: f64| {
                usize::from(interval.low * shift <= truth && truth <= interval.high * shift)
            };
            covered += covers(1.0);
            of_medians += covers(all / estimate.value);
        }
        assert!(covered > 930 && of_medians < 500, "{covered}, {of_medians} of 1000");
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
            let ratio = ratio_of_estimates(&twice, &rounds, Risk::USUAL).unwrap();
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
