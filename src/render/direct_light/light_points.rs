//! The samples of a light that sixteen vertices take.

use crate::render::frame::Frame;
use crate::render::light_samples::SampleAssignment;
use crate::render::path::PathVertex;
use crate::scene::Light;
use crate::simd::LANES;

/// For each lane the samples of its vertex, as points of the unit square. All lanes have equally
/// many.
pub(super) type LanePoints<'a> = [&'a [[f32; 2]]; LANES];

/// Buffers for samples that are made on the fly.
#[derive(Default)]
pub(super) struct LightPoints([Vec<[f32; 2]>; LANES]);

impl LightPoints {
    /// The samples of the scene's light `light` for up to [`LANES`] vertices, at least one. Lanes
    /// without a vertex repeat the samples of the first.
    pub(super) fn of<'a>(
        &'a mut self,
        frame: &'a Frame<'_>,
        light: usize,
        assignment: &SampleAssignment,
        vertices: &[PathVertex],
    ) -> LanePoints<'a> {
        // A point light has one sample, and all points of the square are the same to it.
        let mut points: LanePoints<'a> = [&[[0.0; 2]]; LANES];
        if let Light::Area { .. } = frame.scene.lights[light] {
            for ((points, vertex), buffer) in points.iter_mut().zip(vertices).zip(&mut self.0) {
                let (sample, key) = (vertex.path.sample as usize, vertex.path.key);
                *points = frame.light_samples.points(assignment, light, sample, key, buffer);
            }
            let first = points[0];
            points[vertices.len()..].fill(first);
        }
        points
    }
}
