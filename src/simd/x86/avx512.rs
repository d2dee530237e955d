//! What kernels need of AVX-512.

use std::arch::x86_64::*;

use glam::Vec4;

use super::super::pair::Pair;
use super::super::{LARGEST_PACKET, PacketKernel, Row as _, Simd};
use super::Avx512;
use super::rows::{MaskedEight, Sixteen};
use super::words::{halves, load_words, store_words, transposed_rows};
use crate::math::{Lanes as _, Mask as _};

impl Simd for Avx512 {
    type F8 = MaskedEight;
    type F16 = Sixteen;

    type Crossed = [u32; 8];

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

    #[inline(always)]
    fn crossed(
        near: MaskedEight,
        far: MaskedEight,
        order: &[u32; 8],
        shift: u32,
    ) -> (Self::Crossed, u32) {
        let mut lanes = [0; 8];
        let count = op!({
            let order = _mm256_srlv_epi32(load_words(order), _mm256_set1_epi32(shift as i32));
            let near = MaskedEight(_mm256_permutexvar_ps(order, near.0));
            let mask = near.le(MaskedEight(_mm256_permutexvar_ps(order, far.0))).bits();
            store_words(&mut lanes, _mm256_maskz_compress_epi32(mask as u8, order));
            mask.count_ones()
        });
        (lanes, count)
    }

    #[inline(always)]
    fn crossed_lane(crossed: &Self::Crossed, number: u32) -> usize {
        (crossed[number as usize & 7] & 7) as usize
    }
}
