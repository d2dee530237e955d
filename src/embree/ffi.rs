//! The types of Embree's C interface that are used, as `rtcore.h` of versions 3.13 and 4.4 declares them.
//!
//! Names and layouts are Embree's, so that they can be looked up in its manual. Rays are laid out alike in both
//! versions; hits end with instances, of which version 4 notes more, and there is room for them.

#![allow(non_camel_case_types, reason = "Embree's names")]

use std::ffi::{c_char, c_int, c_uint, c_void};
use std::ptr;

/// Rays in a packet.
pub(super) const PACKET: usize = 16;

/// What ids are where there is none.
pub(super) const RTC_INVALID_GEOMETRY_ID: c_uint = c_uint::MAX;

pub(super) const RTC_ERROR_NONE: c_int = 0;
/// Ten thousand times the first part, a hundred times the second, and the third.
pub(super) const RTC_DEVICE_PROPERTY_VERSION: c_int = 0;
pub(super) const RTC_BUILD_QUALITY_HIGH: c_int = 2;
pub(super) const RTC_SCENE_FLAG_NONE: c_int = 0;
pub(super) const RTC_GEOMETRY_TYPE_TRIANGLE: c_int = 0;
pub(super) const RTC_BUFFER_TYPE_INDEX: c_int = 0;
pub(super) const RTC_BUFFER_TYPE_VERTEX: c_int = 1;
pub(super) const RTC_FORMAT_UINT3: c_int = 0x5003;
pub(super) const RTC_FORMAT_FLOAT3: c_int = 0x9003;
const RTC_INTERSECT_CONTEXT_FLAG_COHERENT: c_int = 1;
const RTC_RAY_QUERY_FLAG_COHERENT: c_int = 1 << 16;
const RTC_FEATURE_FLAG_ALL: c_uint = c_uint::MAX;

pub(super) type RTCDevice = *mut c_void;
pub(super) type RTCScene = *mut c_void;
pub(super) type RTCGeometry = *mut c_void;

pub(super) type RTCErrorFunction =
    unsafe extern "C" fn(user: *mut c_void, code: c_int, text: *const c_char);
pub(super) type RTCMemoryMonitorFunction =
    unsafe extern "C" fn(user: *mut c_void, bytes: isize, post: bool) -> bool;

/// Of version 3.
#[repr(C)]
pub(super) struct RTCIntersectContext {
    flags: c_int,
    filter: *const c_void,
    inst_id: c_uint,
}

/// Of version 4.
#[repr(C)]
pub(super) struct RTCIntersectArguments {
    flags: c_int,
    feature_mask: c_uint,
    context: *const c_void,
    filter: *const c_void,
    intersect: *const c_void,
}

/// The arguments of a query beside its rays, of both versions.
pub(super) struct Arguments {
    pub(super) three: RTCIntersectContext,
    pub(super) four: RTCIntersectArguments,
}

impl Arguments {
    /// For rays that are declared coherent, or not.
    pub(super) fn new(coherent: bool) -> Self {
        let flags = |flag| if coherent { flag } else { 0 };
        Self {
            three: RTCIntersectContext {
                flags: flags(RTC_INTERSECT_CONTEXT_FLAG_COHERENT),
                filter: ptr::null(),
                inst_id: RTC_INVALID_GEOMETRY_ID,
            },
            four: RTCIntersectArguments {
                flags: flags(RTC_RAY_QUERY_FLAG_COHERENT),
                feature_mask: RTC_FEATURE_FLAG_ALL,
                context: ptr::null(),
                filter: ptr::null(),
                intersect: ptr::null(),
            },
        }
    }
}

#[derive(Clone, Copy)]
#[repr(C, align(16))]
pub(super) struct RTCRay {
    pub(super) org: [f32; 3],
    pub(super) tnear: f32,
    pub(super) dir: [f32; 3],
    pub(super) time: f32,
    pub(super) tfar: f32,
    pub(super) mask: c_uint,
    pub(super) id: c_uint,
    pub(super) flags: c_uint,
}

#[derive(Clone, Copy)]
#[repr(C, align(16))]
pub(super) struct RTCHit {
    pub(super) ng: [f32; 3],
    pub(super) u: f32,
    pub(super) v: f32,
    pub(super) prim_id: c_uint,
    pub(super) geom_id: c_uint,
    pub(super) instances: [c_uint; 5],
}

#[derive(Clone, Copy)]
#[repr(C)]
pub(super) struct RTCRayHit {
    pub(super) ray: RTCRay,
    pub(super) hit: RTCHit,
}

#[derive(Clone, Copy)]
#[repr(C, align(64))]
pub(super) struct RTCRay16 {
    pub(super) org: [[f32; PACKET]; 3],
    pub(super) tnear: [f32; PACKET],
    pub(super) dir: [[f32; PACKET]; 3],
    pub(super) time: [f32; PACKET],
    pub(super) tfar: [f32; PACKET],
    pub(super) mask: [c_uint; PACKET],
    pub(super) id: [c_uint; PACKET],
    pub(super) flags: [c_uint; PACKET],
}

#[derive(Clone, Copy)]
#[repr(C, align(64))]
pub(super) struct RTCHit16 {
    pub(super) ng: [[f32; PACKET]; 3],
    pub(super) u: [f32; PACKET],
    pub(super) v: [f32; PACKET],
    pub(super) prim_id: [c_uint; PACKET],
    pub(super) geom_id: [c_uint; PACKET],
    pub(super) instances: [[c_uint; PACKET]; 2],
}

#[derive(Clone, Copy)]
#[repr(C)]
pub(super) struct RTCRayHit16 {
    pub(super) ray: RTCRay16,
    pub(super) hit: RTCHit16,
}

/// Which rays of a packet there are: −1 for those that are traced, 0 for the others.
#[repr(C, align(64))]
pub(super) struct Valid(pub(super) [c_int; PACKET]);

// What the compiler of `rtcore.h` gives, checked once against version 3.13.5; of version 3 hits are 16 and 64 bytes
// shorter.
const _: () = assert!(size_of::<RTCIntersectContext>() == 24);
const _: () = assert!(size_of::<RTCIntersectArguments>() == 32);
const _: () = assert!(size_of::<RTCRay>() == 48 && size_of::<RTCRayHit>() == 96);
const _: () = assert!(size_of::<RTCRay16>() == 768 && size_of::<RTCRayHit16>() == 1344);
