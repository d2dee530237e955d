//! Two rows as one of twice the width.

use std::ops::{Add, BitAnd, BitOr, Div, Mul, Sub};

use crate::math::{LaneFormula, Lanes, Mask};

use super::Row;

/// The lower and the upper half.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair<R>(pub(super) R, pub(super) R);

impl<R: Add<Output = R>> Add for Pair<R> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0, self.1 + other.1)
    }
}

impl<R: Sub<Output = R>> Sub for Pair<R> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0, self.1 - other.1)
    }
}

impl<R: Mul<Output = R>> Mul for Pair<R> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0, self.1 * other.1)
    }
}

impl<R: Div<Output = R>> Div for Pair<R> {
    type Output = Self;
    #[inline(always)]
    fn div(self, other: Self) -> Self {
        Self(self.0 / other.0, self.1 / other.1)
    }
}

impl<R: Lanes> Lanes for Pair<R> {
    type Mask = PairMask<R::Mask>;

    #[inline(always)]
    fn splat(value: f32) -> Self {
        Self(R::splat(value), R::splat(value))
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.abs(), self.1.abs())
    }
    #[inline(always)]
    fn flipped_by(self, of: Self) -> Self {
        Self(self.0.flipped_by(of.0), self.1.flipped_by(of.1))
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt(), self.1.sqrt())
    }
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        Self(self.0.min(other.0), self.1.min(other.1))
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self(self.0.max(other.0), self.1.max(other.1))
    }
    #[inline(always)]
    fn le(self, other: Self) -> Self::Mask {
        PairMask(self.0.le(other.0), self.1.le(other.1))
    }
    #[inline(always)]
    fn lt(self, other: Self) -> Self::Mask {
        PairMask(self.0.lt(other.0), self.1.lt(other.1))
    }
    #[inline(always)]
    fn select_where(self, mask: Self::Mask, other: Self) -> Self {
        Self(self.0.select_where(mask.0, other.0), self.1.select_where(mask.1, other.1))
    }

    const FEW_REGISTERS: bool = R::FEW_REGISTERS;

    #[inline(always)]
    fn apply<const IN: usize, const OUT: usize>(
        formula: &impl LaneFormula<IN, OUT>,
        rows: &[Self; IN],
    ) -> ([Self; OUT], Self::Mask) {
        if !R::FEW_REGISTERS {
            return formula.apply(rows);
        }
        let (mut low, mut high) = ([rows[0].0; IN], [rows[0].1; IN]);
        for i in 0..IN {
            (low[i], high[i]) = (rows[i].0, rows[i].1);
        }
        let (low, in_low) = R::apply(formula, &low);
        let (high, in_high) = R::apply(formula, &high);
        let mut pairs = [Self(low[0], high[0]); OUT];
        for i in 0..OUT {
            pairs[i] = Self(low[i], high[i]);
        }
        (pairs, PairMask(in_low, in_high))
    }
}

/// The masks of both halves.
#[derive(Clone, Copy, Debug)]
pub(super) struct PairMask<M>(M, M);

impl<M: Mask> BitAnd for PairMask<M> {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self(self.0 & other.0, self.1 & other.1)
    }
}

impl<M: Mask> BitOr for PairMask<M> {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0, self.1 | other.1)
    }
}

impl<M: Mask> Mask for PairMask<M> {
    const LANES: u32 = 2 * M::LANES;

    #[inline(always)]
    fn bits(self) -> u32 {
        self.0.bits() | self.1.bits() << M::LANES
    }
    #[inline(always)]
    fn of_bits(bits: u32) -> Self {
        Self(M::of_bits(bits), M::of_bits(bits >> M::LANES))
    }
}

macro_rules! row_of_two {
    ($half:literal, $whole:literal) => {
        impl<R: Row<$half>> Row<$whole> for Pair<R> {
            #[inline(always)]
            fn load(values: &[f32; $whole]) -> Self {
                let (halves, _) = values.as_chunks::<$half>();
                Self(R::load(&halves[0]), R::load(&halves[1]))
            }
            #[inline(always)]
            fn load_bits(bits: &[u32; $whole]) -> Self {
                let (halves, _) = bits.as_chunks::<$half>();
                Self(R::load_bits(&halves[0]), R::load_bits(&halves[1]))
            }
            #[inline(always)]
            fn store(self, values: &mut [f32; $whole]) {
                let (halves, _) = values.as_chunks_mut::<$half>();
                self.0.store(&mut halves[0]);
                self.1.store(&mut halves[1]);
            }
            #[inline(always)]
            fn of_records(records: [&[f32; 8]; $whole]) -> [Self; 8] {
                let (halves, _) = records.as_chunks::<$half>();
                let (low, high) = (R::of_records(halves[0]), R::of_records(halves[1]));
                let mut rows = [Self(low[0], high[0]); 8];
                let mut i = 1;
                while i < 8 {
                    rows[i] = Self(low[i], high[i]);
                    i += 1;
                }
                rows
            }
            #[inline(always)]
            fn smallest(self) -> f32 {
                self.0.min(self.1).smallest()
            }
            #[inline(always)]
            fn largest(self) -> f32 {
                self.0.max(self.1).largest()
            }
            #[inline(always)]
            fn slab(planes: Self, inv_dir: Self, offset: Self) -> Self {
                Self(R::slab(planes.0, inv_dir.0, offset.0), R::slab(planes.1, inv_dir.1, offset.1))
            }
        }
    };
}

row_of_two!(4, 8);
row_of_two!(8, 16);
#[cfg(target_arch = "x86_64")]
row_of_two!(16, 32);
