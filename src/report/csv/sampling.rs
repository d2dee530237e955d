//! The chapter on sampling → CSV: a line for each cost, share and noise.

use super::{line, number, parts, text, whole};
use crate::analysis::Pairing;
use crate::report::Report;

const HEADS: [&str; 18] = [
    "what",
    "scene",
    "sampling",
    "operation",
    "equal",
    "pixel_samples",
    "light_samples",
    "count",
    "rounds",
    "ns",
    "ns_low",
    "ns_high",
    "share",
    "rmse",
    "rmse_low",
    "rmse_high",
    "ratio",
    "converged_rmse",
];

/// Writes the table; `None` without the chapter. Its numbers read back equal to those in the JSON's `derived`. A line
/// is of one of four kinds, given in `what`: `cost`, `share`, `noise`, `converged`.
pub(in crate::report) fn write_sampling(report: &Report<'_>) -> Option<String> {
    let Report { comparison, analysis, .. } = report;
    let chapter = comparison.sampling.as_ref()?;
    let mut lines = line(HEADS.map(str::to_owned));
    for (cost, figures) in chapter.costs.iter().zip(&analysis.operations) {
        let [ns, low, high] = parts(figures.ns);
        lines += &row(&[
            ("what", "cost".to_owned()),
            ("operation", text(&figures.operation)),
            ("count", cost.count.to_string()),
            ("rounds", whole(figures.ns.map(|estimate| estimate.rounds as u64))),
            ("ns", ns),
            ("ns_low", low),
            ("ns_high", high),
        ]);
    }
    for (part, figures) in chapter.parts.iter().zip(&analysis.shares) {
        lines += &row(&[
            ("what", "share".to_owned()),
            ("scene", text(&part.scene)),
            ("sampling", text(&part.sampling)),
            ("operation", text(&part.operation)),
            ("pixel_samples", part.pixel_samples.to_string()),
            ("count", part.count.to_string()),
            ("share", number(figures.share)),
        ]);
    }
    for figures in &analysis.noise {
        let [ns, ns_low, ns_high] = parts(Some(figures.ns));
        let [rmse, rmse_low, rmse_high] = parts(Some(figures.rmse));
        let equal = match figures.pairing {
            Pairing::EqualSamples => "samples",
            Pairing::EqualTime => "time",
        };
        lines += &row(&[
            ("what", "noise".to_owned()),
            ("scene", text(&figures.scene)),
            ("sampling", text(&figures.sampling)),
            ("equal", equal.to_owned()),
            ("pixel_samples", number(Some(figures.pixel_samples))),
            ("light_samples", figures.light_samples.to_string()),
            ("rounds", figures.rmse.rounds.to_string()),
            ("ns", ns),
            ("ns_low", ns_low),
            ("ns_high", ns_high),
            ("rmse", rmse),
            ("rmse_low", rmse_low),
            ("rmse_high", rmse_high),
            ("ratio", number(figures.ratio.map(|ratio| ratio.value))),
        ]);
    }
    for picture in &chapter.converged {
        lines += &row(&[
            ("what", "converged".to_owned()),
            ("scene", text(&picture.scene)),
            ("pixel_samples", picture.pixel_samples.to_string()),
            ("light_samples", picture.light_samples.to_string()),
            ("count", picture.passes.to_string()),
            ("converged_rmse", number(Some(picture.rmse))),
        ]);
    }
    Some(lines)
}

/// A line with the named fields; all others are empty.
fn row(fields: &[(&str, String)]) -> String {
    let field = |head: &str| fields.iter().find(|(name, _)| *name == head);
    line(HEADS.map(|head| field(head).map_or_else(String::new, |(_, text)| text.clone())))
}
