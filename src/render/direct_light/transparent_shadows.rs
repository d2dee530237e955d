//! Shadow rays through transparent objects.

use crate::accel::Answers;
use crate::math::{Hit, Ray};
use crate::render::RayClass;
use crate::render::frame::Frame;
use crate::render::measured_tracer::MeasuredTracer;

/// Light that is dimmed below this by what it passes through is gone.
const MIN_TRANSMITTANCE: f32 = 1.0 / 16_384.0;

/// The rays that still carry light behind what they have hit so far.
#[derive(Default)]
pub(super) struct TransparentShadows {
    rays: Vec<Ray>,
    hits: Vec<Hit>,
    /// For each ray its index among the shadow rays.
    indices: Vec<u32>,
}

impl TransparentShadows {
    /// Follows rays from hit to hit. An opaque object takes all of the light, a transparent one the
    /// share of its opacity. The rays are not bent.
    pub(super) fn dim(
        &mut self,
        frame: &Frame<'_>,
        tracer: &mut MeasuredTracer<'_>,
        rays: &[Ray],
        transmittances: &mut [f32],
    ) {
        self.rays.clear();
        self.rays.extend_from_slice(rays);
        self.indices.clear();
        self.indices.extend(0..rays.len() as u32);
        while !self.rays.is_empty() {
            self.hits.clear();
            self.hits.resize(self.rays.len(), Hit::MISS);
            tracer.trace(RayClass::Shadow, &self.rays, Answers::ClosestHit(&mut self.hits));
            self.dim_and_keep(frame, transmittances);
        }
    }

    /// Dims the rays that hit something, and keeps those that still carry light.
    fn dim_and_keep(&mut self, frame: &Frame<'_>, transmittances: &mut [f32]) {
        let mut kept = 0;
        for i in 0..self.rays.len() {
            let hit = self.hits[i];
            if !hit.is_hit() {
                continue;
            }
            let index = self.indices[i];
            let object = &frame.scene.objects[hit.object as usize];
            let transmittance = &mut transmittances[index as usize];
            *transmittance *= frame.materials[object.material].transparency;
            if *transmittance < MIN_TRANSMITTANCE {
                *transmittance = 0.0;
            } else {
                // The next hit behind this one. On the same ray the same primitive gives the same
                // parameter, so it is not met again.
                self.rays[kept] = Ray { t_min: hit.t.next_up(), ..self.rays[i] };
                self.indices[kept] = index;
                kept += 1;
            }
        }
        self.rays.truncate(kept);
        self.indices.truncate(kept);
    }
}
