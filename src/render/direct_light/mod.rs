//! Direct light: what the lights of a scene add to the vertices of a wave, light by light.
//!
//! Sixteen vertices that follow each other are taken together, a lane each.
//!
//! | file | what it does |
//! |---|---|
//! | `shading_lanes.rs` | the sixteen points that are shaded |
//! | `light_points.rs`, `light_surface.rs` | the points of a light that they take |
//! | `light_contribution.rs` | what such a point contributes, unless it is blocked |
//! | `shadow_rays.rs` | the shadow rays to it, in a buffer |
//! | `visibility.rs`, `transparent_shadows.rs` | how much light arrives along them |
//! | `light_sums.rs` | the sums of what arrives |
//! | `shadow_pass.rs` | all of that for one light |

mod light_contribution;
mod light_points;
mod light_sums;
mod light_surface;
mod shading_lanes;
mod shadow_pass;
mod shadow_rays;
mod transparent_shadows;
mod visibility;

use std::ops::Range;

use crate::math::Color;
use crate::render::Stage;
use crate::render::frame::Frame;
use crate::render::light_samples::SampleAssignment;
use crate::render::measured_tracer::MeasuredTracer;
use crate::render::path::PathVertex;
use crate::render::view_rays::Pixel;
use crate::scene::Light;
use crate::simd::LANES;

use light_points::LightPoints;
use light_surface::LightSurface;
use shading_lanes::{ShadingLanes, ShadingPoint};
use shadow_pass::ShadowPass;
use shadow_rays::ShadowSource;

/// The samples of a batch, and the buffers of a wave.
pub(super) struct DirectLight {
    /// For each light of the scene, the samples that view samples take of it. Point lights need
    /// none.
    assignments: Vec<SampleAssignment>,
    /// The vertices of the wave, sixteen in each; the buffer may be longer.
    lanes: Vec<ShadingLanes>,
    points: LightPoints,
    pass: ShadowPass,
}

impl DirectLight {
    /// Buffers for a scene with some number of lights.
    pub(super) fn new(lights: usize) -> Self {
        Self {
            assignments: std::iter::repeat_with(SampleAssignment::default).take(lights).collect(),
            lanes: Vec::new(),
            points: LightPoints::default(),
            pass: ShadowPass::new(),
        }
    }

    /// Assigns samples of the area lights to some view samples of some pixels.
    pub(super) fn assign_samples(
        &mut self,
        frame: &Frame<'_>,
        pixels: &[Pixel],
        samples: &Range<u32>,
    ) {
        let lights = frame.scene.lights.iter().zip(&mut self.assignments).enumerate();
        for (index, (light, assignment)) in lights {
            if let Light::Area { .. } = light {
                assignment.clear();
                for pixel in pixels {
                    let (pixel, samples) = (pixel.key(), samples.clone());
                    frame.light_samples.assign_some(pixel, index, samples, assignment);
                }
            }
        }
    }

    /// Adds the light of all lights at the vertices to the colours of their view samples.
    pub(super) fn add(
        &mut self,
        frame: &Frame<'_>,
        tracer: &mut MeasuredTracer<'_>,
        vertices: &[PathVertex],
        colors: &mut [Color],
    ) {
        self.fill_lanes(frame, vertices);
        for light in 0..frame.scene.lights.len() {
            self.trace_light(frame, tracer, light, vertices);
            self.add_light(frame, &frame.scene.lights[light], vertices, colors);
            tracer.lap(Stage::Shading);
        }
    }

    fn fill_lanes(&mut self, frame: &Frame<'_>, vertices: &[PathVertex]) {
        let point = |vertex: &PathVertex| ShadingPoint {
            material: frame.material_of(&vertex.surface),
            origin: vertex.origin,
            normal: vertex.surface.normal,
            geometric_normal: vertex.surface.geometric_normal,
            view_dir: vertex.dir,
        };
        let count = vertices.len().div_ceil(LANES);
        if self.lanes.len() < count {
            self.lanes.resize(count, ShadingLanes::EMPTY);
        }
        for (lanes, vertices) in self.lanes.iter_mut().zip(vertices.chunks(LANES)) {
            lanes.fill(vertices.iter().map(point));
        }
    }

    /// Traces the shadow rays from all vertices to one light.
    fn trace_light(
        &mut self,
        frame: &Frame<'_>,
        tracer: &mut MeasuredTracer<'_>,
        light: usize,
        vertices: &[PathVertex],
    ) {
        let surface = LightSurface::new(&frame.scene.lights[light]);
        let assignment = &self.assignments[light];
        self.pass.begin(vertices.len().div_ceil(LANES));
        let all_lanes = self.lanes.iter().zip(vertices.chunks(LANES)).enumerate();
        for (index, (lanes, vertices)) in all_lanes {
            let points = self.points.of(frame, light, assignment, vertices);
            self.pass.send(frame, tracer, &ShadowSource { surface, lanes, index, points });
        }
        self.pass.flush(frame, tracer);
    }

    /// Adds what arrived from one light to the colours.
    fn add_light(
        &self,
        frame: &Frame<'_>,
        light: &Light,
        vertices: &[PathVertex],
        colors: &mut [Color],
    ) {
        let samples = match light {
            Light::Point { .. } => 1,
            Light::Area { .. } => frame.light_samples.per_view_sample(),
        };
        let color = light.color() / samples as f32;
        for (vertices, sums) in vertices.chunks(LANES).zip(self.pass.sums()) {
            for (lane, vertex) in vertices.iter().enumerate() {
                let material = frame.material_of(&vertex.surface);
                let reflected = sums.reflected(lane, material);
                let path = &vertex.path;
                colors[path.sample as usize] += path.weight * color * reflected;
            }
        }
    }
}
