//! A batch of view samples, followed wave by wave to its colours.

use std::ops::Range;

use crate::math::Color;

use super::frame::Frame;
use super::measured_tracer::MeasuredTracer;
use super::path::Path;
use super::secondary_rays::SecondaryRays;
use super::shading::Shading;
use super::view_rays::Pixel;
use super::wave::Wave;
use super::{RayClass, Stage};

/// The buffers of a batch; made once a thread and reused.
pub(super) struct Batch {
    view: Wave,
    /// The rays of this bounce, and those of the next.
    secondary: SecondaryRays,
    next: SecondaryRays,
    shading: Shading,
}

impl Batch {
    /// Buffers for a scene with some number of lights.
    pub(super) fn new(lights: usize) -> Self {
        Self {
            view: Wave::default(),
            secondary: SecondaryRays::default(),
            next: SecondaryRays::default(),
            shading: Shading::new(lights),
        }
    }

    /// The colours of some samples of some pixels, pixel by pixel.
    pub(super) fn run(
        &mut self,
        frame: &Frame<'_>,
        tracer: &mut MeasuredTracer<'_>,
        pixels: &[Pixel],
        samples: &Range<u32>,
    ) -> &[Color] {
        self.make_view_rays(frame, pixels, samples);
        self.shading.begin(frame, pixels, samples);
        tracer.lap(Stage::MakingRays);
        for bounce in 0..=frame.settings.max_recursion {
            self.follow(frame, tracer, bounce < frame.settings.max_recursion);
            std::mem::swap(&mut self.secondary, &mut self.next);
        }
        self.shading.colors()
    }

    fn make_view_rays(&mut self, frame: &Frame<'_>, pixels: &[Pixel], samples: &Range<u32>) {
        self.view.clear();
        for &pixel in pixels {
            for (key, ray) in frame.view_rays.of_pixel(pixel, samples.clone()) {
                let sample = self.view.rays.len() as u32;
                self.view.push(ray, Path::from_eye(sample, key));
            }
        }
    }

    /// Traces and shades the waves of one bounce. Unless it is the last one, the rays of the next
    /// bounce are made.
    fn follow(&mut self, frame: &Frame<'_>, tracer: &mut MeasuredTracer<'_>, goes_on: bool) {
        for (class, wave) in [
            (RayClass::View, &mut self.view),
            (RayClass::Mirror, &mut self.secondary.mirrored),
            (RayClass::Refraction, &mut self.secondary.refracted),
        ] {
            if wave.is_empty() {
                continue;
            }
            self.shading.shade(frame, tracer, class, wave);
            wave.clear();
            if goes_on {
                self.next.append(frame, self.shading.vertices());
                tracer.lap(Stage::MakingRays);
            }
        }
    }
}
