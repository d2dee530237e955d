//! The picture in tiles: threads take them, batches render them.

use std::time::Instant;

use rayon::iter::{IndexedParallelIterator, IntoParallelRefIterator, ParallelIterator};

use crate::accel::Tracer;
use crate::image_io::Picture;
use crate::math::Color;
use crate::scene::Scene;

use super::batch::{Batch, Context, ViewSample};
use super::light_samples::LightSamples;
use super::views::render_view;
use super::{Crop, Observer, RenderStats, Settings, View};

/// Side of a tile in pixels.
const TILE: u32 = 16;

/// View samples in a batch: enough for waves, few enough for a core's cache.
const SAMPLES_AT_ONCE: usize = 1024;

/// What was rendered.
#[derive(Clone, Debug)]
pub struct Rendering {
    /// What the pixels show.
    pub sight: Sight,
    /// Whether every tile was rendered; if not, the missing ones are black, or NaN in a field.
    pub complete: bool,
    /// What the rays did.
    pub stats: RenderStats,
}

/// The content of a rendering.
#[derive(Clone, Debug, PartialEq)]
pub enum Sight {
    /// Colours.
    Picture(Picture),
    /// One number a pixel, row by row from the top left: a depth, or a count.
    Field {
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
        /// The numbers; NaN where nothing is seen, and where nothing was rendered, so that the
        /// scale of the others is theirs alone.
        values: Vec<f32>,
    },
}

/// Renders a scene with a structure, on the threads of the current rayon pool.
///
/// # Panics
/// If a crop leaves the picture or is empty, or if there are more than [`Settings::MAX_PIXELS`].
pub fn render(
    scene: &Scene,
    tracer: &dyn Tracer,
    settings: &Settings,
    observer: &dyn Observer,
) -> Rendering {
    let region = settings.region();
    assert!(
        !region.is_empty() && region.is_within(settings.width, settings.height),
        "the crop is empty or leaves the picture"
    );
    assert!(region.pixels() <= Settings::MAX_PIXELS, "more pixels than memory is trusted to hold");
    let start = Instant::now();
    let context = Context {
        scene,
        tracer,
        observer,
        settings,
        camera: scene.camera.resized(settings.width, settings.height),
        light_samples: LightSamples::new(
            settings.sampling,
            settings.seed,
            settings.aa,
            settings.light_samples,
        ),
        transparent: scene.has_transparency(),
        count: settings.count || settings.view == View::Heatmap,
    };
    let tiles = tiles_of(region);
    let rendered: Vec<Option<Tile>> = tiles
        .par_iter()
        .with_max_len(1)
        .map_init(Batch::default, |batch, &area| render_tile(&context, batch, area))
        .collect();
    assemble(settings, region, &tiles, rendered, start)
}

/// The pixels of a tile, row by row, and the statistics of its rays.
struct Tile {
    pixels: Vec<Color>,
    stats: RenderStats,
}

fn tiles_of(region: Crop) -> Vec<Crop> {
    let columns = || (region.x0..region.x1).step_by(TILE as usize);
    let rows = (region.y0..region.y1).step_by(TILE as usize);
    rows.flat_map(|y0| {
        columns().map(move |x0| Crop {
            x0,
            y0,
            x1: (x0 + TILE).min(region.x1),
            y1: (y0 + TILE).min(region.y1),
        })
    })
    .collect()
}

fn render_tile(context: &Context<'_>, batch: &mut Batch, area: Crop) -> Option<Tile> {
    if context.observer.cancelled() {
        return None;
    }
    batch.stats = RenderStats::default();
    let pixels = match context.settings.view {
        View::Color => colors_of(context, batch, area, SAMPLES_AT_ONCE, |_, color| color),
        View::Heatmap => heat_of(context, batch, area),
        view => render_view(context, batch, area, view),
    };
    let stats = batch.stats.clone();
    context.observer.tile_done(pixels.len() as u64, stats.total_rays());
    Some(Tile { pixels, stats })
}

/// The tests that all rays of each pixel took.
fn heat_of(context: &Context<'_>, batch: &mut Batch, area: Crop) -> Vec<Color> {
    let mut before = 0;
    let samples = context.settings.samples_per_pixel() as usize;
    colors_of(context, batch, area, samples, |stats, _| {
        let tests = stats.total_tests();
        let sum = tests.boxes + tests.primitives;
        let own = sum - before;
        before = sum;
        Color::splat(own as f32)
    })
}

