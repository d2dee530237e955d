//! How, when and with what a comparison was made.

use serde::{Deserialize, Serialize};

use super::Machine;

/// Everything that is needed to repeat the run.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Run {
    /// The exact command, quoted for a shell.
    pub command: String,
    /// When it started: ISO 8601 with its offset from UTC.
    pub date: String,
    /// The version of srt.
    pub version: String,
    /// The commit that it was built from, with `-dirty` appended if the sources had changed since; absent if not known.
    pub commit: Option<String>,
    /// SHA-256 of the names and contents of the sources that it was built from, hexadecimal: a commit does not tell two
    /// builds with changed sources apart. Absent if not known, and in older records.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sources: Option<String>,
    /// The compiler and its version.
    pub compiler: String,
    /// The build profile (`release`, `dev`).
    pub profile: String,
    /// Compiler flags in addition to the profile's; empty for a plain build.
    pub flags: String,
    /// The machine.
    pub machine: Machine,
    /// The seed of all random numbers, for the pictures and for the rays.
    pub seed: u64,
    /// The budget of the whole comparison in seconds; absent for no limit.
    pub budget_seconds: Option<f64>,
    /// How many seconds it took.
    pub elapsed_seconds: f64,
    /// Whether it was stopped before its plan was done.
    pub partial: bool,
    /// The parts of the plan that are done, by which it can be gone on with: names of scenes, `sweep KIND`,
    /// `sampling study`. None in older records.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub done: Vec<String>,
    /// What was rendered and traced.
    pub options: Options,
    /// When each measurement was repeated often enough.
    pub rounds: RoundRule,
    /// The relative standard deviation of a time, or of a ratio of times, from run to run on this machine: stated, not
    /// measured, and included in every interval of a time. 0 in older records, whose intervals are for their run alone.
    #[serde(default)]
    pub between_runs: f64,
}

/// What the pictures and the replayed rays were made with.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Options {
    /// Threads that rendered and built ("all threads").
    pub threads: u32,
    /// Threads that replayed the recorded rays.
    pub trace_threads: u32,
    /// Width and height in pixels; absent if each scene's own were used.
    pub size: Option<[u32; 2]>,
    /// View samples along each side of a pixel; 0 is one ray through the centre. Absent if each scene's own number was
    /// used.
    pub aa: Option<u32>,
    /// Light samples along each side of an area light.
    pub light_samples: u32,
    /// How many times a view ray may be reflected or refracted; absent if each scene's own number was used.
    pub max_recursion: Option<u32>,
    /// How area lights were sampled (`shuffled`, `independent`).
    pub sampling: String,
    /// The quality of builds (`fastest`, `fast`, `medium`, `slow`, `slowest`).
    pub build: String,
}

/// When a measurement has been repeated often enough.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct RoundRule {
    /// Rounds before the first recorded one, to warm up.
    pub warmup: u32,
    /// The least number of rounds, if the budget allowed as many.
    pub at_least: u32,
    /// Rounds ended when half the width of the median's 95 % interval was less than this share of the median.
    pub relative_interval: f64,
}
