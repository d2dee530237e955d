//! A record against an older one.

use srt::record::baseline::Changes;
use srt::record::{Comparison, RayClass};
use srt::report::terminal;

use crate::sample;

/// The sample with the view rays of `bvh` in the bunny scene slower by a factor.
fn slower(factor: f64) -> Comparison {
    let mut comparison = sample::full();
    for round in &mut comparison.scenes[0].structures[2].classes[0].rounds {
        round.wall_ns = (round.wall_ns as f64 * factor) as u64;
        round.cpu_ns = round.cpu_ns.map(|cpu| (cpu as f64 * factor) as u64);
    }
    comparison
}

#[test]
fn a_record_is_no_regression_of_itself() {
    let changes = Changes::between(&sample::full(), &sample::full());
    assert_eq!(changes.changes.len(), 6 * 7);
    assert!(changes.doubts.is_empty(), "{:?}", changes.doubts);
    assert_eq!(changes.regressions(0.0).count() + changes.improvements(0.0).count(), 0);
    let text = terminal::write_changes(&changes, 0.1);
    assert_eq!(text, "nothing of 42 measurements changed by more than 10.0\u{a0}% for sure\n");
}

#[test]
fn a_regression_is_named_where_the_interval_excludes_the_threshold() {
    let changes = Changes::between(&sample::full(), &slower(1.3));
    let named: Vec<_> = changes.regressions(0.1).collect();
    assert_eq!(named.len(), 1);
    assert_eq!((named[0].scene.as_str(), named[0].structure.as_str()), ("bunny", "bvh"));
    assert_eq!(named[0].class, RayClass::View);
    assert!((named[0].slowdown.median - 1.3).abs() < 1e-6);
    assert_eq!(changes.regressions(0.3).count(), 0, "1.3 is within the interval");
    let text = terminal::write_changes(&changes, 0.1);
    let start = "slower: view rays of bunny with bvh take 1.30 × the baseline's time (95 % 1.2";
    assert!(text.starts_with(start), "{text}");
}

#[test]
fn an_improvement_is_no_regression() {
    let changes = Changes::between(&slower(1.3), &sample::full());
    assert_eq!(changes.regressions(0.1).count(), 0);
    assert_eq!(changes.improvements(0.1).count(), 1);
}

#[test]
fn few_rounds_are_never_sure() {
    let mut new = slower(3.0);
    new.scenes[0].structures[2].classes[0].rounds.truncate(3);
    let changes = Changes::between(&sample::full(), &new);
    assert_eq!(changes.regressions(0.1).count(), 0);
}

#[test]
fn what_cannot_be_compared_is_a_doubt() {
    let mut new = sample::full();
    new.run.machine.cpu = "another".to_owned();
    new.scenes[0].hash = "changed".to_owned();
    new.scenes[1].structures[2].classes.clear();
    new.scenes[1].structures[3].classes[0].rays += 1;
    let mut old = sample::full();
    old.scenes[1].structures[1].classes.remove(0);
    let changes = Changes::between(&old, &new);
    let doubts = [changes.warnings.join("\n"), changes.doubts.join("\n")].join("\n");
    for doubt in [
        "The processor was Example CPU <16 & more> @ 2.60GHz and is another.",
        "The scene bunny has changed and is not compared.",
        "The baseline has no view rays of hall with ball.",
        "bvh was not measured in hall, but in the baseline.",
        "307201 view rays of hall with cwbvh were traced where the baseline traced 307200",
    ] {
        assert!(doubts.contains(doubt), "{doubt} is not among\n{doubts}");
    }
    assert!(changes.changes.iter().all(|change| change.scene == "hall"));
    let text = terminal::write_changes(&changes, 0.1);
    assert!(text.starts_with("WARNING: The processor was Example CPU"), "{text}");
    old.scenes.clear();
    assert_eq!(Changes::between(&old, &new).changes, []);
}
