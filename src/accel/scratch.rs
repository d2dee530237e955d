//! Memory that searches need while they run, kept from one to the next.

use std::any::Any;
use std::cell::Cell;
use std::fmt;

/// What searches of slices of rays write on: lists, stacks, rays in other spaces. It grows to what
/// was needed most and is used again; its contents never change an answer.
///
/// Whoever traces many slices makes one for each thread and passes it on. A structure keeps memory
/// of any type here: see [`lend`](Self::lend).
#[derive(Default)]
pub struct Scratch {
    /// What is not lent, at most one a type and level of nesting.
    parts: Vec<Box<dyn Any + Send>>,
}

thread_local! {
    /// For callers that pass none; absent while it is lent.
    static OF_THREAD: Cell<Scratch> = const { Cell::new(Scratch { parts: Vec::new() }) };
}

impl Scratch {
    /// Lends memory of a type, as it was left or fresh, and what remains for searches within this
    /// one.
    pub fn lend<T: Any + Send + Default, R>(
        &mut self,
        work: impl FnOnce(&mut T, &mut Self) -> R,
    ) -> R {
        let kept = self.parts.iter().rposition(|part| part.is::<T>());
        let kept = kept.map(|place| self.parts.swap_remove(place));
        let mut part: Box<T> = kept.and_then(|part| part.downcast().ok()).unwrap_or_default();
        let result = work(&mut part, self);
        self.parts.push(part);
        result
    }

    /// Lends the memory that belongs to the current thread, to callers that keep none of their own.
    pub fn of_thread<R>(work: impl FnOnce(&mut Self) -> R) -> R {
        let mut scratch = OF_THREAD.take();
        let result = work(&mut scratch);
        OF_THREAD.set(scratch);
        result
    }
}

impl fmt::Debug for Scratch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Scratch").field("parts", &self.parts.len()).finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn memory_is_kept_by_type_and_by_level() {
        let mut scratch = Scratch::default();
        for round in 0..3 {
            scratch.lend(|outer: &mut Vec<u32>, scratch| {
                assert_eq!(outer.len(), round);
                outer.push(1);
                scratch.lend(|inner: &mut Vec<u32>, _| {
                    assert!(!std::ptr::eq(inner, outer));
                });
                scratch.lend(|other: &mut String, _| assert!(other.is_empty()));
            });
        }
        assert_eq!(scratch.parts.len(), 3);
    }

    #[test]
    fn the_memory_of_a_thread_nests() {
        Scratch::of_thread(|outer| {
            outer.lend(|list: &mut Vec<u8>, _| list.push(7));
            Scratch::of_thread(|inner| assert!(inner.parts.is_empty()));
        });
    }
}
