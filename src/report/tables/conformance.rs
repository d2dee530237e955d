//! The checks of conformance: which structures keep the contract, as far as that was tried.

use super::{Cell, Table};
use crate::record::{Comparison, Conformance, ConformanceOutcome};
use crate::report::numbers;

/// A row for each structure that was checked; without rows where all are the program's own.
pub(in crate::report) fn conformance_table(comparison: &Comparison) -> Table {
    let heads = ["Structure", "Result", "#Rays", "#Hits", "#Meshes", "#Time"];
    let note = "Structures that are not srt's own were checked before all scenes: their answers must equal \
                those of no structure, bit for bit, for rays that are made to find differences, at awkward \
                meshes at several scales. One whose answers differ is not timed.";
    let mut table = Table::new("Conformance", note, &heads);
    table.rows = comparison.conformance.iter().map(row).collect();
    table
}

fn row(own: &Conformance) -> Vec<Cell> {
    let equal = own.holds().then_some(own);
    vec![
        Cell::text(&own.structure),
        Cell::text(result(own)),
        Cell::of(equal, |own| numbers::whole(own.rays)),
        Cell::of(equal, |own| numbers::whole(own.hits)),
        Cell::of(equal, |own| match own.is_whole() {
            true => numbers::whole(own.meshes),
            false => {
                format!("{} of {}", numbers::whole(own.meshes_checked), numbers::whole(own.meshes))
            }
        }),
        Cell::text(numbers::time(own.seconds * 1e9)),
    ]
}

fn result(own: &Conformance) -> String {
    match &own.outcome {
        ConformanceOutcome::Differs(first) => format!("DIFFERS at mesh {}", first.mesh),
        ConformanceOutcome::Failed { message } => format!("failed: {message}"),
        ConformanceOutcome::Equal if own.rays == 0 => "no time for a ray".to_owned(),
        ConformanceOutcome::Equal if own.is_whole() => "no difference".to_owned(),
        ConformanceOutcome::Equal => "no difference so far; the time was over".to_owned(),
    }
}
