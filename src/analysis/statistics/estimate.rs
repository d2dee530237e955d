//! The median of some rounds and its confidence interval.

use super::risk::Risk;
use crate::math::Random;
use crate::record::{Estimate, Interval};

/// The number of resamples of a bootstrap.
pub const RESAMPLES: usize = 2_000;

/// The least number of rounds for an interval. The range of five values covers the median with a probability of
/// 1 − 2·2⁻⁵ = 93.75 %, that of six with 96.9 %; so fewer than six cannot give 95 %.
pub const INTERVAL_ROUNDS: usize = 6;

const SEED: u64 = 0x0062_6f6f_7473_7472;

/// The middle value; for an even number of values, the mean of the two in the middle. `None` without values, or if one
/// is not finite.
#[must_use]
pub fn median(values: &[f64]) -> Option<f64> {
    if all_finite(values) { median_of(&mut values.to_vec()) } else { None }
}

/// The median of values and its interval. `None` without values, or if one is not finite.
#[must_use]
pub fn estimate(values: &[f64]) -> Option<Estimate> {
    estimate_at(values, Risk::USUAL)
}

/// The same with an interval of another risk.
pub(super) fn estimate_at(values: &[f64], risk: Risk) -> Option<Estimate> {
    let median = median(values)?;
    Some(Estimate { value: median, interval: order_interval(values, risk), rounds: values.len() })
}

/// The exact interval of the median, for any distribution: from the k-th smallest to the k-th largest value (H. A.
/// David, H. N. Nagaraja: *Order Statistics*, 3rd edition, section 7.1). The median lies below the k-th smallest value
/// with the probability that fewer than k of n fair coins show heads; k is the largest number with at most the risk of
/// an end.
fn order_interval(values: &[f64], risk: Risk) -> Option<Interval> {
    let n = values.len();
    let k = outermost(n, risk.of_an_end())?;
    let mut sorted = values.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    Some(Interval { low: sorted[k - 1], high: sorted[n - k] })
}

/// The largest k of [`order_interval`]; `None` if there is none.
fn outermost(n: usize, of_an_end: f64) -> Option<usize> {
    // Logarithms: 2⁻ⁿ underflows for more than a thousand values.
    let (mut ln_term, mut below) = (-(n as f64) * std::f64::consts::LN_2, 0.0);
    let mut k = 0;
    while k < n {
        below += ln_term.exp();
        if below > of_an_end {
            break;
        }
        k += 1;
        ln_term += ((n - k + 1) as f64 / k as f64).ln();
    }
    (k > 0).then_some(k)
}

/// The random numbers of a bootstrap over lists of these lengths.
pub(super) fn random(lengths: &[usize]) -> Random {
    let key: Vec<u64> = std::iter::once(SEED).chain(lengths.iter().map(|&n| n as u64)).collect();
    Random::new(&key)
}

/// Fills `resample` with values drawn with replacement, as many as there are.
pub(super) fn draw(values: &[f64], random: &mut Random, resample: &mut Vec<f64>) {
    let n = u32::try_from(values.len()).unwrap_or(u32::MAX);
    resample.clear();
    resample.extend((0..values.len()).map(|_| values[random.below(n) as usize]));
}

/// The median, by reordering the values.
pub(super) fn median_of(values: &mut [f64]) -> Option<f64> {
    if values.is_empty() {
        return None;
    }
    let even = values.len().is_multiple_of(2);
    let (below, &mut upper, _) = values.select_nth_unstable_by(values.len() / 2, f64::total_cmp);
    if !even {
        return Some(upper);
    }
    let lower = below.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    Some(lower + (upper - lower) / 2.0)
}

/// The 2.5 % and 97.5 % quantiles of a non-empty list.
pub(super) fn quantiles(mut values: Vec<f64>) -> Interval {
    values.sort_unstable_by(f64::total_cmp);
    let last = values.len() - 1;
    let at = |q: f64| values[(q * last as f64).round() as usize];
    Interval { low: at(0.025), high: at(0.975) }
}

pub(super) fn all_finite(values: &[f64]) -> bool {
    values.iter().all(|value| value.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_is_the_middle_value_or_the_mean_of_the_middle_two() {
        assert_eq!(median(&[]), None);
        assert_eq!(median(&[7.0]), Some(7.0));
        assert_eq!(median(&[3.0, 1.0, 2.0]), Some(2.0));
        assert_eq!(median(&[4.0, 1.0, 3.0, 2.0]), Some(2.5));
        assert_eq!(median(&[5.0, 5.0, 1.0, 9.0, 5.0]), Some(5.0));
        assert_eq!(median(&[1.0, f64::NAN]), None);
    }

    #[test]
    fn equal_values_have_an_interval_of_no_width() {
        let estimate = estimate(&[2.0; 10]).unwrap();
        assert_eq!(estimate.interval, Some(Interval { low: 2.0, high: 2.0 }));
        assert_eq!(estimate.relative_half_width(), Some(0.0));
    }

    #[test]
    fn too_few_values_have_no_interval() {
        assert_eq!(estimate(&[1.0, 2.0, 3.0, 4.0, 5.0]).unwrap().interval, None);
        assert!(estimate(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]).unwrap().interval.is_some());
        assert_eq!(estimate(&[]), None);
    }

    /// The places that tables of the sign test give.
    #[test]
    fn the_interval_ends_at_the_places_of_the_tables() {
        let places = [(5, None), (6, Some(1)), (8, Some(1)), (9, Some(2)), (12, Some(3))];
        for (n, k) in places.into_iter().chain([(20, Some(6)), (50, Some(18)), (100, Some(40))]) {
            assert_eq!(outermost(n, 0.025), k, "{n}");
        }
        assert_eq!((outermost(10, 0.001), outermost(9, 0.001)), (Some(1), None));
        assert!(outermost(5_000, 0.025).is_some_and(|k| (2_425..2_436).contains(&k)));
        let values: Vec<f64> = (1..=20).rev().map(f64::from).collect();
        let interval = estimate(&values).unwrap().interval;
        assert_eq!(interval, Some(Interval { low: 6.0, high: 15.0 }));
    }

    #[test]
    fn the_same_rounds_give_the_same_interval() {
        let values: Vec<f64> = (0..30).map(|i| f64::from(i * i % 17)).collect();
        assert_eq!(estimate(&values), estimate(&values));
    }
}
