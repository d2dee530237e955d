//! Waves: dozens of rays in flight on one thread, without a branch that cannot be foreseen.
//!
//! A ray that walks a tree alone takes a turn at every node that no processor can predict, and
//! waits. Here each ray is in a list: of rays at a node, at a leaf, with a candidate for the
//! closest hit, or done. A phase goes through its list, does the same work for each ray and appends
//! it, by arithmetic, to the list that it belongs to next. The rays of a phase do not depend on
//! each other, so the processor works on several at once.

use crate::accel::{PACK, PackHits, Packs, Primitives, Query, Search, search_one};
use crate::counters::Counters;
use crate::math::slab::{meets, not_before};
use crate::math::{BoxRay, Hit, Lanes as _, Mask as _, NONE, Ray, ones, within};
use crate::simd::{Row, Simd, splat3};

use super::HEIGHT;
use super::diverged::{Diverged, DivergedRay};
use super::incoming::{Incoming, Next, Terms};
use super::node::{Child, near_planes, order_shift};
use super::slab_ray::SlabRay;
use super::task::{MOST_IN_FLIGHT, Task};

/// The most rays in flight.
const RAYS: usize = MOST_IN_FLIGHT;

/// Room for the entries, for the row that is written at once beyond them, and up to a whole cache line.
const ROOM: usize = HEIGHT + 2 * PACK;

/// The memory of a wave; `R` is a ray as the primitives' formula takes it.
pub(super) struct Memory<R> {
    slots: [Slot<R>; RAYS],
    terms: Terms<R>,
    candidates: [Candidates; RAYS],
}

/// A ray in flight. What a visit of a node reads is in the first cache line, what a visit of a leaf
/// reads in the next.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
struct Slot<R> {
    /// 1/direction, t_min, offsets of near planes, and the end of the search: the best hit's parameter,
    /// or the ray's end.
    near: [f32; 8],
    /// Offsets of far planes.
    far: [f32; 3],
    /// Entries on its stack.
    height: u32,
    near_planes: [u32; 3],
    order_shift: u32,

    formula: R,
    /// What it visits next.
    at: Child,
    /// The best hit.
    prim: u32,
    u: f32,
    v: f32,
    /// Its number in the caller's slice.
    ray: u32,

    /// The stack: what is to be visited, and where it begins. At the bottom is the end.
    entries: Aligned<[u32; ROOM]>,
    distances: Aligned<[f32; ROOM]>,
    /// Slots are an odd number of cache lines apart, so that they do not share sets of a cache.
    _apart: Aligned<u32>,
}

/// At the beginning of a cache line: rows of a stack that is not high do not cross into the next.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
struct Aligned<T>(T);

/// Places for the slots of a list: room for one more than there can be, because what does not belong is
/// written too, and then overwritten.
type Places = [u8; 2 * RAYS];

/// Rays by their slot. The places are elsewhere, so that the length can stay in a register.
struct List<'a> {
    places: &'a mut Places,
    length: usize,
}

/// What a leaf offers a ray.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
struct Candidates {
    t: [f32; PACK],
    u: [f32; PACK],
    v: [f32; PACK],
    scale: [f32; PACK],
    lanes: u32,
    block: u32,
}

impl<'a> List<'a> {
    fn new(places: &'a mut Places) -> Self {
        Self { places, length: 0 }
    }

    /// Appends a slot if it `belongs`, by arithmetic.
    #[inline(always)]
    fn append(&mut self, slot: u8, belongs: bool) {
        self.places[self.length % (2 * RAYS)] = slot;
        self.length += usize::from(belongs);
    }

    /// Empties the list, and returns how many slots it had. They are still there: whoever goes
    /// through them may append each, or not, behind those that it has appended before.
    #[inline(always)]
    fn restart(&mut self) -> usize {
        std::mem::take(&mut self.length)
    }

    #[inline(always)]
    fn slot(&self, place: usize) -> u8 {
        self.places[place % (2 * RAYS)]
    }
}

