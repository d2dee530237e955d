//! Rays on their way into a wave, eight at a time.

use crate::accel::PACK;
use crate::math::Ray;
use crate::simd::{Cache, prefetch};

use super::super::diverged::{Diverged, DivergedRay};

/// So many rays before they come, rays are asked for.
const RAYS_AHEAD: usize = 64;

/// Rays that are not yet in flight.
pub(super) struct Incoming<'a> {
    /// Those that begin with the root, by their places in the slice.
    fresh: &'a [u32],
    /// Those that a packet has set aside; they come after the others.
    diverged: &'a Diverged,
    /// How many were taken.
    taken: usize,
}

/// Up to eight rays that come next.
pub(super) struct Eight {
    /// Their places in the slice. If they are fewer, the last one comes several times.
    pub(super) index: [u32; PACK],
    /// How many they are.
    pub(super) count: usize,
    /// The number of the first of them, among all that come.
    number: usize,
}

/// How a ray begins.
pub(super) enum Arrival<'a> {
    /// A ray of usual terms, by its place in the slice, at the root.
    AtRoot(u32),
    /// Any other.
    Elsewhere {
        /// Its place in the slice.
        ray: u32,
        /// What it has done on its way, if it has begun.
        begun: Option<&'a DivergedRay>,
        is_usual: bool,
    },
}

/// Set in the number of a ray whose terms are not the usual ones.
const UNUSUAL: u32 = 1 << 31;

impl Eight {
    /// Their numbers among all that come, from which [`Incoming::arrival`] tells how they begin. `usual` has a bit for
    /// each ray of usual terms.
    #[inline(always)]
    pub(super) fn numbers(&self, usual: u32) -> [u32; PACK] {
        let mut numbers = [0; PACK];
        for (lane, number) in numbers.iter_mut().enumerate() {
            let mark = if usual >> lane & 1 == 0 { UNUSUAL } else { 0 };
            *number = (self.number + lane) as u32 | mark;
        }
        numbers
    }
}

impl<'a> Incoming<'a> {
    pub(super) fn new(fresh: &'a [u32], diverged: &'a Diverged) -> Self {
        Self { fresh, diverged, taken: 0 }
    }

    /// The next eight rays, or those that are left; `None` if there are none.
    #[inline(always)]
    pub(super) fn next_eight(&mut self) -> Option<Eight> {
        let number = self.taken;
        if let Some(index) = self.fresh[number.min(self.fresh.len())..].first_chunk() {
            self.taken += PACK;
            return Some(Eight { index: *index, count: PACK, number });
        }
        let left = self.fresh.len() + self.diverged.rays().len() - number;
        let count = left.min(PACK);
        self.taken += count;
        let mut index = [0; PACK];
        for (place, index) in index.iter_mut().enumerate().take(PACK * usize::from(left > 0)) {
            *index = self.ray(number + place.min(count - 1)).0;
        }
        (left > 0).then_some(Eight { index, count, number })
    }

    /// Asks for rays that come soon after these.
    #[inline(always)]
    pub(super) fn prefetch_ahead(&self, eight: &Eight, rays: &[Ray]) {
        // Fresh rays are neighbours, mostly.
        if let Some(&first) = self.fresh.get(eight.number + RAYS_AHEAD)
            && let Some(ahead) = rays[first as usize..].first_chunk::<PACK>()
        {
            prefetch(ahead, Cache::First);
        }
    }

    /// Those of eight rays that have not begun, a bit for each.
    #[inline(always)]
    pub(super) fn fresh_of(&self, eight: &Eight) -> u32 {
        let count = self.fresh.len().saturating_sub(eight.number).min(eight.count);
        (1 << count) - 1
    }

    /// How a ray begins, by its number in [`Eight::numbers`].
    #[inline(always)]
    pub(super) fn arrival(&self, number: u32) -> Arrival<'a> {
        // A mark makes the number larger than any of those that are fresh.
        if let Some(&ray) = self.fresh.get(number as usize) {
            return Arrival::AtRoot(ray);
        }
        let (ray, begun) = self.ray((number & !UNUSUAL) as usize);
        Arrival::Elsewhere { ray, begun, is_usual: number & UNUSUAL == 0 }
    }

    /// A ray by its number: its place in the slice, and what it has done if it has begun.
    #[inline(always)]
    fn ray(&self, number: usize) -> (u32, Option<&'a DivergedRay>) {
        match self.fresh.get(number) {
            Some(&index) => (index, None),
            None => {
                let ray = &self.diverged.rays()[number - self.fresh.len()];
                (ray.ray, Some(ray))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::node::Child;
    use super::*;
    use crate::math::Hit;

    #[test]
    fn rays_come_one_after_the_other_those_that_diverged_last() {
        let mut diverged = Diverged::default();
        for ray in [3, 1, 20] {
            diverged.add(ray, Hit::MISS, [(Child::ROOT, 0.0)].into_iter());
        }
        for count in [0, 1, 8, 9, 30] {
            let fresh: Vec<u32> = (0..count).map(|i| 39 - i).collect();
            let mut incoming = Incoming::new(&fresh, &diverged);
            let mut taken = Vec::new();
            while let Some(eight) = incoming.next_eight() {
                assert!(
                    eight.index[eight.count..].iter().all(|&i| i == eight.index[eight.count - 1])
                );
                // Those whose places are multiples of three are not usual.
                let is_usual = |ray: u32| !ray.is_multiple_of(3);
                let usual =
                    (0..PACK).map(|i| u32::from(is_usual(eight.index[i])) << i).sum::<u32>();
                for (lane, number) in eight.numbers(usual).into_iter().enumerate().take(eight.count)
                {
                    let fresh = incoming.fresh_of(&eight) >> lane & 1 != 0;
                    let (ray, begun) = match incoming.arrival(number) {
                        Arrival::AtRoot(ray) => {
                            assert!(fresh && is_usual(ray));
                            (ray, false)
                        }
                        Arrival::Elsewhere { ray, begun, is_usual: usual } => {
                            assert_eq!(usual, is_usual(ray));
                            assert_eq!(begun.is_some(), !fresh);
                            assert!(!(fresh && usual));
                            (ray, begun.is_some())
                        }
                    };
                    assert_eq!(ray, eight.index[lane]);
                    taken.push((ray, begun));
                }
            }
            let expected: Vec<_> =
                fresh.iter().map(|&i| (i, false)).chain([3, 1, 20].map(|i| (i, true))).collect();
            assert_eq!(taken, expected);
        }
    }
}
