//! Whether structures from outside the program keep the contract, by rays that are made to find out.

use serde::{Deserialize, Serialize};

/// The check of a structure: its answers against those of no structure at all, on awkward meshes, before anything was
/// measured in scenes.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Conformance {
    /// The structure.
    pub structure: String,
    /// What it showed.
    pub outcome: ConformanceOutcome,
    /// Rays whose answers were compared without a difference; 0 unless the outcome is [`ConformanceOutcome::Equal`].
    pub rays: u64,
    /// How many of them hit something.
    pub hits: u64,
    /// Meshes of which all rays were compared. A mesh counts once for each scale and place that it was put in, over
    /// triangles and over objects.
    pub meshes_checked: u64,
    /// All meshes of the check: more than `meshes_checked` if it had no time for all.
    pub meshes: u64,
    /// How many seconds it took.
    pub seconds: f64,
}

/// What a check of conformance showed.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(tag = "state", rename_all = "snake_case")]
pub enum ConformanceOutcome {
    /// No answer differed.
    #[default]
    Equal,
    /// An answer differed. All that is needed to repeat it:
    Differs(ConformanceDifference),
    /// It panicked.
    Failed {
        /// With what words.
        message: String,
    },
}

/// The first ray whose answers differ, in full precision.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ConformanceDifference {
    /// The mesh, by its name in `srt::conformance::nasty_meshes`.
    pub mesh: String,
    /// What it was scaled by.
    pub scale: f32,
    /// What it was moved by after that.
    pub offset: [f32; 3],
    /// The quality of the build.
    pub build: String,
    /// How the ray was searched for: in a slice of many, the same with tests counted, or alone.
    pub way: String,
    /// The ray.
    pub ray: String,
    /// What every structure must answer.
    pub expected: String,
    /// What this one did.
    pub got: String,
}

impl Conformance {
    /// Whether nothing is known against it.
    #[must_use]
    pub fn holds(&self) -> bool {
        self.outcome == ConformanceOutcome::Equal
    }

    /// Whether all rays of all meshes were compared.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        self.holds() && self.meshes_checked == self.meshes
    }

    /// What is wrong, in words that name the ray and both answers; `None` if nothing is.
    #[must_use]
    pub fn fault(&self) -> Option<String> {
        match &self.outcome {
            ConformanceOutcome::Equal => None,
            ConformanceOutcome::Failed { message } => Some(message.clone()),
            ConformanceOutcome::Differs(first) => {
                let ConformanceDifference { mesh, scale, offset: [x, y, z], .. } = first;
                let ConformanceDifference { build, way, ray, expected, got, .. } = first;
                Some(format!(
                    "mesh `{mesh}` times {scale:e} plus [{x}, {y}, {z}], built `{build}`, traced {way}: {ray}; \
                     expected {expected}; got {got}"
                ))
            }
        }
    }
}
