//! Everything that is computed from rounds, in one place, so that no report computes it again.
//!
//! Knows numbers only: neither records nor reports. Random choices (the bootstrap's) start at a
//! fixed seed, so the same rounds always give the same interval. What cannot be told from the
//! numbers at hand is `None`, never NaN.

mod estimate;
mod growth;
mod interpolate;
mod ratio;
mod tradeoff;

pub use estimate::{INTERVAL_ROUNDS, RESAMPLES, estimate, median};
pub use growth::{PowerLaw, log_log_fit};
pub use interpolate::log_log_interpolate;
pub use ratio::{paired_ratio, unpaired_ratio};
pub use tradeoff::{BreakEven, Cost, break_even, million_per_second, pareto_front};
