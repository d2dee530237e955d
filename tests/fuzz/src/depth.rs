//! How far executions go: how many inputs are accepted, and which of them are looked at more closely.

use std::sync::atomic::{AtomicU64, Ordering};

/// Counts an execution, and whether its input was accepted; prints both whenever their number has doubled.
pub fn count(accepted: bool) {
    static ALL: AtomicU64 = AtomicU64::new(0);
    static ACCEPTED: AtomicU64 = AtomicU64::new(0);
    let accepted = ACCEPTED.fetch_add(u64::from(accepted), Ordering::Relaxed) + u64::from(accepted);
    let all = ALL.fetch_add(1, Ordering::Relaxed) + 1;
    if all.is_power_of_two() && all >= 1 << 14 {
        eprintln!("{all} executions, {accepted} of accepted inputs");
    }
}

/// Whether an input is one of so many, by its contents alone, so that it is one again wherever it is run again: for
/// checks that take many times as long as what they check.
pub fn is_one_of(number: u32, input: &[u8]) -> bool {
    // Fowler, Noll and Vo's hash, variant 1a.
    let add = |hash: u32, byte: &u8| (hash ^ u32::from(*byte)).wrapping_mul(0x0100_0193);
    input.iter().fold(0x811c_9dc5, add).is_multiple_of(number)
}
