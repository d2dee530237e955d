//! The whole of a comparison.

use serde::{Deserialize, Serialize};

use super::{Baseline, Conformance, Run, SamplingChapter, SceneRecord, Sweep};

/// The version of the record. It is raised when a field changes its meaning or is removed. A new field that may be
/// absent does not raise it, and neither does a new name for a field whose old name is still read.
pub const SCHEMA_VERSION: u32 = 2;

/// The same work, measured with several structures.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Comparison {
    /// [`SCHEMA_VERSION`] of the program that wrote the record.
    pub schema_version: u32,
    /// How, when and on what it was measured.
    pub run: Run,
    /// The structure that ratios are taken to. In a scene where it was not measured, ratios are taken to the first
    /// structure that was.
    pub base: String,
    /// The checks of the structures that are not the program's own, in the order in which they were named; none in
    /// older records, which checked none.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub conformance: Vec<Conformance>,
    /// The scenes, in the order in which they were named.
    pub scenes: Vec<SceneRecord>,
    /// Cost against size, one for each family of scenes.
    pub sweeps: Vec<Sweep>,
    /// The study of sampling, if it was part of the run.
    pub sampling: Option<SamplingChapter>,
    /// What changed against an older record, if there was a baseline.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub baseline: Option<Baseline>,
    /// Notes on this run, one sentence each.
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
            conformance: Vec::new(),
            scenes: Vec::new(),
            sweeps: Vec::new(),
            sampling: None,
            baseline: None,
            notes: Vec::new(),
        }
    }

    /// The check of a structure; `None` if it was not checked.
    #[must_use]
    pub fn conformance_of(&self, structure: &str) -> Option<&Conformance> {
        self.conformance.iter().find(|own| own.structure == structure)
    }
}
