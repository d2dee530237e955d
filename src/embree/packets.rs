//! Rays in packets of sixteen, in the order in which they stand in the slice.
//!
//! They are declared coherent to Embree, which is what packets are for.

use crate::math::{Hit, Ray};

use super::TriangleScene;
use super::ffi::{
    Arguments, PACKET, RTC_INVALID_GEOMETRY_ID, RTCHit16, RTCRay16, RTCRayHit16, Valid,
};

const ALL: Valid = Valid([-1; PACKET]);
const ZERO: [f32; PACKET] = [0.0; PACKET];
const NONE: [u32; PACKET] = [RTC_INVALID_GEOMETRY_ID; PACKET];
const NO_RAYS: RTCRay16 = RTCRay16 {
    org: [ZERO; 3],
    tnear: ZERO,
    dir: [ZERO; 3],
    time: ZERO,
    tfar: ZERO,
    mask: [u32::MAX; PACKET],
    id: [0; PACKET],
    flags: [0; PACKET],
};
const NO_HITS: RTCHit16 = RTCHit16 {
    ng: [ZERO; 3],
    u: ZERO,
    v: ZERO,
    prim_id: NONE,
    geom_id: NONE,
    instances: [NONE; 2],
};

impl TriangleScene {
    /// The closest hit of each ray, by the kernel for packets of sixteen.
    ///
    /// # Panics
    /// If the slices differ in length.
    pub fn intersect_packets(&self, rays: &[Ray], hits: &mut [Hit]) {
        assert_eq!(rays.len(), hits.len(), "a hit for each ray");
        let mut query = RTCRayHit16 { ray: NO_RAYS, hit: NO_HITS };
        let (packets, rest) = rays.as_chunks();
        let (hits, hits_of_rest) = hits.as_chunks_mut();
        for (rays, hits) in packets.iter().zip(hits) {
            self.intersect_packet(&ALL, rays, &mut query, hits);
        }
        if let Some((valid, rays)) = filled_up(rest) {
            let mut hits = [Hit::MISS; PACKET];
            self.intersect_packet(&valid, &rays, &mut query, &mut hits);
            hits_of_rest.copy_from_slice(&hits[..rest.len()]);
        }
    }

    /// Whether each ray hits anything, by the kernel for packets of sixteen.
    ///
    /// # Panics
    /// If the slices differ in length.
    pub fn occluded_packets(&self, rays: &[Ray], blocked: &mut [bool]) {
        assert_eq!(rays.len(), blocked.len(), "an answer for each ray");
        let mut query = NO_RAYS;
        let (packets, rest) = rays.as_chunks();
        let (blocked, blocked_of_rest) = blocked.as_chunks_mut();
        for (rays, blocked) in packets.iter().zip(blocked) {
            self.occluded_packet(&ALL, rays, &mut query, blocked);
        }
        if let Some((valid, rays)) = filled_up(rest) {
            let mut blocked = [false; PACKET];
            self.occluded_packet(&valid, &rays, &mut query, &mut blocked);
            blocked_of_rest.copy_from_slice(&blocked[..rest.len()]);
        }
    }

    #[inline(always)]
    fn intersect_packet(
        &self,
        valid: &Valid,
        rays: &[Ray; PACKET],
        query: &mut RTCRayHit16,
        hits: &mut [Hit; PACKET],
    ) {
        let ((library, scene), mut arguments) = (self.parts(), Arguments::new(true));
        put(rays, &mut query.ray);
        query.hit.geom_id = NONE;
        // SAFETY: the scene is committed; all structs are Embree's and aligned as it requires.
        unsafe { library.intersect_packet(valid, scene, &mut arguments, query) };
        let RTCHit16 { u, v, prim_id, geom_id, .. } = &query.hit;
        for (lane, hit) in hits.iter_mut().enumerate() {
            *hit = if geom_id[lane] == RTC_INVALID_GEOMETRY_ID {
                Hit::MISS
            } else {
                Hit {
                    t: query.ray.tfar[lane],
                    object: geom_id[lane],
                    prim: prim_id[lane],
                    u: u[lane],
                    v: v[lane],
                }
            };
        }
    }

    #[inline(always)]
    fn occluded_packet(
        &self,
        valid: &Valid,
        rays: &[Ray; PACKET],
        query: &mut RTCRay16,
        blocked: &mut [bool; PACKET],
    ) {
        let ((library, scene), mut arguments) = (self.parts(), Arguments::new(true));
        put(rays, query);
        // SAFETY: the scene is committed; all structs are Embree's and aligned as it requires.
        unsafe { library.occluded_packet(valid, scene, &mut arguments, query) };
        *blocked = query.tfar.map(|tfar| tfar == f32::NEG_INFINITY);
    }
}

/// Puts a ray into each lane. What is the same for all rays is in its place already.
#[inline(always)]
fn put(rays: &[Ray; PACKET], packet: &mut RTCRay16) {
    for axis in 0..3 {
        packet.org[axis] = rays.each_ref().map(|ray| ray.origin[axis]);
        packet.dir[axis] = rays.each_ref().map(|ray| ray.dir[axis]);
    }
    packet.tnear = rays.each_ref().map(|ray| ray.t_min);
    packet.tfar = rays.each_ref().map(|ray| ray.end());
}

/// A packet of fewer rays than there are lanes: the others repeat the last, and do not count.
fn filled_up(rays: &[Ray]) -> Option<(Valid, [Ray; PACKET])> {
    let last = rays.len().checked_sub(1)?;
    let valid = std::array::from_fn(|lane| if lane <= last { -1 } else { 0 });
    Some((Valid(valid), std::array::from_fn(|lane| rays[lane.min(last)])))
}
