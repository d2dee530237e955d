//! What a kernel needs of an instruction set.

use glam::Vec4;

use crate::math::{Lanes, Lanes3, Mask as _};

/// `N` lanes that are loaded from memory and stored to it.
pub trait Row<const N: usize>: Lanes {
    /// The values of an array.
    fn load(values: &[f32; N]) -> Self;
    /// The values whose bits are in an array.
    fn load_bits(bits: &[u32; N]) -> Self;
    /// Writes the lanes to an array.
    fn store(self, values: &mut [f32; N]);
    /// `N` records of eight floats as eight rows, the first of which has all first floats.
    fn of_records(records: [&[f32; 8]; N]) -> [Self; 8];
    /// The smallest lane; of numbers alone.
    fn smallest(self) -> f32;
    /// The largest lane; of numbers alone.
    fn largest(self) -> f32;
    /// The first of the lanes of a mask, not empty, that hold the smallest value.
    #[inline(always)]
    fn first_smallest(self, mask: u32) -> usize {
        let smallest = self.select(mask, Self::splat(f32::INFINITY)).smallest();
        (mask & self.le(Self::splat(smallest)).bits()).trailing_zeros() as usize
    }
    /// Where a ray meets planes: `plane·inv_dir − offset` rounded once where the instruction set
    /// fuses, `(plane − offset)·inv_dir` where it does not: see [`Simd::FUSES`].
    fn slab(planes: Self, inv_dir: Self, offset: Self) -> Self;
}

/// The same vector in every lane.
#[inline(always)]
pub fn splat3<R: Lanes>([x, y, z]: [f32; 3]) -> Lanes3<R> {
    [R::splat(x), R::splat(y), R::splat(z)]
}

/// The lanes of [`Simd::F16`]: so many rays, or surfaces, are computed with together.
pub const LANES: usize = 16;

/// The most rays of a packet.
pub const LARGEST_PACKET: usize = 32;

/// A computation with packets of rays, `N` of them in a row: what [`Simd::in_packets`] runs.
pub trait PacketKernel {
    /// What it returns.
    type Output;
    /// Computes. Inlined, as [`Kernel::run`](super::Kernel::run) is.
    fn run<S: Simd, R: Row<N>, const N: usize>(self) -> Self::Output;
}

/// An instruction set. Its types cannot be named outside of this layer: a kernel gets them from
/// [`dispatch`](super::dispatch), which has checked that the processor has them.
pub trait Simd: Copy + Send + Sync + 'static {
    /// Eight floats.
    type F8: Row<8>;
    /// Sixteen floats.
    type F16: Row<LANES>;

    /// Up to eight lanes in an order: what [`Simd::crossed`] gives.
    type Crossed: Copy;

    /// Whether [`Row::slab`] takes the product of origin and inverse direction as its offset (the
    /// fused form) or the origin.
    const FUSES: bool;

    /// Runs a kernel with packets of as many rays as suit the instruction set.
    fn in_packets<K: PacketKernel>(kernel: K) -> K::Output;

    /// The lower and the upper four lanes.
    fn halves(row: Self::F8) -> [Vec4; 2];
    /// Eight rows, the first of which has all first floats of eight records, as these records, or the other way round.
    fn transpose_eight(rows: [Self::F8; 8]) -> [Self::F8; 8];

    /// The highest bits of eight words, word 0's the lowest.
    fn signs(words: &[u32; 8]) -> u32;
    /// A bit for each of eight words that equals one.
    fn equal(words: &[u32; 8], word: u32) -> u32;

    /// Moves the values with a one in the mask to the front of `kept`; what stands behind them is
    /// not specified.
    fn compress(mask: u32, values: &[u32; 8], kept: &mut [u32; 8]);
    /// As [`Simd::compress`], for floats.
    fn compress_floats(mask: u32, values: Self::F8, kept: &mut [f32; 8]);

    /// Puts what is to be entered on a stack, in the order that `order` has at bit `shift`: place
    /// `i` is taken by lane `order[i] >> shift & 7`. Lanes with `near ≤ far` are entered. Returns
    /// how many there are; what stands behind them is not specified.
    fn enter(
        near: Self::F8,
        far: Self::F8,
        children: &[u32; 8],
        order: &[u32; 8],
        shift: u32,
        entries: &mut [u32; 8],
        distances: &mut [f32; 8],
    ) -> u32;

    /// The lanes with `near ≤ far` in that order, and how many there are.
    fn crossed(near: Self::F8, far: Self::F8, order: &[u32; 8], shift: u32)
    -> (Self::Crossed, u32);
    /// One of these lanes by its number, below eight.
    fn crossed_lane(crossed: &Self::Crossed, number: u32) -> usize;
}

#[cfg(test)]
mod tests {
    use super::super::{Kernel, dispatch};
    use super::*;
    use crate::math::{LaneFormula, Random};

