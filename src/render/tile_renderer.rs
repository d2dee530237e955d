//! Renders tiles on one thread: pixels to batches of samples, and samples to pixels.

use crate::accel::Tracer;
use crate::math::Color;

use super::batch::Batch;
use super::frame::Frame;
use super::hit_views::render_hits;
use super::measured_tracer::MeasuredTracer;
use super::tiles::pixels_of;
use super::view_rays::Pixel;
use super::{Crop, Observer, RenderStats, Stage, View};

/// View samples in a batch: enough for waves, few enough for a core's cache.
const SAMPLES_AT_ONCE: usize = 1024;

/// A thread's part of a rendering.
pub(super) struct TileRenderer<'a> {
    frame: &'a Frame<'a>,
    tracer: MeasuredTracer<'a>,
    batch: Batch,
}

/// A tile after it was rendered.
pub(super) struct Tile {
    pub(super) area: Crop,
    /// Row by row.
    pub(super) pixels: Vec<Color>,
    pub(super) stats: RenderStats,
}

impl<'a> TileRenderer<'a> {
    /// The time of the thread counts from now on.
    pub(super) fn new(
        frame: &'a Frame<'a>,
        tracer: &'a dyn Tracer,
        observer: &'a dyn Observer,
    ) -> Self {
        let counts_tests = frame.settings.count || frame.settings.view == View::Heatmap;
        let tracer = MeasuredTracer::new(tracer, observer, counts_tests);
        Self { frame, tracer, batch: Batch::new(frame.scene.lights.len()) }
    }

    /// `None` if the rendering is cancelled.
    pub(super) fn render(&mut self, area: Crop) -> Option<Tile> {
        let order = pixels_of(area);
        let colors = match self.frame.settings.view {
            View::Color => self.colors(&order),
            View::Heatmap => self.test_counts(&order),
            view => render_hits(self.frame, &mut self.tracer, &order, view),
        };
        if self.tracer.was_cancelled() {
            return None;
        }
        let mut pixels = vec![Color::ZERO; colors.len()];
        for (pixel, color) in order.iter().zip(colors) {
            pixels[((pixel.y - area.y0) * area.width() + (pixel.x - area.x0)) as usize] = color;
        }
        self.tracer.lap(Stage::Rest);
        Some(Tile { area, pixels, stats: self.tracer.take_stats() })
    }

    fn colors(&mut self, pixels: &[Pixel]) -> Vec<Color> {
        self.render_pixels(pixels, SAMPLES_AT_ONCE, |_, color| color)
    }

    /// The number of tests that all rays of each pixel took.
    fn test_counts(&mut self, pixels: &[Pixel]) -> Vec<Color> {
        let mut before = 0;
        let one_pixel = self.frame.settings.samples_per_pixel() as usize;
        self.render_pixels(pixels, one_pixel, |stats, _| {
            let tests = stats.total_tests();
            let sum = tests.boxes + tests.primitives;
            let own = sum - before;
            before = sum;
            Color::splat(own as f32)
        })
    }

    /// Renders pixels in batches of at most `at_once` samples, but of at least one pixel.
    ///
    /// A pixel's colour is the mean of its samples, added in their order; how pixels are divided
    /// into batches never matters. `value` turns the statistics after a batch and a pixel's colour
    /// into what the pixel shows. It sees each pixel's own statistics only if batches are single
    /// pixels. If the rendering is cancelled, there are fewer values than pixels.
    fn render_pixels(
        &mut self,
        pixels: &[Pixel],
        at_once: usize,
        mut value: impl FnMut(&RenderStats, Color) -> Color,
    ) -> Vec<Color> {
        let per_pixel = self.frame.settings.samples_per_pixel() as usize;
        let pixels_at_once = (at_once / per_pixel).max(1);
        let mut values = Vec::with_capacity(pixels.len());
        for pixels in pixels.chunks(pixels_at_once) {
            if self.tracer.is_cancelled() {
                break;
            }
            let colors = self.batch.run(self.frame, &mut self.tracer, pixels);
            for samples in colors.chunks(per_pixel) {
                let mean = samples.iter().sum::<Color>() / per_pixel as f32;
                values.push(value(self.tracer.stats(), mean));
            }
            self.tracer.lap(Stage::Rest);
        }
        values
    }
}
