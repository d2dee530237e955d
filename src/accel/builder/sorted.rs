//! The best way to part a few primitives: all places along each axis are weighed. Whether a leaf of them is worth
//! that look.

use glam::Vec4;

use crate::math::{Lanes as _, Mask as _};
use crate::simd::{LANES, Row as _, Simd};

use super::bins::widest_axis;
use super::reference::{Corners, NOWHERE, Reference};
use super::sweep::{Best, Line, NOTHING, Sweep, one};
use super::terms::Terms;

/// So many primitives are sorted; more are binned.
pub(super) const FEW: usize = LANES;

/// Of up to eight primitives, parting is not worth a look from this sum of their surfaces on, as a share of the
/// surface around them.
pub(super) const DENSE: f32 = 1.0;

/// Up to so many are sorted in eight lanes.
const FEWER: usize = FEW / 2;

/// Weighs all places of 2 to 16 primitives, along the widest axis alone if they may be a leaf or
/// no more effort is wanted, and puts those along the best axis into order. None is found where all centres are one.
#[inline(always)]
pub(super) fn sort_and_part<S: Simd>(
    references: &mut [Reference],
    terms: Terms,
    (line, sweep): (&mut Line, &mut Sweep),
) -> Best {
    let count = references.len().min(FEW);
    let mut centers = [[f32::INFINITY; FEW]; 3];
    let [mut low, mut high] = NOWHERE;
    for (i, reference) in references.iter().take(FEW).enumerate() {
        let [from, to] = S::halves(S::F8::load(&reference.0.0));
        let center = to - from;
        // What is not a number, of a box that is not finite, would have no place.
        let center = Vec4::select(center.cmpeq(center), center, Vec4::ZERO);
        (low, high) = (low.min(center), high.max(center));
        let [x, y, z, _] = center.to_array();
        (centers[0][i], centers[1][i], centers[2][i]) = (x, y, z);
    }
    let mut ranks = [[0; FEW]; 3];
    let mut best = Best::NONE;
    let mut axes = low.cmplt(high).bitmask();
    if terms.effort.widest || count <= terms.most {
        axes &= 1 << widest_axis(&[low, high]);
    }
    line[if count <= FEWER { 0..FEWER } else { 0..FEW }].fill(NOTHING);
    for axis in 0..3 {
        if axes >> axis & 1 == 0 {
            continue;
        }
        for i in 0..count {
            // Of equal centres the first comes first.
            let before = if count <= FEWER {
                let row = S::F8::load(centers[axis].first_chunk().expect("a row has two halves"));
                let own = S::F8::splat(centers[axis][i]);
                row.lt(own).bits() | row.le(own).bits() & ((1 << i) - 1)
            } else {
                let row = S::F16::load(&centers[axis]);
                let own = S::F16::splat(centers[axis][i]);
                row.lt(own).bits() | row.le(own).bits() & ((1 << i) - 1)
            };
            let rank = before.count_ones() as usize % FEW;
            ranks[axis][i] = rank as u8;
            one::<S>(S::F8::load(&references[i].0.0)).store(&mut line[rank].0);
        }
        if count <= FEWER {
            sweep.weigh_eight::<S>(line, axis, terms.pack_bits, &mut best);
        } else {
            sweep.weigh::<S, FEW>(line, axis, terms.pack_bits, &mut best);
        }
    }
    if best.count == 0 {
        return best;
    }
    let mut sorted = [Reference(Corners::EMPTY); FEW];
    for i in 0..count {
        sorted[ranks[best.axis % 3][i] as usize % FEW] = references[i];
    }
    references.copy_from_slice(&sorted[..count]);
    best
}

/// Whether the boxes of up to eight primitives have as large a surface together as the box around them, so that
/// there is nothing to gain where they are parted.
#[inline(always)]
pub(super) fn is_dense<S: Simd>(references: &[Reference], bounds: &Corners) -> bool {
    let mut rows = [S::F8::splat(0.0); FEWER];
    for (row, reference) in rows.iter_mut().zip(references) {
        *row = S::F8::load(&reference.0.0);
    }
    let rows = S::transpose_eight(rows);
    let (x, y, z) = (rows[0] + rows[4], rows[1] + rows[5], rows[2] + rows[6]);
    let mut areas = [0.0; FEWER];
    (x * y + y * z + z * x).store(&mut areas);
    let [a, b, c, d, e, f, g, h] = areas;
    let sum = ((a + b) + (c + d)) + ((e + f) + (g + h));
    references.len() <= FEWER && sum >= DENSE * bounds.half_area()
}
