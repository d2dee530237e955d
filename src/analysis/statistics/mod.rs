//! The arithmetic of the analysis, on plain numbers: medians, intervals, ratios, power laws, break-even points.
//!
//! The random numbers of the bootstrap have a fixed seed, so the same rounds always give the same interval. What cannot
//! be computed from the given numbers is `None`, never NaN.

mod between_runs;
mod estimate;
mod growth;
mod interpolate;
mod ratio;
mod replicates;
mod risk;
mod tradeoff;

pub use between_runs::BetweenRuns;
pub use estimate::{INTERVAL_ROUNDS, RESAMPLES, estimate, median};
pub use growth::{PowerLaw, log_log_fit};
pub use interpolate::log_log_interpolate;
pub use ratio::{paired_ratio, unpaired_ratio};
pub use replicates::{Center, Rounds, ratio_of_estimates, unpaired_ratio_of_estimates};
pub use risk::Risk;
pub use tradeoff::{BreakEven, Cost, break_even, million_per_second};
