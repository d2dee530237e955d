//! From a scene and a structure to an image: threads render tiles, which are assembled.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use rayon::iter::{IndexedParallelIterator, IntoParallelIterator, ParallelIterator};

use crate::accel::Tracer;
use crate::scene::Scene;

use super::frame::Frame;
use super::image::ImageBuilder;
use super::tile_renderer::{Tile, TileRenderer};
use super::tiles::tiles_of;
use super::{Crop, Image, Observer, RenderStats, Settings};

/// What was rendered.
#[derive(Clone, Debug)]
pub struct Rendering {
    /// What the pixels show.
    pub image: Image,
    /// Whether every tile was rendered. If not, the missing ones are black, or NaN in scalars.
    pub complete: bool,
    /// The pixels of the tiles that were rendered.
    pub pixels: u64,
    /// What the rays did.
    pub stats: RenderStats,
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
    let frame = Frame::new(scene, settings);
    let areas = tiles_of(region);
    let tiles = render_tiles(&frame, tracer, observer, &areas);
    let complete = tiles.len() == areas.len();
    let mut image = ImageBuilder::new(region, settings.view);
    let mut stats = RenderStats::default();
    let pixels = tiles.iter().map(|tile| tile.area.pixels()).sum();
    for tile in tiles {
        image.put(tile.area, &tile.pixels);
        stats.merge(&tile.stats);
    }
    stats.time = start.elapsed();
    Rendering { image: image.finish(), complete, pixels, stats }
}

/// Renders tiles on all threads. Each thread takes the next tile from one counter, until there are
/// no more or the observer stops it.
fn render_tiles(
    frame: &Frame<'_>,
    tracer: &dyn Tracer,
    observer: &dyn Observer,
    areas: &[Crop],
) -> Vec<Tile> {
    let next = AtomicUsize::new(0);
    let on_thread = |_| {
        let mut renderer = TileRenderer::new(frame, tracer, observer);
        let mut tiles = Vec::new();
        while let Some(&area) = areas.get(next.fetch_add(1, Ordering::Relaxed)) {
            let Some(tile) = renderer.render(area) else { break };
            observer.tile_done(area.pixels(), tile.stats.total_rays());
            tiles.push(tile);
        }
        tiles
    };
    let threads = rayon::current_num_threads();
    let parts: Vec<_> = (0..threads).into_par_iter().with_max_len(1).map(on_thread).collect();
    parts.into_iter().flatten().collect()
}
