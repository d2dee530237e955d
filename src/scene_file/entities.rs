//! The commands that make objects and lights, with the material and transform in force.

use glam::{DAffine3, DVec3};

use crate::description::{Light, Normals, Shape};
use crate::math::Transform;
use crate::shapes::{Ball, Cylinder, Single, Triangle};

use super::builder::Builder;
use super::command::is_nothing;
use super::diagnostic::Diagnostic;
use super::values::Values;

/// The smallest height of a triangle over its base, relative to its edges, that double precision
/// tells from none.
const SMALLEST_SINE: f64 = 1e-12;

/// A ball: it is transformed as it is read, where that keeps its form.
pub(super) fn ball(builder: &mut Builder, values: &Values<'_>) {
    if let Some(transform) = usable_transform(builder, values) {
        let (ball, transform) = Ball::transformed(values.vector(1), values.number(0), &transform);
        builder.add_object(Single::Ball(ball), transform, values.span.clone());
    }
}

pub(super) fn cylinder(builder: &mut Builder, values: &Values<'_>) {
    add_transformed(builder, values, Single::Cylinder(Cylinder));
}

pub(super) fn mesh_flat(builder: &mut Builder, values: &Values<'_>) {
    mesh(builder, values, Normals::Flat);
}

pub(super) fn mesh_phong(builder: &mut Builder, values: &Values<'_>) {
    mesh(builder, values, Normals::Interpolated);
}

fn mesh(builder: &mut Builder, values: &Values<'_>, normals: Normals) {
    let mesh = builder.mesh_id(values.name, values.spans[0].clone());
    add_transformed(builder, values, Shape::Mesh { mesh, normals });
}

/// Adds a shape in object space, if the transform in force can carry it.
fn add_transformed(builder: &mut Builder, values: &Values<'_>, shape: impl Into<Shape>) {
    if let Some(transform) = usable_transform(builder, values) {
        builder.add_object(shape, transform, values.span.clone());
    }
}

/// The transform in force, if it can carry an object; reported otherwise.
fn usable_transform(builder: &mut Builder, values: &Values<'_>) -> Option<DAffine3> {
    let matrix = builder.state.transform.matrix;
    if !fits(matrix) {
        report_transform(builder, values, "is beyond single precision");
    } else if Transform::new(matrix).is_err() {
        report_transform(builder, values, "is singular: it flattens what it carries");
    } else {
        return Some(matrix);
    }
    None
}

/// One triangle: its corners are transformed as it is read.
pub(super) fn triangle(builder: &mut Builder, values: &Values<'_>) {
    let matrix = builder.state.transform.matrix;
    let corners = [0, 3, 6].map(|i| matrix.transform_point3(values.vector(i)));
    if !corners.iter().all(|&corner| fits_point(corner)) {
        report_transform(builder, values, "carries this beyond single precision");
    } else if is_degenerate(corners) {
        let (_, count) = builder.degenerate.get_or_insert_with(|| (values.span.clone(), 0));
        *count += 1;
    } else {
        let triangle = Triangle::new(corners.map(|corner| corner.as_vec3()));
        builder.add_object(Single::Triangle(triangle), DAffine3::IDENTITY, values.span.clone());
    }
}

pub(super) fn point_light(builder: &mut Builder, values: &Values<'_>) {
    let position = builder.state.transform.matrix.transform_point3(values.vector(0));
    if fits_point(position) {
        builder.lights.push(Light::Point { position, color: values.color(3) });
    } else {
        report_transform(builder, values, "carries this beyond single precision");
    }
}

/// The square [−h, h]² of the plane z = 0, transformed.
pub(super) fn area_light(builder: &mut Builder, values: &Values<'_>) {
    let matrix = builder.state.transform.matrix;
    let h = values.number(0);
    let center = matrix.transform_point3(DVec3::ZERO);
    let half_u = matrix.transform_vector3(DVec3::X * h);
    let half_v = matrix.transform_vector3(DVec3::Y * h);
    let corners = [center, center + half_u, center + half_v];
    if !corners.iter().all(|&corner| fits_point(corner)) {
        report_transform(builder, values, "carries this beyond single precision");
    } else if is_short(half_u) || is_short(half_v) || !has_area(half_u, half_v) {
        report_transform(builder, values, "flattens the light to a line or a point");
    } else {
        builder.lights.push(Light::Area { center, half_u, half_v, color: values.color(1) });
    }
}

/// Says once for a transform what is wrong with it.
fn report_transform(builder: &mut Builder, values: &Values<'_>, what: &str) {
    let transform = &mut builder.state.transform;
    if std::mem::replace(&mut transform.reported, true) {
        return;
    }
    let last = transform.last.clone();
    let error = Diagnostic::error(values.span.clone(), format!("the transform here {what}"))
        .with_label("made with this transform")
        .with_help("look for a `scale` that shrinks or stretches too much");
    builder.report(match last {
        Some(last) => error.with_related(last, "the last command that went into it"),
        None => error,
    });
}

/// Whether single precision can hold a transform.
fn fits(matrix: DAffine3) -> bool {
    let columns = [matrix.x_axis, matrix.y_axis, matrix.z_axis, matrix.translation];
    columns.iter().all(|&column| fits_point(column))
}

fn fits_point(point: DVec3) -> bool {
    point.as_vec3().is_finite()
}

/// Whether single precision may take a vector for 0.
fn is_short(v: DVec3) -> bool {
    is_nothing(v.abs().max_element())
}

/// Whether the corners lie on a line, as written or in single precision.
fn is_degenerate(corners: [DVec3; 3]) -> bool {
    let spans_nothing = |[a, b, c]: [DVec3; 3]| !has_area(b - a, c - a);
    let rounded = corners.map(|corner| corner.as_vec3().as_dvec3());
    spans_nothing(corners) || spans_nothing(rounded)
}

/// Whether two vectors span a parallelogram with an area.
fn has_area(u: DVec3, v: DVec3) -> bool {
    let longest = |w: DVec3| w.abs().max_element();
    // Scaled first, so that no product overflows or is lost.
    let cross = (u / longest(u)).cross(v / longest(v));
    // NaN, from a vector of length 0, has no area.
    cross.length() > SMALLEST_SINE
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn triangles_on_a_line_are_degenerate_at_every_scale() {
        for scale in [1e-30, 1.0, 1e30] {
            let at = |x: f64, y: f64| DVec3::new(x, y, 1.0) * scale;
            assert!(is_degenerate([at(0.0, 0.0), at(1.0, 0.1), at(3.0, 0.3)]));
            assert!(is_degenerate([at(0.0, 0.0), at(0.0, 0.0), at(3.0, 0.3)]));
            assert!(!is_degenerate([at(0.0, 0.0), at(1.0, 0.0), at(3.0, 1e-6)]));
        }
    }

    #[test]
    fn what_single_precision_makes_degenerate_is_degenerate() {
        let near = |x: f64, y: f64| DVec3::new(1e6 + x, y, 0.0);
        assert!(is_degenerate([near(0.0, 0.0), near(1e-3, 1.0), near(-1e-3, 2.0)]));
    }
}
