//! AVX2 and AVX-512.
//!
//! The types of this folder are private to the layer. Kernels come to them through
//! [`dispatch`](super::dispatch) alone, which calls `run_avx2` and `run_avx512` only on processors
//! that have the features. That is the reason why the intrinsics below are safe to call: **the
//! SAFETY of every block in this folder is that the processor has AVX2 and FMA, or AVX-512 (F, VL,
//! BW, DQ), because nothing else can name these types.** Loads and stores are unaligned, through
//! references to whole arrays, or to arrays of which they take a part.

/// An intrinsic, safe to call for the reason at the head of the file. Above the other files, which use it.
macro_rules! op {
    ($call:expr) => {{
        // SAFETY: see the head of `mod.rs`.
        unsafe { $call }
    }};
}

mod avx2;
mod avx512;
mod masks;
mod rows;
mod words;

use super::Kernel;

/// AVX2 with fused multiply-add.
#[derive(Clone, Copy, Debug)]
pub(super) struct Avx2;

/// AVX-512.
#[derive(Clone, Copy, Debug)]
pub(super) struct Avx512;

pub(super) fn has_avx2() -> bool {
    is_x86_feature_detected!("avx2")
        && is_x86_feature_detected!("fma")
        && is_x86_feature_detected!("bmi1")
        && is_x86_feature_detected!("bmi2")
        && is_x86_feature_detected!("lzcnt")
        && is_x86_feature_detected!("popcnt")
}

pub(super) fn has_avx512() -> bool {
    has_avx2()
        && is_x86_feature_detected!("avx512f")
        && is_x86_feature_detected!("avx512vl")
        && is_x86_feature_detected!("avx512bw")
        && is_x86_feature_detected!("avx512dq")
}

/// Runs a kernel compiled for AVX2.
///
/// # Safety
/// [`has_avx2`] must hold.
#[inline(never)]
#[target_feature(enable = "avx2,fma,bmi1,bmi2,lzcnt,popcnt")]
pub(super) unsafe fn run_avx2<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<Avx2>()
}

/// Runs a kernel compiled for AVX-512.
///
/// # Safety
/// [`has_avx512`] must hold.
#[target_feature(enable = "avx512f,avx512vl,avx512bw,avx512dq,avx2,fma,bmi1,bmi2,lzcnt,popcnt")]
pub(super) unsafe fn run_avx512<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<Avx512>()
}
