//! A sweep, and the chapter on sampling.

use srt::record::*;

use super::noise::{rounds, times};

pub(super) fn sweep() -> Sweep {
    let mut points = Vec::new();
    for (s, (name, at_1k, slope)) in
        [("none", 850.0, 1.0), ("ball", 410.0, 0.98), ("bvh", 61.0, 0.19), ("cwbvh", 74.0, 0.16)]
            .into_iter()
            .enumerate()
    {
        for (i, triangles) in [1_000_u64, 10_000, 100_000, 1_000_000].into_iter().enumerate() {
            if s < 2 && triangles > 100_000 {
                continue;
            }
            for class in [RayClass::View, RayClass::Diffuse] {
                let dearer = if class == RayClass::View { 1.0 } else { 1.7 };
                let wobble = 1.0 + 0.04 * ((i * 3 + s) % 4) as f64;
                let ns = at_1k * (triangles as f64 / 1e3).powf(slope) * dearer * wobble;
                points.push(SweepPoint {
                    triangles,
                    structure: name.to_owned(),
                    class,
                    rays: 65_536,
                    rounds: rounds(ns * 65_536.0, 10, (s * 10 + i) as u64),
                    build_ns: triangles * 300,
                    index_bytes: triangles * 64,
                });
            }
        }
    }
    let dropped = |structure: &str| Dropped {
        structure: structure.to_owned(),
        triangles: 1_000_000,
        reason: "a round would take more than its part of the budget".to_owned(),
    };
    Sweep { mesh: "hall".to_owned(), points, dropped: vec![dropped("none"), dropped("ball")] }
}

pub(super) fn sampling() -> SamplingChapter {
    let cost = |operation: &str, ns: f64, key| OperationCost {
        operation: operation.to_owned(),
        count: 1_000_000,
        rounds_ns: times(ns * 1e6, 15, key),
    };
    let share = |scene: &str, part: &str, share| FrameShare {
        scene: scene.to_owned(),
        part: part.to_owned(),
        share,
    };
    let noise = |sampling: &str, pairing, pixel_samples, seconds, rmse| NoisePoint {
        scene: "bunny".to_owned(),
        sampling: sampling.to_owned(),
        pairing,
        pixel_samples,
        light_samples: 4,
        seconds,
        rmse,
    };
    SamplingChapter {
        costs: vec![cost("a random number", 1.21, 201), cost("a shuffle of 64", 93.7, 202)],
        shares: vec![
            share("bunny", "random numbers", 0.0093),
            share("bunny", "shuffling", 0.0214),
            share("hall", "random numbers", 0.0048),
            share("hall", "shuffling", 0.0121),
        ],
        noise: vec![
            noise("shuffled", Pairing::EqualSamples, 16, 1.432, 0.01211),
            noise("independent", Pairing::EqualSamples, 16, 1.401, 0.01987),
            noise("shuffled", Pairing::EqualTime, 16, 1.432, 0.01211),
            noise("independent", Pairing::EqualTime, 16, 1.433, 0.01966),
        ],
        default: "shuffled".to_owned(),
    }
}
