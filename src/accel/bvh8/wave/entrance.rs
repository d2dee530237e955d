//! How rays come to the root: those that miss its children are answered, the others are made ready for slots.

use crate::accel::{PACK, Primitives, Query};
use crate::counters::Counters;
use crate::math::{Hit, Lanes as _, Ray};
use crate::simd::Simd;

use super::super::task::Task;
use super::columns::Columns;
use super::incoming::{Eight, Incoming};
use super::root::{Entered, Root};
use super::waiting::{Ready, Waiting};

/// All of eight lanes.
const ALL: u32 = (1 << PACK) - 1;

/// Rays on their way to slots.
pub(super) struct Entrance<'a> {
    pub(super) incoming: Incoming<'a>,
    pub(super) root: Root<'a>,
    waiting: &'a mut Waiting,
}

impl<'a> Entrance<'a> {
    pub(super) fn new(incoming: Incoming<'a>, root: Root<'a>, waiting: &'a mut Waiting) -> Self {
        waiting.clear();
        Self { incoming, root, waiting }
    }

    /// The next eight rays that are to take slots, at the end those that are left; `None` if there are none. Rays that
    /// miss the root's children are answered on the way.
    #[inline(always)]
    pub(super) fn next<S: Simd, P: Primitives, Q: Query, C: Counters>(
        &mut self,
        task: &Task<'_, P, Q>,
        rays: &[Ray],
        answers: &mut [Q::Answer],
        counters: &mut C,
    ) -> Option<Ready<S>> {
        loop {
            let eight = if self.waiting.has_room() { self.incoming.next_eight() } else { None };
            let Some(eight) = eight else { return self.waiting.take() };
            self.incoming.prefetch_ahead(&eight, rays);
            let (ready, which) =
                self.meet_root::<S, P, Q, C>(&eight, task, rays, answers, counters);
            if which == ALL {
                return Some(ready);
            }
            self.waiting.add(which, &ready);
        }
    }

    /// Works out what rays need at the root. Returns a bit for each that is to take a slot.
    #[inline(always)]
    fn meet_root<S: Simd, P: Primitives, Q: Query, C: Counters>(
        &self,
        eight: &Eight,
        task: &Task<'_, P, Q>,
        rays: &[Ray],
        answers: &mut [Q::Answer],
        counters: &mut C,
    ) -> (Ready<S>, u32) {
        let (columns, usual) = Columns::<S>::new(&eight.index, rays, task.padding);
        let all = ALL >> (PACK - eight.count);
        let at_root = self.incoming.fresh_of(eight) & usual;
        let (mut begins, mut which) = ([S::F8::splat(0.0); PACK], all);
        if at_root != 0 {
            if C::COUNTS {
                counters.boxes(at_root.count_ones() * self.root.children as u32);
            }
            // Which ones miss cannot be foreseen: all do, until those that take a slot are answered from it.
            for &ray in &eight.index {
                let ray = ray as usize;
                answers[ray] = task.query.of_one(&rays[ray], &Hit::MISS);
            }
            let Entered { begins: of_children, any } = self.root.enter::<S>(&columns);
            (begins, which) = (of_children, all & (any | !at_root));
        }
        let (numbers, count) = (eight.numbers(usual), eight.count);
        (Ready { columns, begins, numbers, count }, which)
    }
}
