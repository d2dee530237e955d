//! Rows of eight and of sixteen floats.

use std::arch::x86_64::*;
use std::ops::{Add, Div, Mul, Sub};

use super::super::Row;
use super::masks::{EightBits, Signs, SixteenBits};
use super::words::transposed;
use crate::math::Lanes;

/// Eight floats of AVX2, masks by sign bits.
#[derive(Clone, Copy, Debug)]
pub(in crate::simd) struct Eight(pub(super) __m256);

/// Eight floats of AVX-512, masks in their own registers.
#[derive(Clone, Copy, Debug)]
pub(in crate::simd) struct MaskedEight(pub(super) __m256);

/// Sixteen floats of AVX-512.
#[derive(Clone, Copy, Debug)]
pub(in crate::simd) struct Sixteen(pub(super) __m512);

macro_rules! arithmetic {
    ($row:ident, $add:ident, $sub:ident, $mul:ident, $div:ident) => {
        impl Add for $row {
            type Output = Self;
            #[inline(always)]
            fn add(self, other: Self) -> Self {
                Self(op!($add(self.0, other.0)))
            }
        }
        impl Sub for $row {
            type Output = Self;
            #[inline(always)]
            fn sub(self, other: Self) -> Self {
                Self(op!($sub(self.0, other.0)))
            }
        }
        impl Mul for $row {
            type Output = Self;
            #[inline(always)]
            fn mul(self, other: Self) -> Self {
                Self(op!($mul(self.0, other.0)))
            }
        }
        impl Div for $row {
            type Output = Self;
            #[inline(always)]
            fn div(self, other: Self) -> Self {
                Self(op!($div(self.0, other.0)))
            }
        }
    };
}

arithmetic!(Eight, _mm256_add_ps, _mm256_sub_ps, _mm256_mul_ps, _mm256_div_ps);
arithmetic!(MaskedEight, _mm256_add_ps, _mm256_sub_ps, _mm256_mul_ps, _mm256_div_ps);
arithmetic!(Sixteen, _mm512_add_ps, _mm512_sub_ps, _mm512_mul_ps, _mm512_div_ps);

macro_rules! lanes {
    (
        $row:ident, $mask:ident, $compare:ident, $blend:ident, few registers: $few:literal,
        [$set:ident, $and:ident, $andnot:ident, $xor:ident, $sqrt:ident, $min:ident, $max:ident]
    ) => {
        impl Lanes for $row {
            type Mask = $mask;
            const FEW_REGISTERS: bool = $few;

            #[inline(always)]
            fn splat(value: f32) -> Self {
                Self(op!($set(value)))
            }
            #[inline(always)]
            fn abs(self) -> Self {
                Self(op!($andnot($set(-0.0), self.0)))
            }
            #[inline(always)]
            fn flipped_by(self, of: Self) -> Self {
                Self(op!($xor(self.0, $and($set(-0.0), of.0))))
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                Self(op!($sqrt(self.0)))
            }
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                Self(op!($min(self.0, other.0)))
            }
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                Self(op!($max(self.0, other.0)))
            }
            #[inline(always)]
            fn le(self, other: Self) -> $mask {
                $mask(op!($compare::<_CMP_LE_OQ>(self.0, other.0)))
            }
            #[inline(always)]
            fn lt(self, other: Self) -> $mask {
                $mask(op!($compare::<_CMP_LT_OQ>(self.0, other.0)))
            }
            #[inline(always)]
            fn select_where(self, mask: $mask, other: Self) -> Self {
                Self($blend(mask, self.0, other.0))
            }
        }
    };
}

#[inline(always)]
fn blend_by_signs(mask: Signs, a: __m256, b: __m256) -> __m256 {
    op!(_mm256_blendv_ps(b, a, mask.0))
}

#[inline(always)]
fn blend_by_mask(mask: EightBits, a: __m256, b: __m256) -> __m256 {
    op!(_mm256_mask_mov_ps(b, mask.0, a))
}

#[inline(always)]
fn blend_sixteen(mask: SixteenBits, a: __m512, b: __m512) -> __m512 {
    op!(_mm512_mask_mov_ps(b, mask.0, a))
}

