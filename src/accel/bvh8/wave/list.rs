//! Lists of rays in flight, and how rays go from one to the other without a branch.

use crate::simd::Simd;

use super::super::node::Child;
use super::super::task::MOST_IN_FLIGHT;
use crate::accel::PACK;

/// Places of a list: twice as many as there can be rays, a power of two.
const PLACES: usize = 2 * MOST_IN_FLIGHT;

/// With room for the row that is written whole behind every place.
type Row = [u32; PLACES + PACK];

/// The memory of a list.
pub(super) struct Places {
    /// The rays, by their slots.
    slots: Row,
    /// What each visits next, or has on top of its stack.
    next: Row,
}

/// Rays by their slots, and what each visits next. The places are elsewhere, so that the length can stay in a register.
pub(super) struct List<'a> {
    places: &'a mut Places,
    pub(super) length: usize,
}

/// Where the rays of eight places belong, a bit for each.
struct Ways {
    nodes: u32,
    leaves: u32,
    done: u32,
}

impl Places {
    pub(super) const fn new() -> Self {
        Self { slots: [0; PLACES + PACK], next: [0; PLACES + PACK] }
    }
}

impl Ways {
    /// Those of the first `count` rays, by what they have on top of their stacks, but for those in `without`.
    #[inline(always)]
    fn of<S: Simd>(next: &[u32; PACK], count: usize, without: u32) -> Self {
        let live = ((1u32 << count.min(PACK)) - 1) & !without;
        let (signs, absent) = (S::signs(next) & live, S::equal(next, Child::ABSENT.0) & live);
        Self { nodes: live & !signs, leaves: signs & !absent, done: absent }
    }
}

impl<'a> List<'a> {
    pub(super) fn new(places: &'a mut Places) -> Self {
        Self { places, length: 0 }
    }

    /// The slot at a place.
    #[inline(always)]
    pub(super) fn slot(&self, place: usize) -> u32 {
        self.places.slots[place % PLACES]
    }

    /// What the ray at a place visits next.
    #[inline(always)]
    pub(super) fn next(&self, place: usize) -> Child {
        Child(self.places.next[place % PLACES])
    }

    /// Notes what the ray at a place has on top of its stack.
    #[inline(always)]
    pub(super) fn set_next(&mut self, place: usize, next: Child) {
        self.places.next[place % PLACES] = next.0;
    }

    /// Appends a slot if it `belongs`, by arithmetic.
    #[inline(always)]
    pub(super) fn append_if(&mut self, slot: u32, belongs: bool) {
        self.places.slots[self.length % PLACES] = slot;
        self.length += usize::from(belongs);
    }

    /// Takes the last `count` slots, at least one and at most eight; the last of them comes again in the places behind.
    #[inline(always)]
    pub(super) fn take_last(&mut self, count: usize) -> [u32; PACK] {
        self.length -= count;
        let mut slots = *row(&self.places.slots, self.length);
        for place in count..PACK {
            slots[place] = slots[count - 1];
        }
        slots
    }

    /// Sends those of the first `count` of eight rays that are to visit something to the lists of that.
    #[inline(always)]
    pub(super) fn send_eight<S: Simd>(
        (slots, next): (&[u32; PACK], &[u32; PACK]),
        count: usize,
        nodes: &mut Self,
        leaves: &mut Self,
    ) {
        let ways = Ways::of::<S>(next, count, 0);
        nodes.append_some::<S>(ways.nodes, slots, next);
        leaves.append_some::<S>(ways.leaves, slots, next);
    }

    /// Keeps those of the rays that are at a node again, and sends the others to their lists.
    #[inline(always)]
    pub(super) fn keep_nodes<S: Simd>(&mut self, leaves: &mut Self, done: &mut Self) {
        let count = std::mem::take(&mut self.length);
        for base in (0..count).step_by(PACK) {
            let (slots, next, ways) = self.part::<S>(base, count, 0);
            self.append_some::<S>(ways.nodes, &slots, &next);
            leaves.append_some::<S>(ways.leaves, &slots, &next);
            done.append_some_slots::<S>(ways.done, &slots);
        }
    }

    /// Keeps those of the rays that are at a leaf again, and sends the others to their lists, but for those in
    /// `without`, a bit for each.
    #[inline(always)]
    pub(super) fn keep_leaves<S: Simd>(&mut self, without: u64, nodes: &mut Self, done: &mut Self) {
        let count = std::mem::take(&mut self.length);
        for base in (0..count).step_by(PACK) {
            let (slots, next, ways) = self.part::<S>(base, count, without);
            self.append_some::<S>(ways.leaves, &slots, &next);
            nodes.append_some::<S>(ways.nodes, &slots, &next);
            done.append_some_slots::<S>(ways.done, &slots);
        }
    }

    /// Sends all rays to their lists.
    #[inline(always)]
    pub(super) fn empty<S: Simd>(&mut self, nodes: &mut Self, leaves: &mut Self, done: &mut Self) {
        let count = std::mem::take(&mut self.length);
        for base in (0..count).step_by(PACK) {
            let (slots, next, ways) = self.part::<S>(base, count, 0);
            nodes.append_some::<S>(ways.nodes, &slots, &next);
            leaves.append_some::<S>(ways.leaves, &slots, &next);
            done.append_some_slots::<S>(ways.done, &slots);
        }
    }

    /// Eight places of `count`, from `base` on, and where their rays belong.
    #[inline(always)]
    fn part<S: Simd>(
        &self,
        base: usize,
        count: usize,
        without: u64,
    ) -> ([u32; PACK], [u32; PACK], Ways) {
        let (slots, next) = (*row(&self.places.slots, base), *row(&self.places.next, base));
        let ways = Ways::of::<S>(&next, count - base, (without >> (base % MOST_IN_FLIGHT)) as u32);
        (slots, next, ways)
    }

