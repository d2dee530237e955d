//! The commands that add lights, with the transform in force.

use glam::DVec3;

use crate::description::Light;
use crate::scene_file::action::{Row, add_light};
use crate::scene_file::builder::SceneBuilder;
use crate::scene_file::command::{SceneCommand, ValueKind, number, value};
use crate::scene_file::precision::{has_area, holds_point, is_zero_vector};
use crate::scene_file::values::Values;

pub(super) const ROWS: &[Row] = &[
    Row {
        command: SceneCommand {
            keyword: "pointlight",
            values: &[number("x"), number("y"), number("z"), number("r"), number("g"), number("b")],
            summary: "light from one point",
            example: "pointlight 2 -3 5  1 1 1",
            also_called: &["light", "point_light"],
        },
        action: add_light(point_light),
    },
    Row {
        command: SceneCommand {
            keyword: "arealight",
            values: &[value("h", ValueKind::Positive), number("r"), number("g"), number("b")],
            summary: "light from the square [−h, h]² of the plane z = 0",
            example: "arealight 0.5 1 1 1",
            also_called: &["area_light"],
        },
        action: add_light(area_light),
    },
];

fn point_light(scene: &mut SceneBuilder, values: &Values<'_>) {
    let position = scene.transform().transform_point3(values.vector(0));
    if holds_point(position) {
        scene.add_light(Light::Point { position, color: values.color(3) });
    } else {
        scene.report_transform(values.span(), "takes this beyond single precision");
    }
}

/// The square [−h, h]² of the plane z = 0, transformed.
fn area_light(scene: &mut SceneBuilder, values: &Values<'_>) {
    let matrix = scene.transform();
    let h = values.number(0);
    let center = matrix.transform_point3(DVec3::ZERO);
    let half_u = matrix.transform_vector3(DVec3::X * h);
    let half_v = matrix.transform_vector3(DVec3::Y * h);
    let corners = [center, center + half_u, center + half_v];
    if !corners.iter().all(|&corner| holds_point(corner)) {
        scene.report_transform(values.span(), "takes this beyond single precision");
    } else if is_zero_vector(half_u) || is_zero_vector(half_v) || !has_area(half_u, half_v) {
        scene.report_transform(values.span(), "flattens the light to a line or a point");
    } else {
        scene.add_light(Light::Area { center, half_u, half_v, color: values.color(1) });
    }
}
