//! Figures of operations that are done very often.

use serde::Serialize;

use super::class::quotient;
use super::statistics::estimate;
use crate::record::{Estimate, OperationCost};

/// What an operation costs.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OperationFigures {
    /// What it is.
    pub operation: String,
    /// Processor time of doing it once, in nanoseconds.
    pub ns: Option<Estimate>,
}

impl OperationFigures {
    pub(super) fn of(cost: &OperationCost) -> Self {
        let once = |&ns: &u64| quotient(ns as f64, cost.count as f64);
        let rounds: Option<Vec<f64>> = cost.rounds_ns.iter().map(once).collect();
        let ns = rounds.and_then(|rounds| estimate(&rounds));
        Self { operation: cost.operation.clone(), ns }
    }
}
