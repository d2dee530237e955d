//! The shadow rays to one light, from their making to the sums of what arrives.
//!
//! Rays are collected until their buffer is full, and then traced together.

use crate::render::Stage;
use crate::render::frame::Frame;
use crate::render::measured_tracer::MeasuredTracer;
use crate::simd::dispatch;

use super::light_sums::{AddArriving, LightSums};
use super::shadow_rays::{ShadowRays, ShadowSource};
use super::visibility::Visibility;

pub(super) struct ShadowPass {
    rays: ShadowRays,
    visibility: Visibility,
    /// For each [`ShadingLanes`](super::shading_lanes::ShadingLanes) of the wave.
    sums: Vec<LightSums>,
}

impl ShadowPass {
    pub(super) fn new() -> Self {
        Self { rays: ShadowRays::new(), visibility: Visibility::default(), sums: Vec::new() }
    }

    /// Begins a light: `count` sums are zero.
    pub(super) fn begin(&mut self, count: usize) {
        self.sums.clear();
        self.sums.resize(count, LightSums::default());
    }

    /// Makes the shadow rays from sixteen points to the light. Traces rays when the buffer is full.
    pub(super) fn send(
        &mut self,
        frame: &Frame<'_>,
        tracer: &mut MeasuredTracer<'_>,
        source: &ShadowSource<'_>,
    ) {
        let mut sent = 0;
        while sent < source.points[0].len() {
            if self.rays.is_full() {
                self.flush(frame, tracer);
            }
            sent = self.rays.append(source, sent);
        }
    }

    /// Traces the rays in the buffer and adds what arrives along them.
    pub(super) fn flush(&mut self, frame: &Frame<'_>, tracer: &mut MeasuredTracer<'_>) {
        tracer.lap(Stage::MakingRays);
        let transmittances = self.visibility.transmittances(frame, tracer, self.rays.rays());
        let rows = self.rays.rows();
        dispatch(AddArriving { rows, transmittances, sums: &mut self.sums });
        self.rays.clear();
        tracer.lap(Stage::Shading);
    }

    /// What arrived since the light was begun.
    pub(super) fn sums(&self) -> &[LightSums] {
        &self.sums
    }
}
