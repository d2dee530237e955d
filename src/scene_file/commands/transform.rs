//! The commands that change the transform in force: what is written last is applied first.

use glam::{DAffine3, DQuat, DVec3};

use crate::scene_file::action::{Row, change};
use crate::scene_file::builder::SceneBuilder;
use crate::scene_file::command::{SceneCommand, ValueKind, XYZ, number, value};
use crate::scene_file::diagnostic::Diagnostic;
use crate::scene_file::values::Values;

pub(super) const ROWS: &[Row] = &[
    Row {
        command: SceneCommand {
            keyword: "translate",
            values: XYZ,
            summary: "moves what follows",
            example: "translate 0 0 1",
            also_called: &["move"],
        },
        action: change(|scene, values| {
            scene.compose(DAffine3::from_translation(values.vector(0)), values.span());
        }),
    },
    Row {
        command: SceneCommand {
            keyword: "rotate",
            values: &[number("degrees"), number("x"), number("y"), number("z")],
            summary: "turns what follows about an axis through the origin, of any length",
            example: "rotate 90 0 0 1",
            also_called: &[],
        },
        action: change(rotate),
    },
    Row {
        command: SceneCommand {
            keyword: "scale",
            values: &[
                value("x", ValueKind::ScaleFactor),
                value("y", ValueKind::ScaleFactor),
                value("z", ValueKind::ScaleFactor),
            ],
            summary: "stretches what follows along the axes",
            example: "scale 1 1 0.5",
            also_called: &[],
        },
        action: change(|scene, values| {
            scene.compose(DAffine3::from_scale(values.vector(0)), values.span());
        }),
    },
];

fn rotate(scene: &mut SceneBuilder, values: &Values<'_>) {
    match values.nonzero_vector(1) {
        Some(axis) => {
            let rotation = DAffine3::from_quat(rotation(values.number(0), axis));
            scene.compose(rotation, values.span());
        }
        None => scene.report(
            Diagnostic::error(values.span_of(1, 3), "the axis of `rotate` is the zero vector")
                .with_label("this points nowhere")
                .with_help("it may have any length but 0: `rotate 90 0 0 1` turns about z"),
        ),
    }
}

/// The rotation about an axis of any length but 0.
fn rotation(degrees: f64, axis: DVec3) -> DQuat {
    // Scaled first, so that no square of a tiny or huge axis is lost; whole turns go first too,
    // since the sine of a large angle in radians loses digits.
    let axis = (axis / axis.abs().max_element()).normalize();
    // Not glam's own, which calls the system's C library.
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
