//! The split of a node: all of a few primitives' places are weighed, more are binned, and of many a
//! sample is.

use glam::Vec4;

use crate::math::Lanes as _;
use crate::simd::{Kernel, Row as _, Simd};

use super::bins::{Bins, Grid};
use super::reference::{Centers, Corners, NOWHERE, Reference};
use super::sorted::{FEW, sort_and_part};
use super::sweep::{Best, LONGEST, Line, MOST_COUNTED, NOTHING, Sweep};
use super::terms::{Effort, Terms};

/// Of so many primitives or fewer the box around the centres is found anew, if all axes are looked at.
const TIGHT: usize = 32;

/// Memory that splits need.
pub(super) struct Scratch {
    bins: Bins,
    line: Line,
    sweep: Sweep,
}

impl Scratch {
    pub(super) fn new() -> Box<Self> {
        Box::new(Self { bins: Bins::EMPTY, line: [NOTHING; LONGEST], sweep: Sweep::NEW })
    }
}

/// Parts a node's primitives at the best place. Where there is none, the count is 0.
pub(super) struct Splitting<'a> {
    pub(super) references: &'a mut [Reference],
    /// A box around twice the centres, which may be larger; of few primitives it means nothing.
    pub(super) centers: &'a Centers,
    pub(super) terms: Terms,
    pub(super) scratch: &'a mut Scratch,
}

impl Kernel for Splitting<'_> {
    type Output = (Best, [Centers; 2]);

    #[inline(always)]
    fn run<S: Simd>(self) -> Self::Output {
        let Self { references, centers, terms, scratch } = self;
        let Effort { sample, slack, widest, .. } = terms.effort;
        let Scratch { bins, line, sweep } = scratch;
        let count = references.len();
        if count <= FEW {
            return (sort_and_part::<S>(references, terms, (line, sweep)), [NOWHERE; 2]);
        }
        let mut centers = *centers;
        if count <= TIGHT && !widest {
            centers = around_centers::<S>(references);
        }
        if count >= 2 * sample {
            let grid = Grid::new(centers, sample, widest);
            bins.fill_sample::<S>(references, count / sample, &grid);
            // A sample says nothing of whole packs.
            let mut best = bins.best::<S>(&grid, 0, sweep);
            if best.count > 0 {
                let (front, halves) = part::<S, true>(references, &grid, &best);
                let [sampled, all] =
                    [best.halves, halves].map(|[a, b]| [a.half_area(), b.half_area()]);
                // Boxes that are not finite may all be on one side.
                let parted = 0 < front && front < count;
                if parted && all[0] <= slack * sampled[0] && all[1] <= slack * sampled[1] {
                    (best.count, best.halves) = (front, halves);
                    return (best, grid.halves(&best));
                }
            }
        }
        let grid = Grid::new(centers, count, widest);
        bins.fill::<S>(references, &grid);
        let mut best = bins.best::<S>(&grid, terms.pack_bits, sweep);
        if best.count > 0 && count > MOST_COUNTED {
            let (front, halves) = part::<S, true>(references, &grid, &best);
            (best.count, best.halves) = (if front < count { front } else { 0 }, halves);
        } else if best.count > 0 && part::<S, false>(references, &grid, &best).0 != best.count {
            // Boxes that are not finite may be on either side.
            best.count = 0;
        }
        (best, grid.halves(&best))
    }
}

/// The box around twice the centres of at least four primitives.
#[inline(always)]
fn around_centers<S: Simd>(references: &[Reference]) -> Centers {
    // Four at a time, so that none waits for the one before it; the last four may be some of those before.
    let mut low = [NOWHERE[0]; 4];
    let mut high = [NOWHERE[1]; 4];
    let (fours, _) = references.as_chunks::<4>();
    let last = references.last_chunk::<4>().expect("there are more than a few");
    for four in fours {
        widen::<S>(four, &mut low, &mut high);
    }
    widen::<S>(last, &mut low, &mut high);
    [low[0].min(low[1]).min(low[2].min(low[3])), high[0].max(high[1]).max(high[2].max(high[3]))]
}

#[inline(always)]
fn widen<S: Simd>(four: &[Reference; 4], low: &mut [Vec4; 4], high: &mut [Vec4; 4]) {
    for i in 0..4 {
        let [from, to] = S::halves(S::F8::load(&four[i].0.0));
        (low[i], high[i]) = (low[i].min(to - from), high[i].max(to - from));
    }
}

