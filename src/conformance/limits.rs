//! How long a check may go on, and who watches it.

use std::time::Duration;

/// Is called with how many parts of a check are done, and of how many; from several threads, not always in order.
pub type Progress<'a> = dyn Fn(usize, usize) + Sync + 'a;

/// When a check ends before all is compared, and who sees how far it is.
///
/// It is asked for between slices of rays, which grow: what was begun takes about as long again as the part that was
/// compared before. A build, and the search for a single ray, are never interrupted.
#[derive(Clone, Copy)]
pub struct Limits<'a> {
    /// How long it may take; `None` for as long as it needs. Each mesh gets a share of what is left, so that even a
    /// slow structure meets some rays of all of them.
    pub time: Option<Duration>,
    /// Whether to end now.
    pub cancelled: &'a (dyn Fn() -> bool + Sync + 'a),
    /// What to call with the parts that are done.
    pub progress: &'a Progress<'a>,
}

impl Limits<'_> {
    /// None, and nobody watches.
    pub const NONE: Limits<'static> =
        Limits { time: None, cancelled: &|| false, progress: &|_, _| () };
}

/// The time of a check, in shares for its parts.
pub(super) struct Shares<'a> {
    /// The time since the check began.
    clock: &'a (dyn Fn() -> Duration + Sync),
    time: Option<Duration>,
}

impl<'a> Shares<'a> {
    /// Of so much time, by a clock that shows how long the check has gone on.
    pub(super) fn new(time: Option<Duration>, clock: &'a (dyn Fn() -> Duration + Sync)) -> Self {
        Self { clock, time }
    }

    /// Whether less than a twentieth is left.
    pub(super) fn is_nearly_spent(&self) -> bool {
        self.time.is_some_and(|time| (self.clock)() >= time / 20 * 19)
    }

    /// When, by the clock, the part that begins now is to end, if so many in a row are left with it; `None` without a
    /// limit.
    pub(super) fn end_of_next(&self, left: usize) -> Option<Duration> {
        let (time, now) = (self.time?, (self.clock)());
        let share = time.saturating_sub(now) / u32::try_from(left.max(1)).unwrap_or(u32::MAX);
        Some(now.saturating_add(share))
    }

    /// Whether a part that is to end then has ended.
    pub(super) fn is_over(&self, end: Option<Duration>) -> bool {
        end.is_some_and(|end| (self.clock)() >= end)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_share_what_is_left() {
        let seconds = Duration::from_secs;
        let clock = || seconds(600);
        let unlimited = Shares::new(None, &clock);
        assert_eq!(unlimited.end_of_next(3), None);
        assert!(!unlimited.is_over(None));
        assert_eq!(Shares::new(Some(Duration::MAX), &clock).end_of_next(1), Some(Duration::MAX));
        let hour = Shares::new(Some(seconds(3_600)), &clock);
        assert_eq!(hour.end_of_next(4), Some(seconds(600 + 750)));
        assert_eq!(
            [599, 600, 601].map(|end| hour.is_over(Some(seconds(end)))),
            [true, true, false]
        );
        let spent = Shares::new(Some(seconds(60)), &clock);
        assert_eq!(spent.end_of_next(9), Some(seconds(600)));
        let nearly = Shares::new(Some(seconds(631)), &clock);
        let spent = [&spent, &nearly, &hour, &unlimited].map(Shares::is_nearly_spent);
        assert_eq!(spent, [true, true, false, false]);
    }
}
