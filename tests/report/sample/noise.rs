//! Rounds as a quiet machine measures them.

use srt::math::Random;
use srt::record::{HardwareCounters, Round};

/// Wall times around a median, with the noise of a quiet machine: mostly narrow, some late.
pub(super) fn rounds(median_ns: f64, n: usize, key: u64) -> Vec<Round> {
    times(median_ns, n, key)
        .into_iter()
        .map(|wall_ns| Round {
            wall_ns,
            cpu_ns: Some(wall_ns - wall_ns / 200),
            hardware: Some(HardwareCounters {
                cycles: Some(wall_ns * 3),
                instructions: Some(wall_ns * 7),
                branch_misses: Some(wall_ns / 50),
                cache_misses: Some(wall_ns / 400),
            }),
        })
        .collect()
}

pub(super) fn times(median_ns: f64, n: usize, key: u64) -> Vec<u64> {
    let mut random = Random::new(&[key]);
    let mut noise = || f64::from(random.next_f32());
    (0..n)
        .map(|i| {
            let late = if i % 7 == 5 { 0.04 * noise() } else { 0.0 };
            (median_ns * (0.99 + 0.02 * noise() + late)) as u64
        })
        .collect()
}
