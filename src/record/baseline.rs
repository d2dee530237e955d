//! What changed against an older record, as plain data. [`analysis::baseline`](crate::analysis::baseline) computes it.

use serde::{Deserialize, Serialize};

use super::{Estimate, RayClass};

/// The result of a comparison with an older record.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Baseline {
    /// From which slowdown on a change is a regression: 0.1 is 10 %.
    pub threshold: f64,
    /// What changed.
    pub outcome: Changes,
}

/// What changed from an old record to a new one.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Changes {
    /// Every measurement that both records have, in the order of the new record.
    pub changes: Vec<Change>,
    /// Why no change can be attributed to the program, one sentence each: another processor, other rays.
    pub warnings: Vec<String>,
    /// Why some changes are doubtful, one sentence each: other settings, changed scenes, measurements that only one
    /// record has.
    pub doubts: Vec<String>,
}

/// One scene, structure and class of rays that both records have.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Change {
    /// The name of the scene.
    pub scene: String,
    /// The structure.
    pub structure: String,
    /// The class of rays.
    pub class: RayClass,
    /// New time per ray over old time per ray: above 1 is slower.
    pub slowdown: Estimate,
}
