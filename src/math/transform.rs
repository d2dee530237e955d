//! The affine map between an object's own space and the world's.

use glam::{Affine3A, DAffine3, DMat3, DVec3, Mat3A, Vec3, Vec3A};
use thiserror::Error;

use super::{Aabb, Ray, UNIT_ROUNDOFF};

/// Why a matrix cannot carry an object.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[error("the transform is singular (determinant {determinant:e}): it flattens the object")]
pub struct ConditionError {
    /// The determinant of the linear part.
    pub determinant: f64,
}

/// Object space to world space and back, with what normals and error bounds need.
///
/// Composed and inverted in `f64`; rays are carried in `f32` by the rounded inverse.
#[derive(Clone, Copy, Debug)]
pub struct Transform {
    /// Object points to world points.
    pub world_from_object: DAffine3,
    /// World points to object points.
    pub object_from_world: DAffine3,
    /// The inverse transpose of the linear part: carries normals to the world.
    pub normal_to_world: DMat3,
    ray_to_object: RayToObject,
    amplification: f64,
}

impl Transform {
    /// Prepares a transform.
    ///
    /// # Errors
    /// If the matrix is singular, or so nearly that its inverse is not finite in `f32`.
    pub fn new(world_from_object: DAffine3) -> Result<Self, ConditionError> {
        let determinant = world_from_object.matrix3.determinant();
        let object_from_world = world_from_object.inverse();
        let ray_to_object = RayToObject(rounded(&object_from_world));
        if determinant == 0.0 || !determinant.is_finite() || !ray_to_object.0.is_finite() {
            return Err(ConditionError { determinant });
        }
        let forward = world_from_object.matrix3.abs();
        let back = object_from_world.matrix3.abs();
        let product = forward * back;
        let amplification = (0..3).map(|i| product.row(i).element_sum()).fold(1.0, f64::max);
        Ok(Self {
            world_from_object,
            object_from_world,
            normal_to_world: object_from_world.matrix3.transpose(),
            ray_to_object,
            amplification,
        })
    }

    /// How much rounding a trip to object space and back may amplify: the largest row sum of
    /// |M|·|M⁻¹|, at least 1.
    #[must_use]
    pub fn amplification(&self) -> f64 {
        self.amplification
    }

    /// What carries rays to object space.
    #[must_use]
    pub fn ray_to_object(&self) -> RayToObject {
        self.ray_to_object
    }

    /// A box around the transformed box, rounded outwards.
    #[must_use]
    pub fn bounds_to_world(&self, bounds: &Aabb) -> Aabb {
        let corners = bounds
            .corners()
            .map(|c| self.world_from_object.transform_point3(DVec3::from(Vec3::from(c))));
        let low = corners.iter().copied().fold(DVec3::INFINITY, DVec3::min);
        let high = corners.iter().copied().fold(DVec3::NEG_INFINITY, DVec3::max);
        outward_box(low, high)
    }

    /// Bounds, per axis of the world, on what the `f32` trip of a point to object space can
    /// displace it by, seen in the world.
    ///
    /// Six roundings a coordinate (three products, three sums, the rounded matrix) bound the error
    /// in object space by 6u·(|M⁻¹||p| + |t|); |M| carries it back.
    #[must_use]
    pub fn round_trip_error(&self, world_point: DVec3) -> DVec3 {
        let back = &self.object_from_world;
        let object_error =
            6.0 * UNIT_ROUNDOFF * (back.matrix3.abs() * world_point.abs() + back.translation.abs());
        self.world_from_object.matrix3.abs() * object_error
    }
}

/// Carries rays to an object's space: the only part of a [`Transform`] that a search needs.
#[derive(Clone, Copy, Debug)]
pub struct RayToObject(Affine3A);

impl RayToObject {
    /// The ray in object space. Its direction is not renormalised, so `t` stays what it was.
    #[inline]
    #[must_use]
    pub fn apply(&self, ray: &Ray) -> Ray {
        let origin = self.0.transform_point3a(Vec3A::from(ray.origin));
        let dir = self.0.transform_vector3a(Vec3A::from(ray.dir));
        Ray { origin: origin.into(), dir: dir.into(), ..*ray }
    }

