//! What follows from a record: medians, intervals, ratios, growth, break-even points, changes against a baseline.
//!
//! [`Analysis::of`] computes all figures of a record at once, so that every form of a report prints the same ones.
//! The modules here decide which rounds belong together; the arithmetic is in [`statistics`]. Nothing here measures,
//! rounds or formats a number.

pub mod baseline;
mod class;
mod costs;
mod finding;
pub mod motion;
mod noise;
mod operation;
mod overall;
mod scene;
mod share;
pub mod statistics;
mod sweep;

use serde::Serialize;

use crate::record::Comparison;

use statistics::BetweenRuns;

pub use class::ClassFigures;
pub use finding::Finding;
pub use noise::{NoiseFigures, Pairing};
pub use operation::OperationFigures;
pub use overall::OverallFigures;
pub use scene::{SceneFigures, StructureFigures};
pub use share::ShareFigures;
pub use sweep::{SweepCurve, SweepFigures, SweepValue};

/// What follows from a [`Comparison`]; `derived` in its JSON.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Analysis {
    /// One for each scene, in the record's order.
    pub scenes: Vec<SceneFigures>,
    /// The best supported finding over all scenes; absent if no scene supports one.
    pub finding: Option<Finding>,
    /// Each structure and class over all scenes.
    pub overall: Vec<OverallFigures>,
    /// One for each sweep, in the record's order.
    pub sweeps: Vec<SweepFigures>,
    /// One for each operation of the chapter on sampling, in the record's order.
    pub operations: Vec<OperationFigures>,
    /// One for each part of a frame in the chapter on sampling, in the record's order.
    pub shares: Vec<ShareFigures>,
    /// The noise of each sampling method, for equal samples and for equal time.
    pub noise: Vec<NoiseFigures>,
}

impl Analysis {
    /// Computes all figures of a record.
    #[must_use]
    pub fn of(comparison: &Comparison) -> Self {
        let between_runs = BetweenRuns(comparison.run.between_runs);
        let scene = |scene| SceneFigures::of(scene, &comparison.base, between_runs);
        let chapter = comparison.sampling.as_ref();
        let operations = chapter.iter().flat_map(|chapter| &chapter.costs);
        let operations: Vec<_> =
            operations.map(|cost| OperationFigures::of(cost, between_runs)).collect();
        let scenes: Vec<SceneFigures> = comparison.scenes.iter().map(scene).collect();
        Self {
            finding: finding::best_finding(&comparison.scenes, between_runs),
            overall: overall::overall(&scenes, &comparison.base),
            scenes,
            sweeps: comparison
                .sweeps
                .iter()
                .map(|sweep| SweepFigures::of(sweep, between_runs))
                .collect(),
            shares: chapter.map(|c| share::shares(c, &operations)).unwrap_or_default(),
            noise: chapter.map(|c| noise::noise(&c.noise, between_runs)).unwrap_or_default(),
            operations,
        }
    }
}
