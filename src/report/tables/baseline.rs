//! The table of what changed against an older record.

use super::{Cell, Table};
use crate::analysis::baseline::{improvements, regressions};
use crate::record::{Baseline, Change};
use crate::report::numbers;

/// What became slower or faster at 95 % confidence, each with its interval.
pub(in crate::report) fn baseline_table(baseline: &Baseline) -> Table {
    let Baseline { threshold, outcome } = baseline;
    let heads = ["Scene", "Structure", "Class", "Outcome", "#× the baseline's time"];
    let (slower, faster) = (regressions(baseline), improvements(baseline));
    let mut table = Table::new("Against the baseline", "", &heads);
    table.rows = slower.map(|change| row(change, "SLOWER")).collect();
    table.rows.extend(faster.map(|change| row(change, "faster")));
    table.note = format!(
        "{} of {} changed by more than {} at 95 % confidence: the whole interval of the ratio lies \
         beyond that. {}",
        table.rows.len(),
        numbers::things(outcome.changes.len() as u64, "measurement"),
        numbers::percent(*threshold),
        outcome.doubts.join(" "),
    );
    table
}

fn row(change: &Change, outcome: &str) -> Vec<Cell> {
    vec![
        Cell::text(&change.scene),
        Cell::text(&change.structure),
        Cell::text(change.class.name()),
        Cell::text(outcome),
        Cell::estimate(Some(change.slowdown)),
    ]
}
