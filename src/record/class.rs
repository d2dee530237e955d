//! The rays of a class: how many, what they tested, how long each round took.

use serde::{Deserialize, Serialize};

use super::RayClass;

/// The rays of a class with a structure: the same rays with all structures of a scene.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ClassRecord {
    /// The class.
    pub class: RayClass,
    /// How many rays each round traced.
    pub rays: u64,
    /// How many of them hit something; for shadow rays, how many were blocked.
    pub hits: u64,
    /// Box tests of all rays of a round; absent if they were not counted.
    pub boxes: Option<u64>,
    /// Primitive tests of all rays of a round; absent if they were not counted.
    pub primitives: Option<u64>,
    /// The rounds, in the order of measurement. Rounds are interleaved: round n of all structures was measured
    /// together, so ratios are taken between rounds of the same number.
    pub rounds: Vec<Round>,
    /// The rays that both this structure and the base traced, if one of them traced more than the other; absent if they
    /// traced the same rays, and in older records.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub common: Option<CommonRays>,
}

/// Rays that both a structure and the base traced. A ratio needs equal rays: other rays meet other parts of a scene,
/// and a sparser sample shares less of the caches.
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
    /// Processor time of all threads together, in nanoseconds; absent where the system does not measure it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cpu_ns: Option<u64>,
    /// What the processor counted, where the system permits it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hardware: Option<HardwareCounters>,
}

impl Round {
    /// The round's own time in nanoseconds: wall time without waiting for a processor that other programs used. That is
    /// the shorter of wall time and processor time; the processor time of several threads can be the longer one.
    #[must_use]
    pub fn own_ns(&self) -> u64 {
        self.cpu_ns.map_or(self.wall_ns, |cpu| cpu.min(self.wall_ns))
    }
}

/// Events of a round that the processor counted; each is absent where the system does not permit it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct HardwareCounters {
    /// Clock cycles.
    pub cycles: Option<u64>,
    /// Retired instructions.
    pub instructions: Option<u64>,
    /// Mispredicted branches.
    pub branch_misses: Option<u64>,
    /// Reads that missed the last-level cache.
    pub cache_misses: Option<u64>,
}