lanes!(
    Eight,
    Signs,
    _mm256_cmp_ps,
    blend_by_signs,
    few registers: true,
    [
        _mm256_set1_ps,
        _mm256_and_ps,
        _mm256_andnot_ps,
        _mm256_xor_ps,
        _mm256_sqrt_ps,
        _mm256_min_ps,
        _mm256_max_ps
    ]
);
lanes!(
    MaskedEight,
    EightBits,
    _mm256_cmp_ps_mask,
    blend_by_mask,
    few registers: false,
    [
        _mm256_set1_ps,
        _mm256_and_ps,
        _mm256_andnot_ps,
        _mm256_xor_ps,
        _mm256_sqrt_ps,
        _mm256_min_ps,
        _mm256_max_ps
    ]
);
lanes!(
    Sixteen,
    SixteenBits,
    _mm512_cmp_ps_mask,
    blend_sixteen,
    few registers: false,
    [
        _mm512_set1_ps,
        _mm512_and_ps,
        _mm512_andnot_ps,
        _mm512_xor_ps,
        _mm512_sqrt_ps,
        _mm512_min_ps,
        _mm512_max_ps
    ]
);

macro_rules! eight {
    ($row:ident) => {
        impl Row<8> for $row {
            #[inline(always)]
            fn load(values: &[f32; 8]) -> Self {
                Self(op!(_mm256_loadu_ps(values.as_ptr())))
            }
            #[inline(always)]
            fn load_bits(bits: &[u32; 8]) -> Self {
                Self(op!(_mm256_loadu_ps(bits.as_ptr().cast())))
            }
            #[inline(always)]
            fn store(self, values: &mut [f32; 8]) {
                op!(_mm256_storeu_ps(values.as_mut_ptr(), self.0));
            }
            #[inline(always)]
            fn of_records(records: [&[f32; 8]; 8]) -> [Self; 8] {
                let [a, b, c, d, e, f, g, h] = transposed(records);
                [Self(a), Self(b), Self(c), Self(d), Self(e), Self(f), Self(g), Self(h)]
            }
            #[inline(always)]
            fn smallest(self) -> f32 {
                op!({
                    let low = _mm256_castps256_ps128(self.0);
                    let x = _mm_min_ps(low, _mm256_extractf128_ps::<1>(self.0));
                    let x = _mm_min_ps(x, _mm_movehl_ps(x, x));
                    _mm_cvtss_f32(_mm_min_ss(x, _mm_movehdup_ps(x)))
                })
            }
            #[inline(always)]
            fn largest(self) -> f32 {
                op!({
                    let low = _mm256_castps256_ps128(self.0);
                    let x = _mm_max_ps(low, _mm256_extractf128_ps::<1>(self.0));
                    let x = _mm_max_ps(x, _mm_movehl_ps(x, x));
                    _mm_cvtss_f32(_mm_max_ss(x, _mm_movehdup_ps(x)))
                })
            }
            #[inline(always)]
            fn slab(planes: Self, inv_dir: Self, offset: Self) -> Self {
                Self(op!(_mm256_fmsub_ps(planes.0, inv_dir.0, offset.0)))
            }
        }
    };
}

eight!(Eight);
eight!(MaskedEight);

impl Row<16> for Sixteen {
    #[inline(always)]
    fn load(values: &[f32; 16]) -> Self {
        Self(op!(_mm512_loadu_ps(values.as_ptr())))
    }
    #[inline(always)]
    fn load_bits(bits: &[u32; 16]) -> Self {
        Self(op!(_mm512_loadu_ps(bits.as_ptr().cast())))
    }
    #[inline(always)]
    fn store(self, values: &mut [f32; 16]) {
        op!(_mm512_storeu_ps(values.as_mut_ptr(), self.0));
    }
    #[inline(always)]
    fn of_records(records: [&[f32; 8]; 16]) -> [Self; 8] {
        let (halves, _) = records.as_chunks::<8>();
        let (low, high) = (transposed(halves[0]), transposed(halves[1]));
        let mut rows = [Self::splat(0.0); 8];
        for i in 0..8 {
            let low = op!(_mm512_castps256_ps512(low[i]));
            rows[i] = Self(op!(_mm512_insertf32x8::<1>(low, high[i])));
        }
        rows
    }
    #[inline(always)]
    fn smallest(self) -> f32 {
        op!(_mm512_reduce_min_ps(self.0))
    }
    #[inline(always)]
    fn largest(self) -> f32 {
        op!(_mm512_reduce_max_ps(self.0))
    }
    #[inline(always)]
    fn slab(planes: Self, inv_dir: Self, offset: Self) -> Self {
        Self(op!(_mm512_fmsub_ps(planes.0, inv_dir.0, offset.0)))
    }
}
