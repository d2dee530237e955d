//! The commands that add objects, with the material and the transform in force.

use glam::DAffine3;

use crate::description::{Normals, Shape};
use crate::math::Transform;
use crate::scatter::{ScatteredNormals, scatter};
use crate::scene_file::action::{Row, add_object, add_scattered};
use crate::scene_file::builder::SceneBuilder;
use crate::scene_file::command::{SceneCommand, ValueKind, number, value};
use crate::scene_file::precision::{holds_point, holds_transform, is_degenerate};
use crate::scene_file::repeat::make_room;
use crate::scene_file::values::Values;
use crate::shapes::{Ball, Cylinder, Single, Triangle};

pub(super) const ROWS: &[Row] = &[
    Row {
        command: SceneCommand {
            keyword: "ball",
            values: &[value("radius", ValueKind::Positive), number("x"), number("y"), number("z")],
            summary: "a ball about a point",
            example: "ball 0.5 0 0 1",
            also_called: &["sphere"],
        },
        action: add_object(ball),
    },
    Row {
        command: SceneCommand {
            keyword: "cylinder",
            values: &[],
            summary: "the cylinder of radius 1 about the z axis from z = 0 to z = 1, with both caps",
            example: "cylinder",
            also_called: &["tube"],
        },
        action: add_object(|scene, values| {
            add_transformed(scene, values, Single::Cylinder(Cylinder));
        }),
    },
    Row {
        command: SceneCommand {
            keyword: "triangle",
            values: &[
                number("x0"),
                number("y0"),
                number("z0"),
                number("x1"),
                number("y1"),
                number("z1"),
                number("x2"),
                number("y2"),
                number("z2"),
            ],
            summary: "one triangle",
            example: "triangle 0 0 0  1 0 0  0 1 0",
            also_called: &["face", "polygon"],
        },
        action: add_object(triangle),
    },
    Row {
        command: SceneCommand {
            keyword: "object_flat",
            values: &[value("file", ValueKind::Name)],
            summary: "a Wavefront OBJ mesh, one normal a face",
            example: "object_flat bunny.obj",
            also_called: &["mesh", "object", "obj", "model"],
        },
        action: add_object(|scene, values| mesh(scene, values, Normals::Flat)),
    },
    Row {
        command: SceneCommand {
            keyword: "object_phong",
            values: &[value("file", ValueKind::Name)],
            summary: "a Wavefront OBJ mesh, its normals interpolated over each face",
            example: "object_phong bunny.obj",
            also_called: &["object_smooth"],
        },
        action: add_object(|scene, values| mesh(scene, values, Normals::Interpolated)),
    },
    Row {
        command: SceneCommand {
            keyword: "scatter",
            values: &[value("kind:count[:seed]", ValueKind::Scatter)],
            summary: "many objects by rule: KIND:COUNT[:SEED], KIND one of balls, mixed, knots, city",
            example: "scatter balls:10k:1",
            also_called: &["many", "crowd", "random"],
        },
        action: add_scattered(scatter_objects),
    },
];

/// Adds a shape in object space.
fn add_transformed(scene: &mut SceneBuilder, values: &Values<'_>, shape: impl Into<Shape>) {
    if let Some(transform) = scene.object_transform(values.span()) {
        scene.add_object(shape, transform, values.span());
    }
}

/// A ball: it is transformed as it is read, where that keeps its form.
fn ball(scene: &mut SceneBuilder, values: &Values<'_>) {
    if let Some(transform) = scene.object_transform(values.span()) {
        let (ball, transform) = Ball::transformed(values.vector(1), values.number(0), &transform);
        scene.add_object(Single::Ball(ball), transform, values.span());
    }
}

/// One triangle: its corners are transformed as it is read.
fn triangle(scene: &mut SceneBuilder, values: &Values<'_>) {
    let matrix = scene.transform();
    let corners = [0, 3, 6].map(|i| matrix.transform_point3(values.vector(i)));
    if !corners.iter().all(|&corner| holds_point(corner)) {
        scene.report_transform(values.span(), "takes this beyond single precision");
    } else if is_degenerate(corners) {
        scene.leave_out_degenerate(values.span());
    } else {
        let triangle = Triangle::new(corners.map(|corner| corner.as_vec3()));
        scene.add_object(Single::Triangle(triangle), DAffine3::IDENTITY, values.span());
    }
}

fn mesh(scene: &mut SceneBuilder, values: &Values<'_>, normals: Normals) {
    let mesh = scene.mesh_id(values.name(), values.span_of(0, 0));
    add_transformed(scene, values, Shape::Mesh { mesh, normals });
}

/// Many objects, the material's reflectance under the tint of each.
fn scatter_objects(scene: &mut SceneBuilder, values: &Values<'_>) {
    let span = values.span();
    let (Some(recipe), Some(outer)) = (values.scattered(), scene.object_transform(span.clone()))
    else {
        return;
    };
    if let Err(too_many) = make_room(scene, recipe.count, &span) {
        scene.report(too_many);
        return;
    }
    let mesh = recipe.kind.mesh().map(|(name, normals)| Shape::Mesh {
        mesh: scene.mesh_id(name, values.span_of(0, 0)),
        normals: match normals {
            ScatteredNormals::Flat => Normals::Flat,
            ScatteredNormals::Interpolated => Normals::Interpolated,
        },
    });
    let reflectance = scene.material().reflectance;
    for scattered in scatter(recipe) {
        let placed = scattered.under(&outer);
        let Some(shape) = placed.shape.map(Shape::Single).or(mesh) else { continue };
        match shape {
            Shape::Single(Single::Triangle(triangle)) => {
                let corners = triangle.corners.map(|corner| corner.as_dvec3());
                if !corners.iter().all(|&corner| holds_point(corner)) {
                    scene.report_transform(span.clone(), "takes this beyond single precision");
                    break;
                }
                if is_degenerate(corners) {
                    scene.leave_out_degenerate(span.clone());
                    continue;
                }
            }
            _ if !holds_transform(&placed.transform) => {
                scene.report_transform(span.clone(), "takes this beyond single precision");
                break;
            }
            _ if Transform::new(placed.transform).is_err() => {
                scene.report_transform(span.clone(), "is singular: it flattens the objects");
                break;
            }
            _ => {}
        }
        scene.material().reflectance = reflectance * scattered.tint;
        scene.add_object(shape, placed.transform, span.clone());
    }
    scene.material().reflectance = reflectance;
}
