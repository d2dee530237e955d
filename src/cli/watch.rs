//! Whether files were saved again.
//!
//! They are looked at from time to time. A system's notices of changes were not taken: they do not come from drives of
//! other machines, and they follow a file rather than a name, while editors save by putting another file in its place.
//! A look at a few files costs microseconds.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;
use std::time::{Duration, SystemTime};

/// What tells one state of a file from another; none where there is no file.
type Stamp = Option<(SystemTime, u64)>;

/// The times of files may lag behind the clock by so much.
const LAG: Duration = Duration::from_millis(20);

/// Files, as they were when they were last read.
#[derive(Debug, Default)]
pub(crate) struct WatchedFiles {
    known: BTreeMap<PathBuf, Stamp>,
    /// How they were at the last look, if that was otherwise.
    seen: Option<BTreeMap<PathBuf, Stamp>>,
}

impl WatchedFiles {
    /// Watches these files, which were read since some time. Of those that were watched before, what was known is kept.
    pub(crate) fn set(&mut self, paths: impl IntoIterator<Item = PathBuf>, read_since: SystemTime) {
        let known = std::mem::take(&mut self.known);
        // What was written meanwhile may not be what was read: it counts as changed.
        let is_older = |(written, _): &(SystemTime, u64)| *written + LAG < read_since;
        let stamped = paths.into_iter().map(|path| {
            let stamp = known.get(&path).copied().unwrap_or_else(|| stamp(&path).filter(is_older));
            (path, stamp)
        });
        self.known = stamped.collect();
        self.seen = None;
    }

    /// Looks at the files: whether they were changed, and are as they were at the last look. So a file that is being
    /// written is not read before it is whole, unless its writer pauses.
    pub(crate) fn have_changed(&mut self) -> bool {
        let now: BTreeMap<_, _> =
            self.known.keys().map(|path| (path.clone(), stamp(path))).collect();
        if now == self.known {
            self.seen = None;
            return false;
        }
        if self.seen.as_ref() == Some(&now) {
            self.known = now;
            self.seen = None;
            return true;
        }
        self.seen = Some(now);
        false
    }
}

fn stamp(path: &PathBuf) -> Stamp {
    let metadata = fs::metadata(path).ok()?;
    Some((metadata.modified().ok()?, metadata.len()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_change_counts_once_it_has_settled() {
        let folder = tempfile::tempdir().unwrap();
        let [a, b] = ["a", "b"].map(|name| folder.path().join(name));
        fs::write(&a, "one").unwrap();
        std::thread::sleep(2 * LAG);
        let mut files = WatchedFiles::default();
        files.set([a.clone(), b.clone()], SystemTime::now());
        let mut looks = |count: usize| (0..count).map(|_| files.have_changed()).collect::<Vec<_>>();
        assert_eq!(looks(2), [false; 2]);
        fs::write(&a, "one and").unwrap();
        assert_eq!(looks(1), [false]);
        fs::write(&a, "one and two").unwrap();
        assert_eq!(looks(4), [false, true, false, false], "while it grew, and after");
        // One that was missing appears, and another is put in the place of one.
        fs::write(&b, "").unwrap();
        assert_eq!(looks(3), [false, true, false]);
        fs::write(folder.path().join("c"), "another length").unwrap();
        fs::rename(folder.path().join("c"), &a).unwrap();
        assert_eq!(looks(3), [false, true, false]);
        fs::remove_file(&b).unwrap();
        assert_eq!(looks(3), [false, true, false]);
    }

    #[test]
    fn what_is_watched_further_keeps_what_was_known() {
        let folder = tempfile::tempdir().unwrap();
        let a = folder.path().join("a");
        fs::write(&a, "one").unwrap();
        std::thread::sleep(2 * LAG);
        let mut files = WatchedFiles::default();
        files.set([a.clone()], SystemTime::now());
        fs::write(&a, "saved while it was read").unwrap();
        files.set([a.clone(), folder.path().join("b")], SystemTime::now());
        assert!(!files.have_changed() && files.have_changed());
    }

    #[test]
    fn what_was_written_while_it_was_read_counts_as_changed() {
        let folder = tempfile::tempdir().unwrap();
        let (start, a) = (SystemTime::now(), folder.path().join("a"));
        fs::write(&a, "one").unwrap();
        let mut files = WatchedFiles::default();
        files.set([a], start);
        let looks = [(); 3].map(|()| files.have_changed());
        assert_eq!(looks, [false, true, false]);
    }
}
