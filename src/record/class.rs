//! The rays of a class: how many, what they tested, how long each round took.

use serde::{Deserialize, Serialize};

use super::RayClass;

/// The rays of a class with a structure: the same rays with all structures of a scene, or a random sample of them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ClassRecord {
    /// The class.
    pub class: RayClass,
    /// How many rays each round traced.
    pub rays: u64,
    /// The sample that each round drew; absent if each traced all recorded rays.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sample: Option<BlockSample>,
    /// The rays that the next three fields count; 0 in older records, where it is `rays`.
    #[serde(default)]
    pub counted_rays: u64,
    /// How many of them hit something; for shadow rays, how many were blocked.
    pub hits: u64,
    /// Their box tests; absent if they were not counted.
    pub boxes: Option<u64>,
    /// Their primitive tests; absent if they were not counted.
    pub primitives: Option<u64>,
    /// The rounds, in the order of measurement. Rounds are interleaved: round n of all structures was measured
    /// together, so ratios are taken between rounds of the same number.
    pub rounds: Vec<Round>,
    /// How many rounds each pass over all classes had, in their order; empty in older records, whose rounds of a class
    /// followed each other. Passes are apart in time, and structures may have been built anew for each: so the passes,
    /// not the rounds, are the independent replicates.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub passes: Vec<u64>,
}

/// A stratified random sample of blocks of consecutive rays, drawn anew for each round: the recorded rays are divided
/// into as many equal parts as there are blocks, and a block is drawn from each.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct BlockSample {
    /// How many blocks a round traced.
    pub blocks: u64,
    /// How many consecutive rays a block has.
    pub rays_per_block: u64,
    /// How many rays were recorded.
    pub of_rays: u64,
}

impl ClassRecord {
    /// How many rays of the class were recorded: its times are estimates for all of them.
    #[must_use]
    pub fn recorded_rays(&self) -> u64 {
        self.sample.map_or(self.rays, |sample| sample.of_rays)
    }
}

/// One pass of the rays of a class through a structure.
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

    /// Both together, one after the other. What either did not measure is absent.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        let both = self.hardware.zip(other.hardware);
        Self {
            wall_ns: self.wall_ns.saturating_add(other.wall_ns),
            cpu_ns: sum(self.cpu_ns, other.cpu_ns),
            hardware: both.map(|(own, other)| own.plus(other)),
        }
    }
}

/// The sum, if both are known.
fn sum(a: Option<u64>, b: Option<u64>) -> Option<u64> {
    Some(a?.saturating_add(b?))
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

impl HardwareCounters {
    /// Both together. What either did not count is absent.
    #[must_use]
    pub fn plus(self, other: Self) -> Self {
        Self {
            cycles: sum(self.cycles, other.cycles),
            instructions: sum(self.instructions, other.instructions),
            branch_misses: sum(self.branch_misses, other.branch_misses),
            cache_misses: sum(self.cache_misses, other.cache_misses),
        }
    }
}
