//! The JSON of two records, a line each → what changed from the first to the second, in every form of a report.
#![no_main]

use libfuzzer_sys::{fuzz_mutator, fuzz_target};
use srt::analysis::baseline::{compare, improvements, regressions};
use srt::record::{Change, Comparison};
use srt::report::read_json;

/// From which slowdown on a change is a regression.
const THRESHOLD: f64 = 0.1;

fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
    srt_fuzz::mutate_json(data, size, max_size, seed)
});

fuzz_target!(|data: &[u8]| {
    let text = String::from_utf8_lossy(data);
    let mut lines = text.split('\n');
    let old = lines.next().and_then(|line| read_json(line).ok());
    let new = lines.next().and_then(|line| read_json(line).ok());
    let both = old.zip(new);
    if let Some((old, new)) = &both {
        check(old, new);
    }
    srt_fuzz::count(both.is_some());
});

fn check(old: &Comparison, new: &Comparison) {
    let baseline = compare(old, new, THRESHOLD);
    for change in &baseline.outcome.changes {
        check_change(change, old, new);
    }
    let slower = |slower: &Change| improvements(&baseline).all(|faster| faster != slower);
    assert!(regressions(&baseline).all(slower), "slower and faster at once");
    // A record is no regression of itself.
    let itself = compare(new, new, THRESHOLD);
    assert_eq!(regressions(&itself).count(), 0, "{:?}", itself.outcome.changes);
    let with_baseline = Comparison { baseline: Some(baseline), ..new.clone() };
    srt_fuzz::check_every_form(&with_baseline);
}

/// It is of a scene and a structure that both records have, and its interval is one.
fn check_change(change: &Change, old: &Comparison, new: &Comparison) {
    for record in [old, new] {
        let mut scenes = record.scenes.iter().filter(|scene| scene.name == change.scene);
        assert!(scenes.any(|scene| scene.structure(&change.structure).is_some()));
    }
    if let Some(interval) = change.slowdown.interval {
        assert!(!(interval.low > interval.high), "{change:?}");
    }
}
