//! The chapter on sampling in one sentence.

use super::{Report, numbers};
use crate::analysis::statistics::median;
use crate::analysis::{Analysis, NoiseFigures, Pairing};
use crate::record::SamplingChapter;

/// The noise of a method relative to `independent`, and its share of a frame; the medians over several scenes. `None`
/// without frames.
pub(super) fn sampling_verdict(report: &Report<'_>) -> Option<String> {
    let Report { comparison, analysis, .. } = report;
    let chapter = comparison.sampling.as_ref()?;
    let first = chapter.parts.first()?;
    let own = first.sampling.as_str();
    let samples = first.pixel_samples;
    let noise = |pairing| {
        let ratio = |figures: &NoiseFigures| {
            let is_own = figures.pairing == pairing
                && figures.sampling == own
                && figures.pixel_samples == f64::from(samples);
            is_own.then_some(figures.ratio?.value)
        };
        median(&analysis.noise.iter().filter_map(ratio).collect::<Vec<_>>()).map(numbers::figures)
    };
    let mut scenes: Vec<&str> = chapter.parts.iter().map(|part| part.scene.as_str()).collect();
    scenes.dedup();
    let place = match scenes.as_slice() {
        [scene] => (*scene).to_owned(),
        scenes => format!("the median of {} scenes", scenes.len()),
    };
    let for_samples = noise(Pairing::EqualSamples)?;
    let for_time = noise(Pairing::EqualTime)
        .map_or_else(String::new, |ratio| format!(" and {ratio}\u{a0}× in equal time"));
    Some(format!(
        "Sampling: {own} leaves {for_samples}\u{a0}× the noise of independent with {samples} view \
         samples{for_time} ({place}){}.",
        share(chapter, analysis, own, &scenes)
            .map_or_else(String::new, |share| format!(", and takes {share} of a frame")),
    ))
}

/// All parts of a method's frame together.
fn share(
    chapter: &SamplingChapter,
    analysis: &Analysis,
    sampling: &str,
    scenes: &[&str],
) -> Option<String> {
    let of_scene = |scene: &&str| -> Option<f64> {
        let parts = chapter.parts.iter().zip(&analysis.shares);
        let own = parts.filter(|(part, _)| part.scene == *scene && part.sampling == sampling);
        own.map(|(_, figures)| figures.share).sum()
    };
    let shares: Option<Vec<f64>> = scenes.iter().map(of_scene).collect();
    median(&shares?).map(numbers::small_percent)
}
