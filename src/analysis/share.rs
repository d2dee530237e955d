//! The share of a frame that an operation takes.

use serde::Serialize;

use super::OperationFigures;
use super::class::quotient;
use super::statistics::median;
use crate::record::{FramePart, SamplingChapter};

/// The share of an operation in the time of a frame.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ShareFigures {
    /// The name of the scene.
    pub scene: String,
    /// The method of the frame.
    pub sampling: String,
    /// The operation.
    pub operation: String,
    /// How often a frame performs it, times the median of its cost, over the median time of a frame.
    pub share: Option<f64>,
}

pub(super) fn shares(
    chapter: &SamplingChapter,
    operations: &[OperationFigures],
) -> Vec<ShareFigures> {
    let figures = |part: &FramePart| ShareFigures {
        scene: part.scene.clone(),
        sampling: part.sampling.clone(),
        operation: part.operation.clone(),
        share: share(chapter, operations, part),
    };
    chapter.parts.iter().map(figures).collect()
}

fn share(
    chapter: &SamplingChapter,
    operations: &[OperationFigures],
    part: &FramePart,
) -> Option<f64> {
    let once = operations.iter().find(|own| own.operation == part.operation)?.ns?.value;
    let frame = chapter.noise.iter().find(|point| {
        (&point.scene, &point.sampling, point.pixel_samples)
            == (&part.scene, &part.sampling, part.pixel_samples)
    })?;
    let frame = frame.rounds_ns.iter().map(|&ns| ns as f64).collect::<Vec<_>>();
    quotient(part.count as f64 * once, median(&frame)?)
}
