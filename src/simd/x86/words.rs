//! What both instruction sets do with registers of eight words or floats.

use std::arch::x86_64::*;

use glam::Vec4;

/// For each mask of eight lanes, the lanes that it keeps, a byte each.
pub(super) static KEPT: [u64; 256] = kept();

pub(super) const fn kept() -> [u64; 256] {
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
pub(super) fn to_front(mask: u32) -> __m256i {
    let lanes = KEPT[(mask & 0xff) as usize] as i64;
    op!(_mm256_cvtepu8_epi32(_mm_cvtsi64_si128(lanes)))
}

/// The lowest bytes of the words that a mask keeps.
#[inline(always)]
pub(super) fn kept_bytes(mask: u32, words: __m256i) -> u64 {
    // In registers, and little of it after the mask is known: what waits for this is the way down a tree.
    op!({
        let lowest = _mm256_set1_epi32(0x0c_08_04_00);
        let fours = _mm256_shuffle_epi8(words, lowest);
        let (low, high) = (_mm256_castsi256_si128(fours), _mm256_extracti128_si256::<1>(fours));
        let kept = _mm_cvtsi64_si128(KEPT[(mask & 0xff) as usize] as i64);
        _mm_cvtsi128_si64(_mm_shuffle_epi8(_mm_unpacklo_epi32(low, high), kept)) as u64
    })
}

#[inline(always)]
pub(super) fn load_words(words: &[u32; 8]) -> __m256i {
    op!(_mm256_loadu_si256(words.as_ptr().cast()))
}

#[inline(always)]
pub(super) fn store_words(words: &mut [u32; 8], values: __m256i) {
    op!(_mm256_storeu_si256(words.as_mut_ptr().cast(), values));
}

/// The lower and the upper four floats.
#[inline(always)]
pub(super) fn halves(row: __m256) -> [Vec4; 2] {
    op!([_mm256_castps256_ps128(row).into(), _mm256_extractf128_ps::<1>(row).into()])
}

/// Eight records of eight floats as eight rows. Fours of floats come to their halves as they are loaded, which takes a
/// third of the shuffles away.
#[inline(always)]
pub(super) fn transposed(r: [&[f32; 8]; 8]) -> [__m256; 8] {
    op!({
        let mut rows = [_mm256_setzero_ps(); 8];
        let mut first = 0;
        while first < 8 {
            let mut both = [_mm256_setzero_ps(); 4];
            let mut i = 0;
            while i < 4 {
                let low = _mm256_castps128_ps256(_mm_loadu_ps(r[i].as_ptr().add(first)));
                both[i] =
                    _mm256_insertf128_ps::<1>(low, _mm_loadu_ps(r[i + 4].as_ptr().add(first)));
                i += 1;
            }
            let [a, b, c, d] = both;
            let (ab, cd) = (_mm256_unpacklo_ps(a, b), _mm256_unpacklo_ps(c, d));
            rows[first] = _mm256_shuffle_ps::<0b01_00_01_00>(ab, cd);
            rows[first + 1] = _mm256_shuffle_ps::<0b11_10_11_10>(ab, cd);
            let (ab, cd) = (_mm256_unpackhi_ps(a, b), _mm256_unpackhi_ps(c, d));
            rows[first + 2] = _mm256_shuffle_ps::<0b01_00_01_00>(ab, cd);
            rows[first + 3] = _mm256_shuffle_ps::<0b11_10_11_10>(ab, cd);
            first += 4;
        }
        rows
    })
}

/// Eight records in registers as eight rows, or the other way round.
#[inline(always)]
pub(super) fn transposed_rows(records: [__m256; 8]) -> [__m256; 8] {
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
