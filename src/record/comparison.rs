//! The whole of a comparison.

use serde::{Deserialize, Serialize};

use super::{Baseline, Run, SamplingChapter, SceneRecord, Sweep};

/// The version of the record: raised when a field changes its meaning or goes away. New fields
/// that may be absent do not raise it.
pub const SCHEMA_VERSION: u32 = 1;

/// The same work, done with several structures, and what it took.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Comparison {
    /// [`SCHEMA_VERSION`] of the program that wrote the record.
    pub schema_version: u32,
    /// How, when and on what it was measured.
    pub run: Run,
    /// The name of the structure that ratios are taken to, `none` unless asked otherwise. In a
    /// scene where it was not measured, the first structure that was takes its place.
    pub base: String,
    /// The scenes, in the order in which they were named.
    pub scenes: Vec<SceneRecord>,
    /// Cost against the number of triangles, one for each family of meshes.
    pub sweeps: Vec<Sweep>,
    /// What random numbers and shuffling cost and bring, if that was asked for.
    pub sampling: Option<SamplingChapter>,
    /// What changed against an older record, if it was asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub baseline: Option<Baseline>,
    /// What else a reader should know of this run, one sentence each.
    pub notes: Vec<String>,
}

impl Comparison {
    /// A record without any measurement yet.
    #[must_use]
    pub fn new(run: Run, base: impl Into<String>) -> Self {
        Self {
            schema_version: SCHEMA_VERSION,
            run,
            base: base.into(),
            scenes: Vec::new(),
            sweeps: Vec::new(),
            sampling: None,
            baseline: None,
            notes: Vec::new(),
        }
    }
}