impl<R: Copy + Default> Default for Memory<R> {
    fn default() -> Self {
        Self {
            slots: [Slot::vacant(); RAYS],
            terms: Terms::room(R::default()),
            candidates: [Candidates::NONE; RAYS],
        }
    }
}

impl Candidates {
    const NONE: Self = Self {
        t: [0.0; PACK],
        u: [0.0; PACK],
        v: [0.0; PACK],
        scale: [0.0; PACK],
        lanes: 0,
        block: 0,
    };

    /// Notes the coordinates of hits, and what they are to be divided by.
    #[inline(always)]
    fn set_coordinates<S: Simd>(&mut self, hits: &PackHits<S::F8>) {
        hits.u.store(&mut self.u);
        hits.v.store(&mut self.v);
        hits.scale.store(&mut self.scale);
    }

    /// A candidate as a hit.
    #[inline(always)]
    fn hit(&self, lane: usize, packs: &impl Packs) -> Hit {
        let scale = self.scale[lane];
        Hit {
            t: self.t[lane],
            object: 0,
            prim: packs.id(self.block as usize, lane),
            u: self.u[lane] / scale,
            v: self.v[lane] / scale,
        }
    }

    /// Takes those out that do not count by their own boxes, and puts the others where they count.
    #[inline(always)]
    fn place<S: Simd, P: Primitives, Q: Query>(
        &mut self,
        slot: &Slot<RayOf<P>>,
        task: &Task<'_, P, Q>,
        rays: &[Ray],
    ) {
        // Most rays come here once at most: not kept in the slot.
        let box_ray = BoxRay::new(&rays[slot.ray as usize], task.padding);
        let (begin, leave) = box_ray.intervals(task.packs.boxes::<S>(self.block as usize));
        let searched = [S::F8::splat(slot.t_min()), S::F8::splat(slot.end())];
        self.lanes &= meets([begin, leave], searched).bits();
        not_before(S::F8::load(&self.t), begin).store(&mut self.t);
    }

    /// Whether the query accepts a candidate.
    #[inline(always)]
    fn is_accepted<P: Primitives, Q: Query>(
        &self,
        lane: usize,
        ray: u32,
        task: &Task<'_, P, Q>,
        rays: &[Ray],
    ) -> bool {
        !Q::FILTERS || task.query.accepts(&rays[ray as usize], &self.hit(lane, task.packs))
    }
}

/// Where a slot has the end of the search.
const END: usize = 7;

impl<R> Slot<R> {
    #[inline(always)]
    fn inv_dir(&self) -> [f32; 3] {
        [self.near[0], self.near[1], self.near[2]]
    }

    #[inline(always)]
    fn t_min(&self) -> f32 {
        self.near[3]
    }

    #[inline(always)]
    fn near_offsets(&self) -> [f32; 3] {
        [self.near[4], self.near[5], self.near[6]]
    }

    #[inline(always)]
    fn end(&self) -> f32 {
        self.near[END]
    }
}

impl<R: Copy + Default> Slot<R> {
    fn vacant() -> Self {
        Self {
            near: [0.0; 8],
            far: [0.0; 3],
            height: 0,
            near_planes: [0; 3],
            order_shift: 0,
            at: Child::ABSENT,
            formula: R::default(),
            prim: NONE,
            u: 0.0,
            v: 0.0,
            ray: NONE,
            entries: Aligned([Child::ABSENT.0; ROOM]),
            distances: Aligned([f32::NEG_INFINITY; ROOM]),
            _apart: Aligned(0),
        }
    }
}

/// A ray as the formula of primitives takes it.
pub(super) type RayOf<P> = <<P as Primitives>::Packs as Packs>::Ray;

