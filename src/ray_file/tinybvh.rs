//! Rays as tinybvh holds them: 64 bytes each, the first cache line of its `Ray`.
//!
//! tinybvh writes no rays to a file, and has no arrays of their components; its `BVH_SoA` is a layout of nodes. What
//! its kernels take, and what a program that uses it can copy from a file as it is, is a buffer of such records:
//! `struct Ray` in `tiny_bvh.h` and in `traverse.cl`, copied by 64 bytes in `tiny_bvh_minimal_gpu.cpp`, in
//! <https://github.com/jbikker/tinybvh> at commit 4735685f64d8b2bb0ad2c6c4643f291bf58774ad.
//!
//! | bytes | what |
//! |--:|---|
//! | 0–11 | the origin, three little-endian `f32` |
//! | 12–15 | the mask of instances, `u32`: 0xffff, all of them |
//! | 16–27 | the direction |
//! | 28–31 | an instance's index, 0 |
//! | 32–43 | 1 / direction; for components within ± 10⁻¹², ± 10³⁰ |
//! | 44–47 | the hit's instance, or padding: 0 |
//! | 48–51 | the hit's `t`, `f32`: before the search, the end of the ray |
//! | 52–63 | the hit's `u`, `v` and primitive: 0 |
//!
//! A ray begins at its origin. tinybvh's constructor normalises directions; here they stay as they are, or `t` would
//! mean something else.

use glam::Vec3;
use thiserror::Error;

use crate::math::{Ray, RayError};

/// Bytes of a ray.
const RAY: usize = 64;

/// A ray meets all instances.
const ALL_INSTANCES: u32 = 0xffff;

/// tinybvh's infinity, and the smallest component that it divides by.
const FAR: f32 = 1e30;
const LEAST: f32 = 1e-12;

/// Why rays cannot be written or read in this form.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum TinyBvhError {
    /// A ray begins behind its origin.
    #[error("ray {index} begins at t = {t_min}: tinybvh's rays begin at their origin")]
    Begin {
        /// Its place, from 0.
        index: usize,
        /// Where it begins.
        t_min: f32,
    },
    /// The length is no multiple of a ray's.
    #[error("it has {found} bytes, which is no multiple of 64, a ray of tinybvh's")]
    Length {
        /// Bytes that there are.
        found: usize,
    },
    /// A ray is out of the range of rays.
    #[error("ray {index} cannot be traced: {error}")]
    Ray {
        /// Its place, from 0.
        index: usize,
        /// What is wrong.
        error: RayError,
    },
}

/// The records of rays.
///
/// # Errors
/// If a ray begins elsewhere than at its origin.
pub fn encode(rays: &[Ray]) -> Result<Vec<u8>, TinyBvhError> {
    if let Some(index) = rays.iter().position(|ray| ray.t_min != 0.0) {
        return Err(TinyBvhError::Begin { index, t_min: rays[index].t_min });
    }
    let mut bytes = Vec::with_capacity(rays.len() * RAY);
    for ray in rays {
        add(ray.origin, &mut bytes);
        bytes.extend(ALL_INSTANCES.to_le_bytes());
        add(ray.dir, &mut bytes);
        bytes.extend([0; 4]);
        add(ray.dir.map(inverse), &mut bytes);
        bytes.extend([0; 4]);
        bytes.extend(ray.t_max.to_le_bytes());
        bytes.extend([0; 12]);
    }
    Ok(bytes)
}

fn add(vector: Vec3, bytes: &mut Vec<u8>) {
    vector.to_array().iter().for_each(|number| bytes.extend(number.to_le_bytes()));
}

/// 1/x, as tinybvh takes it.
fn inverse(x: f32) -> f32 {
    match x {
        x if x.abs() > LEAST => 1.0 / x,
        x if x >= 0.0 => FAR,
        _ => -FAR,
    }
}

/// Rays from records. Of a record whose ray was traced, `t` is that of its hit, and the ray ends there.
///
/// # Errors
/// If the length does not fit, or a ray is out of the range of rays.
pub fn decode(bytes: &[u8]) -> Result<Vec<Ray>, TinyBvhError> {
    if !bytes.len().is_multiple_of(RAY) {
        return Err(TinyBvhError::Length { found: bytes.len() });
    }
    let ray = |(index, bytes): (usize, &[u8])| {
        let number =
            |at: usize| bytes[at..].first_chunk().copied().map_or(f32::NAN, f32::from_le_bytes);
        let vector = |at| Vec3::new(number(at), number(at + 4), number(at + 8));
        let ray = Ray { origin: vector(0), t_min: 0.0, dir: vector(16), t_max: number(48) };
        ray.check().map_err(|error| TinyBvhError::Ray { index, error })?;
        Ok(ray)
    };
    bytes.chunks_exact(RAY).enumerate().map(ray).collect()
}
