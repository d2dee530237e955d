//! AVX2 and AVX-512.
//!
//! The types of this file are private to the layer. Kernels come to them through
//! [`dispatch`](super::dispatch) alone, which calls `run_avx2` and `run_avx512` only on processors
//! that have the features. That is the reason why the intrinsics below are safe to call: **the
//! SAFETY of every block in this file is that the processor has AVX2 and FMA, or AVX-512 (F, VL,
//! BW, DQ), because nothing else can name these types.** Loads and stores are unaligned, through
//! references to whole arrays.

use std::arch::asm;
use std::arch::x86_64::*;
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Sub};

use glam::Vec4;

use crate::math::{Lanes, Mask};

use super::pair::Pair;
use super::{Kernel, LARGEST_PACKET, PacketKernel, Row, Simd};

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

/// An intrinsic, safe to call for the reason at the head of the file.
macro_rules! op {
    ($call:expr) => {{
        // SAFETY: see the head of the file.
        unsafe { $call }
    }};
}

/// Eight floats of AVX2, masks by sign bits.
#[derive(Clone, Copy, Debug)]
pub(super) struct Eight(__m256);

/// Eight floats of AVX-512, masks in their own registers.
#[derive(Clone, Copy, Debug)]
pub(super) struct MaskedEight(__m256);

/// Sixteen floats of AVX-512.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sixteen(__m512);

/// A mask of AVX2: all bits of a lane, or none.
#[derive(Clone, Copy, Debug)]
pub(super) struct Signs(__m256);

/// A mask of eight lanes of AVX-512.
#[derive(Clone, Copy, Debug)]
pub(super) struct EightBits(__mmask8);

/// A mask of sixteen lanes of AVX-512.
#[derive(Clone, Copy, Debug)]
pub(super) struct SixteenBits(__mmask16);

/// The sign bits of eight floats.
///
/// `_mm256_movemask_ps` would do, but for what is made of it: two halves of sixteen lanes are packed
/// into one register and read at once, which takes twice as long as reading each.
#[inline]
#[target_feature(enable = "avx2")]
fn sign_bits(row: __m256) -> u32 {
    let bits: u32;
    // SAFETY: one instruction of AVX, which reads a register and writes another, and touches neither
    // memory nor flags; the processor has it: see the head of the file.
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
}

macro_rules! bits {
    ($mask:ident, $lanes:literal) => {
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
        }
    };
}

bits!(EightBits, 8);
bits!(SixteenBits, 16);

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
        $row:ident, $mask:ident, $compare:ident, $select:ident,
        [$set:ident, $and:ident, $andnot:ident, $xor:ident, $sqrt:ident, $min:ident, $max:ident]
    ) => {
        impl Lanes for $row {
            type Mask = $mask;

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
            fn select(self, mask: u32, other: Self) -> Self {
                Self($select(mask, self.0, other.0))
            }
        }
    };
}

/// All bits of the lanes that have a one in the mask.
#[inline(always)]
fn widened(mask: u32) -> __m256 {
    op!({
        let bits = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
        let of_lane = _mm256_and_si256(_mm256_set1_epi32(mask as i32), bits);
        _mm256_castsi256_ps(_mm256_cmpeq_epi32(of_lane, bits))
    })
}

#[inline(always)]
fn select_by_signs(mask: u32, a: __m256, b: __m256) -> __m256 {
    op!(_mm256_blendv_ps(b, a, widened(mask)))
}

#[inline(always)]
fn select_by_mask(mask: u32, a: __m256, b: __m256) -> __m256 {
    op!(_mm256_mask_mov_ps(b, mask as u8, a))
}

#[inline(always)]
fn select_sixteen(mask: u32, a: __m512, b: __m512) -> __m512 {
    op!(_mm512_mask_mov_ps(b, mask as u16, a))
}

