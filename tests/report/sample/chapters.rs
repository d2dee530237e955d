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
                let cost = if class == RayClass::View { 1.0 } else { 1.7 };
                let wobble = 1.0 + 0.04 * ((i * 3 + s) % 4) as f64;
                let ns = at_1k * (triangles as f64 / 1e3).powf(slope) * cost * wobble;
                points.push(SweepPoint {
                    triangles,
                    structure: name.to_owned(),
                    class,
                    rays: 65_536,
                    sample: (name == "none").then_some(BlockSample {
                        blocks: 64,
                        rays_per_block: 1_024,
                        of_rays: 100_352,
                    }),
                    rounds: rounds(ns * 65_536.0, 10, (s * 10 + i) as u64),
                    passes: vec![2; 5],
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
        failed: false,
    };
    let dropped = vec![dropped("none"), dropped("ball")];
    Sweep {
        mesh: "hall".to_owned(),
        unit: "triangles".to_owned(),
        points,
        dropped,
        rays_checked: 123_456,
    }
}

pub(super) fn sampling() -> SamplingChapter {
    let cost = |operation: &str, ns: f64, key| OperationCost {
        operation: operation.to_owned(),
        count: 1_000_000,
        rounds_ns: times(ns * 1e6, 15, key),
    };
    let part = |scene: &str, sampling: &str, operation: &str, count| FramePart {
        scene: scene.to_owned(),
        sampling: sampling.to_owned(),
        pixel_samples: 16,
        operation: operation.to_owned(),
        count,
    };
    let converged = |scene: &str, rmse| ConvergedPicture {
        scene: scene.to_owned(),
        width: 96,
        height: 64,
        passes: 24,
        pixel_samples: 64,
        light_samples: 4,
        rmse,
    };
    SamplingChapter {
        costs: vec![cost("a random number", 1.21, 201), cost("a shuffle of 16", 93.7, 202)],
        parts: vec![
            part("bunny", "shuffled", "a shuffle of 16", 12_288),
            part("bunny", "independent", "a random number", 196_608),
            part("hall", "shuffled", "a shuffle of 16", 24_576),
            part("hall", "independent", "a random number", 393_216),
        ],
        converged: vec![converged("bunny", 0.000_412), converged("hall", 0.000_731)],
        noise: [("bunny", 3.1e7, 0.048), ("hall", 4.4e7, 0.071)]
            .into_iter()
            .flat_map(|(scene, ns, rmse)| noise_of(scene, ns, rmse))
            .collect(),
        default: "shuffled".to_owned(),
    }
}

/// Noise that falls with the root of the samples, and faster where they are shuffled.
fn noise_of(scene: &str, ns: f64, rmse: f64) -> Vec<NoisePoint> {
    let point = |sampling: &str, cost: f64, slope: f64, pixel_samples: u32| {
        let n = f64::from(pixel_samples);
        let noise = times(rmse * n.powf(slope) * 1e9, 8, u64::from(pixel_samples));
        NoisePoint {
            scene: scene.to_owned(),
            sampling: sampling.to_owned(),
            pixel_samples,
            light_samples: 1,
            rounds_ns: times(ns * cost * n, 8, u64::from(pixel_samples) + 40),
            rounds_rmse: noise.into_iter().map(|n| n as f64 / 1e9).collect(),
        }
    };
    let curve = |sampling: &'static str, cost, slope| {
        [1, 4, 16, 64].map(|n| point(sampling, cost, slope, n))
    };
    [curve("shuffled", 1.03, -0.7), curve("independent", 1.0, -0.5)].concat()
}
