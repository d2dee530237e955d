//! Lanes of `f32`, and the instruction sets that compute with them.
//!
//! Formulas are written once, over [`Lanes`]. Kernels that need more (loads, masks, the packing of
//! what a mask keeps) are written once, over [`Simd`], and run with the widest instruction set
//! that the processor has: see [`dispatch`]. This is the only layer with `unsafe` code.

#![allow(unsafe_code, reason = "the only layer that may, block by block")]

mod huge_pages;
mod isa;
mod lanes;
mod pair;
mod portable;
mod prefetch;
mod row;
#[cfg(target_arch = "x86_64")]
mod x86;

pub(crate) use huge_pages::ask_for_huge_pages;
pub use isa::{Isa, IsaError, Kernel, dispatch};
pub(crate) use lanes::ones;
pub use lanes::{Lanes, Lanes3, cross, dot, sub};
pub(crate) use prefetch::prefetch;
pub use row::{LANES, Mask, Row, Simd, splat3};
