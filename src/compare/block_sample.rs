//! Which of a class's rays a round traces: all of them, or a stratified random sample of blocks.
//!
//! A structure that is too slow for all rays in every round traces blocks of consecutive rays, as a renderer sends
//! them: single rays, evenly spread, would share neither caches nor work. The rays are divided into as many equal parts
//! (strata) as there are blocks, and a block is drawn from each, anew for each round. So every round is an unbiased
//! estimate for all rays, and the differences between rounds contain what the choice of blocks adds
//! (`analysis/statistics/replicates.rs`).
//!
//! Samples are nested: of two structures, the blocks of the one with fewer or smaller blocks lie within those of the
//! other, so that what a block costs more than another cancels in their ratio. For that, a place in the sequence of
//! rays is drawn digit by digit, from the coarsest part to the finest, each digit by the random number of its part:
//! the part that is drawn by itself in a coarse sample is drawn in a finer one, too.
//!
//! Before a block is timed, those before it are traced, so that caches are as warm as in the middle of all rays: for as
//! long as it takes to fill them, since a block of a fast structure is too short for that. Before all rays are, the
//! last few thousand of them are: a class of a few hundred rays would else find what the other structures have left in
//! the caches, and its time would depend on their number.

use std::ops::Range;
use std::time::Duration;

use crate::math::Random;

use super::trace::RAYS_PER_CALL;

/// Rays of the smallest block: the width of the narrowest packet that a structure traces together.
const SMALLEST_BLOCK: usize = 8;

/// Blocks become larger, up to a renderer's call, only where there are still as many.
const WANTED_BLOCKS: usize = 16;

/// With fewer blocks a class is not measured.
const FEWEST_BLOCKS: usize = 2;

/// Before a block is timed, rays are traced for at least as long: what a second-level cache of two megabytes takes to
/// be filled from main memory at ten gigabytes a second. With as many rays as are timed, and no more, blocks of 64 rays
/// of a fast tree took up to 1.5 times as long a ray as all rays do.
const WARMUP_TIME: Duration = Duration::from_micros(200);

/// Traced, at most, before all rays are timed: some hundred microseconds of a tree.
const WHOLE_WARMUP: usize = 4 * RAYS_PER_CALL;

/// Binary digits of a place.
const DIGITS: u32 = 32;

/// Keeps its random numbers apart from others of the same seed.
const STREAM: u64 = 0x626c_6f63_6b73;

/// The rays of a round.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sample {
    /// All.
    Whole,
    /// A power of two of blocks of consecutive rays, each after some that warm up.
    Blocks { size: usize, count: usize, warmup: usize },
}

/// A block of a sample, as places of rays.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Block {
    /// What is traced before, to warm the caches.
    pub(super) warmup: Range<usize>,
    /// What is timed.
    pub(super) timed: Range<usize>,
}

impl Sample {
    /// The largest sample of `rays` rays, each of which takes so long, for which no more than `affordable` are traced;
    /// `None` if that is too small to say anything.
    pub(super) fn that_fits(rays: usize, affordable: usize, ray_time: Duration) -> Option<Self> {
        if affordable >= Self::Whole.traced_rays(rays) {
            return Some(Self::Whole);
        }
        let most = RAYS_PER_CALL.min(rays / FEWEST_BLOCKS);
        if most < SMALLEST_BLOCK {
            return None;
        }
        let in_that_time = WARMUP_TIME.as_nanos() / ray_time.as_nanos().max(1);
        let in_that_time =
            usize::try_from(in_that_time).map_or(WHOLE_WARMUP, |n| n.min(WHOLE_WARMUP));
        let warmup = |size: usize| size.max(in_that_time).min(rays - size);
        let fits = |size: &usize| WANTED_BLOCKS * (size + warmup(*size)) <= affordable;
        // What is timed shall be no less than half of what warms up.
        let least = (in_that_time / 2).clamp(SMALLEST_BLOCK, most);
        let sizes = (least.ilog2()..=most.ilog2()).map(|power| 1 << power);
        let size = sizes.rev().find(fits).unwrap_or(1 << least.ilog2());
        let count = affordable / (size + warmup(size));
        let blocks = || Self::Blocks { size, count: 1 << count.ilog2(), warmup: warmup(size) };
        (count >= FEWEST_BLOCKS).then(blocks)
    }

