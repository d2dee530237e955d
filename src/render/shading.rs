//! Shades a wave: traces it, and adds what its paths see to the colours of their view samples.
//!
//! Does not know how paths go on from what they hit.

use std::ops::Range;

use crate::accel::Answers;
use crate::math::{Color, Hit};

use super::direct_light::DirectLight;
use super::frame::Frame;
use super::measured_tracer::MeasuredTracer;
use super::path::PathVertex;
use super::view_rays::Pixel;
use super::wave::Wave;
use super::{RayClass, Stage};

/// The colours of a batch, and the buffers of a wave.
pub(super) struct Shading {
    /// The colours of the batch's view samples.
    colors: Vec<Color>,
    /// The hits of the wave; the buffer may be longer.
    hits: Vec<Hit>,
    /// The vertices of the wave.
    vertices: Vec<PathVertex>,
    direct_light: DirectLight,
}

impl Shading {
    /// Buffers for a scene with some number of lights.
    pub(super) fn new(lights: usize) -> Self {
        Self {
            colors: Vec::new(),
            hits: Vec::new(),
            vertices: Vec::new(),
            direct_light: DirectLight::new(lights),
        }
    }

    /// Begins a batch, some samples of some pixels: they are black.
    pub(super) fn begin(&mut self, frame: &Frame<'_>, pixels: &[Pixel], samples: &Range<u32>) {
        self.colors.clear();
        self.colors.resize(pixels.len() * samples.len(), Color::ZERO);
        self.direct_light.assign_samples(frame, pixels, samples);
    }

    /// Traces and shades a wave.
    pub(super) fn shade(
        &mut self,
        frame: &Frame<'_>,
        tracer: &mut MeasuredTracer<'_>,
        class: RayClass,
        wave: &Wave,
    ) {
        self.find_hits(tracer, class, wave);
        self.add_ambient_light(frame, wave);
        tracer.lap(Stage::Shading);
        self.direct_light.add(frame, tracer, &self.vertices, &mut self.colors);
    }

    /// The colours of the batch's view samples so far.
    pub(super) fn colors(&self) -> &[Color] {
        &self.colors
    }

    /// What the last wave has hit.
    pub(super) fn vertices(&self) -> &[PathVertex] {
        &self.vertices
    }

    fn find_hits(&mut self, tracer: &mut MeasuredTracer<'_>, class: RayClass, wave: &Wave) {
        let count = wave.rays.len();
        if self.hits.len() < count {
            self.hits.resize(count, Hit::MISS);
        }
        tracer.trace(class, &wave.rays, Answers::ClosestHit(&mut self.hits[..count]));
    }

    /// Adds the background where rays miss, and ambient light where they hit. The hits become
    /// vertices.
    fn add_ambient_light(&mut self, frame: &Frame<'_>, wave: &Wave) {
        self.vertices.clear();
        for ((ray, hit), path) in wave.rays.iter().zip(&self.hits).zip(&wave.paths) {
            let seen = if hit.is_hit() {
                let surface = frame.scene.surface(ray, hit);
                let origin = surface.origin_outside();
                let material = frame.material_of(&surface);
                let unit = material.has_secondary_rays();
                let dir = if unit { ray.dir.normalize() } else { ray.dir };
                self.vertices.push(PathVertex { path: *path, surface, dir, origin });
                material.ambient
            } else {
                frame.scene.options.background
            };
            self.colors[path.sample as usize] += path.weight * seen;
        }
    }
}
