//! The rays of rodent's benchmarks (`.rays`): six numbers a ray, and nothing else.
//!
//! Each ray is its origin and its direction, three little-endian `f32` each. The interval of all rays is given to
//! rodent's programs by `--tmin` and `--tmax`, and whether any hit is wanted by `-any`. The source of this is
//! `tools/common/load_rays.h` in <https://github.com/AnyDSL/rodent> at commit f24b885cc9bf0a8b336f4c5de2f12e07a468f798.

use glam::Vec3;
use thiserror::Error;

use crate::math::{Ray, RayError};

/// Bytes of a ray.
const RAY: usize = 24;

/// Rays of which rodent drops what is beyond a multiple of its packets, of up to eight.
pub const LARGEST_PACKET: usize = 8;

/// Why rays cannot be written or read in this form.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum RodentError {
    /// Rays have intervals of their own.
    #[error(
        "ray {index} has the interval from {} to {}, and the first from {} to {}: rodent has one for all",
        own[0], own[1], first[0], first[1]
    )]
    Intervals {
        /// The first ray with another interval.
        index: usize,
        /// Its `t_min` and `t_max`.
        own: [f32; 2],
        /// Those of the first ray.
        first: [f32; 2],
    },
    /// The length is no multiple of a ray's.
    #[error("it has {found} bytes, which is no multiple of 24: six 32-bit floats a ray")]
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

/// The bytes of rays, and the interval of all of them, for `--tmin` and `--tmax`; from 0 to the largest float without
/// rays.
///
/// # Errors
/// If not all rays have one interval.
pub fn encode(rays: &[Ray]) -> Result<(Vec<u8>, [f32; 2]), RodentError> {
    let interval = |ray: &Ray| [ray.t_min, ray.end()];
    let first = rays.first().map_or([0.0, f32::MAX], interval);
    if let Some(index) = rays.iter().position(|ray| interval(ray) != first) {
        return Err(RodentError::Intervals { index, own: interval(&rays[index]), first });
    }
    let mut bytes = Vec::with_capacity(rays.len() * RAY);
    for ray in rays {
        let numbers = ray.origin.to_array().into_iter().chain(ray.dir.to_array());
        numbers.for_each(|number| bytes.extend(number.to_le_bytes()));
    }
    Ok((bytes, first))
}

/// Rays from bytes, with one interval for all.
///
/// # Errors
/// If the length does not fit, or a ray is out of the range of rays.
pub fn decode(bytes: &[u8], [t_min, t_max]: [f32; 2]) -> Result<Vec<Ray>, RodentError> {
    if !bytes.len().is_multiple_of(RAY) {
        return Err(RodentError::Length { found: bytes.len() });
    }
    let ray = |(index, bytes): (usize, &[u8])| {
        let number =
            |at: usize| bytes[4 * at..].first_chunk().copied().map_or(f32::NAN, f32::from_le_bytes);
        let vector = |at| Vec3::new(number(at), number(at + 1), number(at + 2));
        let ray = Ray { origin: vector(0), t_min, dir: vector(3), t_max };
        ray.check().map_err(|error| RodentError::Ray { index, error })?;
        Ok(ray)
    };
    bytes.chunks_exact(RAY).enumerate().map(ray).collect()
}
