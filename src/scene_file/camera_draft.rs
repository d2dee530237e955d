//! The camera as far as it has been read. The last command of each kind counts.

use glam::DVec3;

use crate::description::{Camera, Span};

use super::diagnostic::Diagnostic;

/// The smallest sine of the angle between the direction of view and up.
const SMALLEST_SINE: f64 = 1e-6;

/// The camera as far as it has been read.
#[derive(Default)]
pub(super) struct CameraDraft {
    eye: Option<DVec3>,
    direction: Option<(DVec3, Span)>,
    up: Option<(DVec3, Span)>,
    distance: Option<f64>,
    fovy_degrees: Option<f64>,
    width: Option<u32>,
    height: Option<u32>,
}

impl CameraDraft {
    pub(super) fn set_eye(&mut self, eye: DVec3) {
        self.eye = Some(eye);
    }

    /// The direction of view, which is not the zero vector, and its command.
    pub(super) fn set_direction(&mut self, direction: DVec3, command: Span) {
        self.direction = Some((direction, command));
    }

    /// The direction of up, which is not the zero vector, and its command.
    pub(super) fn set_up(&mut self, up: DVec3, command: Span) {
        self.up = Some((up, command));
    }

    pub(super) fn set_distance(&mut self, distance: f64) {
        self.distance = Some(distance);
    }

    pub(super) fn set_field_of_view(&mut self, fovy_degrees: f64) {
        self.fovy_degrees = Some(fovy_degrees);
    }

    pub(super) fn set_width(&mut self, width: u32) {
        self.width = Some(width);
    }

    pub(super) fn set_height(&mut self, height: u32) {
        self.height = Some(height);
    }

    /// The camera as a whole; `None` where something is missing, which is left to the caller to
    /// report.
    ///
    /// # Errors
    /// If up is parallel to the direction of view.
    pub(super) fn finish(self) -> Result<Option<Camera>, Diagnostic> {
        if let (Some((direction, at_direction)), Some((up, at_up))) = (&self.direction, &self.up)
            && are_parallel(*direction, *up)
        {
            return Err(Diagnostic::error(at_up.clone(), "`eyeup` is parallel to `eyedir`")
                .with_label("so it does not determine what is up in the picture")
                .with_related(at_direction.clone(), "the direction of view")
                .with_help(format!("write for example `eyeup {}`", other_axis(*direction))));
        }
        Ok(self.complete())
    }

    fn complete(self) -> Option<Camera> {
        Some(Camera {
            eye: self.eye?,
            direction: self.direction?.0,
            up: self.up?.0,
            distance: self.distance?,
            fovy_degrees: self.fovy_degrees?,
            width: self.width?,
            height: self.height?,
        })
    }
}

fn are_parallel(a: DVec3, b: DVec3) -> bool {
    // Scaled first, so that no square underflows.
    let scaled = |v: DVec3| (v / v.abs().max_element()).normalize_or_zero();
    scaled(a).cross(scaled(b)).length() < SMALLEST_SINE
}

/// The z axis, as is usual for up, or the y axis for a view along z.
fn other_axis(direction: DVec3) -> &'static str {
    if are_parallel(direction, DVec3::Z) { "0 1 0" } else { "0 0 1" }
}
