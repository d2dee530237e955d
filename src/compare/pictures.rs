//! Whole pictures: the time from a compiled scene to its picture, and heatmaps on one scale.

use std::time::{Duration, Instant};

use crate::accel::Tracer;
use crate::image_io::Picture;
use crate::record::{HeatScale, PictureFile, PictureRound, RoundRule, Spacing};
use crate::render::{self, Image, Rendering, Scale, Settings, View, heat_picture, render};
use crate::scene::{Scene, TracedWorld};

use super::Stage;
use super::budget::Budget;
use super::clock::{nanoseconds, timed};
use super::entrant::Entrant;
use super::guard::guarded;
use super::hash::picture_hash;
use super::record_rays::Recording;
use super::rounds::{Repeat, interleaved};

/// What a ray costs beside its search: shading, sampling, and the handling of waves.
const SHADING: Duration = Duration::from_nanos(150);

/// A picture that takes longer than so many budgets for all of them is given up.
const OVERDRAWN: u32 = 3;

/// Scales whose ends are further apart than this have steps of equal factors.
const WIDE_SCALE: f64 = 30.0;

/// How long a picture will take about, by what its rays take: `ray_times` are those of the
/// recording's sets.
pub(super) fn estimate(
    recording: &Recording,
    ray_times: &[Option<Duration>],
    samples: f64,
    threads: usize,
) -> Option<Duration> {
    let mut seconds = 0.0;
    for (set, time) in recording.sets.iter().zip(ray_times) {
        let time = (*time)? + SHADING;
        seconds += recording.rays_per_sample(set.class) * samples * time.as_secs_f64();
    }
    Some(Duration::from_secs_f64((seconds / threads as f64).min(1e9)))
}

/// Which structures have time for something, the quickest first: their times add up to no more
/// than `budget`.
pub(super) fn that_fit(times: &[Option<Duration>], budget: Duration) -> Vec<usize> {
    let mut known: Vec<(Duration, usize)> =
        times.iter().enumerate().filter_map(|(i, time)| Some(((*time)?, i))).collect();
    known.sort();
    let mut sum = Duration::ZERO;
    let fits = known.into_iter().take_while(|(time, _)| {
        sum = sum.saturating_add(*time);
        sum <= budget
    });
    let mut fit: Vec<usize> = fits.map(|(_, index)| index).collect();
    fit.sort_unstable();
    fit
}

/// Builds and renders in interleaved rounds with some of the structures; gives the picture of each.
pub(super) fn measure(
    entrants: &mut [Entrant<'_>],
    fit: &[usize],
    settings: &Settings,
    stage: &Stage<'_>,
    budget: Budget,
) -> Vec<Option<Picture>> {
    let mut pictures: Vec<Option<Picture>> = vec![None; entrants.len()];
    let rule = RoundRule { warmup: 0, ..stage.plan.rounds.clone() };
    let repeat = Repeat { rule: &rule, budget, cancelled: &|| (stage.cancelled)() };
    let (start, longest) = (Instant::now(), budget.left().saturating_mul(OVERDRAWN));
    let stop = || (stage.cancelled)() || start.elapsed() > longest;
    let rounds = interleaved(fit.len(), &repeat, |lane| {
        let entrant = &mut entrants[fit[lane]];
        let work = || {
            let build = || entrant.structure.build(stage.scene, &stage.plan.build);
            let (world, build) = timed(build);
            (render_with(stage.scene, &*world, settings, &stop), build)
        };
        match stage.pools.all.install(|| guarded(work)) {
            Ok((rendering, build)) if rendering.complete => {
                let render_ns = nanoseconds(rendering.stats.time);
                if let Image::Color(picture) = rendering.image {
                    pictures[fit[lane]].get_or_insert(picture);
                }
                let round = PictureRound { build_ns: build.wall_ns, render_ns };
                Some((round, round.build_ns.saturating_add(render_ns)))
            }
            Ok(_) => None,
            Err(message) => {
                entrant.fail(message);
                None
            }
        }
    });
    for (lane, rounds) in rounds.into_iter().enumerate() {
        entrants[fit[lane]].record.picture_rounds = rounds;
    }
    pictures
}

/// A structure's picture, not timed; `None` if it fails or the comparison is stopped.
pub(super) fn render_once(
    entrant: &mut Entrant<'_>,
    settings: &Settings,
    stage: &Stage<'_>,
) -> Option<Picture> {
    let render = |world: &dyn TracedWorld| {
        let render = || render_with(stage.scene, world, settings, stage.cancelled);
        stage.pools.all.install(render)
    };
    let rendering = entrant.attempt(render).filter(|rendering| rendering.complete)?;
    match rendering.image {
        Image::Color(picture) => Some(picture),
        Image::Scalar { .. } => None,
    }
}

/// A rendering that stops when the comparison is stopped.
pub(super) fn render_with(
    scene: &Scene,
    tracer: &dyn Tracer,
    settings: &Settings,
    cancelled: &(dyn Fn() -> bool + Sync),
) -> Rendering {
    render(scene, tracer, settings, &Stopper(cancelled))
}

struct Stopper<'a>(&'a (dyn Fn() -> bool + Sync));

impl render::Observer for Stopper<'_> {
    fn tile_done(&self, _: u64, _: u64) {}
    fn cancelled(&self) -> bool {
        (self.0)()
    }
}

/// The settings of a scene's heatmaps: the picture's, with one view sample in each pixel.
pub(super) fn heat_settings(picture: &Settings) -> Settings {
    Settings { aa: 0, view: View::Heatmap, ..picture.clone() }
}

/// The heatmaps of some structures on one scale, each with its place among the structures.
pub(super) fn heatmaps(
    entrants: &mut [Entrant<'_>],
    fit: &[usize],
    settings: &Settings,
    stage: &Stage<'_>,
) -> (Option<HeatScale>, Vec<(usize, Picture)>) {
    let mut fields = Vec::new();
    for &index in fit {
        let render = |world: &dyn TracedWorld| {
            let render = || render_with(stage.scene, world, settings, stage.cancelled);
            stage.pools.all.install(render)
        };
        let Some(rendering) = entrants[index].attempt(render) else { continue };
        match rendering.image {
            Image::Scalar { values, .. } if rendering.complete => fields.push((index, values)),
            _ => {}
        }
    }
    let all: Vec<f32> = fields.iter().flat_map(|(_, values)| values).copied().collect();
    let Some(scale) = heat_scale(&all) else { return (None, Vec::new()) };
    let picture = |(index, values): (usize, Vec<f32>)| {
        (index, colored(settings.width, settings.height, &values, &scale))
    };
    (Some(scale), fields.into_iter().map(picture).collect())
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

/// What a record says of a picture in a file.
pub(super) fn picture_file(file: String, picture: &Picture) -> PictureFile {
    let hash = picture_hash(picture);
    PictureFile { file, width: picture.width, height: picture.height, hash }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_quickest_fit_first() {
        let seconds = |s: u64| Some(Duration::from_secs(s));
        let times = [seconds(50), seconds(3), None, seconds(1)];
        assert_eq!(that_fit(&times, Duration::from_secs(5)), [1, 3]);
        assert_eq!(that_fit(&times, Duration::from_secs(100)), [0, 1, 3]);
        assert_eq!(that_fit(&times, Duration::ZERO), [0usize; 0]);
    }

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
