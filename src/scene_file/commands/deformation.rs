//! The commands that deform the meshes that follow, in their own space: twisted first, then waved, then blown apart.

use crate::description::Wave;
use crate::scene_file::action::{Row, change};
use crate::scene_file::command::{SceneCommand, ValueKind, number, value};

pub(super) const ROWS: &[Row] = &[
    Row {
        command: SceneCommand {
            keyword: "twist",
            values: &[number("degrees")],
            summary: "turns the meshes that follow about their z axis by so much for each unit of height",
            example: "twist 90",
            also_called: &[],
        },
        action: change(|scene, values| scene.deformation().twist = values.number(0)),
    },
    Row {
        command: SceneCommand {
            keyword: "wave",
            values: &[number("amplitude"), value("length", ValueKind::Positive), number("phase")],
            summary: "lifts the meshes that follow along z by a wave that runs along x; phase in wavelengths",
            example: "wave 0.1 0.5 0",
            also_called: &["ripple"],
        },
        action: change(|scene, values| {
            let [amplitude, length, phase] = [0, 1, 2].map(|index| values.number(index));
            scene.deformation().wave = Wave { amplitude, length, phase };
        }),
    },
    Row {
        command: SceneCommand {
            keyword: "explode",
            values: &[value("distance", ValueKind::NotNegative)],
            summary: "moves the triangles of the meshes that follow apart, tumbling; 1 doubles the mesh",
            example: "explode 0.5",
            also_called: &["explosion", "burst"],
        },
        action: change(|scene, values| scene.deformation().explosion = values.number(0)),
    },
];
