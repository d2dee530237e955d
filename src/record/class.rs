//! A class of rays: how many, what they tested, what each round took.

use serde::{Deserialize, Serialize};

/// What rays are sent for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum RayClass {
    /// From the eye through a pixel.
    View,
    /// From a surface to a light: is anything between?
    Shadow,
    /// Along a mirror direction.
    Mirror,
    /// Through a surface.
    Refraction,
    /// From a surface in a random direction: the first bounce of diffuse light.
    Diffuse,
    /// Uniformly random through the scene's box.
    Random,
    /// Parallel, along an axis of the scene's box: as a height field is probed.
    Probe,
}

impl RayClass {
    /// All classes, in the order of reports.
    pub const ALL: [Self; 7] = [
        Self::View,
        Self::Shadow,
        Self::Mirror,
        Self::Refraction,
        Self::Diffuse,
        Self::Random,
        Self::Probe,
    ];

    /// The name in reports, as in the record.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::View => "view",
            Self::Shadow => "shadow",
            Self::Mirror => "mirror",
            Self::Refraction => "refraction",
            Self::Diffuse => "diffuse",
            Self::Random => "random",
            Self::Probe => "probe",
        }
    }
}

/// The rays of a class through a structure: the same rays for all structures of a scene.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ClassRecord {
    /// The class.
    pub class: RayClass,
    /// How many rays each round traced.
    pub rays: u64,
    /// How many of them hit something; for shadow rays, how many were blocked.
    pub hits: u64,
    /// Box tests that all rays of a round took; absent if they were not counted.
    pub boxes: Option<u64>,
    /// Primitive tests that all rays of a round took; absent if they were not counted.
    pub primitives: Option<u64>,
    /// The rounds, in the order in which they were run. Round n of one structure ran beside round
    /// n of every other, so that ratios are taken between rounds of the same number.
    pub rounds: Vec<Round>,
    /// The rays that both this structure and the base traced, where one of them had time for more
    /// than the other; absent where they traced the same, and in older records.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub common: Option<CommonRays>,
}

/// Rays that both a structure and the base traced, each of them beside its other rays in every
/// round. Times of different rays are no ratio: other rays meet other parts of a scene, and rays
/// that lie further apart share less of the caches.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct CommonRays {
    /// How many rays there are.
    pub rays: u64,
    /// The structure's rounds with them.
    pub own: Vec<Round>,
    /// The base's rounds with them.
    pub base: Vec<Round>,
}

/// One pass of all rays of a class through a structure.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Round {
    /// Wall time in nanoseconds.
    pub wall_ns: u64,
    /// Processor time of all threads together, in nanoseconds; absent where the system keeps none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cpu_ns: Option<u64>,
    /// What the processor counted, where the system grants it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hardware: Option<HardwareCounters>,
}

impl Round {
    /// The time that the round took of its own: wall time without what it waited for a processor
    /// that other programs had. That is the processor time, unless several threads had a part in
    /// it, whose times add up to more than the wall time.
    #[must_use]
    pub fn own_ns(&self) -> u64 {
        self.cpu_ns.map_or(self.wall_ns, |cpu| cpu.min(self.wall_ns))
    }
}

/// Events of a round that the processor counted; each is absent where it was not granted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct HardwareCounters {
    /// Clock cycles.
    pub cycles: Option<u64>,
    /// Instructions that were retired.
    pub instructions: Option<u64>,
    /// Branches that were predicted wrongly.
    pub branch_misses: Option<u64>,
    /// Reads that missed the last cache.
    pub cache_misses: Option<u64>,
}
