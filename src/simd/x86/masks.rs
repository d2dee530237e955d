//! Masks of AVX2, in the sign bits of a register, and of AVX-512, in registers of their own.

use std::arch::asm;
use std::arch::x86_64::*;
use std::ops::{BitAnd, BitOr};

use crate::math::Mask;

/// A mask of AVX2: all bits of a lane, or none.
#[derive(Clone, Copy, Debug)]
pub(in crate::simd) struct Signs(pub(super) __m256);

/// A mask of eight lanes of AVX-512.
#[derive(Clone, Copy, Debug)]
pub(in crate::simd) struct EightBits(pub(super) __mmask8);

/// A mask of sixteen lanes of AVX-512.
#[derive(Clone, Copy, Debug)]
pub(in crate::simd) struct SixteenBits(pub(super) __mmask16);

/// The sign bits of eight floats.
///
/// `_mm256_movemask_ps` would do, but for what is made of it: two halves of sixteen lanes are packed
/// into one register and read at once, which takes twice as long as reading each.
#[inline]
#[target_feature(enable = "avx2")]
pub(super) fn sign_bits(row: __m256) -> u32 {
    let bits: u32;
    // SAFETY: one instruction of AVX, which reads a register and writes another, and touches neither
    // memory nor flags; the processor has it: see the head of `mod.rs`.
    unsafe {
        asm!(
            "vmovmskps {bits:e}, {row}",
            row = in(ymm_reg) row,
            bits = lateout(reg) bits,
            options(pure, nomem, nostack, preserves_flags),
        );
    }
    bits
}

impl BitAnd for Signs {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self(op!(_mm256_and_ps(self.0, other.0)))
    }
}

impl BitOr for Signs {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        Self(op!(_mm256_or_ps(self.0, other.0)))
    }
}

impl Mask for Signs {
    const LANES: u32 = 8;

    #[inline(always)]
    fn bits(self) -> u32 {
        op!(sign_bits(self.0))
    }
    #[inline(always)]
    fn of_bits(bits: u32) -> Self {
        op!({
            let of_lanes = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
            let bits = _mm256_and_si256(_mm256_set1_epi32(bits as i32), of_lanes);
            Self(_mm256_castsi256_ps(_mm256_cmpeq_epi32(bits, of_lanes)))
        })
    }
}

macro_rules! bits {
    ($mask:ident, $bits:ident, $lanes:literal) => {
        impl BitAnd for $mask {
            type Output = Self;
            #[inline(always)]
            fn bitand(self, other: Self) -> Self {
                Self(self.0 & other.0)
            }
        }

        impl BitOr for $mask {
            type Output = Self;
            #[inline(always)]
            fn bitor(self, other: Self) -> Self {
                Self(self.0 | other.0)
            }
        }
        impl Mask for $mask {
            const LANES: u32 = $lanes;

            #[inline(always)]
            fn bits(self) -> u32 {
                u32::from(self.0)
            }
            #[inline(always)]
            fn of_bits(bits: u32) -> Self {
                Self(bits as $bits)
            }
        }
    };
}

bits!(EightBits, __mmask8, 8);
bits!(SixteenBits, __mmask16, 16);
