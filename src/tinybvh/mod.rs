//! tinybvh, to compare with: its fastest tree for processors, `BVH8_CPU`, built by its own builders and searched ray by
//! ray.
//!
//! Jacco Bikker's [tinybvh](https://github.com/jbikker/tinybvh) (MIT) is one C++ header. `compile.rs` compiles it as a
//! part of `build.rs`, together with `shim.cpp`, for AVX2 and FMA, which its tree needs. With `simd` and `embree` the
//! only layer with unsafe code, all of it calls of the shim. Knows nothing of scenes: triangles and rays in, hits out.
//! Its formulas are its own, so its hits are close to those of the structures, and not equal to them.
//!
//! Where other libraries return an error, this one ends the process, or writes beyond a stack. So what it does not take
//! is refused beforehand: a tree that is too deep for its stacks, or larger than its index can be.

#![allow(unsafe_code, reason = "calls of a C interface, each with its reason")]

#[cfg(target_arch = "x86_64")]
mod index;
#[cfg(not(target_arch = "x86_64"))]
#[path = "elsewhere.rs"]
mod index;
mod triangles;

use thiserror::Error;

pub use triangles::{Builder, Quality, TriangleScene};

/// Why tinybvh cannot index triangles.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum TinyBvhError {
    /// The processor is another.
    #[error(
        "tinybvh's eight-wide tree needs a processor of x86-64 with AVX2 and FMA, and this one is none"
    )]
    Processor,
    /// There is no memory for it.
    #[error("tinybvh has no memory for {triangles} triangles")]
    Memory {
        /// How many there are.
        triangles: usize,
    },
    /// Its tree would not fit into its stacks.
    #[error(
        "tinybvh's tree of {triangles} triangles is too deep for its stacks, as where hundreds of triangles lie in one \
         place"
    )]
    Deep {
        /// How many there are.
        triangles: usize,
    },
    /// Its index would be too large.
    #[error(
        "tinybvh's index of {triangles} triangles would be larger than the 4 GiB that it can count"
    )]
    Large {
        /// How many there are.
        triangles: usize,
    },
}
