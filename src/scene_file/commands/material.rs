//! The commands that change the material in force.

use crate::scene_file::action::{Row, change};
use crate::scene_file::command::{REFLECTANCE, RGB, SceneCommand, ValueKind, value};

pub(super) const ROWS: &[Row] = &[
    Row {
        command: SceneCommand {
            keyword: "ca",
            values: RGB,
            summary: "the ambient light's colour",
            example: "ca 0.1 0.1 0.1",
            also_called: &["ambient"],
        },
        action: change(|scene, values| scene.material().ambient_light = values.color(0)),
    },
    Row {
        command: SceneCommand {
            keyword: "cr",
            values: REFLECTANCE,
            summary: "the diffuse and ambient reflectance",
            example: "cr 0.8 0.3 0.2",
            also_called: &["diffuse", "color", "colour"],
        },
        action: change(|scene, values| scene.material().reflectance = values.color(0)),
    },
    Row {
        command: SceneCommand {
            keyword: "cp",
            values: REFLECTANCE,
            summary: "the specular reflectance; black means neither highlight nor mirror",
            example: "cp 0.5 0.5 0.5",
            also_called: &["specular"],
        },
        action: change(|scene, values| scene.material().specular = values.color(0)),
    },
    Row {
        command: SceneCommand {
            keyword: "shininess",
            values: &[value("exponent", ValueKind::NotNegative)],
            summary: "the Phong exponent",
            example: "shininess 50",
            also_called: &["phong"],
        },
        action: change(|scene, values| scene.material().shininess = values.single(0)),
    },
    Row {
        command: SceneCommand {
            keyword: "alpha",
            values: &[value("opacity", ValueKind::Share)],
            summary: "the opacity, from 0 (clear) to 1 (opaque)",
            example: "alpha 0.3",
            also_called: &["opacity"],
        },
        action: change(|scene, values| scene.material().alpha = values.single(0)),
    },
    Row {
        command: SceneCommand {
            keyword: "ri",
            values: &[value("index", ValueKind::Positive)],
            summary: "the index of refraction of the inside",
            example: "ri 1.5",
            also_called: &["ior"],
        },
        action: change(|scene, values| scene.material().refractive_index = values.single(0)),
    },
];
