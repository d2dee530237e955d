//! Which primitives a ray has just been tested with.
//!
//! A primitive is in the lists of several cells, and a ray that passes several of them need not be
//! tested with it again: all that it has for the ray was recorded the first time, when the search went
//! at least as far. A mailbox at each primitive (Amanatides, Woo: *A Fast Voxel Traversal Algorithm for
//! Ray Tracing*, 1987) would be written to by all threads. So the ray keeps the last few ids instead:
//! Shevtsov, Soupikov, Kapustin: *Highly Parallel Fast KD-tree Construction for Interactive Ray Tracing
//! of Dynamic Scenes*, 2007 ("inverse mailboxing").

use crate::math::NONE;

/// Places, of which each id has one.
const PLACES: usize = 8;

/// The last ids of a ray.
pub(in super::super) struct Mailbox([u32; PLACES]);

impl Mailbox {
    pub(in super::super) const EMPTY: Self = Self([NONE; PLACES]);

    /// Notes a primitive; whether it was noted before.
    #[inline(always)]
    pub(in super::super) fn has(&mut self, id: u32) -> bool {
        let place = &mut self.0[id as usize % PLACES];
        std::mem::replace(place, id) == id
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_noted_last_in_its_place_is_known() {
        let mut mailbox = Mailbox::EMPTY;
        let has = [3, 4, 3, 11, 3, 4].map(|id| mailbox.has(id));
        assert_eq!(has, [false, false, true, false, false, true], "11 has the place of 3");
    }
}