/// Renders the pixels of an area in batches of at most `at_once` samples, or one pixel.
///
/// A pixel is the mean of its samples, added in their order; a batch's border never matters.
/// `finish` turns the statistics so far and a pixel's mean into what the pixel shows; it sees each
/// pixel's own statistics only if batches are single pixels.
fn colors_of(
    context: &Context<'_>,
    batch: &mut Batch,
    area: Crop,
    at_once: usize,
    mut finish: impl FnMut(&RenderStats, Color) -> Color,
) -> Vec<Color> {
    let per_pixel = context.settings.samples_per_pixel();
    let lights = &context.scene.lights;
    let pixels: Vec<(u32, u32)> =
        (area.y0..area.y1).flat_map(|y| (area.x0..area.x1).map(move |x| (x, y))).collect();
    let pixels_at_once = (at_once / per_pixel as usize).max(1);
    let mut colors = Vec::with_capacity(pixels.len());
    for group in pixels.chunks(pixels_at_once) {
        batch.samples.clear();
        batch.pixel_orders.clear();
        batch.pixel_of_sample.clear();
        for (index, &(x, y)) in group.iter().enumerate() {
            let samples = (0..per_pixel).map(|number| ViewSample { x, y, number });
            let key = ViewSample { x, y, number: 0 }.pixel_key();
            batch.pixel_orders.push(context.light_samples.pixel(key, lights));
            batch.samples.extend(samples);
            batch.pixel_of_sample.resize(batch.samples.len(), index as u32);
        }
        batch.run(context);
        for samples in batch.colors.chunks(per_pixel as usize) {
            let mean = samples.iter().sum::<Color>() / per_pixel as f32;
            colors.push(finish(&batch.stats, mean));
        }
    }
    colors
}

fn assemble(
    settings: &Settings,
    region: Crop,
    areas: &[Crop],
    tiles: Vec<Option<Tile>>,
    start: Instant,
) -> Rendering {
    let (width, height) = (region.width(), region.height());
    let is_field = matches!(settings.view, View::Depth | View::Heatmap);
    let missing = if is_field { Color::NAN } else { Color::ZERO };
    let mut picture =
        Picture { width, height, pixels: vec![missing; width as usize * height as usize] };
    let mut stats = RenderStats::default();
    let complete = tiles.iter().all(Option::is_some);
    for (area, tile) in areas.iter().zip(tiles) {
        let Some(tile) = tile else { continue };
        stats.merge(&tile.stats);
        for (y, row) in (area.y0..).zip(tile.pixels.chunks(area.width() as usize)) {
            let first = ((y - region.y0) * width + (area.x0 - region.x0)) as usize;
            picture.pixels[first..first + row.len()].copy_from_slice(row);
        }
    }
    stats.time = start.elapsed();
    let sight = if is_field {
        let values = picture.pixels.iter().map(|pixel| pixel.x).collect();
        Sight::Field { width, height, values }
    } else {
        Sight::Picture(picture)
    };
    Rendering { sight, complete, stats }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::{Sampling, Scale};

    /// Two tiles side by side, the second of which was not rendered.
    fn half_rendered(view: View) -> Rendering {
        let settings = Settings {
            width: 20,
            height: 2,
            crop: None,
            aa: 0,
            light_samples: 1,
            sampling: Sampling::default(),
            max_recursion: 0,
            seed: 0,
            view,
            count: false,
        };
        let areas = tiles_of(settings.region());
        let pixels = (0..32).map(|i| Color::splat(5.0 + i as f32)).collect();
        let tile = Tile { pixels, stats: RenderStats::default() };
        assemble(&settings, settings.region(), &areas, vec![Some(tile), None], Instant::now())
    }

    #[test]
    fn what_was_not_rendered_does_not_stretch_the_scale() {
        for view in [View::Depth, View::Heatmap] {
            let rendering = half_rendered(view);
            assert!(!rendering.complete);
            let Sight::Field { values, .. } = rendering.sight else { panic!("not a field") };
            assert_eq!(Scale::of(&values), Some(Scale { low: 5.0, high: 36.0 }));
            assert!(values[16..20].iter().all(|value| value.is_nan()));
        }
    }

    #[test]
    fn what_was_not_rendered_of_a_picture_is_black() {
        let Sight::Picture(picture) = half_rendered(View::Color).sight else { panic!("a field") };
        assert_eq!(picture.pixels[15], Color::splat(20.0));
        assert_eq!(picture.pixels[16], Color::ZERO);
    }
}
