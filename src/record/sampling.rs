//! What random numbers and shuffling cost, and how much noise they leave.

use serde::{Deserialize, Serialize};

/// The chapter on sampling.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct SamplingChapter {
    /// The costs of single operations.
    pub costs: Vec<OperationCost>,
    /// How often a frame performs them.
    pub parts: Vec<FramePart>,
    /// The pictures that noise is measured against.
    pub converged: Vec<ConvergedPicture>,
    /// The noise that is left.
    pub noise: Vec<NoisePoint>,
    /// The default method of srt.
    pub default: String,
}

/// An operation that a frame performs very often.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct OperationCost {
    /// The operation, such as `a random number`.
    pub operation: String,
    /// How many times each round performed it.
    pub count: u64,
    /// Processor time of each round in nanoseconds; wall time where the system does not measure processor time.
    pub rounds_ns: Vec<u64>,
}

/// How often one of the frames whose noise was measured performs an operation.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FramePart {
    /// The name of the scene.
    pub scene: String,
    /// The method of the frame (`shuffled`, `independent`).
    pub sampling: String,
    /// View samples for each pixel of the frame.
    pub pixel_samples: u32,
    /// The operation, one of [`SamplingChapter::costs`].
    pub operation: String,
    /// How many times.
    pub count: u64,
}

/// The mean of many renderings of a scene, each with other random numbers.
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
    /// The noise of the mean itself, estimated from the differences between its renderings, in the unit of the noise of
    /// frames.
    pub rmse: f64,
}

/// The noise and the time, on one thread, of frames with a method and a number of samples. Rounds are interleaved:
/// frames of the same round have the same random view rays.
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
    /// Processor time of each frame in nanoseconds; wall time where the system does not measure processor time.
    pub rounds_ns: Vec<u64>,
    /// For each frame, the root of the mean squared difference to the converged picture, over all channels, in linear
    /// units.
    pub rounds_rmse: Vec<f64>,
}