/// Answers those of the rays whose places in the slice are in `which`, and those that diverged.
#[inline(always)]
pub(super) fn search<S: Simd, P: Primitives, Q: Query, C: Counters>(
    task: &Task<'_, P, Q>,
    rays: &[Ray],
    (which, diverged): (&[u32], &Diverged),
    answers: &mut [Q::Answer],
    memory: &mut Memory<RayOf<P>>,
    counters: &mut C,
) {
    let any = const { matches!(Q::SEARCH, Search::First) };
    let (tree, packs) = (&task.tree.nodes[..], task.packs);
    let Memory { slots, terms, candidates } = memory;
    let [a, b, c, d, e, f] = &mut [[0; 2 * RAYS]; 6];
    let (mut nodes, mut nodes_now) = (List::new(a), List::new(b));
    let (mut leaves, mut leaves_now) = (List::new(c), List::new(d));
    let (mut improved, mut done) = (List::new(e), List::new(f));
    let mut incoming = Incoming::new(rays, which, diverged);
    for (id, slot) in slots.iter_mut().enumerate().take(task.in_flight) {
        slot.ray = NONE;
        done.append(id as u8, true);
    }
    loop {
        for place in 0..done.restart() {
            let id = done.slot(place);
            let slot = &mut slots[usize::from(id) % RAYS];
            if let Some(ray) = rays.get(slot.ray as usize) {
                answers[slot.ray as usize] = task.query.of_one(ray, &slot.hit());
            }
            while let Some(next) = incoming.next::<S, P::Packs>(terms, task.padding) {
                let taken = slot.take(&next, terms)
                    || take_cut::<S, P, Q, C>(task, slot, (&next, rays), counters, answers);
                if taken {
                    if let Some(ray) = next.diverged {
                        slot.go_on(ray, diverged.entries(ray));
                    }
                    pop(slot, id, true, &mut nodes, &mut leaves, &mut done);
                    break;
                }
            }
        }
        if nodes.length + leaves.length == 0 {
            break;
        }
        if task.large {
            for place in 0..nodes.length {
                task.prefetch(slots[usize::from(nodes.slot(place)) % RAYS].at);
            }
        }
        std::mem::swap(&mut nodes, &mut nodes_now);
        nodes.restart();
        for place in 0..nodes_now.length {
            let id = nodes_now.slot(place);
            let slot = &mut slots[usize::from(id) % RAYS];
            let node = &tree[slot.at.index()];
            if C::COUNTS {
                counters.boxes(node.present().count() as u32);
            }
            let (begin, end) = node.intervals::<S>(
                slot.near_planes,
                splat3::<S::F8>(slot.inv_dir()),
                splat3::<S::F8>(slot.near_offsets()),
                splat3::<S::F8>(slot.far),
                [S::F8::splat(slot.t_min()), S::F8::splat(slot.end())],
            );
            let top = slot.height as usize;
            if any {
                let mask = begin.le(end).bits();
                S::compress(mask, node.children(), row_mut(&mut slot.entries.0, top));
                slot.height += mask.count_ones();
            } else {
                slot.height += S::enter(
                    begin,
                    end,
                    node.children(),
                    node.orders(),
                    slot.order_shift,
                    row_mut(&mut slot.entries.0, top),
                    row_mut(&mut slot.distances.0, top),
                );
            }
            pop(slot, id, true, &mut nodes, &mut leaves, &mut done);
        }

        if task.large {
            for place in 0..leaves.length {
                task.prefetch(slots[usize::from(leaves.slot(place)) % RAYS].at);
            }
        }
        improved.restart();
        std::mem::swap(&mut leaves, &mut leaves_now);
        leaves.restart();
        for place in 0..leaves_now.length {
            let id = leaves_now.slot(place);
            let slot = &mut slots[usize::from(id) % RAYS];
            let block = slot.at.block();
            if C::COUNTS {
                counters.primitives(slot.at.count());
            }
            let mut hits = packs.test_pack::<S>(block, &slot.formula);
            for lane in ones(hits.flat()) {
                hits.replace(lane, packs.flat_hit(block, lane, &rays[slot.ray as usize]));
            }
            let t = hits.t / hits.scale;
            let in_reach = within(t, [S::F8::splat(slot.t_min()), S::F8::splat(slot.end())]);
            let lanes = (hits.inside & in_reach).bits();
            if any {
                // A candidate nearly always ends the search: at most one misprediction a ray.
                if lanes != 0 {
                    t.store(&mut candidates[0].t);
                    candidates[0].lanes = lanes;
                    candidates[0].block = block as u32;
                    if Q::FILTERS {
                        candidates[0].set_coordinates::<S>(&hits);
                    }
                    if any_accepted::<S, P, Q>(slot, task, rays, &mut candidates[0]) {
                        slot.prim = 0;
                        slot.height = 1;
                    }
                }
                pop(slot, id, true, &mut nodes, &mut leaves, &mut done);
                continue;
            }
            let offered = &mut candidates[improved.length % RAYS];
            t.store(&mut offered.t);
            offered.set_coordinates::<S>(&hits);
            offered.lanes = lanes;
            offered.block = block as u32;
            // No branch: whether a leaf has a candidate cannot be foreseen.
            improved.append(id, lanes != 0);
            pop(slot, id, lanes == 0, &mut nodes, &mut leaves, &mut done);
        }

        for place in 0..improved.length {
            let id = improved.slot(place);
            let slot = &mut slots[usize::from(id) % RAYS];
            if improve::<S, P, Q>(slot, task, rays, &mut candidates[place % RAYS]) {
                drop_behind::<S, _>(slot);
            }
            pop(slot, id, true, &mut nodes, &mut leaves, &mut done);
        }
    }
}

