//! The material and the transform in force, and the commands that change them.

use glam::{DAffine3, DQuat, DVec3};

use crate::description::{Material, Span};

use super::builder::Builder;
use super::camera::points_somewhere;
use super::diagnostic::Diagnostic;
use super::values::Values;

/// The material and the transform in force.
#[derive(Clone, Default)]
pub(super) struct State {
    pub(super) material: Material,
    pub(super) transform: TransformState,
}

/// The transform in force.
#[derive(Clone, Default)]
pub(super) struct TransformState {
    /// Object space to world space.
    pub(super) matrix: DAffine3,
    /// The last command that went into it.
    pub(super) last: Option<Span>,
    /// Whether it was reported as unusable, so that every further object need not.
    pub(super) reported: bool,
}

pub(super) fn ambient_light(builder: &mut Builder, values: &Values<'_>) {
    builder.state.material.ambient_light = values.color(0);
}

pub(super) fn reflectance(builder: &mut Builder, values: &Values<'_>) {
    builder.state.material.reflectance = values.color(0);
}

pub(super) fn specular(builder: &mut Builder, values: &Values<'_>) {
    builder.state.material.specular = values.color(0);
}

pub(super) fn shininess(builder: &mut Builder, values: &Values<'_>) {
    builder.state.material.shininess = values.single(0);
}

pub(super) fn alpha(builder: &mut Builder, values: &Values<'_>) {
    builder.state.material.alpha = values.single(0);
}

pub(super) fn refractive_index(builder: &mut Builder, values: &Values<'_>) {
    builder.state.material.refractive_index = values.single(0);
}

pub(super) fn translate(builder: &mut Builder, values: &Values<'_>) {
    compose(builder, values, DAffine3::from_translation(values.vector(0)));
}

pub(super) fn rotate(builder: &mut Builder, values: &Values<'_>) {
    let axis = values.vector(1);
    if !points_somewhere(axis) {
        builder.report(
            Diagnostic::error(values.span_of(1, 3), "the axis of `rotate` is the zero vector")
                .with_label("this points nowhere")
                .with_help("it may have any length but 0: `rotate 90 0 0 1` turns about z"),
        );
        return;
    }
    compose(builder, values, DAffine3::from_quat(rotation(values.number(0), axis)));
}

pub(super) fn scale(builder: &mut Builder, values: &Values<'_>) {
    compose(builder, values, DAffine3::from_scale(values.vector(0)));
}

/// transform ← transform · T.
fn compose(builder: &mut Builder, values: &Values<'_>, by: DAffine3) {
    let transform = &mut builder.state.transform;
    transform.matrix *= by;
    transform.last = Some(values.span.clone());
}

/// The rotation about an axis of any length but 0.
fn rotation(degrees: f64, axis: DVec3) -> DQuat {
    // Scaled first, so that no square of a tiny or huge axis is lost; whole turns go first too,
    // since the sine of a large angle in radians loses digits.
    let axis = (axis / axis.abs().max_element()).normalize();
    // Not glam's own, which asks the system's C library.
    let (sin, cos) = libm::sincos(0.5 * (degrees % 360.0).to_radians());
    DQuat::from_vec4((axis * sin).extend(cos))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_rotation_turns_about_its_axis_whatever_the_length() {
        for length in [1e-30, 1.0, 1e30] {
            for turns in [-2.0, 0.0, 5.0] {
                let turned = rotation(90.0 + 360.0 * turns, DVec3::Z * length) * DVec3::X;
                assert!((turned - DVec3::Y).length() < 1e-15, "{turned}");
            }
        }
    }

    #[test]
    fn a_rotation_has_the_same_bits_on_every_machine() {
        let bits = rotation(37.0, DVec3::new(1.0, 2.0, 3.0)).to_array().map(f64::to_bits);
        assert_eq!(
            bits,
            [
                0x3FB5_B5AA_3783_BB9B,
                0x3FC5_B5AA_3783_BB9B,
                0x3FD0_483F_A9A2_CCB4,
                0x3FEE_58AA_D9A4_4824
            ],
        );
    }
}
