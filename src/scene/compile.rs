//! From the scene as written to the scene as traced.

use std::sync::Arc;

use glam::{DAffine3, DVec3, Vec3, Vec3A};

use crate::assets::MeshData;
use crate::description::{self, SceneDescription, Shape};
use crate::math::{Aabb, Transform};
use crate::shapes::{Ball, Cylinder, Triangle};

use super::{Camera, Form, Light, Object, Scene, SceneError};

impl Scene {
    /// Compiles a description with its meshes, which stand in the order of
    /// [`SceneDescription::meshes`].
    ///
    /// # Errors
    /// If the camera or an object's transform is degenerate, or an object leaves the range of
    /// single precision.
    ///
    /// # Panics
    /// If an object refers to a mesh or a material that is not there.
    pub fn new(
        description: &SceneDescription,
        meshes: Vec<Arc<MeshData>>,
    ) -> Result<Self, SceneError> {
        let mesh_bounds: Vec<Aabb> = meshes.iter().map(|mesh| bounds_of(mesh)).collect();
        let objects = description
            .objects
            .iter()
            .enumerate()
            .map(|(id, object)| compile_object(id, object, &mesh_bounds))
            .collect::<Result<_, _>>()?;
        Ok(Self {
            camera: Camera::new(&description.camera)?,
            options: description.options,
            materials: description.materials.clone(),
            objects,
            lights: description.lights.iter().map(Light::new).collect(),
            meshes,
        })
    }
}

fn bounds_of(mesh: &MeshData) -> Aabb {
    Aabb::of_points(mesh.positions.iter().map(|&p| Vec3A::from(p)))
}

fn compile_object(
    id: usize,
    object: &description::Object,
    mesh_bounds: &[Aabb],
) -> Result<Object, SceneError> {
    let (form, transform) = match object.shape {
        Shape::Ball { radius, center } => ball_in_world(radius, center, &object.transform),
        Shape::Cylinder => (Form::Cylinder, object.transform),
        Shape::Triangle { corners } => {
            (Form::Triangle(Triangle::new(corners.map(|c| c.as_vec3()))), DAffine3::IDENTITY)
        }
        Shape::Mesh { mesh, normals } => (Form::Mesh { mesh, normals }, object.transform),
    };
    let transform = if transform == DAffine3::IDENTITY {
        None
    } else {
        let transform = Transform::new(transform)
            .map_err(|source| SceneError::Transform { object: id, source })?;
        Some(Box::new(transform))
    };
    let own_bounds = match form {
        Form::Ball(ball) => ball.bounds(),
        Form::Cylinder => Cylinder::bounds(),
        Form::Triangle(triangle) => triangle.bounds(),
        Form::Mesh { mesh, .. } => mesh_bounds[mesh],
    };
    let bounds = transform.as_ref().map_or(own_bounds, |t| t.bounds_to_world(&own_bounds));
    let in_range = bounds.min.is_finite() && bounds.max.is_finite() && !bounds.is_empty();
    if !in_range || matches!(form, Form::Ball(ball) if !is_normal(ball.radius)) {
        return Err(SceneError::OutOfRange { object: id });
    }
    Ok(Object { form, transform, bounds, material: object.material })
}

/// Neither zero nor so small or large that its square leaves single precision.
fn is_normal(length: f32) -> bool {
    (length * length).is_normal()
}

/// A ball whose transform keeps its form is traced where it is; any other becomes the unit ball
/// about the origin, transformed. Which of the two depends on the scene alone, never on the
/// structure.
fn ball_in_world(radius: f64, center: DVec3, transform: &DAffine3) -> (Form, DAffine3) {
    if let Some(scale) = uniform_scale(transform) {
        let center = transform.transform_point3(center).as_vec3();
        return (Form::Ball(Ball { center, radius: (radius * scale) as f32 }), DAffine3::IDENTITY);
    }
    let own = DAffine3::from_translation(center) * DAffine3::from_scale(DVec3::splat(radius));
    (Form::Ball(Ball { center: Vec3::ZERO, radius: 1.0 }), *transform * own)
}

/// The factor by which a transform scales lengths, if it is the same in all directions.
fn uniform_scale(transform: &DAffine3) -> Option<f64> {
    let m = transform.matrix3;
    let gram = m.transpose() * m;
    let scale_squared = gram.x_axis.x;
    let difference = gram - glam::DMat3::from_diagonal(DVec3::splat(scale_squared));
    let largest = difference.abs().to_cols_array().into_iter().fold(0.0, f64::max);
    (scale_squared > 0.0 && largest <= 1e-12 * scale_squared).then(|| scale_squared.sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DQuat;

    #[test]
    fn turned_and_evenly_scaled_balls_stay_balls() {
        let m = DAffine3::from_scale_rotation_translation(
            DVec3::new(2.0, -2.0, 2.0),
            DQuat::from_rotation_x(0.4),
            DVec3::new(1.0, 0.0, 0.0),
        );
        let (form, transform) = ball_in_world(0.5, DVec3::ZERO, &m);
        assert_eq!(form, Form::Ball(Ball { center: Vec3::X, radius: 1.0 }));
        assert_eq!(transform, DAffine3::IDENTITY);
    }

    #[test]
    fn an_ellipsoid_is_the_unit_ball_transformed() {
        let m = DAffine3::from_scale(DVec3::new(2.0, 1.0, 1.0));
        let (form, transform) = ball_in_world(3.0, DVec3::new(1.0, 0.0, 0.0), &m);
        assert_eq!(form, Form::Ball(Ball { center: Vec3::ZERO, radius: 1.0 }));
        assert_eq!(transform.transform_point3(DVec3::X), DVec3::new(8.0, 0.0, 0.0));
    }
}
