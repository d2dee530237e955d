//! The best way to part a few primitives: all places along each axis are weighed.

use glam::Vec4;

use crate::math::{Lanes as _, Mask as _};
use crate::simd::{LANES, Row as _, Simd};

use super::bins::widest_axis;
use super::reference::{Corners, NOWHERE, Reference};
use super::sweep::{Best, Line, Sweep};
use super::terms::Terms;

/// So many primitives are sorted; more are binned.
pub(super) const FEW: usize = LANES;

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
        let center = reference.center();
        // What is not a number, of a box that is not finite, would have no place.
        let center = Vec4::select(center.cmpeq(center), center, Vec4::ZERO);
        (low, high) = (low.min(center), high.max(center));
        let [x, y, z, _] = center.to_array();
        (centers[0][i], centers[1][i], centers[2][i]) = (x, y, z);
    }
    line.counts[..FEW].fill(1);
    let mut ranks = [[0; FEW]; 3];
    let mut best = Best::NONE;
    let mut axes = low.cmplt(high).bitmask();
    if terms.effort.widest || count <= terms.most {
        axes &= 1 << widest_axis(&[low, high]);
    }
    for axis in 0..3 {
        if axes >> axis & 1 == 0 {
            continue;
        }
        let row = S::F16::load(&centers[axis]);
        for i in 0..count {
            let own = S::F16::splat(centers[axis][i]);
            // Of equal centres the first comes first.
            let before = row.lt(own).bits() | row.le(own).bits() & ((1 << i) - 1);
            let rank = before.count_ones() as usize % FEW;
            ranks[axis][i] = rank as u8;
            S::F8::load(&references[i].0.0).store(&mut line.boxes[rank].0);
        }
        sweep.weigh::<S>(line, count, axis, terms.pack_bits, &mut best);
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
