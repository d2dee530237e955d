//! Random numbers, orders and light samples.

use std::hint::black_box;

use criterion::BenchmarkGroup;
use criterion::measurement::WallTime;
use srt::math::Random;
use srt::render::{LightSamples, SampleAssignment, Sampling};

/// View samples along each side of a pixel.
const SIDE: u32 = 4;

pub(crate) fn measure(group: &mut BenchmarkGroup<'_, WallTime>) {
    check_numbers();
    let mut random = Random::new(&[1]);
    group.bench_function("number", |b| b.iter(|| random.next_f32()));
    group.bench_function("pair", |b| b.iter(|| random.next_pair()));
    group.bench_function("stream", |b| b.iter(|| Random::new(black_box(&[1, 2, 3]))));
    for light_side in [1, 4] {
        let shuffled = LightSamples::new(Sampling::Shuffled, 1, SIDE, light_side);
        let independent = LightSamples::new(Sampling::Independent, 1, SIDE, light_side);
        check(&shuffled, SIDE * light_side);
        check(&independent, light_side);
        if light_side == 1 {
            let (mut pixel, mut assignment) = (0, SampleAssignment::default());
            group.bench_function(format!("shuffle-{}", SIDE * SIDE), |b| {
                b.iter(|| {
                    pixel += 1;
                    assignment.clear();
                    shuffled.assign(pixel, 0, &mut assignment);
                    black_box(&assignment);
                });
            });
        }
        let count = light_side * light_side;
        for (name, samples) in [("take", &shuffled), ("make", &independent)] {
            let assignment = assignment_of(samples, 1);
            let (mut buffer, mut key) = (Vec::new(), 0);
            group.bench_function(format!("{name}-{count}"), |b| {
                b.iter(|| {
                    key += 1;
                    let points =
                        samples.points(&assignment, 0, key as usize % 16, key, &mut buffer);
                    points.iter().map(|point| point[0] + point[1]).sum::<f32>()
                });
            });
        }
    }
}

/// The mean and the mean square of uniform numbers.
fn check_numbers() {
    let mut random = Random::new(&[1]);
    let numbers: Vec<f64> = (0..100_000).map(|_| f64::from(random.next_f32())).collect();
    let mean = |f: fn(f64) -> f64| numbers.iter().map(|&x| f(x)).sum::<f64>() / 1e5;
    assert!((mean(|x| x) - 1.0 / 2.0).abs() < 0.005, "the numbers are not uniform");
    assert!((mean(|x| x * x) - 1.0 / 3.0).abs() < 0.005, "the numbers are not uniform");
}

/// Each cell of side × side gets as many points as every other: of a pixel's points together if
/// they are shuffled, of each view sample's on their own in any case.
fn check(samples: &LightSamples, side: u32) {
    for pixel in 0..64 {
        let points = points_of(samples, &assignment_of(samples, pixel), pixel);
        let mut cells = vec![0; (side * side) as usize];
        for [x, y] in &points {
            let cell = |x: f32| (x * side as f32) as u32;
            cells[(cell(*y) * side + cell(*x)) as usize] += 1;
        }
        let even = points.len() / cells.len();
        assert!(cells.iter().all(|&n| n == even), "pixel {pixel} covers the light unevenly");
    }
}

/// What one pixel's view samples get of light 0.
fn assignment_of(samples: &LightSamples, pixel: u64) -> SampleAssignment {
    let mut assignment = SampleAssignment::default();
    samples.assign(pixel, 0, &mut assignment);
    assignment
}

fn points_of(samples: &LightSamples, assignment: &SampleAssignment, pixel: u64) -> Vec<[f32; 2]> {
    let mut buffer = Vec::new();
    let views = 0..(SIDE * SIDE) as usize;
    let of_view = |view: usize| {
        samples.points(assignment, 0, view, pixel << 8 | view as u64, &mut buffer).to_vec()
    };
    views.flat_map(of_view).collect()
}
