//! The instruction sets that compute with lanes of `f32`.
//!
//! Formulas are written once, over [`Lanes`](crate::math::Lanes). Kernels that need more (loads, stores, the packing of
//! what a mask keeps) are written once, over [`Simd`], and run with the widest instruction set
//! that the processor has: see [`dispatch`]. Here, too, are prefetching, large pages, and tables that
//! all threads write. With `embree` and `tinybvh`, this is the only layer with `unsafe` code.

#![allow(unsafe_code, reason = "the only layer that may, block by block")]

mod huge_pages;
mod isa;
mod pair;
mod portable;
mod prefetch;
mod row;
mod table;
#[cfg(target_arch = "x86_64")]
mod x86;

pub(crate) use huge_pages::ask_for_huge_pages;
pub use isa::{Isa, IsaError, Kernel, dispatch};
pub use prefetch::Cache;
pub(crate) use prefetch::prefetch;
pub use row::{LANES, LARGEST_PACKET, PacketKernel, Row, Simd, splat3};
pub(crate) use table::{concatenated, extend, table};
