//! What the processor counts while a thread works: cycles, instructions, misses.
//!
//! Linux grants this to some programs on some machines. Where it does not, nothing is counted and
//! the fields of the record are absent.

use crate::record::HardwareCounters;

pub(super) use system::Hardware;

/// What was read, or nothing at all if none of the counters was granted.
fn if_any(counts: HardwareCounters) -> Option<HardwareCounters> {
    (counts != HardwareCounters::default()).then_some(counts)
}

#[cfg(target_os = "linux")]
mod system {
    use perf_event::events::Hardware as Event;
    use perf_event::{Builder, Counter};

    use super::{HardwareCounters, if_any};

    /// Cycles, instructions, branch misses and cache misses of a thread, those that were granted.
    ///
    /// Each counts by itself: a group (of perf-event 0.4) cannot be read once a member was refused.
    pub(in crate::compare) struct Hardware([Option<Counter>; 4]);

    impl Hardware {
        /// Opens the counters of the calling thread.
        pub(in crate::compare) fn of_this_thread() -> Self {
            let events =
                [Event::CPU_CYCLES, Event::INSTRUCTIONS, Event::BRANCH_MISSES, Event::CACHE_MISSES];
            Self(events.map(|event| Builder::new().kind(event).build().ok()))
        }

        /// Runs something on this thread and counts meanwhile.
        pub(in crate::compare) fn count<T>(
            &mut self,
            work: impl FnOnce() -> T,
        ) -> (T, Option<HardwareCounters>) {
            for counter in self.0.iter_mut().flatten() {
                // One that cannot be started is read as one that missed the work.
                let _ = counter.reset().and_then(|()| counter.enable());
            }
            let result = work();
            let [cycles, instructions, branch_misses, cache_misses] =
                self.0.each_mut().map(|counter| read(counter.as_mut()?));
            let counts = HardwareCounters { cycles, instructions, branch_misses, cache_misses };
            (result, if_any(counts))
        }
    }

    /// What was counted; `None` if the counter did not run all the time.
    fn read(counter: &mut Counter) -> Option<u64> {
        counter.disable().ok()?;
        let read = counter.read_count_and_time().ok()?;
        // One that had to share the processor's counters with others missed a part of the work.
        (read.time_running > 0 && read.time_running == read.time_enabled).then_some(read.count)
    }
}

#[cfg(not(target_os = "linux"))]
mod system {
    use super::{HardwareCounters, if_any};

    /// Nothing is granted here.
    pub(in crate::compare) struct Hardware;

    impl Hardware {
        pub(in crate::compare) fn of_this_thread() -> Self {
            Self
        }

        pub(in crate::compare) fn count<T>(
            &mut self,
            work: impl FnOnce() -> T,
        ) -> (T, Option<HardwareCounters>) {
            (work(), if_any(HardwareCounters::default()))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn work_is_done_whether_it_is_counted_or_not() {
        let mut hardware = Hardware::of_this_thread();
        for _ in 0..2 {
            let (sum, counts) = hardware.count(|| (0..1_000u64).sum::<u64>());
            assert_eq!(sum, 499_500);
            // Where anything is granted, something was counted.
            if let Some(counts) = counts {
                assert_ne!(counts, HardwareCounters::default());
                assert_ne!(counts.cycles, Some(0));
            }
        }
        assert_eq!(if_any(HardwareCounters::default()), None);
    }
}
