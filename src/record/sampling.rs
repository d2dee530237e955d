//! The course's own question: what do random numbers and shuffling cost, and what do they bring?

use serde::{Deserialize, Serialize};

/// The chapter on sampling.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SamplingChapter {
    /// What single operations cost.
    pub costs: Vec<OperationCost>,
    /// What share of a frame they are.
    pub shares: Vec<FrameShare>,
    /// How much noise is left.
    pub noise: Vec<NoisePoint>,
    /// The method that is the default because of these figures.
    pub default: String,
}

/// Something that is done very often.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct OperationCost {
    /// What it is, such as `a random number`.
    pub operation: String,
    /// How many times each round did it.
    pub count: u64,
    /// Wall time of each round in nanoseconds.
    pub rounds_ns: Vec<u64>,
}

/// A part of the time that a frame takes.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FrameShare {
    /// The name of the scene.
    pub scene: String,
    /// What the time goes to, such as `shuffling`.
    pub part: String,
    /// Its share of the frame's time, from 0 to 1.
    pub share: f64,
}

/// What is held equal between two methods of sampling.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Pairing {
    /// The same number of samples.
    EqualSamples,
    /// As many samples as take the same time.
    EqualTime,
}

/// The noise in a picture.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NoisePoint {
    /// The name of the scene.
    pub scene: String,
    /// The method (`shuffled`, `independent`).
    pub sampling: String,
    /// What this point has in common with the other methods' points.
    pub pairing: Pairing,
    /// View samples for each pixel.
    pub pixel_samples: u32,
    /// Light samples for each view sample and light.
    pub light_samples: u32,
    /// Wall time of the frame in seconds.
    pub seconds: f64,
    /// Root of the mean squared difference to a converged picture, over all channels, in linear
    /// units.
    pub rmse: f64,
}
