//! The noise of sampling methods compared: for equal samples and for equal time.
//!
//! Frames have square numbers of samples, so two methods never take exactly the same time. The noise of one at the time
//! of the other is interpolated between its measurements.

use serde::Serialize;

use super::statistics::{BetweenRuns, estimate, log_log_interpolate, paired_ratio};
use crate::record::{Estimate, NoisePoint};

/// The method that others are compared with.
const BASE: &str = "independent";

/// What is equal in a comparison of two sampling methods.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Pairing {
    /// The same number of samples.
    EqualSamples,
    /// The same time, with as many samples as that allows.
    EqualTime,
}

/// The noise of a method.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct NoiseFigures {
    /// The name of the scene.
    pub scene: String,
    /// What is equal to the other method.
    pub pairing: Pairing,
    /// The method.
    pub sampling: String,
    /// View samples for each pixel; not a whole number if it is interpolated.
    pub pixel_samples: f64,
    /// Light samples for each view sample and light.
    pub light_samples: u32,
    /// Processor time of a frame on one thread, in nanoseconds.
    pub ns: Estimate,
    /// Root of the mean squared difference to the converged picture; without an interval if it is interpolated.
    pub rmse: Estimate,
    /// This noise over that of `independent` with the same pairing; absent for `independent` itself.
    pub ratio: Option<Estimate>,
}

/// A point with its medians.
struct Measured<'a> {
    point: &'a NoisePoint,
    ns: Estimate,
    rmse: Estimate,
}

/// For each scene first all counts of samples, then all times.
pub(super) fn noise(points: &[NoisePoint], between_runs: BetweenRuns) -> Vec<NoiseFigures> {
    let mut scenes: Vec<&str> = points.iter().map(|point| point.scene.as_str()).collect();
    scenes.dedup();
    let mut figures = Vec::new();
    for scene in scenes {
        let of_scene = points.iter().filter(|point| point.scene == scene);
        let measured: Vec<Measured<'_>> =
            of_scene.filter_map(|point| Measured::of(point, between_runs)).collect();
        figures.extend(measured.iter().map(|own| own.for_equal_samples(&measured)));
        for own in measured.iter().filter(|own| own.point.sampling != BASE) {
            figures.extend(own.for_equal_time(&measured).into_iter().flatten());
        }
    }
    figures
}

impl<'a> Measured<'a> {
    fn of(point: &'a NoisePoint, between_runs: BetweenRuns) -> Option<Self> {
        let ns: Vec<f64> = point.rounds_ns.iter().map(|&ns| ns as f64).collect();
        Some(Self {
            point,
            ns: between_runs.widen(estimate(&ns)?),
            rmse: estimate(&point.rounds_rmse)?,
        })
    }

    fn figures(&self, pairing: Pairing, ratio: Option<Estimate>) -> NoiseFigures {
        NoiseFigures {
            scene: self.point.scene.clone(),
            pairing,
            sampling: self.point.sampling.clone(),
            pixel_samples: f64::from(self.point.pixel_samples),
            light_samples: self.point.light_samples,
            ns: self.ns,
            rmse: self.rmse,
            ratio,
        }
    }

    fn for_equal_samples(&self, all: &[Self]) -> NoiseFigures {
        let base = all.iter().find(|other| {
            other.point.sampling == BASE && other.point.pixel_samples == self.point.pixel_samples
        });
        let base = base.filter(|_| self.point.sampling != BASE);
        // The frames of a round have the same view rays, so most noise of the view rays cancels in the ratio.
        let ratio = |base: &Self| paired_ratio(&self.point.rounds_rmse, &base.point.rounds_rmse);
        self.figures(Pairing::EqualSamples, base.and_then(ratio))
    }

    /// This point, and the base at the same time; `None` if that time is outside the range of the base.
    fn for_equal_time(&self, all: &[Self]) -> Option<[NoiseFigures; 2]> {
        let base = || all.iter().filter(|other| other.point.sampling == BASE);
        let at_this_time = |value: fn(&Self) -> f64| {
            let curve: Vec<_> = base().map(|own| (own.ns.value, value(own))).collect();
            log_log_interpolate(&curve, self.ns.value)
        };
        let pixel_samples = at_this_time(|own| f64::from(own.point.pixel_samples))?;
        let noise = at_this_time(|own| own.rmse.value)?;
        let rounds = base().map(|own| own.rmse.rounds).min()?;
        let without_interval = |median: f64| Estimate { value: median, interval: None, rounds };
        let ratio = without_interval(self.rmse.value / noise);
        let base = NoiseFigures {
            sampling: BASE.to_owned(),
            pixel_samples,
            rmse: without_interval(noise),
            ..self.figures(Pairing::EqualTime, None)
        };
        Some([self.figures(Pairing::EqualTime, Some(ratio)), base])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(sampling: &str, pixel_samples: u32, ns: u64, rmse: f64) -> NoisePoint {
        NoisePoint {
            scene: "a".to_owned(),
            sampling: sampling.to_owned(),
            pixel_samples,
            light_samples: 1,
            rounds_ns: vec![ns; 6],
            rounds_rmse: vec![rmse; 6],
        }
    }

    #[test]
    fn equal_samples_are_paired_and_equal_times_interpolated() {
        let points = [
            point("shuffled", 4, 200, 0.1),
            point("shuffled", 16, 800, 0.03),
            point("independent", 4, 100, 0.2),
            point("independent", 16, 400, 0.1),
        ];
        let figures = noise(&points, BetweenRuns(0.0));
        let ratio = |figures: &NoiseFigures| figures.ratio.map(|ratio| ratio.value);
        let samples: Vec<_> = figures.iter().take(4).map(ratio).collect();
        assert_eq!(samples, [Some(0.5), Some(0.3), None, None]);
        // 800 ns is outside the range of the base.
        let [own, base] = &figures[4..] else { panic!("{figures:?}") };
        assert_eq!((own.pairing, base.pairing), (Pairing::EqualTime, Pairing::EqualTime));
        assert_eq!((own.ns.value, base.ns.value), (200.0, 200.0));
        assert!((base.pixel_samples - 8.0).abs() < 1e-9);
        let between = 0.2_f64 / 2.0_f64.sqrt();
        assert!((base.rmse.value - between).abs() < 1e-12);
        assert!((ratio(own).unwrap() - 0.1 / between).abs() < 1e-12);
    }

    #[test]
    fn points_without_frames_have_no_figures() {
        let mut empty = point("shuffled", 4, 1, 1.0);
        empty.rounds_ns.clear();
        assert_eq!(noise(&[empty], BetweenRuns(0.0)), []);
    }
}
