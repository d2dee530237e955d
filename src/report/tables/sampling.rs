//! The tables of the chapter on sampling.

use super::{Cell, Table};
use crate::record::derived::OperationFigures;
use crate::record::{Pairing, SamplingChapter};
use crate::report::numbers;

/// Costs, shares of a frame, noise.
pub(in crate::report) fn sampling_tables(
    chapter: &SamplingChapter,
    operations: &[OperationFigures],
) -> Vec<Table> {
    vec![costs(operations), shares(chapter), noise(chapter)]
}

fn costs(operations: &[OperationFigures]) -> Table {
    let mut table = Table::new("What an operation costs", "", &["Operation", "#Time", "#Rounds"]);
    let row = |figures: &OperationFigures| {
        vec![
            Cell::text(&figures.operation),
            Cell::time(figures.ns),
            Cell::of(figures.ns, |estimate| estimate.rounds.to_string()),
        ]
    };
    table.rows = operations.iter().map(row).collect();
    table
}

fn shares(chapter: &SamplingChapter) -> Table {
    let mut table = Table::new("Share of a frame", "", &["Scene", "Part", "#Share"]);
    table.rows = chapter
        .shares
        .iter()
        .map(|share| {
            vec![
                Cell::text(&share.scene),
                Cell::text(&share.part),
                Cell::text(numbers::percent(share.share)),
            ]
        })
        .collect();
    table
}

fn noise(chapter: &SamplingChapter) -> Table {
    let heads = ["Scene", "Equal", "Sampling", "#View samples", "#Light samples", "#Time", "#RMSE"];
    let note = "Root of the mean squared difference to a converged picture, in linear units.";
    let mut table = Table::new("Noise that is left", note, &heads);
    table.rows = chapter
        .noise
        .iter()
        .map(|point| {
            let equal = match point.pairing {
                Pairing::EqualSamples => "samples",
                Pairing::EqualTime => "time",
            };
            vec![
                Cell::text(&point.scene),
                Cell::text(equal),
                Cell::text(&point.sampling),
                Cell::text(point.pixel_samples.to_string()),
                Cell::text(point.light_samples.to_string()),
                Cell::text(numbers::time(point.seconds * 1e9)),
                Cell::text(numbers::figures(point.rmse)),
            ]
        })
        .collect();
    table
}
