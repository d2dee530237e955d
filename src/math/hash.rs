//! Random numbers that depend on what they are for, and on nothing else.
//!
//! A sample is a function of (seed, pixel, sample index), so neither threads, tiles, crops nor
//! structures change a picture. The mixer is the finalizer of SplitMix64 (Steele, Lea, Flood:
//! *Fast splittable pseudorandom number generators*, OOPSLA 2014; constants of Stafford's mix 13).

const GOLDEN_GAMMA: u64 = 0x9E37_79B9_7F4A_7C15;

/// Mixes 64 bits: a bijection in which every bit of the input changes half the bits of the output.
#[inline]
#[must_use]
pub(crate) fn hash_u64(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

/// A stream of random numbers that starts at a key: SplitMix64.
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// The stream that belongs to a list of numbers, in this order.
    #[inline]
    #[must_use]
    pub fn new(key: &[u64]) -> Self {
        let fold = |state: u64, part: &u64| hash_u64(state.wrapping_add(GOLDEN_GAMMA) ^ part);
        Self(key.iter().fold(0, fold))
    }

    /// 64 random bits.
    #[inline]
    pub fn next_u64(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(GOLDEN_GAMMA);
        hash_u64(self.0)
    }

    /// Leaves out so many steps of the stream.
    #[inline]
    pub fn skip(&mut self, steps: u64) {
        self.0 = self.0.wrapping_add(GOLDEN_GAMMA.wrapping_mul(steps));
    }

    /// Uniform in [0, 1), on a grid of 2⁻²⁴.
    #[inline]
    pub fn next_f32(&mut self) -> f32 {
        unit_f32((self.next_u64() >> 40) as u32)
    }

    /// Two numbers uniform in [0, 1), from one step of the stream.
    #[inline]
    pub fn next_pair(&mut self) -> [f32; 2] {
        unit_pair(self.next_u64())
    }

    /// Uniform in 0..n for n > 0 (by multiplication: Lemire, *Fast random integer generation in an
    /// interval*, 2019; the bias of at most n·2⁻³² is left in).
    #[inline]
    pub fn below(&mut self, n: u32) -> u32 {
        ((u64::from((self.next_u64() >> 32) as u32) * u64::from(n)) >> 32) as u32
    }
}

/// Two numbers uniform in [0, 1), on a grid of 2⁻²⁴, from 64 random bits.
#[inline]
#[must_use]
pub(crate) fn unit_pair(bits: u64) -> [f32; 2] {
    [unit_f32((bits >> 40) as u32), unit_f32((bits >> 8) as u32 & 0x00FF_FFFF)]
}

/// 24 random bits as a float in [0, 1).
#[inline]
fn unit_f32(bits: u32) -> f32 {
    bits as f32 * (1.0 / 16_777_216.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn splitmix64_gives_its_published_first_numbers() {
        // The reference implementation seeded with 1234567.
        let mut r = Random(1_234_567);
        assert_eq!(r.next_u64(), 6_457_827_717_110_365_317);
        assert_eq!(r.next_u64(), 3_203_168_211_198_807_973);
    }

    #[test]
    fn steps_are_left_out_as_if_they_were_taken() {
        let (mut walked, mut skipped) = (Random::new(&[5]), Random::new(&[5]));
        for _ in 0..1_000 {
            walked.next_u64();
        }
        skipped.skip(1_000);
        assert_eq!(walked.next_u64(), skipped.next_u64());
    }

    #[test]
    fn uniform_numbers_have_the_mean_and_variance_of_the_uniform_distribution() {
        let mut r = Random::new(&[1, 2, 3]);
        let n = 100_000;
        let (mut sum, mut squares) = (0.0, 0.0);
        for _ in 0..n {
            let x = f64::from(r.next_f32());
            assert!((0.0..1.0).contains(&x));
            sum += x;
            squares += x * x;
        }
        let mean = sum / f64::from(n);
        let variance = squares / f64::from(n) - mean * mean;
        assert!((mean - 0.5).abs() < 0.005, "mean {mean}");
        assert!((variance - 1.0 / 12.0).abs() < 0.002, "variance {variance}");
    }

    #[test]
    fn below_reaches_every_value_about_equally_often() {
        let mut r = Random::new(&[7]);
        let mut seen = [0u32; 10];
        for _ in 0..10_000 {
            seen[r.below(10) as usize] += 1;
        }
        assert!(seen.iter().all(|&n| (850..1150).contains(&n)), "{seen:?}");
    }

    #[test]
    fn keys_differ_by_order_and_by_length() {
        let first = |key: &[u64]| Random::new(key).next_u64();
        assert_ne!(first(&[1, 2]), first(&[2, 1]));
        assert_ne!(first(&[0]), first(&[0, 0]));
    }
}
