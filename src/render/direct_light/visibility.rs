//! How much light arrives along shadow rays.

use crate::accel::Answers;
use crate::math::Ray;
use crate::render::RayClass;
use crate::render::frame::Frame;
use crate::render::measured_tracer::MeasuredTracer;

use super::transparent_shadows::TransparentShadows;

/// The buffers of shadow rays' results.
#[derive(Default)]
pub(super) struct Visibility {
    /// The buffer may be longer than there are rays.
    blocked: Vec<bool>,
    transmittances: Vec<f32>,
    transparent: TransparentShadows,
}

impl Visibility {
    /// The share of the light that arrives along each ray, from 0 to 1. Where all objects are
    /// opaque, that is 0 or 1.
    pub(super) fn transmittances(
        &mut self,
        frame: &Frame<'_>,
        tracer: &mut MeasuredTracer<'_>,
        rays: &[Ray],
    ) -> &[f32] {
        self.transmittances.clear();
        if rays.is_empty() {
            return &[]; // No call of the tracer, and no report of one to the observer.
        }
        if frame.has_transparency {
            self.transmittances.resize(rays.len(), 1.0);
            self.transparent.dim(frame, tracer, rays, &mut self.transmittances);
        } else {
            self.find_occlusion(tracer, rays);
        }
        &self.transmittances
    }

    fn find_occlusion(&mut self, tracer: &mut MeasuredTracer<'_>, rays: &[Ray]) {
        if self.blocked.len() < rays.len() {
            self.blocked.resize(rays.len(), false);
        }
        let blocked = &mut self.blocked[..rays.len()];
        tracer.trace(RayClass::Shadow, rays, Answers::AnyHit(blocked));
        self.transmittances.extend(blocked.iter().map(|&blocked| f32::from(u8::from(!blocked))));
    }
}
