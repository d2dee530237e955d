//! The exponent of highlights, and powers that are equal on every machine.

use crate::math::Lanes;

/// The exponent of a highlight.
///
/// Whole ones, which nearly all scenes use, are multiplied out; others go through `libm`. The
/// result is the same on every machine, which the C library's power is not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Exponent {
    /// A whole number.
    Whole(u32),
    /// Any other, and large ones.
    Other(f32),
}

impl Exponent {
    /// The exponent `exponent` ≥ 0.
    pub(super) fn new(exponent: f32) -> Self {
        const LARGEST_WHOLE: f32 = 4096.0;
        if exponent.fract() != 0.0 || exponent > LARGEST_WHOLE {
            Self::Other(exponent)
        } else {
            Self::Whole(exponent as u32)
        }
    }

    /// A base between 0 and 1 to this power.
    #[inline]
    pub(super) fn power(self, base: f32) -> f32 {
        match self {
            Self::Whole(exponent) => whole_power(base, exponent, 1.0),
            Self::Other(exponent) => libm::powf(base, exponent),
        }
    }
}

/// Bases to a whole power, by squares; `one` has a 1 in every lane.
#[inline(always)]
pub(super) fn whole_power<L: Lanes>(base: L, exponent: u32, one: L) -> L {
    let (mut square, mut product, mut rest) = (base, one, exponent);
    while rest > 0 {
        if rest & 1 == 1 {
            product = product * square;
        }
        square = square * square;
        rest >>= 1;
    }
    product
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_powers() {
        for (base, exponent) in
            [(0.5f64, 3.0f32), (0.9, 100.0), (0.99, 2.5), (0.0, 0.0), (0.0, 5.0), (1.0, 9.0)]
        {
            let expected = base.powf(f64::from(exponent));
            let power = Exponent::new(exponent).power(base as f32);
            assert!((f64::from(power) - expected).abs() < 1e-6);
        }
    }
}
