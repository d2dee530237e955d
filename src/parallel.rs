//! Loops on all threads, compiled once.
//!
//! A parallel loop of rayon's is two thousand lines of the compiler's code, anew for each closure and each type that it
//! meets: where a loop stands in a function that is generic, it is most of what there is to compile. Here is one loop,
//! and what it does is called through a pointer. So that the call costs nothing, it is to do much: a chunk of a list.

use std::sync::Mutex;

use rayon::prelude::*;

/// Does some work for each number below `count`.
fn each(count: usize, work: &(dyn Fn(usize) + Sync)) {
    (0..count).into_par_iter().for_each(work);
}

/// Does some work for each chunk of a list, all but the last of so many elements. It is told the place of the first.
pub(crate) fn for_chunks<T: Send>(
    list: &mut [T],
    length: usize,
    work: &(dyn Fn(usize, &mut [T]) + Sync),
) {
    // A chunk is for the thread that takes it: none ever waits for another.
    let chunks: Vec<_> = list.chunks_mut(length).map(Mutex::new).collect();
    each(chunks.len(), &|chunk| {
        let mut elements = chunks[chunk].lock().expect("a chunk is taken once");
        work(chunk * length, &mut elements);
    });
}

/// What some work gives for each number below `count`, in their order.
pub(crate) fn values<T: Send>(count: usize, work: &(dyn Fn(usize) -> T + Sync)) -> Vec<T> {
    let mut values: Vec<Option<T>> = (0..count).map(|_| None).collect();
    for_chunks(&mut values, 1, &|place, value| value[0] = Some(work(place)));
    values.into_iter().map(|value| value.expect("each was given")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_chunk_is_met_once_with_its_place() {
        for (count, length) in [(0, 3), (1, 3), (6, 3), (1000, 7)] {
            let mut list = vec![0; count];
            for_chunks(&mut list, length, &|first, chunk| {
                assert!(first.is_multiple_of(length) && chunk.len() == length.min(count - first));
                chunk.iter_mut().zip(first..).for_each(|(value, place)| *value += place);
            });
            assert!(list.into_iter().eq(0..count));
        }
    }

    #[test]
    fn values_are_in_order() {
        for count in [0, 1, 1000] {
            assert!(values(count, &|i| i * i).into_iter().eq((0..count).map(|i| i * i)));
        }
    }

    #[test]
    #[should_panic(expected = "no seven")]
    fn a_panic_is_handed_on() {
        for_chunks(&mut [0; 20], 1, &|place, _| assert!(place != 7, "no seven"));
    }
}
