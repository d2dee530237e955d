//! The operations of sampling, each in batches.

use std::hint::black_box;

use crate::math::{Random, unit_pair};
use crate::record::OperationCost;
use crate::render::{LightSamples, SampleAssignment, Sampling};

use crate::compare::clock::timed;
use crate::compare::rounds::{Repeat, interleaved};

/// View samples along each side of the pixels whose samples are timed, and of the frames whose
/// shares are computed: sixteen samples a pixel.
pub(super) const SIDE: u32 = 4;

/// Pixels whose orders are made beforehand: as many as a tile of the renderer has.
const PIXELS: usize = 256;

const SEED: u64 = 1;

/// Something that a renderer does very often.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Operation {
    /// A number of a stream.
    Number,
    /// All that decides where in its pixel a view sample lies.
    Place,
    /// A pixel's order of its view samples, for one light.
    Shuffle,
    /// All tables of a picture.
    Tables,
    /// The points of a view sample, from a table.
    Take,
    /// The points of a view sample, on the fly.
    Make,
}

impl Operation {
    const ALL: [Self; 6] =
        [Self::Number, Self::Place, Self::Shuffle, Self::Tables, Self::Take, Self::Make];

    /// The name in reports.
    pub(super) fn name(self) -> String {
        let views = SIDE * SIDE;
        match self {
            Self::Number => "a random number".to_owned(),
            Self::Place => "placing a view sample in its pixel".to_owned(),
            Self::Shuffle => format!("shuffling {views} view samples of a pixel"),
            Self::Tables => "making the tables of shuffled samples".to_owned(),
            Self::Take => "taking a view sample's light samples from a table".to_owned(),
            Self::Make => "making a view sample's light samples on the fly".to_owned(),
        }
    }

    /// How many make a batch: about a millisecond.
    fn batch(self) -> u64 {
        match self {
            Self::Number => 1 << 19,
            Self::Place | Self::Take | Self::Make => 1 << 16,
            Self::Shuffle => 1 << 13,
            Self::Tables => 1 << 8,
        }
    }
}

/// Times batches of all operations, on the current thread.
pub(super) fn measure(light_side: u32, repeat: &Repeat<'_>) -> Vec<OperationCost> {
    let bench = Bench::new(light_side);
    let rounds = interleaved(Operation::ALL.len(), repeat, |task, _| {
        let operation = Operation::ALL[task];
        let ((), round) = timed(|| bench.run(operation));
        // A batch is so short that one interruption would be most of it.
        let time = round.cpu_ns.unwrap_or(round.wall_ns);
        Some((time, time))
    });
    let cost = |(operation, rounds_ns): (Operation, Vec<u64>)| OperationCost {
        operation: operation.name(),
        count: operation.batch(),
        rounds_ns,
    };
    Operation::ALL.into_iter().zip(rounds).map(cost).collect()
}

/// What the batches work on.
struct Bench {
    light_side: u32,
    shuffled: LightSamples,
    independent: LightSamples,
    /// The samples of some pixels, assigned in advance.
    assignment: SampleAssignment,
}

impl Bench {
    fn new(light_side: u32) -> Self {
        let samples = |sampling| LightSamples::new(sampling, SEED, SIDE, light_side);
        let (shuffled, independent) = (samples(Sampling::Shuffled), samples(Sampling::Independent));
        let mut assignment = SampleAssignment::default();
        for pixel in 0..PIXELS as u64 {
            shuffled.assign(pixel, 0, &mut assignment);
        }
        Self { light_side, assignment, shuffled, independent }
    }

    /// A batch. Keys run on as those of a renderer's pixels and paths do.
    fn run(&self, operation: Operation) {
        let numbers = 0..operation.batch();
        let mut buffer = Vec::new();
        let mut keys = Random::new(&[SEED]);
        match operation {
            Operation::Number => {
                let mut random = Random::new(&[black_box(SEED)]);
                numbers.for_each(|_| {
                    black_box(random.next_f32());
                });
            }
            Operation::Place => numbers.for_each(|number| {
                // A stream for each pixel, of which each view sample takes a number.
                if number % 16 == 0 {
                    keys = Random::new(&[black_box(SEED), number / 16]);
                }
                black_box(unit_pair(keys.next_u64()));
            }),
            Operation::Shuffle => {
                let mut assignment = SampleAssignment::default();
                numbers.for_each(|number| {
                    assignment.clear();
                    self.shuffled.assign(black_box(number), 0, &mut assignment);
                    black_box(&assignment);
                });
            }
            Operation::Tables => numbers.for_each(|number| {
                let samples =
                    LightSamples::new(Sampling::Shuffled, number, SIDE, black_box(self.light_side));
                black_box(samples);
            }),
            Operation::Take => numbers.for_each(|number| {
                let sample = number as usize % ((SIDE * SIDE) as usize * PIXELS);
                let key = black_box(number);
                let points = self.shuffled.points(&self.assignment, 0, sample, key, &mut buffer);
                points.iter().for_each(|point| {
                    black_box(*point);
                });
            }),
            Operation::Make => numbers.for_each(|number| {
                let key = black_box(number);
                let points = self.independent.points(&self.assignment, 0, 0, key, &mut buffer);
                points.iter().for_each(|point| {
                    black_box(*point);
                });
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use super::*;
    use crate::compare::budget::Budget;
    use crate::record::RoundRule;

    #[test]
    fn every_operation_takes_some_time() {
        let rule = RoundRule { warmup: 0, at_least: 2, relative_interval: 1.0 };
        let budget = Budget::from_now(Some(Duration::ZERO));
        let costs = measure(2, &Repeat::new(rule, budget, &|| false));
        assert_eq!(costs.len(), 6);
        for cost in costs {
            assert_eq!(cost.rounds_ns.len(), 1, "{}", cost.operation);
            assert!(cost.count > 0 && cost.rounds_ns[0] > 0, "{}", cost.operation);
        }
    }
}