    /// How many rays of `rays` a round times.
    pub(super) fn timed_rays(self, rays: usize) -> usize {
        match self {
            Self::Whole => rays,
            Self::Blocks { size, count, .. } => size * count,
        }
    }

    /// How many rays of `rays` a round traces, those that warm up included.
    pub(super) fn traced_rays(self, rays: usize) -> usize {
        match self {
            Self::Whole => rays + rays.min(WHOLE_WARMUP),
            Self::Blocks { size, count, warmup } => (size + warmup) * count,
        }
    }

    /// The blocks of a round, in the order of the rays.
    pub(super) fn draw(self, rays: usize, seed: u64, round: usize) -> Vec<Block> {
        match self {
            Self::Whole => {
                let warmup = rays - rays.min(WHOLE_WARMUP)..rays;
                vec![Block { warmup, timed: 0..rays }]
            }
            Self::Blocks { size, count, warmup } => {
                let block = |stratum| {
                    let place = place(seed, round, count.ilog2(), stratum, rays);
                    // The block around the place, aligned, so that smaller blocks lie within larger ones.
                    let start = (place / size * size).min(rays - size);
                    // The first blocks have not as many before them: the last rays warm them up.
                    let before = if start >= warmup { start - warmup } else { rays - warmup };
                    Block { warmup: before..before + warmup, timed: start..start + size }
                };
                (0..count).map(block).collect()
            }
        }
    }
}

/// A uniformly distributed ray of the stratum, of `2^level` strata.
fn place(seed: u64, round: usize, level: u32, stratum: usize, rays: usize) -> usize {
    let mut position = stratum as u64;
    for depth in level..DIGITS {
        // The digit belongs to the part at this depth, however it was reached.
        let mut random = Random::new(&[seed, STREAM, round as u64, u64::from(depth), position]);
        position = 2 * position + u64::from(random.below(2));
    }
    ((u128::from(position) * rays as u128) >> DIGITS) as usize
}

/// Divides time among tasks that need so much each: whoever needs less than an even share of what is left gets what it
/// needs, and the others share the rest.
pub(super) fn shares(needs: &[Duration], time: Duration) -> Vec<Duration> {
    let mut order: Vec<usize> = (0..needs.len()).collect();
    order.sort_by_key(|&task| needs[task]);
    let (mut left, mut shares) = (time, vec![Duration::ZERO; needs.len()]);
    for (done, &task) in order.iter().enumerate() {
        let even = left.div_f64((needs.len() - done) as f64);
        shares[task] = needs[task].min(even);
        left = left.saturating_sub(shares[task]);
    }
    // The slowest may have what is left over.
    if let Some(&last) = order.last() {
        shares[last] = shares[last].saturating_add(left);
    }
    shares
}

#[cfg(test)]
mod tests {
    use super::*;

    const RAYS: usize = 40 * RAYS_PER_CALL;

    #[test]
    fn a_sample_fits_and_grows_by_blocks_then_by_their_size() {
        let slow = Duration::from_millis(1);
        let sample = |affordable| Sample::that_fits(RAYS, affordable, slow);
        let blocks = |size, count| Some(Sample::Blocks { size, count, warmup: size });
        assert_eq!(sample(31), None);
        assert_eq!(sample(32), blocks(8, 2));
        assert_eq!(sample(256), blocks(8, 16));
        assert_eq!(sample(2_048), blocks(64, 16));
        let whole = Sample::Whole.traced_rays(RAYS);
        assert_eq!(whole, RAYS + WHOLE_WARMUP);
        assert_eq!(sample(whole - 1), blocks(1_024, 16));
        assert_eq!(sample(whole), Some(Sample::Whole));
        assert_eq!(Sample::that_fits(10, 19, slow), None, "fewer rays than two blocks");
        assert_eq!(Sample::that_fits(10, 20, slow), Some(Sample::Whole));
        assert_eq!(Sample::that_fits(0, 0, slow), Some(Sample::Whole));
    }

