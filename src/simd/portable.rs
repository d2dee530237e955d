//! Every processor's instruction set: what glam makes of four floats (SSE2, NEON), and loops.

use glam::Vec4;

use crate::math::{Lanes as _, Mask as _};

use super::pair::Pair;
use super::{LANES, PacketKernel, Row, Simd};

/// Four floats at a time, nothing fused.
#[derive(Clone, Copy, Debug)]
pub(super) struct Portable;

impl Row<4> for Vec4 {
    #[inline(always)]
    fn load(values: &[f32; 4]) -> Self {
        Vec4::from_array(*values)
    }
    #[inline(always)]
    fn load_bits(&[x, y, z, w]: &[u32; 4]) -> Self {
        Vec4::new(f32::from_bits(x), f32::from_bits(y), f32::from_bits(z), f32::from_bits(w))
    }
    #[inline(always)]
    fn store(self, values: &mut [f32; 4]) {
        *values = self.to_array();
    }
    #[inline(always)]
    fn of_records(records: [&[f32; 8]; 4]) -> [Self; 8] {
        let mut rows = [Vec4::ZERO; 8];
        let mut i = 0;
        while i < 8 {
            let [x, y, z, w] = [records[0][i], records[1][i], records[2][i], records[3][i]];
            rows[i] = Vec4::new(x, y, z, w);
            i += 1;
        }
        rows
    }
    #[inline(always)]
    fn smallest(self) -> f32 {
        self.min_element()
    }
    #[inline(always)]
    fn largest(self) -> f32 {
        self.max_element()
    }
    #[inline(always)]
    fn slab(planes: Self, inv_dir: Self, offset: Self) -> Self {
        (planes - offset) * inv_dir
    }
}

impl Simd for Portable {
    type F8 = Pair<Vec4>;
    type F16 = Pair<Pair<Vec4>>;

    type Crossed = [u32; 8];

    const FUSES: bool = false;

    #[inline(always)]
    fn in_packets<K: PacketKernel>(kernel: K) -> K::Output {
        kernel.run::<Self, Self::F16, LANES>()
    }

    #[inline(always)]
    fn halves(row: Self::F8) -> [Vec4; 2] {
        [row.0, row.1]
    }

    #[inline(always)]
    fn transpose_eight(mut rows: [Self::F8; 8]) -> [Self::F8; 8] {
        let mut records = [[0.0; 8]; 8];
        for (number, row) in rows.iter().enumerate() {
            let mut values = [0.0; 8];
            row.store(&mut values);
            for (record, value) in records.iter_mut().zip(values) {
                record[number] = value;
            }
        }
        for (row, record) in rows.iter_mut().zip(&records) {
            *row = Self::F8::load(record);
        }
        rows
    }

    #[inline(always)]
    fn signs(words: &[u32; 8]) -> u32 {
        words.iter().rev().fold(0, |signs, word| signs << 1 | word >> 31)
    }

    #[inline(always)]
    fn equal(words: &[u32; 8], word: u32) -> u32 {
        words.iter().rev().fold(0, |bits, &other| bits << 1 | u32::from(other == word))
    }

    #[inline(always)]
    fn compress(mask: u32, values: &[u32; 8], kept: &mut [u32; 8]) {
        let mut count = 0;
        for (lane, &value) in values.iter().enumerate() {
            kept[count & 7] = value;
            count += (mask >> lane & 1) as usize;
        }
    }

    #[inline(always)]
    fn compress_floats(mask: u32, values: Self::F8, kept: &mut [f32; 8]) {
        let mut row = [0.0; 8];
        values.store(&mut row);
        let mut count = 0;
        for (lane, value) in row.into_iter().enumerate() {
            kept[count & 7] = value;
            count += (mask >> lane & 1) as usize;
        }
    }

    #[inline(always)]
    fn enter(
        near: Self::F8,
        far: Self::F8,
        children: &[u32; 8],
        order: &[u32; 8],
        shift: u32,
        entries: &mut [u32; 8],
        distances: &mut [f32; 8],
    ) -> u32 {
        let mask = near.le(far).bits();
        let mut begins = [0.0; 8];
        near.store(&mut begins);
        let mut count = 0;
        for word in order {
            let lane = (word >> shift & 7) as usize;
            entries[count & 7] = children[lane];
            distances[count & 7] = begins[lane];
            count += (mask >> lane & 1) as usize;
        }
        count as u32
    }

    #[inline(always)]
    fn crossed(
        near: Self::F8,
        far: Self::F8,
        order: &[u32; 8],
        shift: u32,
    ) -> (Self::Crossed, u32) {
        let mask = near.le(far).bits();
        let (mut lanes, mut count) = ([0; 8], 0);
        for word in order {
            let lane = word >> shift & 7;
            lanes[count & 7] = lane;
            count += (mask >> lane & 1) as usize;
        }
        (lanes, count as u32)
    }

    #[inline(always)]
    fn crossed_lane(crossed: &Self::Crossed, number: u32) -> usize {
        crossed[number as usize & 7] as usize
    }
}
