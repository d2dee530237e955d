//! The affine map between an object's own space and the world's.

use glam::{DAffine3, DMat3, DVec3, Vec3, Vec3A, Vec3Swizzles};
use thiserror::Error;

use super::{Aabb, Ray, UNIT_ROUNDOFF, round_down, round_up};

/// Why a matrix cannot carry an object.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[error("the transform is singular (determinant {determinant:e}): it flattens the object")]
pub struct ConditionError {
    /// The determinant of the linear part.
    pub determinant: f64,
}

/// Object space to world space and back.
///
/// Composed and inverted in `f64`; rays are carried in `f32` by the rounded inverse.
#[derive(Clone, Copy, Debug)]
pub struct Transform {
    /// Object points to world points.
    pub world_from_object: DAffine3,
    /// World points to object points.
    pub object_from_world: DAffine3,
    ray_to_object: RayToObject,
}

impl Transform {
    /// Checks and prepares a transform.
    ///
    /// # Errors
    /// If the matrix is singular, or so nearly that its inverse is not finite in `f32`.
    pub fn new(world_from_object: DAffine3) -> Result<Self, ConditionError> {
        let determinant = world_from_object.matrix3.determinant();
        let transform = Self::of_invertible(world_from_object);
        if determinant == 0.0 || !determinant.is_finite() || !transform.ray_to_object().is_finite()
        {
            return Err(ConditionError { determinant });
        }
        Ok(transform)
    }

    /// The transform of a matrix that [`new`](Self::new) has taken before.
    #[inline]
    #[must_use]
    pub fn of_invertible(world_from_object: DAffine3) -> Self {
        let object_from_world = world_from_object.inverse();
        let ray_to_object = RayToObject::rounded(&object_from_world);
        Self { world_from_object, object_from_world, ray_to_object }
    }

    /// How much rounding a trip to object space and back may amplify: the largest row sum of
    /// |M|·|M⁻¹|, at least 1.
    #[must_use]
    pub fn amplification(&self) -> f64 {
        let forward = self.world_from_object.matrix3.abs();
        let product = forward * self.object_from_world.matrix3.abs();
        (0..3).map(|i| product.row(i).element_sum()).fold(1.0, f64::max)
    }

    /// What carries rays to object space.
    #[inline]
    #[must_use]
    pub fn ray_to_object(&self) -> RayToObject {
        self.ray_to_object
    }

    /// The inverse transpose of the linear part: carries normals to the world.
    #[inline]
    #[must_use]
    pub fn normal_to_world(&self) -> DMat3 {
        self.object_from_world.matrix3.transpose()
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
pub struct RayToObject {
    /// The images of the axes.
    axes: [Vec3; 3],
    /// The image of the origin.
    origin: Vec3,
}

impl RayToObject {
    /// A matrix rounded to `f32`.
    fn rounded(m: &DAffine3) -> Self {
        let DMat3 { x_axis, y_axis, z_axis } = m.matrix3;
        Self {
            axes: [x_axis, y_axis, z_axis].map(|axis| axis.as_vec3()),
            origin: m.translation.as_vec3(),
        }
    }

    /// Whether nothing of it is infinite or NaN.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        self.axes.iter().all(|axis| axis.is_finite()) && self.origin.is_finite()
    }

    /// The ray in object space. Its direction is not renormalised, so `t` stays what it was.
    #[inline]
    #[must_use]
    pub fn apply(&self, ray: &Ray) -> Ray {
        let [x, y, z] = self.axes.map(Vec3A::from);
        let turned = |v: Vec3| {
            let v = Vec3A::from(v);
            v.xxx() * x + v.yyy() * y + v.zzz() * z
        };
        let origin = turned(ray.origin) + Vec3A::from(self.origin);
        Ray { origin: origin.into(), dir: turned(ray.dir).into(), ..*ray }
    }

    /// The images of the axes and of the origin: [`apply`](Self::apply) adds the products with a
    /// point's coordinates up in this order.
    #[inline]
    #[must_use]
    pub fn columns(&self) -> [[f32; 3]; 4] {
        let [x, y, z] = self.axes;
        [x, y, z, self.origin].map(|column| column.to_array())
    }
}

/// The smallest `f32` box that contains an `f64` one.
pub(crate) fn outward_box(low: DVec3, high: DVec3) -> Aabb {
    Aabb {
        min: Vec3A::from_array(low.to_array().map(round_down)),
        max: Vec3A::from_array(high.to_array().map(round_up)),
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
        let normal = transform.normal_to_world() * DVec3::new(1.0, 1.0, 0.0);
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
