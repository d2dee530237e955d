//! Large tables that are written on all threads.
//!
//! Memory that is new takes its time: all threads are the first to write to some of it, in large pages where the system
//! grants them. Values are made where they lie: what is returned would be copied once more.

use rayon::prelude::*;

use super::ask_for_huge_pages;

/// A table of so many values. Each is `blank` until `fill`, which is told its place, has changed it.
pub(crate) fn table<T: Copy + Send + Sync>(
    count: usize,
    blank: T,
    fill: impl Fn(usize, &mut T) + Send + Sync,
) -> Vec<T> {
    let mut table = Vec::with_capacity(count);
    let room = &mut table.spare_capacity_mut()[..count];
    ask_for_huge_pages(room);
    let places = room.par_iter_mut().enumerate();
    places.for_each(|(place, room)| fill(place, room.write(blank)));
    // SAFETY: there is room for so many values, and each of them was written.
    unsafe { table.set_len(count) };
    table
}

/// A table of parts behind each other, of so many values each, which are told by their part and their place there.
pub(crate) fn table_of_parts<P: Sync, T: Copy + Send>(
    parts: &[P],
    length: impl Fn(&P) -> usize,
    value: impl Fn(&P, usize) -> T + Send + Sync,
) -> Vec<T> {
    let count = parts.iter().map(&length).sum();
    let mut table = Vec::with_capacity(count);
    let mut room = &mut table.spare_capacity_mut()[..count];
    ask_for_huge_pages(room);
    let own = |part| room.split_off_mut(..length(part)).expect("the lengths were added up");
    let rooms: Vec<_> = parts.iter().map(own).collect();
    assert!(room.is_empty(), "a part has one length");
    parts.par_iter().zip(rooms).for_each(|(part, room)| {
        for (place, room) in room.iter_mut().enumerate() {
            room.write(value(part, place));
        }
    });
    // SAFETY: there is room for so many values, and each of them was written: the rooms are all of it.
    unsafe { table.set_len(count) };
    table
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_value_is_filled_at_its_place() {
        for count in [0, 1, 1000, 300_000] {
            let squares = table(count, [7u64; 2], |place, pair| pair[1] = (place * place) as u64);
            assert!(squares.iter().copied().eq((0..count as u64).map(|i| [7, i * i])));
        }
    }

    #[test]
    fn parts_stand_behind_each_other() {
        for parts in [vec![], vec![0], vec![3, 0, 1], vec![100_000, 7, 200_000]] {
            let numbers = table_of_parts(&parts, |&n| n, |&n, place| n - place);
            assert!(numbers.into_iter().eq(parts.iter().flat_map(|&n| (1..=n).rev())));
        }
    }
}
