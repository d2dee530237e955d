//! A structure over a scene: its shape and memory, the times of its builds, its rays.

use serde::{Deserialize, Serialize};

use super::{ClassRecord, PictureFile, RayClass};

/// What was measured of a structure over a scene. What was not measured is absent or empty.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct StructureRecord {
    /// The name of the structure.
    pub name: String,
    /// Whether it is a peer: the structure of another library, compared for its speed. Its results need not be equal,
    /// and it has no counts, shape and heatmap.
    #[serde(default, alias = "yardstick")]
    pub peer: bool,
    /// Whether everything was measured, and if not, why.
    pub status: Status,
    /// The times of its builds.
    pub build: BuildRecord,
    /// Its memory.
    pub memory: Option<Memory>,
    /// Its nodes, leaves and quality.
    pub shape: Option<ShapeRecord>,
    /// Its rays, by class.
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

    /// Whether it failed, maybe after some measurements.
    #[must_use]
    pub fn has_failed(&self) -> bool {
        matches!(self.status, Status::Failed { .. })
    }
}

/// Whether a structure was measured over a scene.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(tag = "state", rename_all = "snake_case")]
pub enum Status {
    /// Everything was measured.
    #[default]
    Ok,
    /// It failed.
    Failed {
        /// Why, in words.
        message: String,
    },
    /// A measurement was left out because it would take longer than its budget.
    TooSlow {
        /// This budget, in seconds.
        after_seconds: f64,
    },
    /// The comparison was stopped before all was measured.
    Stopped,
}

/// Wall times of builds in nanoseconds, one for each round, from the compiled scene to the first ray.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct BuildRecord {
    /// On one thread.
    pub one_thread_ns: Vec<u64>,
    /// On all threads.
    pub all_threads_ns: Vec<u64>,
    /// The stages of the builds on all threads, each the median of the builds that were timed; none if the structure
    /// does not report them, and in older records.
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
    /// The index itself, without the primitives; of a peer with what it holds of them.
    pub index_bytes: u64,
    /// The triangles of meshes as they are traced; of a peer what it keeps of them outside of its index.
    pub primitive_bytes: u64,
    /// The largest resident memory of the process during a build, where the system reports it.
    pub peak_resident_bytes: Option<u64>,
}

impl Memory {
    /// The index and the triangles; of a peer all that it keeps.
    #[must_use]
    pub fn total_bytes(&self) -> u64 {
        self.index_bytes.saturating_add(self.primitive_bytes)
    }
}

/// The shape of a structure: the sums over all meshes, each mesh once; in a scene without meshes, the structure over
/// its objects.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ShapeRecord {
    /// Inner nodes, the root included.
    pub nodes: u64,
    /// Leaves: ranges of primitives that are tested together.
    pub leaves: u64,
    /// Steps from the root to the deepest leaf; 0 if it is no tree.
    pub depth: u32,
    /// Entry n: how many leaves have n primitives.
    pub leaf_sizes: Vec<u64>,
    /// Primitives that were indexed.
    pub primitives: u64,
    /// References from leaves to primitives; more than `primitives` where a build splits them.
    pub references: u64,
    /// The expected cost of a ray by the surface area heuristic, of trees: a box test costs 1, a primitive test costs
    /// 1.
    pub sah_cost: Option<f64>,
    /// End-point overlap (Aila, Karras, Laine: *On quality metrics of bounding volume hierarchies*, HPG 2013), of trees
    /// over meshes: the cost of the boxes around a ray's end point that do not belong to the surface there, at the
    /// costs of `sah_cost`.
    pub epo: Option<f64>,
    /// The standard error of `epo`; absent if it was computed from all triangles.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub epo_standard_error: Option<f64>,
    /// How many triangles `epo` was estimated from, sampled by area with the seed of the run; absent if it was computed
    /// from all.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub epo_samples: Option<u64>,
}

/// A round of building and rendering the whole picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct PictureRound {
    /// Wall time of the build in nanoseconds.
    pub build_ns: u64,
    /// Wall time of the rendering in nanoseconds.
    pub render_ns: u64,
}
