//! What a hit means: point, normals and material, computed once, after the search.
//!
//! In `f64` up to the last step. Rays that leave the surface start a little off it: after Pharr,
//! Jakob, Humphreys, *Physically Based Rendering*, 3rd edition, section 3.9, by a bound on the
//! error of the point and of the formula that could hit it again, and not by an epsilon that suits
//! one scene's scale and no other's.

use glam::{DVec3, Vec3};

use crate::description::{Normals, Shape};
use crate::math::{Hit, Ray, Transform, UNIT_ROUNDOFF};
use crate::shapes::{SurfacePoint, Triangle};

use super::{Object, Scene};

/// A point of a surface as it is seen along a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// Unit normal of the surface itself, on the side from which it is seen.
    pub geometric_normal: Vec3,
    /// Unit normal that shades it, on the same side.
    pub normal: Vec3,
    /// Whether it is seen from inside of what it bounds.
    pub from_inside: bool,
    /// Index into the scene's materials.
    pub material: usize,
    point: DVec3,
    clearance: f64,
}

/// A bound on the share of a number that rounding to `f32` changes it by, and a little more.
const ROUNDING: f64 = UNIT_ROUNDOFF * (1.0 + 1e-6);

impl Surface {
    /// Where a ray starts that leaves the surface on the side from which it is seen.
    #[inline]
    #[must_use]
    pub fn origin_outside(&self) -> Vec3 {
        self.offset(self.geometric_normal)
    }

    /// Where a ray starts that goes through the surface, to its other side.
    #[inline]
    #[must_use]
    pub fn origin_behind(&self) -> Vec3 {
        self.offset(-self.geometric_normal)
    }

    /// The point, moved off the surface to the side of `normal`, so that rounding to `f32` does
    /// not bring it back: each coordinate is moved by as much as rounding moves it at most.
    #[inline]
    fn offset(&self, normal: Vec3) -> Vec3 {
        let normal = normal.as_dvec3();
        let moved = self.point + self.clearance * normal;
        (moved + (ROUNDING * moved.abs()) * normal.signum()).as_vec3()
    }
}

impl Scene {
    /// What a ray sees where it hits.
    ///
    /// # Panics
    /// If `hit` is a miss, or not a hit of this scene.
    #[inline]
    #[must_use]
    pub fn surface(&self, ray: &Ray, hit: &Hit) -> Surface {
        let object = &self.objects[hit.object as usize];
        let transform = self.transform_of(object);
        let own = self.own_point(object, transform.as_deref(), ray, hit);
        let (point, outward, clearance) = to_world(transform.as_deref(), &own);
        let facing = if outward.dot(ray.dir.as_dvec3()) <= 0.0 { outward } else { -outward };
        let geometric_normal = facing.as_vec3();
        let shading = self.shading_normal(object, transform.as_deref(), hit);
        let normal = shading.map_or(geometric_normal, |normal| {
            if normal.dot(geometric_normal) < 0.0 { -normal } else { normal }
        });
        Surface {
            geometric_normal,
            normal,
            from_inside: facing != outward,
            material: object.material,
            point,
            clearance,
        }
    }

    /// The point in the object's own space.
    #[inline]
    fn own_point(
        &self,
        object: &Object,
        transform: Option<&Transform>,
        ray: &Ray,
        hit: &Hit,
    ) -> SurfacePoint {
        let own_ray = || transform.map_or(*ray, |transform| transform.ray_to_object().apply(ray));
        match object.shape {
            Shape::Single(single) => single.surface_point(&own_ray(), hit),
            Shape::Mesh { mesh, .. } => {
                let mesh = &self.meshes[mesh];
                let corners = mesh.triangles[hit.prim as usize];
                Triangle::new(corners.map(|c| mesh.positions[c as usize]))
                    .surface_point(hit.u, hit.v)
            }
        }
    }

    /// The interpolated unit normal in the world, for meshes that have one.
    #[inline]
    fn shading_normal(
        &self,
        object: &Object,
        transform: Option<&Transform>,
        hit: &Hit,
    ) -> Option<Vec3> {
        let Shape::Mesh { mesh, normals: Normals::Interpolated } = object.shape else {
            return None;
        };
        let mesh = &self.meshes[mesh];
        let corners = mesh.normal_indices[hit.prim as usize];
        let [a, b, c] = corners.map(|corner| mesh.normals[corner as usize]);
        let own = (1.0 - hit.u - hit.v) * a + hit.u * b + hit.v * c;
        match transform {
            None => own.try_normalize(),
            Some(transform) => {
                Some((transform.normal_to_world() * own.as_dvec3()).try_normalize()?.as_vec3())
            }
        }
    }
}

/// Takes a point to the world: where it is, its outward unit normal, and how far rays must start
/// from it along the normal.
///
/// That distance is the shape's own clearance, seen in the world; the rounding of the starting
/// point to `f32`; and what the trip of that point back to object space can move it by. The
/// errors are vectors of bounds per axis; along the normal they are their product with |normal|.
#[inline]
fn to_world(transform: Option<&Transform>, own: &SurfacePoint) -> (DVec3, DVec3, f64) {
    let rounding = |point: DVec3| 2.0 * UNIT_ROUNDOFF * point.abs();
    let Some(transform) = transform else {
        let clearance = own.clearance + own.normal.abs().dot(rounding(own.position));
        return (own.position, own.normal, clearance);
    };
    let point = transform.world_from_object.transform_point3(own.position);
    let normal = transform.normal_to_world() * own.normal;
    let length_recip = normal.length_recip();
    let unit = normal * length_recip;
    // The inverse transpose shortens a normal by as much as distances along it grow.
    let own_clearance = own.clearance * length_recip;
    let error = rounding(point) + transform.round_trip_error(point);
    (point, unit, own_clearance + unit.abs().dot(error))
}
