//! Intel's Embree 3 and 4, to compare with: their triangles, built with high quality and traced in their fast
//! default mode. Their libraries are loaded as they are asked for.
//!
//! With `simd` and `tinybvh` the only layer with unsafe code, all of it calls of Embree's C interface. Knows
//! nothing of scenes: triangles in, rays in, hits out. Its formulas are its own, so its hits are
//! close to those of the structures, and not equal to them.
//!
//! The processor's handling of denormal numbers is left as Rust has it; Embree's manual recommends
//! to flush them to zero.

#![allow(unsafe_code, reason = "calls of a C library, each with its reason")]

mod device;
mod ffi;
mod library;
mod packets;
mod single;
mod triangles;

use thiserror::Error;

pub use library::Version;
pub use triangles::{Builder, TriangleScene};

/// Why a call of Embree failed.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum EmbreeError {
    /// Its library is not there, or is another.
    #[error("Embree {version} is not installed ({reasons}); {variable} may name its library")]
    NotFound {
        /// 3 or 4.
        version: u32,
        /// What the system says, of each place.
        reasons: String,
        /// The variable of the environment.
        variable: &'static str,
    },
    /// It has no device, or a call failed without words.
    #[error("Embree reports error {code}")]
    Device {
        /// An `RTCError` of its manual.
        code: i32,
    },
    /// A call failed.
    #[error("Embree reports {text}")]
    Refused {
        /// Its own words.
        text: String,
    },
}
