//! Rays that enter children of the root, and wait until they are eight.
//!
//! Of rays in all directions half meet nothing. What the others need in their slots is worked out for eight of them at
//! a time, so that no lane works for a ray that is already answered.

use crate::accel::PACK;
use crate::math::Lanes as _;
use crate::simd::{Row as _, Simd};

use super::columns::{COLUMNS, Columns};

/// Up to seven that wait, and eight that come.
const PLACES: usize = 2 * PACK;

/// The memory of those that wait.
#[repr(C, align(64))]
pub(super) struct Waiting {
    columns: [[f32; PLACES]; COLUMNS],
    begins: [[f32; PLACES]; PACK],
    numbers: [u32; PLACES],
    length: usize,
}

/// Up to eight rays that can take slots.
pub(super) struct Ready<S: Simd> {
    pub(super) columns: Columns<S>,
    /// Where they enter each child of the root; infinite where they do not. Of no meaning for rays that do not begin
    /// there with usual terms.
    pub(super) begins: [S::F8; PACK],
    /// Their numbers among all that come: see [`Incoming::arrival`](super::incoming::Incoming::arrival).
    pub(super) numbers: [u32; PACK],
    /// How many they are, the first so many.
    pub(super) count: usize,
}

impl Waiting {
    pub(super) const NONE: Self = Self {
        columns: [[0.0; PLACES]; COLUMNS],
        begins: [[0.0; PLACES]; PACK],
        numbers: [0; PLACES],
        length: 0,
    };

    /// Forgets all of them.
    #[inline(always)]
    pub(super) fn clear(&mut self) {
        self.length = 0;
    }

    /// Whether eight more have a place.
    #[inline(always)]
    pub(super) fn has_room(&self) -> bool {
        self.length < PACK
    }

    /// Adds those of eight rays whose bits are set. There must be room.
    #[inline(always)]
    #[allow(clippy::needless_range_loop, reason = "wide values do not go through iterators")]
    pub(super) fn add<S: Simd>(&mut self, which: u32, rays: &Ready<S>) {
        let at = self.length;
        let columns = rays.columns.rows();
        for row in 0..COLUMNS {
            S::compress_floats(which, columns[row], eight(&mut self.columns[row], at));
        }
        for child in 0..PACK {
            S::compress_floats(which, rays.begins[child], eight(&mut self.begins[child], at));
        }
        S::compress(which, &rays.numbers, eight(&mut self.numbers, at));
        self.length = at % PACK + which.count_ones() as usize;
    }

    /// Takes the last eight, or all if they are fewer; `None` if there are none.
    #[inline(always)]
    #[allow(clippy::needless_range_loop, reason = "wide values do not go through iterators")]
    pub(super) fn take<S: Simd>(&mut self) -> Option<Ready<S>> {
        if self.length == 0 {
            return None;
        }
        let count = self.length.min(PACK);
        self.length -= count;
        let at = self.length;
        let (mut columns, mut begins) = ([S::F8::splat(0.0); COLUMNS], [S::F8::splat(0.0); PACK]);
        for row in 0..COLUMNS {
            columns[row] = S::F8::load(eight(&mut self.columns[row], at));
        }
        for child in 0..PACK {
            begins[child] = S::F8::load(eight(&mut self.begins[child], at));
        }
        let numbers = *eight(&mut self.numbers, at);
        Some(Ready { columns: Columns::of_rows(columns), begins, numbers, count })
    }
}

/// Eight places, of which fewer than eight are before.
#[inline(always)]
fn eight<T>(row: &mut [T; PLACES], at: usize) -> &mut [T; PACK] {
    row[at % PACK..]
        .first_chunk_mut()
        .expect("a row has room behind each of the first eight places")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Random;
    use crate::simd::{Kernel, dispatch};

    /// What is kept of a ray: its number among all rows, then the number.
    type Kept = ([f32; COLUMNS + PACK], u32);

    /// Adds rays eight at a time, and takes them when eight are together, or all have come.
    struct Pass<'a>(&'a [([Kept; PACK], u32)]);

    impl Kernel for Pass<'_> {
        type Output = Vec<Kept>;

        #[inline(always)]
        fn run<S: Simd>(self) -> Vec<Kept> {
            let mut waiting = Waiting::NONE;
            let mut passed = Vec::new();
            for (rays, which) in self.0 {
                let mut rows = [S::F8::splat(0.0); COLUMNS + PACK];
                for (place, row) in rows.iter_mut().enumerate() {
                    let mut values = [0.0; PACK];
                    (0..PACK).for_each(|lane| values[lane] = rays[lane].0[place]);
                    *row = S::F8::load(&values);
                }
                let (columns, begins) = rows.split_at(COLUMNS);
                let mut numbers = [0; PACK];
                (0..PACK).for_each(|lane| numbers[lane] = rays[lane].1);
                let ready = Ready {
                    columns: Columns::of_rows(columns.try_into().expect("as many rows")),
                    begins: begins.try_into().expect("eight rows"),
                    numbers,
                    count: PACK,
                };
                assert!(waiting.has_room());
                waiting.add::<S>(*which, &ready);
                if !waiting.has_room() {
                    passed.extend(kept(waiting.take::<S>()));
                }
            }
            passed.extend(kept(waiting.take::<S>()));
            assert!(waiting.take::<S>().is_none());
            passed
        }
    }

    /// The rays of what is ready.
    #[inline(always)]
    fn kept<S: Simd>(ready: Option<Ready<S>>) -> Vec<Kept> {
        let mut rays = Vec::new();
        if let Some(Ready { columns, begins, numbers, count }) = ready {
            rays = numbers[..count].iter().map(|&number| ([0.0; COLUMNS + PACK], number)).collect();
            for (place, row) in columns.rows().into_iter().chain(begins).enumerate() {
                let mut values = [0.0; PACK];
                row.store(&mut values);
                rays.iter_mut().zip(values).for_each(|(ray, value)| ray.0[place] = value);
            }
        }
        rays
    }

    #[test]
    fn each_ray_that_is_added_is_taken_once_with_all_its_rows() {
        let mut random = Random::new(&[83]);
        for rounds in 0..60 {
            let mut number = 0;
            let added: Vec<([Kept; PACK], u32)> = (0..rounds)
                .map(|_| {
                    let rays = std::array::from_fn(|_| {
                        number += 1;
                        let row = |place| number as f32 + place as f32 / 32.0;
                        (std::array::from_fn(row), number)
                    });
                    (
                        rays,
                        [0, 0xff, random.below(256), random.below(256)][random.below(4) as usize],
                    )
                })
                .collect();
            let mut passed = dispatch(Pass(&added));
            passed.sort_by_key(|ray| ray.1);
            let expected: Vec<Kept> = added
                .iter()
                .flat_map(|(rays, which)| {
                    rays.iter().enumerate().filter(move |(lane, _)| which >> lane & 1 != 0)
                })
                .map(|(_, ray)| *ray)
                .collect();
            assert_eq!(passed, expected);
        }
    }
}