    /// The columns of the matrix and the translation: [`apply`](Self::apply) adds the products
    /// with a point's coordinates up in this order.
    #[inline]
    #[must_use]
    pub fn columns(&self) -> [[f32; 3]; 4] {
        let Affine3A { matrix3, translation } = self.0;
        [matrix3.x_axis, matrix3.y_axis, matrix3.z_axis, translation]
            .map(|column| column.to_array())
    }
}

/// A matrix rounded to `f32`.
fn rounded(m: &DAffine3) -> Affine3A {
    Affine3A {
        matrix3: Mat3A::from_cols(
            m.matrix3.x_axis.as_vec3a(),
            m.matrix3.y_axis.as_vec3a(),
            m.matrix3.z_axis.as_vec3a(),
        ),
        translation: m.translation.as_vec3a(),
    }
}

/// The smallest `f32` box that contains an `f64` one.
pub(crate) fn outward_box(low: DVec3, high: DVec3) -> Aabb {
    let down = |x: f64| {
        let y = x as f32;
        if f64::from(y) > x { y.next_down() } else { y }
    };
    let up = |x: f64| {
        let y = x as f32;
        if f64::from(y) < x { y.next_up() } else { y }
    };
    Aabb {
        min: Vec3A::new(down(low.x), down(low.y), down(low.z)),
        max: Vec3A::new(up(high.x), up(high.y), up(high.z)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{DQuat, Quat};

    #[test]
    fn rays_keep_their_parameter() {
        let m = DAffine3::from_scale_rotation_translation(
            DVec3::new(2.0, 0.5, -3.0),
            DQuat::from_rotation_y(0.7),
            DVec3::new(5.0, -1.0, 2.0),
        );
        let transform = Transform::new(m).unwrap();
        let ray = Ray::new(Vec3::new(1.0, 2.0, 3.0), Vec3::new(-0.3, 0.9, 2.0));
        let object = transform.ray_to_object().apply(&ray);
        for t in [0.0, 0.5, 4.0] {
            let back = m.transform_point3(object.at(t).as_dvec3());
            assert!((back - ray.at(t).as_dvec3()).length() < 1e-5);
        }
    }

    #[test]
    fn normals_stay_perpendicular_under_unequal_scales() {
        let m = DAffine3::from_scale(DVec3::new(4.0, 1.0, 1.0));
        let transform = Transform::new(m).unwrap();
        let tangent = m.transform_vector3(DVec3::new(1.0, -1.0, 0.0));
        let normal = transform.normal_to_world * DVec3::new(1.0, 1.0, 0.0);
        assert!(normal.dot(tangent).abs() < 1e-12);
    }

    #[test]
    fn a_flattening_transform_is_refused() {
        let error = Transform::new(DAffine3::from_scale(DVec3::new(1.0, 0.0, 1.0))).unwrap_err();
        assert_eq!(error.determinant, 0.0);
        assert!(Transform::new(DAffine3::from_scale(DVec3::splat(1e-30))).is_ok());
    }

    #[test]
    fn the_amplification_of_a_rotation_is_small_and_of_a_shear_is_not() {
        let rotation = DAffine3::from_quat(DQuat::from_rotation_z(0.5));
        assert!(Transform::new(rotation).unwrap().amplification() < 3.0);
        let shear =
            DAffine3::from_mat3(DMat3::from_cols(DVec3::X, DVec3::new(1000.0, 1.0, 0.0), DVec3::Z));
        assert!(Transform::new(shear).unwrap().amplification() > 1000.0);
    }

    #[test]
    fn outward_boxes_contain_what_rounding_would_cut() {
        let third = 1.0 / 3.0;
        let b = outward_box(DVec3::splat(-third), DVec3::splat(third));
        assert!(f64::from(b.min.x) <= -third && f64::from(b.max.x) >= third);
        let rotated =
            Transform::new(DAffine3::from_quat(Quat::from_rotation_z(0.3).as_dquat().normalize()))
                .unwrap()
                .bounds_to_world(&Aabb { min: Vec3A::splat(-1.0), max: Vec3A::splat(1.0) });
        assert!((rotated.max.x - (0.3f32.cos() + 0.3f32.sin())).abs() < 1e-5);
    }
}
