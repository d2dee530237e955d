//! Figures of operations that a frame performs very often.

use serde::Serialize;

use super::class::quotient;
use super::statistics::{BetweenRuns, estimate};
use crate::record::{Estimate, OperationCost};

/// The cost of an operation.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OperationFigures {
    /// The operation.
    pub operation: String,
    /// Processor time of one operation, in nanoseconds.
    pub ns: Option<Estimate>,
}

impl OperationFigures {
    pub(super) fn of(cost: &OperationCost, between_runs: BetweenRuns) -> Self {
        let once = |&ns: &u64| quotient(ns as f64, cost.count as f64);
        let rounds: Option<Vec<f64>> = cost.rounds_ns.iter().map(once).collect();
        let ns = rounds.and_then(|rounds| estimate(&rounds)).map(|ns| between_runs.widen(ns));
        Self { operation: cost.operation.clone(), ns }
    }
}
