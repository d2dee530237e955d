//! The tables of the chapter on sampling.

use super::{Cell, Table};
use crate::analysis::{Analysis, NoiseFigures, OperationFigures, Pairing, ShareFigures};
use crate::record::{ConvergedPicture, FramePart, SamplingChapter};
use crate::report::numbers;

/// Costs, shares of a frame, noise, and what it was measured against.
pub(in crate::report) fn sampling_tables(
    chapter: &SamplingChapter,
    analysis: &Analysis,
) -> Vec<Table> {
    vec![
        costs(&analysis.operations),
        shares(&chapter.parts, &analysis.shares),
        noise(
            "Noise that is left by equal samples",
            "Root of the mean squared difference to a converged picture, in linear units; medians \
             of frames with different random numbers. Time is processor time on one thread. In each \
             round both methods trace the same view rays. The ratio is the median of the rounds' \
             ratios.",
            Pairing::EqualSamples,
            &analysis.noise,
        ),
        noise(
            "Noise that is left after equal time",
            "Times are those of the measured shuffled frames. Noise and number of independent samples \
             at these times are interpolated between the measured independent frames, on \
             logarithmic axes. Times outside their range are left out.",
            Pairing::EqualTime,
            &analysis.noise,
        ),
        converged(&chapter.converged),
    ]
}

fn costs(operations: &[OperationFigures]) -> Table {
    let note = "Measured in batches on one thread, in interleaved rounds.";
    let mut table = Table::new("What an operation costs", note, &["Operation", "#Time", "#Rounds"]);
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

fn shares(parts: &[FramePart], shares: &[ShareFigures]) -> Table {
    let heads = ["Scene", "Sampling", "#View samples", "Part", "#Times in a frame", "#Share"];
    let note = "How often a frame performs the operation, times its cost in a batch, over the median \
                processor time of the frame on one thread. Within a renderer the operation may cost \
                more than in a batch.";
    let mut table = Table::new("Share of a frame", note, &heads);
    let row = |(part, figures): (&FramePart, &ShareFigures)| {
        vec![
            Cell::text(&part.scene),
            Cell::text(&part.sampling),
            Cell::text(part.pixel_samples.to_string()),
            Cell::text(&part.operation),
            Cell::text(numbers::whole(part.count)),
            Cell::of(figures.share, numbers::small_percent),
        ]
    };
    table.rows = parts.iter().zip(shares).map(row).collect();
    table
}

fn noise(title: &str, note: &str, pairing: Pairing, noise: &[NoiseFigures]) -> Table {
    let heads = [
        "Scene",
        "Sampling",
        "#View samples",
        "#Light samples",
        "#Time",
        "#RMSE",
        "#× independent",
        "#Rounds",
    ];
    let mut table = Table::new(title, note, &heads);
    let number = match pairing {
        Pairing::EqualSamples => Cell::estimate,
        Pairing::EqualTime => Cell::interpolated_or_measured,
    };
    let row = |figures: &NoiseFigures| {
        vec![
            Cell::text(&figures.scene),
            Cell::text(&figures.sampling),
            Cell::text(samples(figures.pixel_samples)),
            Cell::text(figures.light_samples.to_string()),
            Cell::time(Some(figures.ns)),
            number(Some(figures.rmse)),
            number(figures.ratio),
            Cell::text(figures.rmse.rounds.to_string()),
        ]
    };
    table.rows = noise.iter().filter(|own| own.pairing == pairing).map(row).collect();
    table
}

/// Whole numbers without decimals, others rounded as everywhere.
fn samples(n: f64) -> String {
    if n.fract() == 0.0 { format!("{n}") } else { numbers::figures(n) }
}

fn converged(pictures: &[ConvergedPicture]) -> Table {
    let heads = ["Scene", "#Width", "#Height", "#Renderings", "#View", "#Light", "#Own RMSE"];
    let note = "The mean of renderings with independent samples. View samples are per pixel and \
                rendering, light samples per view sample and light. The noise of the mean itself is \
                estimated from the differences between its renderings, and is included in all noise \
                above.";
    let mut table = Table::new("Converged pictures", note, &heads);
    let row = |picture: &ConvergedPicture| {
        vec![
            Cell::text(&picture.scene),
            Cell::text(picture.width.to_string()),
            Cell::text(picture.height.to_string()),
            Cell::text(picture.passes.to_string()),
            Cell::text(picture.pixel_samples.to_string()),
            Cell::text(picture.light_samples.to_string()),
            Cell::text(numbers::figures(picture.rmse)),
        ]
    };
    table.rows = pictures.iter().map(row).collect();
    table
}
