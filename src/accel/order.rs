//! Which primitive stands in which slot, and whether such an order is whole.

use std::sync::atomic::{AtomicBool, Ordering};

use rayon::prelude::*;

use crate::math::NONE;

/// Slots that a thread looks at together.
const CHUNK: usize = 1 << 14;

/// For each slot the index of its primitive, or [`NONE`] where the slot stays empty, which is for
/// primitives that are tested several at once ([`Build::grain`](super::Build::grain)).
///
/// [`Indexed::build`](super::Indexed::build) panics if a primitive has no slot, or several in a
/// permutation, with a message as `the order names primitive 17 twice and 4 never`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Order {
    /// Each primitive has one slot.
    Permutation(Vec<u32>),
    /// Each primitive has at least one slot: a primitive that several leaves refer to is copied into
    /// a slot of each. Its copies have the same id and give the same hit, so it does not matter how
    /// many of them a ray tests. Each takes the memory of a primitive.
    References(Vec<u32>),
}

/// A slot, or how many there are, or another place of a structure, in the 32 bits in which structures keep it.
///
/// # Panics
/// If it does not fit.
#[inline]
pub(crate) fn in_32_bits(number: usize) -> u32 {
    match u32::try_from(number) {
        Ok(number) => number,
        Err(_) => {
            panic!(
                "the structure would need {number} slots or nodes, and has numbers for {NONE} only"
            )
        }
    }
}

impl Order {
    /// What so many primitives have, to which leaves refer so many times.
    pub(super) fn of(slots: Vec<u32>, references: usize, primitives: u32) -> Self {
        if references > primitives as usize {
            Self::References(slots)
        } else {
            Self::Permutation(slots)
        }
    }

    /// The primitive of each slot.
    #[must_use]
    pub fn slots(&self) -> &[u32] {
        match self {
            Self::Permutation(slots) | Self::References(slots) => slots,
        }
    }

    /// Panics unless each of `count` primitives has its slots; the message names the first that has
    /// not.
    pub(super) fn assert_whole(&self, count: u32, grain: u32) {
        if let Some(fault) = self.fault(count, grain) {
            panic!("{fault}");
        }
    }

    /// What is wrong, if something is. Slots may be empty only where primitives are tested several at
    /// once.
    pub(super) fn fault(&self, count: u32, grain: u32) -> Option<String> {
        let empty = || self.slots().iter().position(|&slot| slot == NONE).filter(|_| grain == 1);
        let misnamed = if self.names_all(count) { None } else { self.misnamed(count) };
        misnamed.or_else(|| {
            let slot = empty()?;
            Some(format!(
                "the order leaves slot {slot} empty, of primitives that are tested one by one"
            ))
        })
    }

    /// Whether each primitive has its slots, found on all threads.
    fn names_all(&self, count: u32) -> bool {
        let named: Vec<_> = (0..count).map(|_| AtomicBool::new(false)).collect();
        let name = |slots: &[u32]| {
            let (mut names, mut known) = (0, true);
            for &primitive in slots.iter().filter(|&&primitive| primitive != NONE) {
                names += 1;
                match named.get(primitive as usize) {
                    Some(named) => named.store(true, Ordering::Relaxed),
                    None => known = false,
                }
            }
            (names, known)
        };
        let (names, known) = self
            .slots()
            .par_chunks(CHUNK)
            .map(name)
            .reduce(|| (0, true), |a, b| (a.0 + b.0, a.1 && b.1));
        // As many names as primitives, and all of these named: then none is named twice.
        let is_enough = matches!(self, Self::References(_)) || names == count as usize;
        known
            && is_enough
            && named
                .par_chunks(CHUNK)
                .all(|named| named.iter().all(|named| named.load(Ordering::Relaxed)))
    }

    /// Which primitive has not its slots, if there is one.
    fn misnamed(&self, count: u32) -> Option<String> {
        let mut named = vec![false; count as usize];
        let mut twice = None;
        for &primitive in self.slots().iter().filter(|&&primitive| primitive != NONE) {
            match named.get_mut(primitive as usize) {
                None => {
                    return Some(format!(
                        "the order names primitive {primitive}, and there are {count}, counted from 0"
                    ));
                }
                Some(named) if *named => twice = twice.or(Some(primitive)),
                Some(named) => *named = true,
            }
        }
        let never = named.iter().position(|&named| !named);
        let twice = twice.filter(|_| matches!(self, Self::Permutation(_)));
        Some(match (twice, never) {
            (None, None) => return None,
            (Some(twice), None) => format!("the order names primitive {twice} twice"),
            (None, Some(never)) => format!("the order names primitive {never} never"),
            (Some(twice), Some(never)) => {
                format!("the order names primitive {twice} twice and {never} never")
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_slots_have_32_bits() {
        assert_eq!([0, 7, u32::MAX as usize].map(in_32_bits), [0, 7, u32::MAX]);
    }

    #[cfg(target_pointer_width = "64")]
    #[test]
    #[should_panic(expected = "the structure would need 4294967297 slots")]
    fn numbers_of_slots_are_not_cut() {
        in_32_bits((1 << 32) + 1);
    }

    #[test]
    fn slots_are_empty_among_several_lanes() {
        Order::Permutation(vec![1, NONE, 0]).assert_whole(2, 4);
        Order::References(vec![1, NONE, 0, 1]).assert_whole(2, 4);
    }

    #[test]
    #[should_panic(expected = "the order leaves slot 1 empty")]
    fn no_slot_is_empty_where_there_are_no_lanes() {
        Order::Permutation(vec![1, NONE, 0]).assert_whole(2, 1);
    }

    #[test]
    fn each_primitive_has_one_slot_in_a_permutation() {
        let fault = |order: &[u32], count| {
            let order = Order::Permutation(order.to_vec());
            assert_eq!(order.names_all(count), order.misnamed(count).is_none());
            order.misnamed(count)
        };
        assert_eq!(fault(&[2, NONE, 0, 1, NONE], 3), None);
        assert_eq!(fault(&[], 0), None);
        let fault = |order: &[u32]| fault(order, 5).unwrap();
        assert_eq!(fault(&[0, 1, 2, 2, 3]), "the order names primitive 2 twice and 4 never");
        assert_eq!(fault(&[0, 1, 3, 2]), "the order names primitive 4 never");
        assert_eq!(fault(&[0, 1, 2, 3, 4, 1]), "the order names primitive 1 twice");
        assert!(fault(&[0, 5]).starts_with("the order names primitive 5, and there are 5"));
    }

    #[test]
    fn each_primitive_has_some_slot_among_references() {
        let fault = |order: &[u32]| {
            let order = Order::References(order.to_vec());
            assert_eq!(order.names_all(3), order.misnamed(3).is_none());
            order.misnamed(3)
        };
        assert_eq!(fault(&[2, 0, NONE, 1, 0, 2, 2]), None);
        assert_eq!(fault(&[2, 0, 2]).unwrap(), "the order names primitive 1 never");
        assert!(fault(&[0, 1, 2, 3]).unwrap().starts_with("the order names primitive 3, and"));
    }
}
