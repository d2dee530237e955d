//! How, when and with what a comparison was made.

use serde::{Deserialize, Serialize};

use super::Machine;

/// All that somebody needs to do the same again.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Run {
    /// The exact command, quoted for a shell.
    pub command: String,
    /// When it started: ISO 8601 with its offset from UTC.
    pub date: String,
    /// The version of srt.
    pub version: String,
    /// The commit whose sources it was built from, `-dirty` behind it if they had changed since;
    /// absent where that is not known.
    pub commit: Option<String>,
    /// The compiler and its version.
    pub compiler: String,
    /// The build profile (`release`, `dev`).
    pub profile: String,
    /// Flags that were given to the compiler beside the profile's; empty for a plain build.
    pub flags: String,
    /// The machine.
    pub machine: Machine,
    /// Where random numbers started, for the pictures and for the rays.
    pub seed: u64,
    /// How many seconds the whole comparison was given; absent for no limit.
    pub budget_seconds: Option<f64>,
    /// How many seconds it took.
    pub elapsed_seconds: f64,
    /// Whether it was stopped before its plan was done.
    pub partial: bool,
    /// What was rendered and traced.
    pub options: Options,
    /// How often each measurement was repeated.
    pub rounds: RoundRule,
}

/// What the pictures and the replayed rays were made with.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Options {
    /// Threads that rendered, and that "all threads" of builds means.
    pub threads: u32,
    /// Threads that replayed the recorded rays.
    pub trace_threads: u32,
    /// Width and height asked for, in pixels; absent where each scene's own was taken.
    pub size: Option<[u32; 2]>,
    /// View samples along each side of a pixel; 0 is one ray through the centre. Absent where each
    /// scene's own was taken.
    pub aa: Option<u32>,
    /// Light samples along each side of an area light.
    pub light_samples: u32,
    /// How many times a view ray may be mirrored or refracted; absent where each scene's own was
    /// taken.
    pub max_recursion: Option<u32>,
    /// How area lights were sampled (`shuffled`, `independent`).
    pub sampling: String,
    /// The quality that builds were asked for (`fast`, `medium`, `best`).
    pub build: String,
}

/// When a measurement has been repeated often enough.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct RoundRule {
    /// Rounds that were made first and are not in the record.
    pub warmup: u32,
    /// Rounds that were made at least, if the budget allowed.
    pub at_least: u32,
    /// Half the width of the median's 95 % interval, as a share of the median, below which
    /// rounds ended.
    pub relative_interval: f64,
}
