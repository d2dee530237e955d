//! The cheapest place to part a row of boxes, by the surface area heuristic.
//!
//! Boxes are united from the left and from the right; then sixteen places are weighed at once.

use crate::math::{Lanes as _, Mask as _};
use crate::simd::{LANES, Row as _, Simd};

use super::reference::Corners;
use super::terms::PACK_COST;

/// The most boxes in a line: two rows of lanes.
pub(super) const LONGEST: usize = 2 * LANES;

/// Boxes along an axis, in ascending order, and how many primitives are in each.
#[derive(Clone)]
pub(super) struct Line {
    pub(super) boxes: [Corners; LONGEST],
    pub(super) counts: [u32; LONGEST],
}

impl Line {
    pub(super) const EMPTY: Self = Self { boxes: [Corners::EMPTY; LONGEST], counts: [0; LONGEST] };
}

/// The best place found so far to part a node's primitives: behind place `last` along an axis.
#[derive(Clone, Copy)]
pub(super) struct Best {
    /// The areas of both boxes, each times the cost of its primitives.
    pub(super) cost: f32,
    pub(super) axis: usize,
    pub(super) last: usize,
    /// Primitives up to there; 0 if no place was found.
    pub(super) count: usize,
    /// The boxes around both parts.
    pub(super) halves: [Corners; 2],
}

impl Best {
    /// No place.
    pub(super) const NONE: Self =
        Self { cost: f32::INFINITY, axis: 0, last: 0, count: 0, halves: [Corners::EMPTY; 2] };
}

/// Memory for sweeps, so that none is cleared for each: what is left in it has no effect.
#[repr(align(64))]
pub(super) struct Sweep {
    /// The boxes around all up to a place, and around all behind it.
    left: [[f32; 8]; LONGEST],
    right: [[f32; 8]; LONGEST],
}

impl Sweep {
    pub(super) const NEW: Self = Self { left: [[0.0; 8]; LONGEST], right: [[0.0; 8]; LONGEST] };

    /// Weighs the places of a line that has its primitives among the first `used` boxes, at least
    /// one.
    #[inline(always)]
    pub(super) fn weigh<S: Simd>(
        &mut self,
        line: &Line,
        used: usize,
        axis: usize,
        pack_bits: u32,
        best: &mut Best,
    ) {
        let used = used.min(LONGEST);
        let mut before = [0; LONGEST];
        let mut all = 0;
        let mut united = S::F8::splat(f32::NEG_INFINITY);
        for (place, before) in before.iter_mut().enumerate().take(used) {
            united = united.max(S::F8::load(&line.boxes[place].0));
            united.store(&mut self.left[place]);
            all += line.counts[place];
            *before = all;
        }
        let mut united = S::F8::splat(f32::NEG_INFINITY);
        for place in (1..used).rev() {
            united = united.max(S::F8::load(&line.boxes[place].0));
            united.store(&mut self.right[place - 1]);
        }
        for first in (0..used).step_by(LANES) {
            let (left, right) = (chunk(&self.left, first), chunk(&self.right, first));
            let before = chunk(&before, first);
            let mut after = [0; LANES];
            for (after, before) in after.iter_mut().zip(before) {
                *after = all.saturating_sub(*before);
            }
            // At a place with none before it or behind it, boxes are empty and areas have no sense.
            let [some_before, some_after] = [some::<S>(before), some::<S>(&after)];
            let places = some_before & some_after;
            if places == 0 {
                continue;
            }
            let cost = costs::<S>(left, before, pack_bits) + costs::<S>(right, &after, pack_bits);
            let lane = cost.first_smallest(places) % LANES;
            let mut row = [0.0; LANES];
            cost.store(&mut row);
            if row[lane] < best.cost {
                *best = Best {
                    cost: row[lane],
                    axis,
                    last: first + lane,
                    count: before[lane] as usize,
                    halves: [Corners(left[lane]), Corners(right[lane])],
                };
            }
        }
    }
}

/// The lanes in which some are counted.
#[inline(always)]
fn some<S: Simd>(counts: &[u32; LANES]) -> u32 {
    S::F16::splat(0.0).lt(S::F16::load(&floats(counts))).bits()
}

/// The areas of sixteen boxes times the cost of so many primitives: that of the packs that they fill, and
/// of each of them.
#[inline(always)]
fn costs<S: Simd>(boxes: &[[f32; 8]; LANES], counts: &[u32; LANES], pack_bits: u32) -> S::F16 {
    let mut packs = *counts;
    for packs in &mut packs {
        *packs = (*packs + (1 << pack_bits) - 1) >> pack_bits;
    }
    let rows = S::transpose(boxes);
    let (x, y, z) = (rows[0] + rows[4], rows[1] + rows[5], rows[2] + rows[6]);
    let (packs, single) = (S::F16::load(&floats(&packs)), S::F16::load(&floats(counts)));
    (x * y + y * z + z * x) * (packs * S::F16::splat(PACK_COST) + single)
}

#[inline(always)]
fn floats(counts: &[u32; LANES]) -> [f32; LANES] {
    let mut floats = [0.0; LANES];
    for (float, count) in floats.iter_mut().zip(counts) {
        *float = *count as f32;
    }
    floats
}

/// Sixteen values of a row.
#[inline(always)]
fn chunk<T>(row: &[T; LONGEST], first: usize) -> &[T; LANES] {
    row[first..].first_chunk().expect("rows are whole chunks")
}
