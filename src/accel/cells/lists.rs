//! The primitives that cells refer to, cell by cell.
//!
//! Primitives that are tested several at once are copied into the slots of each of their cells, so that
//! a list is a range of slots and is tested in packs. They need no mailbox: a test of four lanes costs
//! less than to find out which of the four are known (`docs/speed-notes.md`, "Cells"). Primitives that
//! are tested one by one, as the objects of a scene, can be whole meshes. They stay in their one slot, a
//! list has their ids, and a [`Mailbox`] spares a ray to search a mesh again in the next cell.

use std::ops::{ControlFlow, Range};

use crate::math::NONE;

use super::super::Order;
use super::super::order::in_32_bits;
use super::Mailbox;

/// The most references of all lists together, unless there are more primitives. Lists that begin at multiples of eight
/// slots take up to eight slots a reference: half as many as slots have numbers. Builds over more primitives may need
/// more slots, and then panic.
pub(in super::super) const MOST_REFERENCES: u64 = 1 << 28;

/// The lists of all cells.
#[derive(Clone, Debug)]
pub(in super::super) struct CellLists {
    /// The slots behind each other that the lists name; none where primitives were copied and lists
    /// are ranges of slots.
    ids: Option<Vec<u32>>,
}

impl CellLists {
    /// Offers the primitives of a list. Breaks where the search is over; `end` is how far it goes.
    #[inline(always)]
    pub(in super::super) fn offer<C>(
        &self,
        list: Range<u32>,
        mailbox: &mut Mailbox,
        end: &mut f32,
        counters: &mut C,
        leaf: &mut impl FnMut(Range<u32>, &mut C) -> ControlFlow<(), f32>,
    ) -> ControlFlow<()> {
        let mut left = list;
        // One call for both kinds: what it calls is compiled into this place.
        while !left.is_empty() {
            let slots = match &self.ids {
                None => std::mem::replace(&mut left, 0..0),
                Some(ids) => {
                    let id = ids[left.start as usize];
                    left.start += 1;
                    if mailbox.has(id) {
                        continue;
                    }
                    id..id + 1
                }
            };
            *end = leaf(slots, counters)?;
        }
        ControlFlow::Continue(())
    }

    /// The slots of a list.
    pub(in super::super) fn slots(&self, list: Range<u32>) -> impl Iterator<Item = u32> {
        list.map(|place| self.ids.as_ref().map_or(place, |ids| ids[place as usize]))
    }

    /// Whether lists are ranges of slots.
    pub(in super::super) fn are_slots(&self) -> bool {
        self.ids.is_none()
    }

    /// Bytes beside the structure's own.
    pub(in super::super) fn bytes(&self) -> u64 {
        self.ids.as_ref().map_or(0, |ids| size_of_val(&ids[..]) as u64)
    }
}

/// Lists in the making.
pub(in super::super) struct ListBuilder {
    /// Lists begin at multiples of so many slots.
    grain: usize,
    slots: Vec<u32>,
}

impl ListBuilder {
    /// For primitives that are tested so many at once.
    pub(in super::super) fn new(grain: u32) -> Self {
        Self { grain: grain as usize, slots: Vec::new() }
    }

    /// Appends the list of a cell.
    pub(in super::super) fn add(&mut self, ids: &[u32]) -> Range<u32> {
        if !ids.is_empty() {
            self.slots.resize(self.slots.len().next_multiple_of(self.grain), NONE);
        }
        let first = in_32_bits(self.slots.len());
        self.slots.extend_from_slice(ids);
        first..in_32_bits(self.slots.len())
    }

    /// The lists, and the order of the slots.
    pub(in super::super) fn finish(mut self) -> (CellLists, Option<Order>) {
        if self.grain > 1 {
            return (CellLists { ids: None }, Some(Order::References(self.slots)));
        }
        self.slots.shrink_to_fit();
        (CellLists { ids: Some(self.slots) }, None)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The ranges that are offered of two lists with a primitive in common.
    fn offered(grain: u32) -> Vec<Range<u32>> {
        let mut builder = ListBuilder::new(grain);
        let lists = [&[7, 2, 9][..], &[], &[2, 5]].map(|ids| builder.add(ids));
        let (all, order) = builder.finish();
        assert_eq!(all.are_slots(), order.is_some());
        let mut offered = Vec::new();
        let (mut mailbox, mut end) = (Mailbox::EMPTY, 1.0);
        for list in lists {
            let mut leaf = |slots: Range<u32>, (): &mut ()| {
                offered.push(slots);
                ControlFlow::Continue(0.5)
            };
            let flow = all.offer(list, &mut mailbox, &mut end, &mut (), &mut leaf);
            assert_eq!((flow, end), (ControlFlow::Continue(()), 0.5));
        }
        offered
    }

    #[test]
    fn copies_are_offered_as_ranges_that_begin_where_packs_do() {
        assert_eq!(offered(4), [0..3, 4..6]);
    }

    #[test]
    fn ids_are_offered_one_by_one_and_not_twice_in_a_row() {
        assert_eq!(offered(1), [7..8, 2..3, 9..10, 5..6]);
    }
}
