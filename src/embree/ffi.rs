//! The part of Embree 3's C interface that is used, as `rtcore.h` of version 3.13 declares it.
//!
//! Names and layouts are Embree's, so that they can be looked up in its manual.

#![allow(non_camel_case_types, reason = "Embree's names")]

use std::ffi::{c_char, c_int, c_uint, c_void};

/// Rays in a packet.
pub(super) const PACKET: usize = 16;

/// What ids are where there is none.
pub(super) const RTC_INVALID_GEOMETRY_ID: c_uint = c_uint::MAX;

pub(super) const RTC_ERROR_NONE: c_int = 0;
pub(super) const RTC_BUILD_QUALITY_HIGH: c_int = 2;
pub(super) const RTC_SCENE_FLAG_NONE: c_int = 0;
pub(super) const RTC_GEOMETRY_TYPE_TRIANGLE: c_int = 0;
pub(super) const RTC_BUFFER_TYPE_INDEX: c_int = 0;
pub(super) const RTC_BUFFER_TYPE_VERTEX: c_int = 1;
pub(super) const RTC_FORMAT_UINT3: c_int = 0x5003;
pub(super) const RTC_FORMAT_FLOAT3: c_int = 0x9003;
pub(super) const RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT: c_int = 0;
pub(super) const RTC_INTERSECT_CONTEXT_FLAG_COHERENT: c_int = 1;

pub(super) type RTCDevice = *mut c_void;
pub(super) type RTCScene = *mut c_void;
pub(super) type RTCGeometry = *mut c_void;

pub(super) type RTCErrorFunction =
    unsafe extern "C" fn(user: *mut c_void, code: c_int, text: *const c_char);
pub(super) type RTCMemoryMonitorFunction =
    unsafe extern "C" fn(user: *mut c_void, bytes: isize, post: bool) -> bool;

#[repr(C)]
pub(super) struct RTCIntersectContext {
    pub(super) flags: c_int,
    pub(super) filter: *const c_void,
    pub(super) inst_id: c_uint,
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
    pub(super) inst_id: c_uint,
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
    pub(super) inst_id: [c_uint; PACKET],
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

// What the compiler of `rtcore.h` gives, checked once against version 3.13.5.
const _: () = assert!(size_of::<RTCIntersectContext>() == 24);
const _: () = assert!(size_of::<RTCRay>() == 48 && size_of::<RTCRayHit>() == 80);
const _: () = assert!(size_of::<RTCRay16>() == 768 && size_of::<RTCRayHit16>() == 1280);

#[link(name = "embree3")]
unsafe extern "C" {
    pub(super) fn rtcNewDevice(config: *const c_char) -> RTCDevice;
    pub(super) fn rtcReleaseDevice(device: RTCDevice);
    pub(super) fn rtcGetDeviceError(device: RTCDevice) -> c_int;
    pub(super) fn rtcSetDeviceErrorFunction(
        device: RTCDevice,
        error: RTCErrorFunction,
        user: *mut c_void,
    );
    pub(super) fn rtcSetDeviceMemoryMonitorFunction(
        device: RTCDevice,
        monitor: RTCMemoryMonitorFunction,
        user: *mut c_void,
    );

    pub(super) fn rtcNewScene(device: RTCDevice) -> RTCScene;
    pub(super) fn rtcReleaseScene(scene: RTCScene);
    pub(super) fn rtcSetSceneBuildQuality(scene: RTCScene, quality: c_int);
    pub(super) fn rtcSetSceneFlags(scene: RTCScene, flags: c_int);
    pub(super) fn rtcAttachGeometryByID(scene: RTCScene, geometry: RTCGeometry, id: c_uint);
    pub(super) fn rtcCommitScene(scene: RTCScene);

    pub(super) fn rtcNewGeometry(device: RTCDevice, kind: c_int) -> RTCGeometry;
    pub(super) fn rtcReleaseGeometry(geometry: RTCGeometry);
    pub(super) fn rtcCommitGeometry(geometry: RTCGeometry);
    pub(super) fn rtcSetNewGeometryBuffer(
        geometry: RTCGeometry,
        kind: c_int,
        slot: c_uint,
        format: c_int,
        byte_stride: usize,
        item_count: usize,
    ) -> *mut c_void;

    pub(super) fn rtcIntersect1(
        scene: RTCScene,
        context: *mut RTCIntersectContext,
        ray_hit: *mut RTCRayHit,
    );
    pub(super) fn rtcOccluded1(
        scene: RTCScene,
        context: *mut RTCIntersectContext,
        ray: *mut RTCRay,
    );
    pub(super) fn rtcIntersect16(
        valid: *const c_int,
        scene: RTCScene,
        context: *mut RTCIntersectContext,
        ray_hit: *mut RTCRayHit16,
    );
    pub(super) fn rtcOccluded16(
        valid: *const c_int,
        scene: RTCScene,
        context: *mut RTCIntersectContext,
        ray: *mut RTCRay16,
    );
}
