//! The cheapest place to part a row of boxes, by the surface area heuristic.
//!
//! Boxes are united from the left and from the right; then eight or sixteen places are weighed at once.
//! Rows have eight, sixteen or thirty-two boxes, whether all are used or not: no loop ends early, and the
//! processor has nothing to guess.

use crate::math::{Lanes, Mask as _};
use crate::simd::{LANES, Row as _, Simd};

use super::reference::Corners;
use super::terms::PACK_COST;

/// The most boxes in a line: two rows of lanes.
pub(super) const LONGEST: usize = 2 * LANES;

/// The lane of a box that counts the primitives in it, as a whole number: exact up to 2²⁴ of them.
const COUNT: usize = 3;

/// The mask of this lane.
const COUNTED: u32 = 1 << COUNT;

/// More whole numbers than these a float does not count.
pub(super) const MOST_COUNTED: usize = 1 << 24;

/// Added to 2²³ and taken away again, a small number is rounded to whole ones.
const ROUND: f32 = 8_388_608.0;

/// The box of no points, in which no primitives are counted.
pub(super) const NOTHING: Corners = {
    let mut corners = Corners::EMPTY;
    corners.0[COUNT] = 0.0;
    corners
};

/// A primitive's box, in which one is counted.
#[inline(always)]
pub(super) fn one<S: Simd>(bounds: S::F8) -> S::F8 {
    S::F8::splat(1.0).select(COUNTED, bounds)
}

/// The box around a box and that of one more primitive.
#[inline(always)]
pub(super) fn with_one<S: Simd>(all: S::F8, bounds: S::F8) -> S::F8 {
    (all + S::F8::splat(1.0)).select(COUNTED, all.max(bounds))
}

/// Boxes along an axis, in ascending order, with their primitives counted.
pub(super) type Line = [Corners; LONGEST];

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
    pub(super) const NEW: Self = Self { left: [NOTHING.0; LONGEST], right: [NOTHING.0; LONGEST] };

    /// Weighs the places of the first `N` boxes of a line, in which all primitives are; a multiple of sixteen.
    #[inline(always)]
    pub(super) fn weigh<S: Simd, const N: usize>(
        &mut self,
        line: &Line,
        axis: usize,
        pack_bits: u32,
        best: &mut Best,
    ) {
        self.unite::<S, N>(line);
        for first in (0..N).step_by(LANES) {
            let left = S::F16::of_records(chunk(&self.left, first).each_ref());
            let right = S::F16::of_records(chunk(&self.right, first).each_ref());
            let places = some::<S::F16>(left[COUNT], right[COUNT]);
            if places == 0 {
                continue;
            }
            let cost = costs(left, pack_bits) + costs(right, pack_bits);
            let lane = cost.first_smallest(places) % LANES;
            let mut row = [0.0; LANES];
            cost.store(&mut row);
            self.note(row[lane], axis, first + lane, best);
        }
    }

    /// The same of the first eight boxes.
    #[inline(always)]
    pub(super) fn weigh_eight<S: Simd>(
        &mut self,
        line: &Line,
        axis: usize,
        pack_bits: u32,
        best: &mut Best,
    ) {
        self.unite::<S, 8>(line);
        let (left, right) = (transposed::<S>(&self.left), transposed::<S>(&self.right));
        let places = some::<S::F8>(left[COUNT], right[COUNT]);
        if places == 0 {
            return;
        }
        let cost = costs(left, pack_bits) + costs(right, pack_bits);
        let lane = cost.first_smallest(places) % 8;
        let mut row = [0.0; 8];
        cost.store(&mut row);
        self.note(row[lane], axis, lane, best);
    }

    #[inline(always)]
    fn unite<S: Simd, const N: usize>(&mut self, line: &Line) {
        // Counts and boxes apart, so that each waits for one operation alone.
        let nothing = S::F8::load(&NOTHING.0);
        let (mut bounds, mut counts) = (nothing, nothing);
        for (next, left) in line[..N].iter().zip(&mut self.left[..N]) {
            let next = S::F8::load(&next.0);
            (bounds, counts) = (bounds.max(next), counts + next);
            counts.select(COUNTED, bounds).store(left);
        }
        let (mut bounds, mut counts) = (nothing, nothing);
        nothing.store(&mut self.right[N - 1]);
        for place in (1..N).rev() {
            let next = S::F8::load(&line[place].0);
            (bounds, counts) = (bounds.max(next), counts + next);
            counts.select(COUNTED, bounds).store(&mut self.right[place - 1]);
        }
    }

    #[inline(always)]
    fn note(&self, cost: f32, axis: usize, last: usize, best: &mut Best) {
        if cost < best.cost {
            let halves = [Corners(self.left[last]), Corners(self.right[last])];
            *best = Best { cost, axis, last, count: halves[0].0[COUNT] as usize, halves };
        }
    }
}

/// The lanes with some on either side. At a place with none before it or behind it, a box is empty and its area has no
/// sense.
#[inline(always)]
fn some<L: Lanes>(before: L, after: L) -> u32 {
    (L::splat(0.0).lt(before) & L::splat(0.0).lt(after)).bits()
}

/// The areas of boxes times the cost of their primitives: that of the packs that they fill, and of each of
/// them.
#[inline(always)]
fn costs<L: Lanes>(rows: [L; 8], pack_bits: u32) -> L {
    let (x, y, z) = (rows[0] + rows[4], rows[1] + rows[5], rows[2] + rows[6]);
    let count = rows[COUNT];
    // Rounded up: of so many in a pack, one more than whole packs lies behind the middle, and none before it.
    let pack = 1.0 / (1u32 << pack_bits) as f32;
    let packs =
        count * L::splat(pack) + L::splat(0.5 - 0.5 * pack) + L::splat(ROUND) - L::splat(ROUND);
    (x * y + y * z + z * x) * (packs * L::splat(PACK_COST) + count)
}

/// Sixteen boxes.
#[inline(always)]
fn chunk(boxes: &[[f32; 8]; LONGEST], first: usize) -> &[[f32; 8]; LANES] {
    boxes[first..].first_chunk().expect("lines are whole chunks")
}

/// The first eight boxes as rows.
#[inline(always)]
fn transposed<S: Simd>(boxes: &[[f32; 8]; LONGEST]) -> [S::F8; 8] {
    S::transpose_eight([
        S::F8::load(&boxes[0]),
        S::F8::load(&boxes[1]),
        S::F8::load(&boxes[2]),
        S::F8::load(&boxes[3]),
        S::F8::load(&boxes[4]),
        S::F8::load(&boxes[5]),
        S::F8::load(&boxes[6]),
        S::F8::load(&boxes[7]),
    ])
}
