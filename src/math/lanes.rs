//! One formula for one value and for several at once.
//!
//! Every operation here rounds each lane exactly as the scalar operation does, and none fuses a
//! product with a sum, so a formula written over [`Lanes`] gives the same bits for any width. A lane
//! holds a ray, a primitive, a box, or an axis (in a [`Vec3A`]).
//!
//! Values must not pass through functions that are not `#[inline(always)]`, closures among them, nor
//! through the standard library's combinators: these are compiled without the instruction set of the
//! kernel around them, and a call that hands over a wide value is not inlined.

use std::ops::{Add, BitAnd, BitOr, Div, Mul, Sub};

use glam::{BVec3A, BVec4A, Vec3A, Vec4};

/// A yes or no for each lane.
pub trait Mask: Copy + BitAnd<Output = Self> + BitOr<Output = Self> {
    /// How many lanes there are; at most 32.
    const LANES: u32;
    /// As bits, lane 0 the lowest.
    fn bits(self) -> u32;
    /// The mask of these bits; those above the last lane are of no meaning.
    fn of_bits(bits: u32) -> Self;
}

/// Floats that are computed with together.
pub trait Lanes:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + std::fmt::Debug
{
    /// What comparisons give.
    type Mask: Mask;

    /// The same value in every lane.
    fn splat(value: f32) -> Self;
    /// Absolute values.
    fn abs(self) -> Self;
    /// The same values, with their signs changed where the sign bit of `of` is set.
    fn flipped_by(self, of: Self) -> Self;
    /// Square roots, rounded correctly; NaN of what is negative.
    fn sqrt(self) -> Self;
    /// The smaller ones, lane by lane; of numbers alone.
    fn min(self, other: Self) -> Self;
    /// The larger ones, lane by lane; of numbers alone.
    fn max(self, other: Self) -> Self;
    /// Where `self ≤ other`; false where either is NaN.
    fn le(self, other: Self) -> Self::Mask;
    /// Where `self < other`; false where either is NaN.
    fn lt(self, other: Self) -> Self::Mask;
    /// `self` where the mask holds, `other` elsewhere.
    fn select_where(self, mask: Self::Mask, other: Self) -> Self;
    /// `self` where the bits have a one, `other` elsewhere. Where a comparison has just made the mask,
    /// [`select_where`](Self::select_where) spares the way through bits.
    #[inline(always)]
    fn select(self, bits: u32, other: Self) -> Self {
        self.select_where(Self::Mask::of_bits(bits), other)
    }

    /// Whether the processor has too few registers for a formula with several rows of several registers each.
    const FEW_REGISTERS: bool = false;

    /// Applies a formula, to one register of each row after the other where there are few.
    #[inline(always)]
    fn apply<const IN: usize, const OUT: usize>(
        formula: &impl LaneFormula<IN, OUT>,
        rows: &[Self; IN],
    ) -> ([Self; OUT], Self::Mask) {
        formula.apply(rows)
    }
}

/// A formula from rows to rows and a mask, lane by lane.
pub trait LaneFormula<const IN: usize, const OUT: usize> {
    /// Applies it. Inlined, as all that handles rows is.
    fn apply<L: Lanes>(&self, rows: &[L; IN]) -> ([L; OUT], L::Mask);
}

/// The sign bit.
const SIGN: u32 = 1 << 31;

impl Mask for bool {
    const LANES: u32 = 1;

    #[inline(always)]
    fn bits(self) -> u32 {
        u32::from(self)
    }
    #[inline(always)]
    fn of_bits(bits: u32) -> Self {
        bits & 1 != 0
    }
}

impl Lanes for f32 {
    type Mask = bool;

    #[inline(always)]
    fn splat(value: f32) -> Self {
        value
    }
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
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        f32::min(self, other)
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        f32::max(self, other)
    }
    #[inline(always)]
    fn le(self, other: Self) -> bool {
        self <= other
    }
    #[inline(always)]
    fn lt(self, other: Self) -> bool {
        self < other
    }
    #[inline(always)]
    fn select_where(self, mask: bool, other: Self) -> Self {
        if mask { self } else { other }
    }
}

/// The vectors of glam, whose operations have the same names.
macro_rules! vector {
    ($vector:ident, $mask:ident, $unsigned:ident, [$($lane:literal),*]) => {
        impl Mask for $mask {
            const LANES: u32 = [$($lane),*].len() as u32;

            #[inline(always)]
            fn bits(self) -> u32 {
                self.bitmask()
            }
            #[inline(always)]
            fn of_bits(bits: u32) -> Self {
                $mask::new($(bits >> $lane & 1 != 0),*)
            }
        }

        impl Lanes for $vector {
            type Mask = $mask;
            // SSE2 has sixteen, NEON has 32.
            const FEW_REGISTERS: bool = cfg!(any(target_arch = "x86", target_arch = "x86_64"));

            #[inline(always)]
            fn splat(value: f32) -> Self {
                $vector::splat(value)
            }
            #[inline(always)]
            fn abs(self) -> Self {
                $vector::abs(self)
            }
            #[inline(always)]
            fn flipped_by(self, of: Self) -> Self {
                // With the bits of `of` in place of the numbers' own, only signs are taken from it.
                let bits = |v: Self| glam::$unsigned::from_array(v.to_array().map(f32::to_bits));
                let flipped = bits(self) ^ bits(of) & glam::$unsigned::splat(SIGN);
                $vector::from_array(flipped.to_array().map(f32::from_bits))
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                $vector::sqrt(self)
            }
            #[inline(always)]
            fn min(self, other: Self) -> Self {
                $vector::min(self, other)
            }
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                $vector::max(self, other)
            }
            #[inline(always)]
            fn le(self, other: Self) -> $mask {
                self.cmple(other)
            }
            #[inline(always)]
            fn lt(self, other: Self) -> $mask {
                self.cmplt(other)
            }
            #[inline(always)]
            fn select_where(self, mask: $mask, other: Self) -> Self {
                $vector::select(mask, self, other)
            }
        }
    };
}

vector!(Vec4, BVec4A, UVec4, [0, 1, 2, 3]);
vector!(Vec3A, BVec3A, UVec3, [0, 1, 2]);

/// Three rows: the x, y and z of several vectors.
pub type Lanes3<L> = [L; 3];

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

/// Whether values lie in closed intervals; never where any of the three is NaN.
#[inline(always)]
pub fn within<L: Lanes>(value: L, [low, high]: [L; 2]) -> L::Mask {
    low.le(value) & value.le(high)
}

/// The positions of the ones of a mask of lanes, the lowest first.
#[inline(always)]
pub fn ones(mut mask: u32) -> impl Iterator<Item = usize> {
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
