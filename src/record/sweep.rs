//! How cost grows with the size of a scene.

use serde::{Deserialize, Serialize};

use super::{BlockSample, RayClass, Round};

/// A family of scenes, built and traced at growing sizes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Sweep {
    /// The family (`hall`, `terrain`, …).
    pub mesh: String,
    /// What its sizes count: `triangles` of a mesh, or `objects`; older records have meshes alone.
    #[serde(default = "triangles")]
    pub unit: String,
    /// The measurements, by growing size.
    pub points: Vec<SweepPoint>,
    /// The structures that stopped before the largest size.
    pub dropped: Vec<Dropped>,
    /// Results that were compared with those of another structure, bit for bit, over all sizes; 0 in older records,
    /// which compared none.
    #[serde(default)]
    pub rays_checked: u64,
}

impl Default for Sweep {
    /// Of a mesh without a name, with nothing measured.
    fn default() -> Self {
        let (points, dropped) = (Vec::new(), Vec::new());
        Self { mesh: String::new(), unit: triangles(), points, dropped, rays_checked: 0 }
    }
}

fn triangles() -> String {
    "triangles".to_owned()
}

/// One size, one structure, one class of rays.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SweepPoint {
    /// The size: triangles of the mesh, or objects.
    pub triangles: u64,
    /// The structure.
    pub structure: String,
    /// The class of rays.
    pub class: RayClass,
    /// How many rays each round traced.
    pub rays: u64,
    /// The sample that each round drew; absent if each traced all recorded rays.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sample: Option<BlockSample>,
    /// The rounds, interleaved as in [`ClassRecord`](super::ClassRecord).
    pub rounds: Vec<Round>,
    /// How many rounds each pass had, as in [`ClassRecord`](super::ClassRecord).
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub passes: Vec<u64>,
    /// Wall time of the structure's build on all threads, in nanoseconds.
    pub build_ns: u64,
    /// Bytes of the index.
    pub index_bytes: u64,
}

/// A structure that stopped before the largest size.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Dropped {
    /// The structure.
    pub structure: String,
    /// The size at which it stopped.
    pub triangles: u64,
    /// Why, in words.
    pub reason: String,
    /// Whether it failed or its results differed; false if it was too slow, and for peers.
    #[serde(default)]
    pub failed: bool,
}
