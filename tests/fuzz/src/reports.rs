//! What stands for every form of a report, whatever the record says: a record may come from anybody.

use srt::record::Comparison;
use srt::report::{Pictures, Report, read_json};

use crate::{csv, html, markdown};

/// Writes all forms and checks each.
///
/// # Panics
/// If one of them is not what it should be.
pub fn check_every_form(record: &Comparison) {
    let report = Report::new(record);
    let json = report.json().expect("a record is written");
    assert_eq!(read_json(&json).expect("it is read again"), *record);
    html::check(&report.html(&Pictures::new()));
    markdown::check(&report.markdown());
    csv::check(&report.csv());
    if let Some(table) = report.sampling_csv() {
        csv::check(&table);
    }
    let changes = report.terminal_changes().unwrap_or_default();
    for text in [report.terminal(), changes] {
        let controls = |c: char| c.is_control() && c != '\n';
        assert!(!text.contains(controls), "what could control a terminal: {text:?}");
    }
}