    #[inline(always)]
    fn append_some<S: Simd>(&mut self, which: u32, slots: &[u32; PACK], next: &[u32; PACK]) {
        S::compress(which, next, row_mut(&mut self.places.next, self.length));
        self.append_some_slots::<S>(which, slots);
    }

    #[inline(always)]
    fn append_some_slots<S: Simd>(&mut self, which: u32, slots: &[u32; PACK]) {
        S::compress(which, slots, row_mut(&mut self.places.slots, self.length));
        self.length += which.count_ones() as usize;
    }
}

/// Eight places.
#[inline(always)]
fn row(row: &Row, base: usize) -> &[u32; PACK] {
    row[base % PLACES..].first_chunk().expect("a row has room behind every place")
}

#[inline(always)]
fn row_mut(row: &mut Row, base: usize) -> &mut [u32; PACK] {
    row[base % PLACES..].first_chunk_mut().expect("a row has room behind every place")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Random;
    use crate::simd::{Kernel, dispatch};

    const RAYS: usize = MOST_IN_FLIGHT;

    /// Rays with what they visit next, by slot; those that are left out; how they are sent.
    struct Send<'a> {
        rays: &'a [(u32, Child)],
        without: u64,
        way: usize,
    }

    /// The rays at nodes, at leaves, and those that are done.
    type Sent = ([Vec<(u32, Child)>; 2], Vec<u32>);

    /// Stands in another list before.
    const OTHER: (u32, Child) = (99, Child::ROOT);

    fn append(list: &mut List<'_>, (slot, next): (u32, Child)) {
        list.set_next(list.length, next);
        list.append_if(slot, true);
    }

    impl Kernel for Send<'_> {
        type Output = Sent;

        #[inline(always)]
        fn run<S: Simd>(self) -> Sent {
            let places = &mut [const { Places::new() }; 4];
            let [a, b, c, d] = places;
            let (mut from, mut nodes) = (List::new(a), List::new(b));
            let (mut leaves, mut done) = (List::new(c), List::new(d));
            for &(slot, next) in self.rays {
                append(&mut from, (slot, next));
            }
            append(&mut nodes, OTHER);
            append(&mut leaves, OTHER);
            match self.way {
                0 => from.empty::<S>(&mut nodes, &mut leaves, &mut done),
                1 => from.keep_nodes::<S>(&mut leaves, &mut done),
                3 => {
                    for base in (0..from.length).step_by(PACK) {
                        let count = (from.length - base).min(PACK);
                        let eight = (row(&from.places.slots, base), row(&from.places.next, base));
                        List::send_eight::<S>(eight, count, &mut nodes, &mut leaves);
                    }
                }
                _ => from.keep_leaves::<S>(self.without, &mut nodes, &mut done),
            }
            let rays = |list: &List<'_>| {
                (0..list.length).map(|place| (list.slot(place), list.next(place))).collect()
            };
            let slots = (0..done.length).map(|place| done.slot(place)).collect();
            let sent = match self.way {
                0 => {
                    assert_eq!(from.length, 0);
                    [rays(&nodes), rays(&leaves)]
                }
                1 => [rays(&from), rays(&leaves)],
                3 => [rays(&nodes), rays(&leaves)],
                _ => [rays(&nodes), rays(&from)],
            };
            (sent, slots)
        }
    }

    #[test]
    fn every_ray_comes_to_the_list_where_it_belongs_in_order() {
        let mut random = Random::new(&[61]);
        for round in 0..3200 {
            let count = [0, 1, 7, 8, 9, 31, 40, RAYS][round % 8];
            let rays: Vec<(u32, Child)> = (0..count as u32)
                .map(|slot| match random.below(3) {
                    0 => (slot, Child::ABSENT),
                    1 => (slot, Child::leaf(random.below(1 << 27) as usize, 8)),
                    _ => (slot, Child::node(random.below(1 << 27) as usize)),
                })
                .collect();
            let way = round / 8 % 4;
            let some = u64::from(random.below(u32::MAX)) << (round % 33);
            let without = if way == 2 { some } else { 0 };
            let live: Vec<_> =
                rays.iter().filter(|(slot, _)| without >> slot & 1 == 0).copied().collect();
            let of = |kind: fn(Child) -> bool, others: &[(u32, Child)]| -> Vec<_> {
                let own = live.iter().filter(|(_, next)| kind(*next));
                others.iter().chain(own).copied().collect()
            };
            let nodes = of(|next| !next.is_leaf(), if way == 1 { &[] } else { &[OTHER] });
            let leaves = of(
                |next| next.is_leaf() && next != Child::ABSENT,
                if way == 2 { &[] } else { &[OTHER] },
            );
            // Of eight rays, those that are to visit nothing go nowhere.
            let is_done = |next| next == Child::ABSENT;
            let done = of(if way == 3 { |_| false } else { is_done }, &[]);
            let done = done.into_iter().map(|(slot, _)| slot);
            let sent = dispatch(Send { rays: &rays, without, way });
            assert_eq!(sent, ([nodes, leaves], done.collect()));
        }
    }

    #[test]
    fn slots_are_taken_from_the_end_and_the_last_of_few_fills_the_row() {
        let mut places = Places::new();
        let mut list = List::new(&mut places);
        for slot in 0..20 {
            list.append_if(slot, slot % 5 != 4);
        }
        assert_eq!(list.length, 16);
        assert_eq!(list.take_last(8), [10, 11, 12, 13, 15, 16, 17, 18]);
        assert_eq!(list.take_last(3), [6, 7, 8, 8, 8, 8, 8, 8]);
    }
}
