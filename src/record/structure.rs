//! A structure over a scene: what it is, what its build took, what its rays took.

use serde::{Deserialize, Serialize};

use super::{ClassRecord, PictureFile, RayClass};

/// What a structure did with a scene. What was not measured is absent or empty.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct StructureRecord {
    /// The name of the structure.
    pub name: String,
    /// Whether it is another program's, compared for its speed alone: not held to equal answers,
    /// and without counts, form and heatmap.
    #[serde(default)]
    pub yardstick: bool,
    /// Whether it did its work.
    pub status: Status,
    /// What building took.
    pub build: BuildRecord,
    /// What it occupies.
    pub memory: Option<Memory>,
    /// What it looks like.
    pub shape: Option<Shape>,
    /// What its rays took, by class.
    pub classes: Vec<ClassRecord>,
    /// Rounds of building and rendering the whole picture, all threads.
    pub picture_rounds: Vec<PictureRound>,
    /// Tests for each pixel, on the scene's [`HeatScale`](super::HeatScale).
    pub heatmap: Option<PictureFile>,
}

impl StructureRecord {
    /// A class of rays.
    #[must_use]
    pub fn class(&self, class: RayClass) -> Option<&ClassRecord> {
        self.classes.iter().find(|record| record.class == class)
    }
}

/// How a structure got through a scene.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(tag = "state", rename_all = "snake_case")]
pub enum Status {
    /// All that was asked for was measured.
    #[default]
    Ok,
    /// It could not go on.
    Failed {
        /// Why, in words.
        message: String,
    },
    /// It was left out because a round took longer than the budget allows.
    TooSlow {
        /// How long it had been given until then, in seconds.
        after_seconds: f64,
    },
    /// The comparison was stopped before its turn was over.
    Stopped,
}

/// Wall times of builds in nanoseconds, one for each round, from the compiled scene to the first
/// ray.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct BuildRecord {
    /// On one thread.
    pub one_thread_ns: Vec<u64>,
    /// On all threads.
    pub all_threads_ns: Vec<u64>,
    /// The stages of one build on all threads, that of the structure that was traced; none where it
    /// does not tell them, and in older records.
    #[serde(default)]
    pub stages: Vec<BuildStage>,
}

/// A stage of a build.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct BuildStage {
    /// Its name.
    pub name: String,
    /// Its wall time in nanoseconds, of all meshes together.
    pub ns: u64,
}

/// Memory in bytes.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Memory {
    /// The index itself, without the primitives.
    pub index_bytes: u64,
    /// The primitives as they are traced.
    pub primitive_bytes: u64,
    /// The most that the process had resident while it built, where the system tells.
    pub peak_resident_bytes: Option<u64>,
}

/// The form of a structure: those of all meshes added up, each mesh once; in a scene without
/// meshes, the one over its objects.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Shape {
    /// Inner nodes, the root included.
    pub nodes: u64,
    /// Leaves: ranges of primitives that are offered at once.
    pub leaves: u64,
    /// Steps from the root to the deepest leaf; 0 where there is no tree.
    pub depth: u32,
    /// Entry n: how many leaves hold n primitives.
    pub leaf_sizes: Vec<u64>,
    /// Primitives that were indexed.
    pub primitives: u64,
    /// References from leaves to primitives; more than `primitives` where a build splits them.
    pub references: u64,
    /// Expected cost of a ray by the surface area heuristic, for trees: a box test costs 1, a
    /// primitive test costs 1.
    pub sah_cost: Option<f64>,
    /// End-point overlap (Aila, Karras, Laine: *On quality metrics of bounding volume
    /// hierarchies*, HPG 2013), for trees over meshes: what a ray that ends on a surface pays in
    /// boxes that the surface does not belong to, at the costs of `sah_cost`.
    pub epo: Option<f64>,
    /// The standard error of `epo`; absent if it was computed from all triangles.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub epo_standard_error: Option<f64>,
    /// The triangles that `epo` was estimated from, chosen by area and by the seed of the run;
    /// absent if it was computed from all.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub epo_samples: Option<u64>,
}

/// A round of the time to the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct PictureRound {
    /// Wall time of the build in nanoseconds.
    pub build_ns: u64,
    /// Wall time of the rendering in nanoseconds.
    pub render_ns: u64,
}
