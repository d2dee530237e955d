//! The course's own question: what do random numbers and shuffling cost, and what do they bring?

use serde::{Deserialize, Serialize};

/// The chapter on sampling.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SamplingChapter {
    /// What single operations cost.
    pub costs: Vec<OperationCost>,
    /// How often a frame does them.
    pub parts: Vec<FramePart>,
    /// The pictures that noise is measured against.
    pub converged: Vec<ConvergedPicture>,
    /// How much noise is left.
    pub noise: Vec<NoisePoint>,
    /// The method that is the default of this program.
    pub default: String,
}

/// Something that is done very often.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct OperationCost {
    /// What it is, such as `a random number`.
    pub operation: String,
    /// How many times each round did it.
    pub count: u64,
    /// Processor time of each round in nanoseconds; wall time where the system does not tell.
    pub rounds_ns: Vec<u64>,
}

/// How often an operation is done in one of the frames whose noise was measured.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FramePart {
    /// The name of the scene.
    pub scene: String,
    /// The method of the frame (`shuffled`, `independent`).
    pub sampling: String,
    /// View samples for each pixel of the frame.
    pub pixel_samples: u32,
    /// The operation, one of those whose cost is known.
    pub operation: String,
    /// How many times.
    pub count: u64,
}

/// The mean of many renderings of a scene, each with random numbers of its own.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ConvergedPicture {
    /// The name of the scene.
    pub scene: String,
    /// Width in pixels, of all frames of the scene.
    pub width: u32,
    /// Height in pixels, of all frames of the scene.
    pub height: u32,
    /// How many renderings were averaged.
    pub passes: u32,
    /// View samples for each pixel of a rendering.
    pub pixel_samples: u32,
    /// Light samples for each view sample and light.
    pub light_samples: u32,
    /// The noise that the mean itself still has, by how its renderings differ, in the unit of the
    /// noise of frames.
    pub rmse: f64,
}

/// The noise in the frames of a method with so many samples, and the time they take on one thread.
/// Rounds of the same number ran beside each other, with the same random view rays.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct NoisePoint {
    /// The name of the scene.
    pub scene: String,
    /// The method (`shuffled`, `independent`).
    pub sampling: String,
    /// View samples for each pixel.
    pub pixel_samples: u32,
    /// Light samples for each view sample and light.
    pub light_samples: u32,
    /// Processor time of each frame in nanoseconds; wall time where the system does not tell.
    pub rounds_ns: Vec<u64>,
    /// For each frame, the root of the mean squared difference to the converged picture, over all
    /// channels, in linear units.
    pub rounds_rmse: Vec<f64>,
}
