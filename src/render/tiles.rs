//! The picture in tiles: threads take them, batches render them.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use rayon::iter::{IndexedParallelIterator, IntoParallelIterator, ParallelIterator};

use crate::accel::Tracer;
use crate::image_io::Picture;
use crate::math::Color;
use crate::scene::Scene;

use super::batch::{Batch, Context};
use super::finish::Finish;
use super::light_samples::LightSamples;
use super::view_rays::{Pixel, ViewRays};
use super::views::render_view;
use super::{Crop, Observer, RenderStats, Settings, Stage, View};

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
        view_rays: ViewRays::new(scene.camera.resized(settings.width, settings.height), settings),
        light_samples: LightSamples::new(
            settings.sampling,
            settings.seed,
            settings.aa,
            settings.light_samples,
        ),
        finishes: scene.materials.iter().map(Finish::new).collect(),
        transparent: scene.has_transparency(),
        count: settings.count || settings.view == View::Heatmap,
    };
    let tiles = tiles_of(region);
    let rendered = render_tiles(&context, &tiles);
    assemble(settings, region, &tiles, rendered, start)
}

/// Renders tiles on all threads: each takes the next one that nobody has taken, with buffers of its
/// own. Tiles that were not rendered are `None`.
fn render_tiles(context: &Context<'_>, tiles: &[Crop]) -> Vec<Option<Tile>> {
    let next = AtomicUsize::new(0);
    let take = |_| {
        let mut batch = Batch::new(context.scene.lights.len());
        let mut done = Vec::new();
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            let Some(&area) = tiles.get(index) else { return done };
            let Some(tile) = render_tile(context, &mut batch, area) else { return done };
            done.push((index, tile));
        }
    };
    let threads = rayon::current_num_threads();
    let parts: Vec<_> = (0..threads).into_par_iter().with_max_len(1).map(take).collect();
    let mut rendered: Vec<Option<Tile>> = tiles.iter().map(|_| None).collect();
    for (index, tile) in parts.into_iter().flatten() {
        rendered[index] = Some(tile);
    }
    rendered
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
    let order = pixels_of(area);
    let colors = match context.settings.view {
        View::Color => colors_of(context, batch, &order, SAMPLES_AT_ONCE, |_, color| color),
        View::Heatmap => heat_of(context, batch, &order),
        view => render_view(context, batch, &order, view),
    };
    let mut pixels = vec![Color::ZERO; colors.len()];
    for (pixel, color) in order.iter().zip(colors) {
        pixels[((pixel.y - area.y0) * area.width() + (pixel.x - area.x0)) as usize] = color;
    }
    batch.lap(Stage::Rest);
    let stats = batch.stats.clone();
    context.observer.tile_done(pixels.len() as u64, stats.total_rays());
    Some(Tile { pixels, stats })
}

/// The columns and rows of a picture's pixels, in the order in which a single thread renders them.
pub fn pixel_order(width: u32, height: u32) -> impl Iterator<Item = [u32; 2]> {
    let tiles = tiles_of(Crop { x0: 0, y0: 0, x1: width, y1: height });
    tiles.into_iter().flat_map(pixels_of).map(|pixel| [pixel.x, pixel.y])
}

/// The pixels of a tile along Morton's curve: pixels that follow each other lie in a small square,
/// whatever their number, and so do the rays through them.
fn pixels_of(area: Crop) -> Vec<Pixel> {
    let even_bits = |code: u32| (0..16).fold(0, |bits, i| bits | (code >> (2 * i) & 1) << i);
    (0..TILE * TILE)
        .map(|code| Pixel { x: area.x0 + even_bits(code), y: area.y0 + even_bits(code >> 1) })
        .filter(|pixel| pixel.x < area.x1 && pixel.y < area.y1)
        .collect()
}

/// The tests that all rays of each pixel took.
fn heat_of(context: &Context<'_>, batch: &mut Batch, pixels: &[Pixel]) -> Vec<Color> {
    let mut before = 0;
    let samples = context.settings.samples_per_pixel() as usize;
    colors_of(context, batch, pixels, samples, |stats, _| {
        let tests = stats.total_tests();
        let sum = tests.boxes + tests.primitives;
        let own = sum - before;
        before = sum;
        Color::splat(own as f32)
    })
}

/// Renders pixels in batches of at most `at_once` samples, or one pixel.
///
/// A pixel is the mean of its samples, added in their order; a batch's border never matters.
/// `finish` turns the statistics so far and a pixel's mean into what the pixel shows; it sees each
/// pixel's own statistics only if batches are single pixels.
fn colors_of(
    context: &Context<'_>,
    batch: &mut Batch,
    pixels: &[Pixel],
    at_once: usize,
    mut finish: impl FnMut(&RenderStats, Color) -> Color,
) -> Vec<Color> {
    let per_pixel = context.settings.samples_per_pixel() as usize;
    let pixels_at_once = (at_once / per_pixel).max(1);
    let mut colors = Vec::with_capacity(pixels.len());
    for group in pixels.chunks(pixels_at_once) {
        batch.pixels.clear();
        batch.pixels.extend_from_slice(group);
        batch.run(context);
        for samples in batch.colors.chunks(per_pixel) {
            let mean = samples.iter().sum::<Color>() / per_pixel as f32;
            colors.push(finish(&batch.stats, mean));
        }
        batch.lap(Stage::Rest);
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
    use crate::render::{Sampling, Scale, Spacing};

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
            let scale = Scale { low: 5.0, high: 36.0, spacing: Spacing::Linear };
            assert_eq!(Scale::of(&values), Some(scale));
            assert!(values[16..20].iter().all(|value| value.is_nan()));
        }
    }

    #[test]
    fn what_was_not_rendered_of_a_picture_is_black() {
        let Sight::Picture(picture) = half_rendered(View::Color).sight else { panic!("a field") };
        assert_eq!(picture.pixels[15], Color::splat(20.0));
        assert_eq!(picture.pixels[16], Color::ZERO);
    }

    #[test]
    fn a_tile_is_walked_in_squares_and_left_out_nowhere() {
        let area = Crop { x0: 32, y0: 16, x1: 48, y1: 32 };
        let pixels = pixels_of(area);
        for square in pixels.chunks(16) {
            let side = |of: fn(&Pixel) -> u32| {
                let values = || square.iter().map(of);
                values().max().unwrap_or(0) - values().min().unwrap_or(0)
            };
            assert_eq!((side(|p| p.x), side(|p| p.y)), (3, 3));
        }
        let cut = Crop { x1: 37, y1: 19, ..area };
        let mut places: Vec<_> = pixels_of(cut).iter().map(|p| (p.y, p.x)).collect();
        places.sort_unstable();
        let expected: Vec<_> = (16..19).flat_map(|y| (32..37).map(move |x| (y, x))).collect();
        assert_eq!(places, expected);
    }
}