/// Puts the primitives before a place to the front, and returns how many there are, and the boxes
/// around both parts if they are to be measured.
#[inline(always)]
fn part<S: Simd, const MEASURED: bool>(
    references: &mut [Reference],
    grid: &Grid,
    best: &Best,
) -> (usize, [Corners; 2]) {
    let side = grid.side(best.axis, best.last);
    let mut front = 0;
    let nothing = S::F8::splat(f32::NEG_INFINITY);
    let [mut left, mut right] = [nothing; 2];
    // Each goes to the front, and one that belongs to the back is overwritten by the next that
    // does not: without a branch.
    for i in 0..references.len() {
        let place = side.place(&references[i]);
        let reference = S::F8::load(&references[i].0.0);
        let first = S::F8::load(&references[front].0.0);
        first.store(&mut references[i].0.0);
        reference.store(&mut references[front].0.0);
        if MEASURED {
            let before = side.lanes_before::<S>(place);
            left = left.max(reference.select(before, nothing));
            right = right.max(nothing.select(before, reference));
            front += (before & 1) as usize;
        } else {
            front += usize::from(side.is_before(place));
        }
    }
    let mut halves = [Corners::EMPTY; 2];
    left.store(&mut halves[0].0);
    right.store(&mut halves[1].0);
    (front, halves)
}

#[cfg(test)]
mod tests {
    use super::super::super::Quality;
    use super::super::terms::cost_of;
    use super::*;
    use crate::math::{Aabb, Random};
    use crate::simd::dispatch;
    use glam::Vec3A;

    fn references(count: u32) -> Vec<Reference> {
        let mut random = Random::new(&[11, u64::from(count)]);
        let mut point = || Vec3A::from_array(std::array::from_fn(|_| random.next_f32()));
        (0..count)
            .map(|index| (index, point(), point()))
            .map(|(index, a, b)| Reference::new(index, &Aabb { min: a, max: a + 0.1 * b }))
            .collect()
    }

    fn around(references: &[Reference]) -> Corners {
        references.iter().fold(Corners::EMPTY, |bounds, reference| bounds.union(&reference.0))
    }

    fn split(references: &mut [Reference], pack_bits: u32, quality: Quality) -> Best {
        let effort = Effort::of(quality);
        let centers = references.iter().fold(NOWHERE, |[low, high], reference| {
            [low.min(reference.center()), high.max(reference.center())]
        });
        let scratch = &mut *Scratch::new();
        let terms = Terms { pack_bits, most: 1, effort };
        dispatch(Splitting { references, centers: &centers, terms, scratch }).0
    }

    #[test]
    fn parts_are_those_that_the_split_tells() {
        let qualities = [Quality::Fastest, Quality::Medium];
        let counts = [2, 16, 17, 100, 1000, 4096, 30_000];
        for (count, quality) in counts.into_iter().flat_map(|n| qualities.map(|q| (n, q))) {
            let mut parted = references(count);
            let best = split(&mut parted, 3, quality);
            let mut seen: Vec<_> = parted.iter().map(Reference::index).collect();
            seen.sort_unstable();
            assert!(seen.into_iter().eq(0..count), "each of {count} is there once");
            let (left, right) = parted.split_at(best.count);
            assert!(!left.is_empty() && !right.is_empty());
            let axis = best.axis;
            let last = left.iter().map(|r| r.center()[axis]).fold(f32::MIN, f32::max);
            assert!(right.iter().all(|r| r.center()[axis] >= last));
            let areas = [left, right].map(|part| around(part).half_area());
            assert_eq!(best.halves.map(|half| half.half_area()), areas);
        }
    }

    #[test]
    fn no_split_of_a_few_is_cheaper() {
        for count in 2..=FEW {
            for pack_bits in [0, 3] {
                let mut few = references(count as u32);
                let mut least = f32::INFINITY;
                for axis in 0..3 {
                    few.sort_by(|a, b| a.center()[axis].total_cmp(&b.center()[axis]));
                    for place in 1..count {
                        let (left, right) = few.split_at(place);
                        let cost = |part: &[Reference]| {
                            around(part).half_area() * cost_of(part.len(), pack_bits)
                        };
                        least = least.min(cost(left) + cost(right));
                    }
                }
                let found = split(&mut few, pack_bits, Quality::Medium).cost;
                assert!((found - least).abs() <= 1e-5 * least, "{count}: {found}, {least}");
            }
        }
    }
}
