//! Large tables that are written on all threads.
//!
//! Memory that is new takes its time: all threads are the first to write to some of it, in large pages where the system
//! grants them. Values are made where they lie: what is returned would be copied once more.

use rayon::prelude::*;

use crate::parallel::for_chunks;

use super::ask_for_huge_pages;

/// So many values are made by a thread at a time.
const AT_ONCE: usize = 1 << 9;

/// A table of so many values. Each is `blank` until `fill`, which is told its place, has changed it.
pub(crate) fn table<T: Copy + Send + Sync>(
    count: usize,
    blank: T,
    fill: impl Fn(usize, &mut T) + Send + Sync,
) -> Vec<T> {
    let mut table = Vec::with_capacity(count);
    let room = &mut table.spare_capacity_mut()[..count];
    ask_for_huge_pages(room);
    for_chunks(room, AT_ONCE, &|first, room| {
        for (place, room) in (first..).zip(room) {
            fill(place, room.write(blank));
        }
    });
    // SAFETY: there is room for so many values, and each of them was written. After a panic there are none, and what
    // was written needs no drop.
    unsafe { table.set_len(count) };
    table
}

/// Puts so many values behind those of a list: `value` is told the place of each among them.
pub(crate) fn extend<T: Send>(
    list: &mut Vec<T>,
    count: usize,
    value: impl Fn(usize) -> T + Send + Sync,
) {
    list.reserve(count);
    let room = &mut list.spare_capacity_mut()[..count];
    for_chunks(room, AT_ONCE, &|first, room| {
        for (place, room) in (first..).zip(room) {
            room.write(value(place));
        }
    });
    // SAFETY: there is room for so many values behind the others, and each of them was written. After a panic the list
    // is as it was, and what was written is forgotten.
    unsafe { list.set_len(list.len() + count) };
}

/// The values of some parts, one part behind the other.
///
/// # Panics
/// If a part has not as many values as it says.
pub(crate) fn concatenated<T: Copy + Send>(
    parts: Vec<impl ExactSizeIterator<Item = T> + Send>,
) -> Vec<T> {
    let count = parts.iter().map(ExactSizeIterator::len).sum();
    let mut table = Vec::with_capacity(count);
    let mut room = &mut table.spare_capacity_mut()[..count];
    ask_for_huge_pages(room);
    let rooms = parts.into_iter().map(|part| {
        let own = room.split_off_mut(..part.len()).expect("the lengths were added up");
        (part, own)
    });
    let rooms: Vec<_> = rooms.collect();
    assert!(room.is_empty(), "a part has one length");
    rooms.into_par_iter().for_each(|(part, room)| {
        let mut written = 0;
        for (room, value) in room.iter_mut().zip(part) {
            room.write(value);
            written += 1;
        }
        assert_eq!(written, room.len(), "a part has as many values as it says");
    });
    // SAFETY: the rooms of the parts are all of the room there is for so many values, and each was written to its end.
    // After a panic there are none, and what was written needs no drop.
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
        for lengths in [vec![], vec![0], vec![3, 0, 1], vec![100_000, 7, 200_000]] {
            let expected: Vec<i32> = lengths.iter().flat_map(|&n| 0..n).collect();
            assert_eq!(concatenated(lengths.into_iter().map(|n| 0..n).collect()), expected);
        }
    }

    #[test]
    fn values_are_put_behind_others() {
        let mut list = vec![7];
        for count in [0, 1, 70_000] {
            let (before, expected) = (list.clone(), (0..count).map(|place| 3 * place));
            extend(&mut list, count, |place| 3 * place);
            assert!(list.iter().copied().eq(before.into_iter().chain(expected)));
        }
    }

    /// Says that it has more values than it has.
    struct Short(std::ops::Range<u8>);

    impl Iterator for Short {
        type Item = u8;

        fn next(&mut self) -> Option<u8> {
            self.0.next()
        }

        fn size_hint(&self) -> (usize, Option<usize>) {
            (self.0.len() + 1, Some(self.0.len() + 1))
        }
    }

    impl ExactSizeIterator for Short {}

    #[test]
    #[should_panic(expected = "a part has as many values as it says")]
    fn a_part_that_is_too_short_makes_no_table() {
        let _ = concatenated(vec![Short(0..3), Short(0..2)]);
    }

    #[test]
    #[should_panic(expected = "no seven")]
    fn a_panic_makes_no_table() {
        let _ = table(20, 0, |place, _| assert!(place != 7, "no seven"));
    }
}
