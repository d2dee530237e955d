//! One formula for one value and for several at once.
//!
//! Every operation here rounds each lane exactly as the scalar operation does, and none fuses a
//! product with a sum, so a formula written over [`Lanes`] gives the same bits for any width.

use std::ops::{Add, Div, Mul, Sub};

use glam::Vec4;

/// A row of floats that are computed with together.
pub trait Lanes:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + std::fmt::Debug
{
    /// Absolute values.
    fn abs(self) -> Self;
    /// The same values, with their signs changed where the sign bit of `of` is set.
    fn flipped_by(self, of: Self) -> Self;
    /// Square roots, rounded correctly; NaN of what is negative.
    fn sqrt(self) -> Self;
}

/// The sign bit.
const SIGN: u32 = 1 << 31;

impl Lanes for f32 {
    #[inline(always)]
    fn abs(self) -> Self {
        f32::abs(self)
    }
    #[inline(always)]
    fn flipped_by(self, of: Self) -> Self {
        f32::from_bits(self.to_bits() ^ of.to_bits() & SIGN)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        f32::sqrt(self)
    }
}

impl Lanes for Vec4 {
    #[inline(always)]
    fn abs(self) -> Self {
        Vec4::abs(self)
    }
    #[inline(always)]
    fn flipped_by(self, of: Self) -> Self {
        // With the bits of `of` in place of the numbers' own, only signs are taken from it.
        let flipped = glam::UVec4::from_array(self.to_array().map(f32::to_bits))
            ^ glam::UVec4::from_array(of.to_array().map(f32::to_bits)) & glam::UVec4::splat(SIGN);
        Vec4::from_array(flipped.to_array().map(f32::from_bits))
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Vec4::sqrt(self)
    }
}

/// Three rows: the x, y and z of several vectors.
pub type Lanes3<L> = [L; 3];

/// a × b, lane by lane.
#[inline(always)]
pub fn cross<L: Lanes>(a: Lanes3<L>, b: Lanes3<L>) -> Lanes3<L> {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// a · b, lane by lane: x + (y + z) in this order.
#[inline(always)]
pub fn dot<L: Lanes>(a: Lanes3<L>, b: Lanes3<L>) -> L {
    a[0] * b[0] + (a[1] * b[1] + a[2] * b[2])
}

/// a − b, lane by lane.
#[inline(always)]
pub fn sub<L: Lanes>(a: Lanes3<L>, b: Lanes3<L>) -> Lanes3<L> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// The positions of the ones of a mask of lanes, the lowest first.
#[inline(always)]
pub(crate) fn ones(mut mask: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lowest = (mask != 0).then(|| mask.trailing_zeros() as usize);
        mask &= mask.wrapping_sub(1);
        lowest
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ones_are_listed_from_the_lowest() {
        assert_eq!(ones(0b1010_0001).collect::<Vec<_>>(), [0, 5, 7]);
        assert_eq!(ones(1 << 31).collect::<Vec<_>>(), [31]);
        assert_eq!(ones(0).count(), 0);
    }

    #[test]
    fn four_lanes_are_four_scalars() {
        let values = [1.5f32, -0.0, f32::MIN_POSITIVE, -3.0e30];
        let row = Vec4::from_array(values);
        for (i, x) in values.into_iter().enumerate() {
            for of in [1.0, -0.0, f32::NEG_INFINITY] {
                let flipped = row.flipped_by(Vec4::splat(of))[i];
                assert_eq!(flipped.to_bits(), x.flipped_by(of).to_bits());
                assert_eq!(flipped.to_bits(), (x * of.signum()).to_bits());
            }
            assert_eq!(Lanes::abs(row)[i].to_bits(), Lanes::abs(x).to_bits());
            let root = Lanes::sqrt(Lanes::abs(row))[i];
            assert_eq!(root.to_bits(), Lanes::sqrt(Lanes::abs(x)).to_bits());
        }
    }
}