    struct Crossed<'a>([f32; 8], [f32; 8], &'a [u32; 8], u32);

    impl Kernel for Crossed<'_> {
        type Output = Vec<usize>;

        #[inline(always)]
        fn run<S: Simd>(self) -> Vec<usize> {
            let Self(near, far, order, shift) = self;
            let (crossed, count) = S::crossed(S::F8::load(&near), S::F8::load(&far), order, shift);
            (0..count).map(|number| S::crossed_lane(&crossed, number)).collect()
        }
    }

    #[test]
    fn lanes_that_are_crossed_keep_their_order() {
        let mut random = Random::new(&[19]);
        for _ in 0..1000 {
            let mut row = || std::array::from_fn(|_| random.next_f32());
            let (near, far): ([f32; 8], [f32; 8]) = (row(), row());
            let mut lanes = [0, 1, 2, 3, 4, 5, 6, 7];
            lanes.sort_by_key(|_| random.below(1000));
            let shift = 3 * random.below(8);
            let order =
                lanes.map(|lane: u32| lane << shift | random.below(1 << 24) & !(7 << shift));
            let met = |&lane: &usize| near[lane] <= far[lane];
            let expected: Vec<_> =
                lanes.map(|lane| lane as usize).into_iter().filter(met).collect();
            assert_eq!(dispatch(Crossed(near, far, &order, shift)), expected);
        }
    }

    struct Choose([f32; 32], u32);

    impl Kernel for Choose {
        type Output = (u32, [Vec<f32>; 2]);

        #[inline(always)]
        fn run<S: Simd>(self) -> Self::Output {
            S::in_packets(self)
        }
    }

    impl PacketKernel for Choose {
        type Output = (u32, [Vec<f32>; 2]);

        #[inline(always)]
        fn run<S: Simd, R: Row<N>, const N: usize>(self) -> Self::Output {
            let values = R::load(self.0.first_chunk().expect("no packet is larger"));
            let (of_bits, half) = (R::Mask::of_bits(self.1), R::splat(0.5));
            let [mut by_bits, mut by_comparison] = [[0.0; N]; 2];
            values.select(self.1, half).store(&mut by_bits);
            values.select_where(values.lt(half), half).store(&mut by_comparison);
            (of_bits.bits(), [by_bits.to_vec(), by_comparison.to_vec()])
        }
    }

    #[test]
    fn lanes_are_chosen_by_bits_and_by_comparisons() {
        let mut random = Random::new(&[21]);
        for _ in 0..1000 {
            let values: [f32; 32] = std::array::from_fn(|_| random.next_f32());
            let bits = random.below(u32::MAX);
            let (again, [by_bits, by_comparison]) = dispatch(Choose(values, bits));
            let lanes = by_bits.len();
            assert_eq!(again, bits & u32::MAX >> (32 - lanes));
            for lane in 0..lanes {
                let chosen = if bits >> lane & 1 != 0 { values[lane] } else { 0.5 };
                assert_eq!(by_bits[lane], chosen);
                assert_eq!(by_comparison[lane], values[lane].min(0.5));
            }
        }
    }

    /// A formula with a mask.
    struct Quotient(f32);

    impl LaneFormula<2, 1> for Quotient {
        #[inline(always)]
        fn apply<L: Lanes>(&self, &[a, b]: &[L; 2]) -> ([L; 1], L::Mask) {
            ([(a + L::splat(self.0)) / b], a.lt(b))
        }
    }

    struct Apply([[f32; 32]; 2]);

    impl Kernel for Apply {
        type Output = (Vec<f32>, u32);

        #[inline(always)]
        fn run<S: Simd>(self) -> Self::Output {
            S::in_packets(self)
        }
    }

    impl PacketKernel for Apply {
        type Output = (Vec<f32>, u32);

        #[inline(always)]
        fn run<S: Simd, R: Row<N>, const N: usize>(self) -> Self::Output {
            let row =
                |values: &[f32; 32]| R::load(values.first_chunk().expect("no packet is larger"));
            let ([quotient], mask) = R::apply(&Quotient(3.0), &[row(&self.0[0]), row(&self.0[1])]);
            let mut values = [0.0; N];
            quotient.store(&mut values);
            (values.to_vec(), mask.bits())
        }
    }

    #[test]
    fn a_formula_is_the_same_register_by_register() {
        let mut random = Random::new(&[20]);
        let mut row = || std::array::from_fn(|_| 0.1 + random.next_f32());
        let [a, b]: [[f32; 32]; 2] = [row(), row()];
        let (quotients, mask) = dispatch(Apply([a, b]));
        for (lane, quotient) in quotients.into_iter().enumerate() {
            assert_eq!(quotient, (a[lane] + 3.0) / b[lane]);
            assert_eq!(mask >> lane & 1 != 0, a[lane] < b[lane]);
        }
    }
}
