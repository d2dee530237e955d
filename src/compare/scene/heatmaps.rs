//! The fifth step: what the rays of each pixel tested, for each structure, on one scale.

use crate::compare::budget::Budget;
use crate::compare::candidate::Candidate;
use crate::compare::context::SceneContext;
use crate::compare::render_picture::render_whole;
use crate::image_io::Picture;
use crate::record::{HeatScale, Spacing};
use crate::render::{Image, Scale, Settings, View, heat_picture};

use super::picture_times::PictureTimes;
use super::recording::SceneRays;

/// The share of what is left of a scene's budget that its heatmaps may take.
const SHARE_OF_HEATMAPS: f64 = 0.2;

/// Scales whose ends are further apart than by this factor have steps of equal factors.
const WIDE_SCALE: f64 = 30.0;

/// The heatmaps of a scene.
pub(super) struct Heatmaps {
    /// Absent if there is none.
    pub(super) scale: Option<HeatScale>,
    /// Each with the place of its structure.
    pub(super) pictures: Vec<(usize, Picture)>,
    /// What a reader should know of them.
    pub(super) notes: Option<String>,
}

/// Draws the heatmaps of all structures that have the time, one view sample a pixel. Peers have
/// none, because they count no tests.
pub(super) fn draw_all(
    context: &SceneContext<'_>,
    candidates: &mut [Candidate<'_>],
    rays: &SceneRays,
    budget: Budget,
) -> Heatmaps {
    let settings = Settings { aa: 0, view: View::Heatmap, ..context.picture_settings() };
    let budget = budget.share(SHARE_OF_HEATMAPS);
    let times = PictureTimes::of_renderings(context, candidates, rays, &settings, budget);
    let notes = times.note_missing(candidates, "heatmap");
    let mut fit = times.fit;
    fit.retain(|&i| !candidates[i].is_peer());
    let mut fields = Vec::new();
    for index in fit {
        match render_whole(context, &mut candidates[index], &settings) {
            Some(Image::Scalar { values, .. }) => fields.push((index, values)),
            Some(Image::Color(_)) | None => {}
        }
    }
    let all: Vec<f32> = fields.iter().flat_map(|(_, values)| values).copied().collect();
    let Some(scale) = heat_scale(&all) else {
        return Heatmaps { scale: None, pictures: Vec::new(), notes };
    };
    let picture = |(index, values): (usize, Vec<f32>)| {
        (index, colored(settings.width, settings.height, &values, &scale))
    };
    let pictures = fields.into_iter().map(picture).collect();
    Heatmaps { scale: Some(scale), pictures, notes }
}

/// From the least to the most of all tests.
fn heat_scale(values: &[f32]) -> Option<HeatScale> {
    let Scale { low, high, .. } = Scale::of(values)?;
    let (low, high) = (f64::from(low), f64::from(high));
    if high > WIDE_SCALE * low.max(1.0) {
        return Some(HeatScale { low: low.max(1.0), high, spacing: Spacing::Logarithmic });
    }
    Some(HeatScale { low, high, spacing: Spacing::Linear })
}

fn colored(width: u32, height: u32, values: &[f32], scale: &HeatScale) -> Picture {
    let (low, high) = (scale.low as f32, scale.high as f32);
    let scale = Scale { low, high, spacing: scale.spacing };
    heat_picture(width, height, values, scale)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_scale_spans_all_and_wide_ones_step_by_factors() {
        let narrow = heat_scale(&[2.0, 40.0]).unwrap();
        assert_eq!((narrow.low, narrow.high, narrow.spacing), (2.0, 40.0, Spacing::Linear));
        let wide = heat_scale(&[0.0, 70_000.0]).unwrap();
        assert_eq!((wide.low, wide.high, wide.spacing), (1.0, 70_000.0, Spacing::Logarithmic));
        let picture = colored(3, 1, &[0.0, 300.0, 70_000.0], &wide);
        let brightness = |i: usize| picture.pixels[i].element_sum();
        assert!(brightness(0) < brightness(1) && brightness(1) < brightness(2));
        assert!(heat_scale(&[]).is_none());
    }
}
