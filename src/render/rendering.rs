//! From a scene and a structure to an image, in one go.

use std::time::Instant;

use crate::film::Film;
use crate::scene::{Scene, TracedWorld};

use super::{Image, Kept, Observer, RenderStats, Renderer, Settings};

/// What was rendered.
#[derive(Clone, Debug)]
pub struct Rendering {
    /// What the pixels show.
    pub image: Image,
    /// Whether every tile was rendered. If not, the missing ones are black, or NaN in scalars.
    pub complete: bool,
    /// The pixels of the tiles that were rendered.
    pub pixels: u64,
    /// The samples that were rendered, over all pixels.
    pub samples: u64,
    /// What the rays did.
    pub stats: RenderStats,
}

/// Renders a scene with a structure, on the threads of the current rayon pool.
///
/// # Panics
/// If a crop leaves the picture or is empty, or if there are more than [`Settings::MAX_PIXELS`].
pub fn render(
    scene: &Scene,
    world: &dyn TracedWorld,
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
    let film = Film::new(region, settings.film_samples());
    let renderer = Renderer::new(scene, world, settings);
    let pieces = film.missing(film.samples());
    let mut stats = renderer.render(&pieces, Kept::Sums, observer, &|part| {
        let taken = film.take(part);
        debug_assert_eq!(taken, Ok(()), "the pieces are the film's own");
    });
    let coverage = film.coverage();
    let image = Image::of(&film, settings.view);
    stats.time = start.elapsed();
    Rendering {
        image,
        complete: coverage.is_complete(),
        pixels: coverage.pixels,
        samples: coverage.samples,
        stats,
    }
}
