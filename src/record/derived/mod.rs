//! All figures that follow from a record, computed once; every report prints these.
//!
//! Knows which rounds belong together, and leaves the arithmetic to
//! [`statistics`](super::statistics).

mod class;
mod operation;
mod scene;
mod sweep;

use serde::Serialize;

use super::Comparison;

pub use class::ClassFigures;
pub(super) use class::wall_ns_per_ray;
pub use operation::OperationFigures;
pub use scene::{SceneFigures, StructureFigures};
pub use sweep::{SweepCurve, SweepFigures, SweepValue};

/// What follows from a [`Comparison`].
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Derived {
    /// One for each scene, in the record's order.
    pub scenes: Vec<SceneFigures>,
    /// One for each sweep, in the record's order.
    pub sweeps: Vec<SweepFigures>,
    /// One for each operation of the chapter on sampling, in the record's order.
    pub operations: Vec<OperationFigures>,
}

impl Derived {
    /// Computes all figures of a record.
    #[must_use]
    pub fn of(comparison: &Comparison) -> Self {
        let scene = |scene| SceneFigures::of(scene, &comparison.base);
        let operations = comparison.sampling.iter().flat_map(|chapter| &chapter.costs);
        Self {
            scenes: comparison.scenes.iter().map(scene).collect(),
            sweeps: comparison.sweeps.iter().map(SweepFigures::of).collect(),
            operations: operations.map(OperationFigures::of).collect(),
        }
    }
}
