//! The time that some work takes: wall time and processor time.

use std::time::{Duration, Instant};

use crate::record::Round;

/// Runs something and measures it: wall time, and processor time where the system grants it.
pub fn timed<T>(work: impl FnOnce() -> T) -> (T, Round) {
    let cpu = processor_time();
    let start = Instant::now();
    let result = work();
    let wall = start.elapsed();
    let cpu = processor_time().zip(cpu).map(|(end, start)| nanoseconds(end.saturating_sub(start)));
    (result, Round { wall_ns: nanoseconds(wall), cpu_ns: cpu, hardware: None })
}

/// A time in whole nanoseconds.
pub(super) fn nanoseconds(time: Duration) -> u64 {
    u64::try_from(time.as_nanos()).unwrap_or(u64::MAX)
}

/// The processor time of all threads of this process.
#[cfg(unix)]
fn processor_time() -> Option<Duration> {
    use rustix::time::{ClockId, clock_gettime};
    let time = clock_gettime(ClockId::ProcessCPUTime);
    Some(Duration::new(u64::try_from(time.tv_sec).ok()?, u32::try_from(time.tv_nsec).ok()?))
}

#[cfg(not(unix))]
fn processor_time() -> Option<Duration> {
    None
}
