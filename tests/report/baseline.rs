//! A record against an older one.

use srt::analysis::baseline::{compare, improvements, regressions};
use srt::record::{Baseline, Comparison, RayClass};
use srt::report::Report;

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

/// What the terminal shows of it.
fn text(baseline: Baseline) -> String {
    let mut comparison = sample::minimal();
    comparison.baseline = Some(baseline);
    Report::new(&comparison).terminal_changes().unwrap()
}

#[test]
fn a_record_is_no_regression_of_itself() {
    let same = |threshold| compare(&sample::full(), &sample::full(), threshold);
    let baseline = same(0.0);
    assert_eq!(baseline.outcome.changes.len(), 6 * 7);
    assert!(baseline.outcome.doubts.is_empty(), "{:?}", baseline.outcome.doubts);
    assert_eq!(regressions(&baseline).count() + improvements(&baseline).count(), 0);
    let nothing = "none of 42 measurements changed by more than 10.0\u{a0}% at 95 % confidence\n";
    assert_eq!(text(same(0.1)), nothing);
    assert_eq!(Report::new(&sample::minimal()).terminal_changes(), None);
}

#[test]
fn a_regression_is_named_where_the_interval_excludes_the_threshold() {
    let baseline = compare(&sample::full(), &slower(1.3), 0.1);
    let named: Vec<_> = regressions(&baseline).collect();
    assert_eq!(named.len(), 1);
    assert_eq!((named[0].scene.as_str(), named[0].structure.as_str()), ("bunny", "bvh"));
    assert_eq!(named[0].class, RayClass::View);
    assert!((named[0].slowdown.value - 1.3).abs() < 1e-6);
    let at_the_median = compare(&sample::full(), &slower(1.3), 0.3);
    assert_eq!(regressions(&at_the_median).count(), 0, "1.3 is within the interval");
    let text = text(baseline);
    let start = "slower: view rays of bunny with bvh take 1.30 × the baseline's time (95 % 1.2";
    assert!(text.starts_with(start), "{text}");
}

#[test]
fn an_improvement_is_no_regression() {
    let baseline = compare(&slower(1.3), &sample::full(), 0.1);
    assert_eq!(regressions(&baseline).count(), 0);
    assert_eq!(improvements(&baseline).count(), 1);
}

#[test]
fn few_rounds_show_no_change() {
    let mut new = slower(3.0);
    new.scenes[0].structures[2].classes[0].rounds.truncate(3);
    assert_eq!(regressions(&compare(&sample::full(), &new, 0.1)).count(), 0);
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
    let mut shadow = old.scenes[1].structures[3].classes[1].clone();
    shadow.class = RayClass::Shadow;
    old.scenes[1].structures[0].classes.push(shadow);
    let baseline = compare(&old, &new, 0.1);
    let changes = &baseline.outcome;
    let doubts = [changes.warnings.join("\n"), changes.doubts.join("\n")].join("\n");
    for doubt in [
        "The processor was Example CPU <16 & more> @ 2.60GHz and is another.",
        "The scene bunny has changed and is not compared.",
        "The baseline has no view rays of hall with ball.",
        "The baseline measured view, shadow, mirror, refraction, diffuse, random rays of hall with bvh; \
         the new run did not.",
        "The baseline measured shadow rays of hall with none; the new run did not.",
        "307201 view rays of hall with cwbvh were recorded, 307200 in the baseline",
    ] {
        assert!(doubts.contains(doubt), "{doubt} is not among\n{doubts}");
    }
    assert!(changes.changes.iter().all(|change| change.scene == "hall"));
    let text = text(baseline);
    assert!(text.starts_with("WARNING: The processor was Example CPU"), "{text}");
    old.scenes.clear();
    assert_eq!(compare(&old, &new, 0.1).outcome.changes, []);
}
