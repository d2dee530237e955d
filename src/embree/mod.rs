//! Intel's Embree 3, to compare with: its triangles, built with high quality and traced in its fast
//! default mode.
//!
//! With `simd` the only layer with unsafe code, all of it calls of Embree's C interface. Knows
//! nothing of scenes: triangles in, rays in, hits out. Its formulas are its own, so its hits are
//! close to those of the structures, and not equal to them.
//!
//! The processor's handling of denormal numbers is left as Rust has it; Embree's manual recommends
//! to flush them to zero.

#![allow(unsafe_code, reason = "calls of a C library, each with its reason")]

mod device;
mod ffi;
mod packets;
mod single;
mod triangles;

use thiserror::Error;

pub use triangles::{Builder, TriangleScene};

/// Why a call of Embree failed.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum EmbreeError {
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