impl<R> Slot<R> {
    fn hit(&self) -> Hit {
        if self.prim == NONE {
            return Hit::MISS;
        }
        Hit { t: self.end(), object: 0, prim: self.prim, u: self.u, v: self.v }
    }
}

/// Puts a ray that hardly moves along an axis into a slot, or searches it alone and returns false if
/// the slab test cannot take it. Apart, for the sake of usual rays.
#[cold]
#[inline(never)]
fn take_cut<S: Simd, P: Primitives, Q: Query, C: Counters>(
    task: &Task<'_, P, Q>,
    slot: &mut Slot<RayOf<P>>,
    (next, rays): (&Next<'_>, &[Ray]),
    counters: &mut C,
    answers: &mut [Q::Answer],
) -> bool {
    let ray = &rays[next.index as usize];
    let box_ray = BoxRay::new(ray, task.padding);
    let Some(slab) = SlabRay::cut::<S>(ray, &box_ray, task.padding) else {
        debug_assert!(next.diverged.is_none(), "a packet has taken the ray by the same terms");
        answers[next.index as usize] =
            search_one(task.tree, task.query, task.primitives, ray, counters);
        return false;
    };
    let (inv, near) = (slab.inv_dir, slab.near);
    slot.near = [inv.x, inv.y, inv.z, ray.t_min, near.x, near.y, near.z, ray.t_max];
    slot.far = slab.far.to_array();
    slot.formula = P::Packs::ray(ray, &box_ray.inv_dir.to_array());
    slot.begin(next.index, slab.octant);
    true
}

impl<R: Copy> Slot<R> {
    /// Takes a ray by its terms; returns false if they are not the usual ones.
    #[inline(always)]
    fn take(&mut self, next: &Next<'_>, terms: &Terms<R>) -> bool {
        let lane = next.lane % PACK;
        if !terms.are_usual(lane) {
            return false;
        }
        self.near = terms.near[lane];
        let [x, y, z, ..] = terms.far[lane];
        self.far = [x, y, z];
        self.formula = terms.formula[lane];
        self.begin(next.index, terms.octant(lane));
        true
    }

    /// Begins with the root.
    #[inline(always)]
    fn begin(&mut self, index: u32, octant: u32) {
        self.near_planes = near_planes(octant);
        self.order_shift = order_shift(octant);
        self.prim = NONE;
        self.ray = index;
        self.entries.0[1] = Child::ROOT.0;
        self.height = 2;
    }
}

impl<R> Slot<R> {
    /// Gives a ray what it has found on its way, and what it is still to visit.
    #[inline(always)]
    fn go_on(&mut self, ray: &DivergedRay, entries: &[(Child, f32)]) {
        let Hit { t, prim, u, v, .. } = ray.best;
        (self.near[END], self.prim, self.u, self.v) = (t, prim, u, v);
        let places = self.entries.0[1..HEIGHT].iter_mut().zip(&mut self.distances.0[1..HEIGHT]);
        for ((entry, distance), (child, begin)) in places.zip(entries) {
            (*entry, *distance) = (child.0, *begin);
        }
        self.height = 1 + entries.len().min(HEIGHT - 1) as u32;
    }
}

/// Appends a ray to the list where the top of its stack belongs, and takes that from the stack;
/// leaves the stack and the lists as they are if the ray is not `free` to go.
#[inline(always)]
fn pop<R>(
    slot: &mut Slot<R>,
    id: u8,
    free: bool,
    nodes: &mut List<'_>,
    leaves: &mut List<'_>,
    done: &mut List<'_>,
) {
    let next = Child(slot.entries.0[(slot.height - 1) as usize % HEIGHT]);
    slot.height -= u32::from(free);
    slot.at = next;
    let (leaf, end) = (next.is_leaf(), next == Child::ABSENT);
    nodes.append(id, free & !leaf);
    leaves.append(id, free & leaf & !end);
    done.append(id, free & end);
}

/// Whether any candidate counts.
#[inline(always)]
fn any_accepted<S: Simd, P: Primitives, Q: Query>(
    slot: &Slot<RayOf<P>>,
    task: &Task<'_, P, Q>,
    rays: &[Ray],
    offered: &mut Candidates,
) -> bool {
    offered.place::<S, P, Q>(slot, task, rays);
    ones(offered.lanes).any(|lane| offered.is_accepted(lane % PACK, slot.ray, task, rays))
}

/// Replaces a ray's best hit by the first candidate that counts, if that comes before. Returns
/// whether there is one.
#[inline(always)]
fn improve<S: Simd, P: Primitives, Q: Query>(
    slot: &mut Slot<RayOf<P>>,
    task: &Task<'_, P, Q>,
    rays: &[Ray],
    offered: &mut Candidates,
) -> bool {
    offered.place::<S, P, Q>(slot, task, rays);
    let t = S::F8::load(&offered.t);
    let mut lanes = offered.lanes;
    while lanes != 0 {
        // Ids ascend within a pack: the first of equal lanes is the one that counts.
        let lane = t.first_smallest(lanes) % PACK;
        if offered.is_accepted(lane, slot.ray, task, rays) {
            let Hit { t, prim, u, v, .. } = offered.hit(lane, task.packs);
            let better = (t < slot.end()) | (prim < slot.prim);
            slot.near[END] = if better { t } else { slot.end() };
            slot.prim = if better { prim } else { slot.prim };
            slot.u = if better { u } else { slot.u };
            slot.v = if better { v } else { slot.v };
            return true;
        }
        lanes &= !(1 << lane);
    }
    false
}

/// Takes from a ray's stack what begins behind the end of the search.
#[inline(always)]
fn drop_behind<S: Simd, R>(slot: &mut Slot<R>) {
    let (end, height) = (S::F8::splat(slot.end()), slot.height as usize);
    let (mut kept, mut base) = (0, 0);
    while base < height {
        let begins = S::F8::load(row_mut(&mut slot.distances.0, base));
        let live = (1u32 << (height - base).min(PACK)) - 1;
        let mask = begins.le(end).bits() & live;
        let row = *row_mut(&mut slot.entries.0, base);
        S::compress(mask, &row, row_mut(&mut slot.entries.0, kept));
        S::compress_floats(mask, begins, row_mut(&mut slot.distances.0, kept));
        kept += mask.count_ones() as usize;
        base += PACK;
    }
    slot.height = kept as u32;
}

/// Eight places of a stack.
#[inline(always)]
fn row_mut<T>(stack: &mut [T; ROOM], at: usize) -> &mut [T; PACK] {
    stack[at % HEIGHT..].first_chunk_mut().expect("a row has room behind every place")
}
