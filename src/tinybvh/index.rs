//! The tree behind the C interface of `shim.cpp`, which declares the same functions.

use std::ffi::c_void;
use std::ptr;

use crate::math::{Hit, Ray};

use super::TinyBvhError;
use super::triangles::{Corner, Facts, Quality};

/// The most triangles whose corners it counts; the index is full before.
const MOST: usize = 1 << 28;

// What `Refusal` says in the shim.
const NONE: u32 = 0;
const DEEP: u32 = 2;
const LARGE: u32 = 3;

unsafe extern "C" {
    fn srt_tinybvh_build(
        corners: *const f32,
        triangles: u32,
        hq: bool,
        threads: u32,
        built: *mut *mut c_void,
    ) -> u32;
    fn srt_tinybvh_free(built: *mut c_void);
    fn srt_tinybvh_facts(built: *const c_void, facts: *mut Facts);
    fn srt_tinybvh_closest(built: *const c_void, rays: *const Ray, count: usize, hits: *mut Hit);
    fn srt_tinybvh_any(built: *const c_void, rays: *const Ray, count: usize, blocked: *mut bool);
}

// What the shim calls `Query` and `Found`.
const _: () = assert!(size_of::<Ray>() == 32 && size_of::<Hit>() == 20);

/// A `BVH8_CPU`, freed when it goes.
pub(super) struct Index(*mut c_void);

// SAFETY: a tree that is built is only read, and has no state of a thread.
unsafe impl Send for Index {}
// SAFETY: as above.
unsafe impl Sync for Index {}

impl Index {
    /// Whether this processor has what the tree needs. With a header that computes constants for it as the program
    /// starts, one without has ended it before.
    pub(super) fn check_processor() -> Result<(), TinyBvhError> {
        let fits = is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma");
        if fits { Ok(()) } else { Err(TinyBvhError::Processor) }
    }

    /// The tree over triangles, three corners each.
    pub(super) fn build(
        corners: &[Corner],
        quality: Quality,
        threads: usize,
    ) -> Result<Self, TinyBvhError> {
        Self::check_processor()?;
        let triangles = corners.len() / 3;
        if triangles > MOST {
            return Err(TinyBvhError::Large { triangles });
        }
        let (data, hq) = (corners.as_ptr().cast(), quality == Quality::High);
        let threads = threads.try_into().unwrap_or(u32::MAX);
        let mut built = ptr::null_mut();
        // SAFETY: there are three corners of four floats for each triangle, aligned to 16 bytes; the tree keeps none.
        let refusal =
            unsafe { srt_tinybvh_build(data, triangles as u32, hq, threads, &raw mut built) };
        match refusal {
            NONE => Ok(Self(built)),
            DEEP => Err(TinyBvhError::Deep { triangles }),
            LARGE => Err(TinyBvhError::Large { triangles }),
            _ => Err(TinyBvhError::Memory { triangles }),
        }
    }

    pub(super) fn facts(&self) -> Facts {
        let mut facts = Facts::default();
        // SAFETY: the tree is built; the shim's `Facts` has the same layout.
        unsafe { srt_tinybvh_facts(self.0, &raw mut facts) };
        facts
    }

    /// The closest hit of each ray, with the triangle's place in the list in the place of its ids.
    ///
    /// # Panics
    /// If the slices differ in length.
    pub(super) fn closest(&self, rays: &[Ray], hits: &mut [Hit]) {
        assert_eq!(rays.len(), hits.len(), "a hit for each ray");
        // SAFETY: the tree is built; rays and hits are as many, and laid out as the shim's.
        unsafe { srt_tinybvh_closest(self.0, rays.as_ptr(), rays.len(), hits.as_mut_ptr()) };
    }

    /// Whether each ray hits anything.
    ///
    /// # Panics
    /// If the slices differ in length.
    pub(super) fn any(&self, rays: &[Ray], blocked: &mut [bool]) {
        assert_eq!(rays.len(), blocked.len(), "an answer for each ray");
        // SAFETY: as above.
        unsafe { srt_tinybvh_any(self.0, rays.as_ptr(), rays.len(), blocked.as_mut_ptr()) };
    }
}

impl Drop for Index {
    fn drop(&mut self) {
        // SAFETY: the tree is built, and is not used again.
        unsafe { srt_tinybvh_free(self.0) };
    }
}
