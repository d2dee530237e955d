//! The commands of the camera and of the rendering options. The last one written of each counts.
//!
//! Every camera command is required. The options have defaults: one mirror bounce, one ray through
//! each pixel's centre, a black background.

use glam::DVec3;

use crate::description::{Camera, Options, Span};
use crate::math::Color;

use super::builder::Builder;
use super::command::{Group, is_nothing};
use super::diagnostic::Diagnostic;
use super::table::COMMANDS;
use super::values::Values;

/// The options of a scene that says nothing of them.
pub(super) const DEFAULT_OPTIONS: Options =
    Options { max_recursion: 1, aa: 0, background: Color::ZERO };

/// The smallest sine of the angle between the direction of view and up.
const SMALLEST_SINE: f64 = 1e-6;

/// What the text has said of the camera so far.
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

pub(super) fn eye_position(builder: &mut Builder, values: &Values<'_>) {
    builder.camera.eye = Some(values.vector(0));
}

pub(super) fn eye_direction(builder: &mut Builder, values: &Values<'_>) {
    if let Some(direction) = some_direction(builder, values, "the direction of view") {
        builder.camera.direction = Some((direction, values.span.clone()));
    }
}

pub(super) fn eye_up(builder: &mut Builder, values: &Values<'_>) {
    if let Some(up) = some_direction(builder, values, "the direction of up") {
        builder.camera.up = Some((up, values.span.clone()));
    }
}

pub(super) fn distance(builder: &mut Builder, values: &Values<'_>) {
    builder.camera.distance = Some(values.number(0));
}

pub(super) fn field_of_view(builder: &mut Builder, values: &Values<'_>) {
    builder.camera.fovy_degrees = Some(values.number(0));
}

pub(super) fn width(builder: &mut Builder, values: &Values<'_>) {
    builder.camera.width = Some(values.whole(0));
}

pub(super) fn height(builder: &mut Builder, values: &Values<'_>) {
    builder.camera.height = Some(values.whole(0));
}

pub(super) fn max_recursion(builder: &mut Builder, values: &Values<'_>) {
    builder.options.max_recursion = values.whole(0);
}

pub(super) fn aa_samples(builder: &mut Builder, values: &Values<'_>) {
    builder.options.aa = values.whole(0);
}

pub(super) fn background(builder: &mut Builder, values: &Values<'_>) {
    builder.options.background = values.color(0);
}

/// A vector that points somewhere.
fn some_direction(builder: &mut Builder, values: &Values<'_>, what: &str) -> Option<DVec3> {
    let vector = values.vector(0);
    if points_somewhere(vector) {
        return Some(vector);
    }
    builder.report(
        Diagnostic::error(values.span_of(0, 2), format!("{what} must not be the zero vector"))
            .with_label("this points nowhere")
            .with_help("it may have any length but 0"),
    );
    None
}

/// Whether a vector is long enough to have a direction in single precision.
pub(super) fn points_somewhere(vector: DVec3) -> bool {
    !is_nothing(vector.abs().max_element())
}

/// Reports the camera commands that neither were read nor failed.
pub(super) fn report_missing(builder: &mut Builder, end: &Span) {
    let missing: Vec<_> = COMMANDS
        .iter()
        .filter(|c| c.group == Group::Camera && !builder.seen.contains(c.keyword))
        .collect();
    if missing.is_empty() {
        return;
    }
    let names: Vec<_> = missing.iter().map(|c| format!("`{}`", c.keyword)).collect();
    let examples: Vec<_> =
        missing.iter().map(|c| format!("    {:<18}# {}", c.example, c.summary)).collect();
    builder.report(
        Diagnostic::error(end.clone(), format!("the camera lacks {}", names.join(", ")))
            .with_label(if missing.len() == 1 {
                "the scene ends here without it"
            } else {
                "the scene ends here without them"
            })
            .with_help(format!("add, for example\n{}", examples.join("\n"))),
    );
}

/// The camera as a whole. `None` where something of it is missing or wrong, which was reported.
pub(super) fn finish(builder: &mut Builder) -> Option<Camera> {
    let draft = std::mem::take(&mut builder.camera);
    let (direction, direction_span) = draft.direction?;
    let (up, up_span) = draft.up?;
    if are_parallel(direction, up) {
        builder.report(
            Diagnostic::error(up_span, "`eyeup` is parallel to `eyedir`")
                .with_label("so it does not say what is up in the picture")
                .with_related(direction_span, "the direction of view")
                .with_help(format!("write for example `eyeup {}`", other_axis(direction))),
        );
        return None;
    }
    Some(Camera {
        eye: draft.eye?,
        direction,
        up,
        distance: draft.distance?,
        fovy_degrees: draft.fovy_degrees?,
        width: draft.width?,
        height: draft.height?,
    })
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
