//! Renders pieces on one thread: pixels to batches of samples, and samples to the values of a part.

use std::ops::Range;

use crate::accel::Tracer;
use crate::film::{Part, Piece, Values};
use crate::math::Color;

use super::batch::Batch;
use super::frame::Frame;
use super::hit_views::{render_cells, render_hits};
use super::measured_tracer::MeasuredTracer;
use super::tiles::pixels_of;
use super::view_rays::Pixel;
use super::{Kept, Observer, RenderStats, Stage, View};

/// View samples in a batch: enough for waves, few enough for a core's cache.
const SAMPLES_AT_ONCE: usize = 1024;

/// A thread's part of a rendering.
pub(super) struct TileRenderer<'a> {
    frame: &'a Frame<'a>,
    tracer: MeasuredTracer<'a>,
    batch: Batch,
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
    pub(super) fn render(&mut self, piece: &Piece, kept: Kept) -> Option<(Part, RenderStats)> {
        let Piece { area, samples } = piece;
        let order = pixels_of(*area);
        let keeps_samples = kept == Kept::Samples || samples.start > 0;
        let found = match self.frame.settings.view {
            View::Color => self.colors(&order, samples, keeps_samples),
            View::Heatmap => self.test_counts(&order),
            View::Cells => render_cells(self.frame, &mut self.tracer, &order),
            view => render_hits(self.frame, &mut self.tracer, &order, view),
        };
        if self.tracer.was_cancelled() {
            return None;
        }
        let of_pixel = found.len() / order.len();
        let mut values = vec![Color::ZERO; found.len()];
        for (pixel, found) in order.iter().zip(found.chunks(of_pixel)) {
            let place = (pixel.y - area.y0) * area.width() + (pixel.x - area.x0);
            values[place as usize * of_pixel..][..of_pixel].copy_from_slice(found);
        }
        let values = if keeps_samples { Values::Samples(values) } else { Values::Sums(values) };
        self.tracer.lap(Stage::Rest);
        Some((Part { piece: piece.clone(), values }, self.tracer.take_stats()))
    }

    /// The samples of each pixel, or their sums.
    fn colors(
        &mut self,
        pixels: &[Pixel],
        samples: &Range<u32>,
        keeps_samples: bool,
    ) -> Vec<Color> {
        self.render_pixels(pixels, samples, SAMPLES_AT_ONCE, |_, colors, found| {
            if keeps_samples {
                found.extend(colors);
            } else {
                found.push(colors.iter().sum());
            }
        })
    }

    /// The number of tests that all rays of each pixel took.
    fn test_counts(&mut self, pixels: &[Pixel]) -> Vec<Color> {
        let mut before = 0;
        let all = 0..self.frame.settings.samples_per_pixel();
        self.render_pixels(pixels, &all, all.len(), |stats, _, found| {
            let tests = stats.total_tests();
            let sum = tests.boxes + tests.primitives;
            let own = sum - before;
            before = sum;
            found.push(Color::splat(own as f32));
        })
    }

    /// Renders some samples of pixels in batches of at most `at_once` samples, but of at least one pixel.
    ///
    /// A pixel's samples are added in their order; how pixels are divided into batches never matters. `add` turns the
    /// statistics after a batch and a pixel's samples into what is found of it, always equally much. It sees each
    /// pixel's own statistics only if batches are single pixels. If the rendering is cancelled, less is found.
    fn render_pixels(
        &mut self,
        pixels: &[Pixel],
        samples: &Range<u32>,
        at_once: usize,
        mut add: impl FnMut(&RenderStats, &[Color], &mut Vec<Color>),
    ) -> Vec<Color> {
        let pixels_at_once = (at_once / samples.len()).max(1);
        let mut found = Vec::with_capacity(pixels.len());
        for pixels in pixels.chunks(pixels_at_once) {
            if self.tracer.is_cancelled() {
                break;
            }
            let colors = self.batch.run(self.frame, &mut self.tracer, pixels, samples);
            for colors in colors.chunks(samples.len()) {
                add(self.tracer.stats(), colors, &mut found);
            }
            self.tracer.lap(Stage::Rest);
        }
        found
    }
}
