//! How long a check may go on, and who watches it.

use std::time::{Duration, Instant};

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
pub(super) struct Shares {
    start: Instant,
    time: Option<Duration>,
}

impl Shares {
    /// The time begins.
    pub(super) fn begin(time: Option<Duration>) -> Self {
        Self { start: Instant::now(), time }
    }

    /// Whether less than a twentieth is left.
    pub(super) fn is_nearly_spent(&self) -> bool {
        self.time.is_some_and(|time| self.start.elapsed() >= time / 20 * 19)
    }

    /// When the part that begins now is to end, if so many in a row are left with it; `None` without a limit.
    pub(super) fn end_of_next(&self, left: usize) -> Option<Instant> {
        let rest = self.time?.saturating_sub(self.start.elapsed());
        let share = rest / u32::try_from(left.max(1)).unwrap_or(u32::MAX);
        // Beyond what a clock can show there is no limit.
        Instant::now().checked_add(share)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_share_what_is_left() {
        assert_eq!(Shares::begin(None).end_of_next(3), None);
        assert_eq!(Shares::begin(Some(Duration::MAX)).end_of_next(1), None);
        let hour = Shares::begin(Some(Duration::from_secs(3_600)));
        let share = hour.end_of_next(4).unwrap() - Instant::now();
        assert!(share > Duration::from_secs(800) && share <= Duration::from_secs(900), "{share:?}");
        let spent = Shares::begin(Some(Duration::ZERO));
        assert!(spent.end_of_next(9).unwrap() <= Instant::now());
        let nearly = [&spent, &hour, &Shares::begin(None)].map(Shares::is_nearly_spent);
        assert_eq!(nearly, [true, false, false]);
    }
}
