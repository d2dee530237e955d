//! What kernels need of AVX2.

use std::arch::x86_64::*;

use glam::Vec4;

use super::super::pair::Pair;
use super::super::{LARGEST_PACKET, PacketKernel, Row as _, Simd};
use super::Avx2;
use super::masks::sign_bits;
use super::rows::Eight;
use super::words::{halves, kept_bytes, load_words, store_words, to_front, transposed_rows};
use crate::math::{Lanes as _, Mask as _};

impl Simd for Avx2 {
    type F8 = Eight;
    type F16 = Pair<Eight>;

    /// A byte each, the first the lowest: in a register, which takes less time than through memory.
    type Crossed = u64;

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
            let children = _mm256_permutevar8x32_epi32(load_words(children), order);
            let front = to_front(mask);
            store_words(entries, _mm256_permutevar8x32_epi32(children, front));
            Eight(_mm256_permutevar8x32_ps(near.0, front)).store(distances);
            mask.count_ones()
        })
    }

    #[inline(always)]
    fn crossed(near: Eight, far: Eight, order: &[u32; 8], shift: u32) -> (Self::Crossed, u32) {
        op!({
            let order = _mm256_srlv_epi32(load_words(order), _mm256_set1_epi32(shift as i32));
            let near = Eight(_mm256_permutevar8x32_ps(near.0, order));
            let mask = near.le(Eight(_mm256_permutevar8x32_ps(far.0, order))).bits();
            (kept_bytes(mask, order), mask.count_ones())
        })
    }

    #[inline(always)]
    fn crossed_lane(crossed: &Self::Crossed, number: u32) -> usize {
        (crossed >> (8 * number) & 7) as usize
    }
}