lanes!(
    Eight,
    Signs,
    _mm256_cmp_ps,
    select_by_signs,
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
    select_by_mask,
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
    select_sixteen,
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
            fn of_records(records: &[[f32; 8]; 8]) -> [Self; 8] {
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
    fn of_records(records: &[[f32; 8]; 16]) -> [Self; 8] {
        let (halves, _) = records.as_chunks::<8>();
        let (low, high) = (transposed(&halves[0]), transposed(&halves[1]));
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

/// For each mask of eight lanes, the lanes that it keeps, a byte each.
static KEPT: [u64; 256] = kept();

const fn kept() -> [u64; 256] {
    let mut table = [0; 256];
    let mut mask = 0;
    while mask < 256 {
        let (mut lane, mut count) = (0, 0);
        while lane < 8 {
            if mask >> lane & 1 != 0 {
                table[mask] |= (lane as u64) << (8 * count);
                count += 1;
            }
            lane += 1;
        }
        mask += 1;
    }
    table
}

/// The permutation that moves the lanes of a mask to the front.
#[inline(always)]
fn to_front(mask: u32) -> __m256i {
    let lanes = KEPT[(mask & 0xff) as usize] as i64;
    op!(_mm256_cvtepu8_epi32(_mm_cvtsi64_si128(lanes)))
}

#[inline(always)]
fn load_words(words: &[u32; 8]) -> __m256i {
    op!(_mm256_loadu_si256(words.as_ptr().cast()))
}

#[inline(always)]
fn store_words(words: &mut [u32; 8], values: __m256i) {
    op!(_mm256_storeu_si256(words.as_mut_ptr().cast(), values));
}

/// The lower and the upper four floats.
#[inline(always)]
fn halves(row: __m256) -> [Vec4; 2] {
    op!([_mm256_castps256_ps128(row).into(), _mm256_extractf128_ps::<1>(row).into()])
}

/// Eight records of eight floats as eight rows.
#[inline(always)]
fn transposed(r: &[[f32; 8]; 8]) -> [__m256; 8] {
    transposed_rows(op!([
        _mm256_loadu_ps(r[0].as_ptr()),
        _mm256_loadu_ps(r[1].as_ptr()),
        _mm256_loadu_ps(r[2].as_ptr()),
        _mm256_loadu_ps(r[3].as_ptr()),
        _mm256_loadu_ps(r[4].as_ptr()),
        _mm256_loadu_ps(r[5].as_ptr()),
        _mm256_loadu_ps(r[6].as_ptr()),
        _mm256_loadu_ps(r[7].as_ptr()),
    ]))
}

/// The same of records in registers.
#[inline(always)]
fn transposed_rows(records: [__m256; 8]) -> [__m256; 8] {
    op!({
        // Pairs of records, then fours, then all eight.
        let mut pairs = records;
        let mut fours = records;
        let mut rows = records;
        let mut i = 0;
        while i < 8 {
            pairs[i] = _mm256_unpacklo_ps(records[i], records[i + 1]);
            pairs[i + 1] = _mm256_unpackhi_ps(records[i], records[i + 1]);
            i += 2;
        }
        let mut i = 0;
        while i < 8 {
            fours[i] = _mm256_shuffle_ps::<0b01_00_01_00>(pairs[i], pairs[i + 2]);
            fours[i + 1] = _mm256_shuffle_ps::<0b11_10_11_10>(pairs[i], pairs[i + 2]);
            fours[i + 2] = _mm256_shuffle_ps::<0b01_00_01_00>(pairs[i + 1], pairs[i + 3]);
            fours[i + 3] = _mm256_shuffle_ps::<0b11_10_11_10>(pairs[i + 1], pairs[i + 3]);
            i += 4;
        }
        let mut i = 0;
        while i < 4 {
            rows[i] = _mm256_permute2f128_ps::<0x20>(fours[i], fours[i + 4]);
            rows[i + 4] = _mm256_permute2f128_ps::<0x31>(fours[i], fours[i + 4]);
            i += 1;
        }
        rows
    })
}

impl Simd for Avx2 {
    type F8 = Eight;
    type F16 = Pair<Eight>;

    const FUSES: bool = true;

    #[inline(always)]
    fn in_packets<K: PacketKernel>(kernel: K) -> K::Output {
        kernel.run::<Self, Pair<Self::F16>, LARGEST_PACKET>()
    }

    #[inline(always)]
    fn halves(row: Eight) -> [Vec4; 2] {
        halves(row.0)
    }

    #[inline(always)]
    fn transpose_eight(rows: [Eight; 8]) -> [Eight; 8] {
        let [a, b, c, d, e, f, g, h] = rows;
        let [a, b, c, d, e, f, g, h] = transposed_rows([a.0, b.0, c.0, d.0, e.0, f.0, g.0, h.0]);
        [Eight(a), Eight(b), Eight(c), Eight(d), Eight(e), Eight(f), Eight(g), Eight(h)]
    }

    #[inline(always)]
    fn signs(words: &[u32; 8]) -> u32 {
        op!(sign_bits(_mm256_castsi256_ps(load_words(words))))
    }

    #[inline(always)]
    fn equal(words: &[u32; 8], word: u32) -> u32 {
        op!({
            let equal = _mm256_cmpeq_epi32(load_words(words), _mm256_set1_epi32(word as i32));
            sign_bits(_mm256_castsi256_ps(equal))
        })
    }

    #[inline(always)]
    fn compress(mask: u32, values: &[u32; 8], kept: &mut [u32; 8]) {
        store_words(kept, op!(_mm256_permutevar8x32_epi32(load_words(values), to_front(mask))));
    }

    #[inline(always)]
    fn compress_floats(mask: u32, values: Eight, kept: &mut [f32; 8]) {
        Eight(op!(_mm256_permutevar8x32_ps(values.0, to_front(mask)))).store(kept);
    }

    #[inline(always)]
    fn enter(
        near: Eight,
        far: Eight,
        children: &[u32; 8],
        order: &[u32; 8],
        shift: u32,
        entries: &mut [u32; 8],
        distances: &mut [f32; 8],
    ) -> u32 {
        op!({
            let order = _mm256_srlv_epi32(load_words(order), _mm256_set1_epi32(shift as i32));
            let near = Eight(_mm256_permutevar8x32_ps(near.0, order));
            let mask = near.le(Eight(_mm256_permutevar8x32_ps(far.0, order))).bits();
            let front = to_front(mask);
            let lanes = _mm256_permutevar8x32_epi32(order, front);
            store_words(entries, _mm256_permutevar8x32_epi32(load_words(children), lanes));
            Eight(_mm256_permutevar8x32_ps(near.0, front)).store(distances);
            mask.count_ones()
        })
    }
}

impl Simd for Avx512 {
    type F8 = MaskedEight;
    type F16 = Sixteen;

    const FUSES: bool = true;

    #[inline(always)]
    fn in_packets<K: PacketKernel>(kernel: K) -> K::Output {
        kernel.run::<Self, Pair<Sixteen>, LARGEST_PACKET>()
    }

    #[inline(always)]
    fn halves(row: MaskedEight) -> [Vec4; 2] {
        halves(row.0)
    }

    #[inline(always)]
    fn transpose_eight(rows: [MaskedEight; 8]) -> [MaskedEight; 8] {
        let [a, b, c, d, e, f, g, h] = rows;
        let [a, b, c, d, e, f, g, h] = transposed_rows([a.0, b.0, c.0, d.0, e.0, f.0, g.0, h.0]);
        [
            MaskedEight(a),
            MaskedEight(b),
            MaskedEight(c),
            MaskedEight(d),
            MaskedEight(e),
            MaskedEight(f),
            MaskedEight(g),
            MaskedEight(h),
        ]
    }

    #[inline(always)]
    fn signs(words: &[u32; 8]) -> u32 {
        op!(u32::from(_mm256_movepi32_mask(load_words(words))))
    }

    #[inline(always)]
    fn equal(words: &[u32; 8], word: u32) -> u32 {
        op!(u32::from(_mm256_cmpeq_epi32_mask(load_words(words), _mm256_set1_epi32(word as i32))))
    }

    #[inline(always)]
    fn compress(mask: u32, values: &[u32; 8], kept: &mut [u32; 8]) {
        store_words(kept, op!(_mm256_maskz_compress_epi32(mask as u8, load_words(values))));
    }

    #[inline(always)]
    fn compress_floats(mask: u32, values: MaskedEight, kept: &mut [f32; 8]) {
        MaskedEight(op!(_mm256_maskz_compress_ps(mask as u8, values.0))).store(kept);
    }

    #[inline(always)]
    fn enter(
        near: MaskedEight,
        far: MaskedEight,
        children: &[u32; 8],
        order: &[u32; 8],
        shift: u32,
        entries: &mut [u32; 8],
        distances: &mut [f32; 8],
    ) -> u32 {
        op!({
            let order = _mm256_srlv_epi32(load_words(order), _mm256_set1_epi32(shift as i32));
            let near = MaskedEight(_mm256_permutexvar_ps(order, near.0));
            let mask = near.le(MaskedEight(_mm256_permutexvar_ps(order, far.0))).bits();
            let children = _mm256_permutexvar_epi32(order, load_words(children));
            store_words(entries, _mm256_maskz_compress_epi32(mask as u8, children));
            Self::compress_floats(mask, near, distances);
            mask.count_ones()
        })
    }
}
