//! Records of numbers and texts that no run gives, but a file may have: found by `tests/fuzz`, or of its kinds.

use serde_json::{Number, Value};
use srt::record::{Comparison, PeerAgreement};
use srt::report::{Pictures, Report};

use crate::sample;

/// The record with each number that its field takes in place of the own one.
fn with_numbers(comparison: &Comparison, numbers: &[Number]) -> Comparison {
    fn visit(value: &mut Value, paths: &mut Vec<String>, path: &str) {
        match value {
            Value::Number(_) => paths.push(path.to_owned()),
            Value::Array(list) => {
                // The first ones stand for all.
                for (i, own) in list.iter_mut().enumerate().take(2) {
                    visit(own, paths, &format!("{path}/{i}"));
                }
            }
            Value::Object(fields) => {
                for (name, own) in fields {
                    visit(own, paths, &format!("{path}/{name}"));
                }
            }
            _ => {}
        }
    }
    let mut value = serde_json::to_value(comparison).unwrap();
    let mut paths = Vec::new();
    visit(&mut value, &mut paths, "");
    paths.retain(|path| path != "/schema_version");
    assert!(paths.len() > 200, "{}", paths.len());
    for path in paths {
        for number in numbers {
            let place = value.pointer_mut(&path).unwrap();
            let old = std::mem::replace(place, Value::Number(number.clone()));
            if serde_json::from_value::<Comparison>(value.clone()).is_ok() {
                break;
            }
            *value.pointer_mut(&path).unwrap() = old;
        }
    }
    serde_json::from_value(value).unwrap()
}

/// The values of the attributes that place something in a plot.
fn places(page: &str) -> impl Iterator<Item = &str> {
    const NAMES: [&str; 8] = ["x", "y", "x1", "y1", "cx", "cy", "width", "points"];
    NAMES.iter().flat_map(|name| {
        let start = format!(" {name}=\"");
        page.match_indices(&start)
            .map(|(at, _)| page[at + start.len()..].split_once('"').unwrap().0)
            .collect::<Vec<_>>()
    })
}

#[test]
fn any_numbers_have_a_report() {
    let whole = [u64::MAX, u64::from(u32::MAX)].map(Number::from);
    let floats = |float: f64| [vec![Number::from_f64(float).unwrap()], whole.to_vec()].concat();
    let zeros = [Number::from_f64(0.0).unwrap(), 0.into()];
    for numbers in [&floats(f64::MAX), &floats(-f64::MAX), &floats(5e-324), &zeros[..]] {
        let record = with_numbers(&sample::full(), numbers);
        let report = Report::new(&record);
        let page = report.html(&Pictures::new());
        let wrong: Vec<_> =
            places(&page).filter(|place| place.contains(char::is_alphabetic)).collect();
        assert!(wrong.is_empty(), "{numbers:?}: {wrong:?}");
        assert!(places(&page).count() > 100);
        assert!(!report.markdown().is_empty() && !report.csv().is_empty());
        assert!(!report.terminal().is_empty() && report.terminal_changes().is_some());
        report.json().unwrap();
    }
}

#[test]
fn sums_of_large_numbers_do_not_begin_again_at_0() {
    let mut record = sample::full();
    for scene in &mut record.scenes {
        let proof = scene.proof.as_mut().unwrap();
        proof.structures.iter_mut().for_each(|entry| entry.rays_checked = u64::MAX);
        proof.peers = vec![PeerAgreement { rays_agreeing: 3, ..PeerAgreement::default() }];
    }
    let report = Report::new(&record);
    let verdict = report.verdict();
    assert!(
        verdict.contains("18\u{a0}447\u{a0}M") || verdict.contains("G compared rays"),
        "{verdict}"
    );
    assert!(report.markdown().contains("| 0 disagree |"), "more rays agree than there are");
}

#[test]
fn text_of_the_record_does_not_control_the_terminal() {
    let mut record = sample::full();
    let hostile = "\u{1b}[2J\u{7}a\r\nb\u{202e}";
    record.scenes[0].name = hostile.to_owned();
    record.scenes[0].structures[1].name = hostile.to_owned();
    record.sweeps[0].mesh = hostile.to_owned();
    let baseline = record.baseline.as_mut().unwrap();
    baseline.outcome.warnings = vec![hostile.to_owned()];
    baseline.outcome.doubts = vec![hostile.to_owned()];
    baseline.outcome.changes.iter_mut().for_each(|change| change.scene = hostile.to_owned());
    let report = Report::new(&record);
    for text in [report.terminal(), report.terminal_changes().unwrap()] {
        let controls = |c: char| (c.is_control() && c != '\n') || c == '\u{202e}';
        assert!(!text.contains(controls), "{text:?}");
        assert!(text.contains("\u{fffd}[2J\u{fffd}a\u{fffd}\u{fffd}b\u{fffd}"), "{text}");
    }
}