    #[test]
    fn a_fast_structure_warms_up_for_longer_than_a_block_and_is_timed_for_half_as_long() {
        let sample = |affordable, nanoseconds| {
            Sample::that_fits(RAYS, affordable, Duration::from_nanos(nanoseconds))
        };
        // Five microseconds a ray: 40 of them.
        let expected = Sample::Blocks { size: 16, count: 16, warmup: 40 };
        assert_eq!(sample(1_024, 5_000), Some(expected));
        let expected = Sample::Blocks { size: 64, count: 16, warmup: 64 };
        assert_eq!(sample(2_048, 5_000), Some(expected));
        // A fifth of a microsecond: 1000 of them, before blocks of 256 at least.
        let expected = Sample::Blocks { size: 256, count: 4, warmup: 1_000 };
        assert_eq!(sample(10_000, 200), Some(expected));
        let few = Sample::that_fits(600, 700, Duration::from_nanos(200));
        assert_eq!(few, None, "two blocks of 256 and what warms them up");
        for block in expected.draw(RAYS, 3, 7) {
            let before = if block.timed.start < 1_000 { RAYS } else { block.timed.start };
            assert_eq!(block.warmup, before - 1_000..before);
        }
    }

    #[test]
    fn a_round_draws_one_block_from_each_stratum_and_warms_up_by_the_one_before() {
        let sample = Sample::Blocks { size: 64, count: 16, warmup: 64 };
        assert_eq!(sample.timed_rays(RAYS), 1_024);
        let blocks = sample.draw(RAYS, 3, 7);
        assert_eq!(blocks.len(), 16);
        for (block, stratum) in blocks.iter().zip(0..) {
            let Range { start, end } = block.timed;
            assert!(start % 64 == 0 && end == start + 64);
            let (from, to) = (stratum * RAYS / 16, (stratum + 1) * RAYS / 16);
            assert!(start >= from && end <= to, "{start} of {from}..{to}");
            let before = if start == 0 { RAYS } else { start };
            assert_eq!(block.warmup, before - 64..before);
        }
        assert_ne!(blocks, sample.draw(RAYS, 3, 8), "each round draws anew");
        assert_ne!(blocks, sample.draw(RAYS, 4, 7), "by the seed");
    }

    #[test]
    fn all_rays_come_after_the_last_few_thousand_of_them() {
        let block = |rays| Sample::Whole.draw(rays, 0, 0).pop().unwrap();
        assert_eq!(block(RAYS), Block { warmup: RAYS - WHOLE_WARMUP..RAYS, timed: 0..RAYS });
        assert_eq!(block(865), Block { warmup: 0..865, timed: 0..865 }, "all of a few");
    }

    #[test]
    fn the_blocks_of_a_smaller_sample_lie_within_those_of_a_larger_one() {
        let larger = Sample::Blocks { size: 256, count: 32, warmup: 256 }.draw(RAYS, 1, 2);
        for smaller in [(256, 8), (8, 32), (32, 4)] {
            let (size, count) = smaller;
            for block in (Sample::Blocks { size, count, warmup: 40 }).draw(RAYS, 1, 2) {
                let within = |of: &Block| {
                    of.timed.start <= block.timed.start && of.timed.end >= block.timed.end
                };
                assert!(larger.iter().any(within), "{smaller:?} {block:?}");
            }
        }
    }

    /// Also where strata do not end between blocks: every ray is drawn equally often, so means are unbiased.
    #[test]
    fn every_block_is_drawn_as_often_as_any_other() {
        let (rays, size, count) = (11 * 8, 8, 4);
        let mut drawn = [0_u32; 11];
        for round in 0..11_000 {
            for block in (Sample::Blocks { size, count, warmup: 8 }).draw(rays, 9, round) {
                drawn[block.timed.start / size] += 1;
            }
        }
        // 44,000 draws: 4000 of each, with a standard deviation of at most 61.
        assert!(drawn.iter().all(|n| n.abs_diff(4_000) < 250), "{drawn:?}");
    }

    #[test]
    fn quick_tasks_leave_their_time_to_slow_ones() {
        let ms = Duration::from_millis;
        assert_eq!(shares(&[ms(1), ms(90), ms(40)], ms(61)), [ms(1), ms(30), ms(30)]);
        assert_eq!(shares(&[ms(1), ms(2)], ms(10)), [ms(1), ms(9)]);
        assert_eq!(shares(&[], ms(10)), [] as [Duration; 0]);
    }
}
