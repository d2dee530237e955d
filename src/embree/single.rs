//! Rays one by one.

use crate::math::{Hit, Ray};

use super::TriangleScene;
use super::ffi::{Arguments, RTC_INVALID_GEOMETRY_ID, RTCHit, RTCRay, RTCRayHit};

const NO_HIT: RTCHit = RTCHit {
    ng: [0.0; 3],
    u: 0.0,
    v: 0.0,
    prim_id: RTC_INVALID_GEOMETRY_ID,
    geom_id: RTC_INVALID_GEOMETRY_ID,
    instances: [RTC_INVALID_GEOMETRY_ID; 5],
};

impl TriangleScene {
    /// The closest hit of each ray, by the kernel for single rays.
    ///
    /// # Panics
    /// If the slices differ in length.
    pub fn intersect(&self, rays: &[Ray], hits: &mut [Hit]) {
        assert_eq!(rays.len(), hits.len(), "a hit for each ray");
        let ((library, scene), mut arguments) = (self.parts(), Arguments::new(false));
        for (ray, hit) in rays.iter().zip(hits) {
            let mut query = RTCRayHit { ray: rtc_ray(ray), hit: NO_HIT };
            // SAFETY: the scene is committed; both structs are Embree's and aligned as it requires.
            unsafe { library.intersect(scene, &mut arguments, &mut query) };
            let RTCHit { u, v, prim_id, geom_id, .. } = query.hit;
            *hit = if geom_id == RTC_INVALID_GEOMETRY_ID {
                Hit::MISS
            } else {
                Hit { t: query.ray.tfar, object: geom_id, prim: prim_id, u, v }
            };
        }
    }

    /// Whether each ray hits anything, by the kernel for single rays.
    ///
    /// # Panics
    /// If the slices differ in length.
    pub fn occluded(&self, rays: &[Ray], blocked: &mut [bool]) {
        assert_eq!(rays.len(), blocked.len(), "an answer for each ray");
        let ((library, scene), mut arguments) = (self.parts(), Arguments::new(false));
        for (ray, blocked) in rays.iter().zip(blocked) {
            let mut query = rtc_ray(ray);
            // SAFETY: as above.
            unsafe { library.occluded(scene, &mut arguments, &mut query) };
            *blocked = query.tfar == f32::NEG_INFINITY;
        }
    }
}

#[inline(always)]
fn rtc_ray(ray: &Ray) -> RTCRay {
    RTCRay {
        org: ray.origin.to_array(),
        tnear: ray.t_min,
        dir: ray.dir.to_array(),
        time: 0.0,
        tfar: ray.end(),
        mask: u32::MAX,
        id: 0,
        flags: 0,
    }
}
