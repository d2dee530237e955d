//! Ratios of times, with intervals.

use super::estimate::{
    INTERVAL_ROUNDS, RESAMPLES, all_finite, draw, estimate, median, median_of, quantiles, random,
};
use crate::record::Estimate;

/// The median of `base[n] / own[n]`: how many times as fast as the base.
///
/// Rounds are interleaved: what slows the machine slows rounds of the same number alike, and cancels in their ratio.
/// Rounds that only one of both has are left out. `None` without common rounds, or if a ratio is not finite.
#[must_use]
pub fn paired_ratio(base: &[f64], own: &[f64]) -> Option<Estimate> {
    let ratios: Vec<f64> = base.iter().zip(own).map(|(base, own)| base / own).collect();
    estimate(&ratios)
}

/// `median(base) / median(own)` of rounds that were not interleaved, such as those of two runs. The interval is by the
/// percentile bootstrap: both are resampled independently.
#[must_use]
pub fn unpaired_ratio(base: &[f64], own: &[f64]) -> Option<Estimate> {
    let ratio = median(base)? / median(own)?;
    if !ratio.is_finite() {
        return None;
    }
    let rounds = base.len().min(own.len());
    let interval = (rounds >= INTERVAL_ROUNDS).then(|| {
        let mut random = random(&[base.len(), own.len()]);
        let mut resample = Vec::new();
        let mut resampled_median = |values: &[f64]| {
            draw(values, &mut random, &mut resample);
            median_of(&mut resample)
        };
        let ratios: Vec<f64> = (0..RESAMPLES)
            .filter_map(|_| Some(resampled_median(base)? / resampled_median(own)?))
            .collect();
        all_finite(&ratios).then(|| quantiles(ratios))
    });
    Some(Estimate { value: ratio, interval: interval.flatten(), rounds })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::Interval;

    #[test]
    fn what_slows_both_cancels_in_the_paired_ratio() {
        let own: Vec<f64> = (1..=12).map(|n| f64::from(n * n)).collect();
        let base: Vec<f64> = own.iter().map(|t| 3.0 * t).collect();
        let ratio = paired_ratio(&base, &own).unwrap();
        assert_eq!(ratio.value, 3.0);
        assert_eq!(ratio.interval, Some(Interval { low: 3.0, high: 3.0 }));
        let unpaired = unpaired_ratio(&base, &own).unwrap();
        assert_eq!(unpaired.value, 3.0);
        let interval = unpaired.interval.unwrap();
        assert!(interval.low < 2.0 && interval.high > 4.0, "{interval:?}");
    }

    #[test]
    fn rounds_without_a_partner_are_left_out() {
        let ratio = paired_ratio(&[6.0, 8.0], &[2.0, 2.0, 1000.0]).unwrap();
        assert_eq!((ratio.value, ratio.rounds, ratio.interval), (3.5, 2, None));
        assert_eq!(paired_ratio(&[], &[1.0]), None);
    }

    #[test]
    fn a_ratio_to_nothing_is_none() {
        assert_eq!(paired_ratio(&[1.0], &[0.0]), None);
        assert_eq!(unpaired_ratio(&[1.0], &[0.0]), None);
        assert_eq!(unpaired_ratio(&[], &[1.0]), None);
    }

    #[test]
    fn the_unpaired_interval_of_constants_is_their_ratio() {
        let ratio = unpaired_ratio(&[8.0; 7], &[2.0; 9]).unwrap();
        assert_eq!(ratio.interval, Some(Interval { low: 4.0, high: 4.0 }));
        assert_eq!((ratio.value, ratio.rounds), (4.0, 7));
    }
}
