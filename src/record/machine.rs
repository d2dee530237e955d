//! The machine that measured.

use serde::{Deserialize, Serialize};

/// The machine, as far as times depend on it. What the system does not report is absent.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Machine {
    /// The processor's name.
    pub cpu: String,
    /// Hardware threads that the program may run on.
    pub cores: u32,
    /// Main memory in bytes.
    pub memory_bytes: Option<u64>,
    /// The operating system and its version.
    pub os: String,
    /// The widest instruction set that the kernels used, chosen as the program started.
    pub instruction_set: String,
    /// The governor of the clock frequency (`performance`, `schedutil`, …).
    pub governor: Option<String>,
    /// Load averages over 1, 5 and 15 minutes before the first measurement: 1.0 is one busy core.
    pub load_at_start: Option<[f64; 3]>,
}
