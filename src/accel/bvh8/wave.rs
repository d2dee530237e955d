//! Waves: dozens of rays in flight on one thread, without a branch that cannot be foreseen.
//!
//! A ray that walks a tree alone takes a turn at every node that no processor can predict, and
//! waits. Here each ray stands in a list: of rays at a node, at a leaf, with a candidate for the
//! closest hit, or done. A phase goes through its list, does the same work for each ray and appends
//! it, by arithmetic, to the list that it belongs to next. The rays of a phase do not depend on
//! each other, so the processor works on several at once.

use crate::accel::{PACK, Packs, Primitives};
use crate::counters::Counters;
use crate::math::{BoxRay, Hit, NONE, Ray};
use crate::simd::{Mask, Row, Simd, splat3};

use super::Search;
use super::answer::Answer;
use super::node::{Child, near_rows, order_shift};
use super::slab_ray::SlabRay;

/// Rays in flight.
const RAYS: usize = 32;

/// The memory of a wave, kept from call to call.
pub(super) struct Scratch {
    slots: Vec<Slot>,
    /// The rays' stacks, one behind the other: what is to be visited, and where it begins.
    entries: Vec<u32>,
    distances: Vec<f32>,
    /// Places of a ray's stack.
    stride: usize,
    /// The memory of the lists.
    lists: [[u32; 2 * RAYS]; 6],
    candidates: Vec<Candidates>,
}

/// A ray in flight.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
struct Slot {
    slab: SlabRay,
    origin: [f32; 3],
    t_min: f32,
    dir: [f32; 3],
    /// The end of the search: the best hit's parameter, or the ray's end.
    end: f32,
    near_rows: [u32; 3],
    order_shift: u32,
    /// Where it stands.
    at: Child,
    /// Entries on its stack.
    height: u32,
    /// The best hit.
    prim: u32,
    u: f32,
    v: f32,
    /// Its number in the caller's slice.
    ray: u32,
    box_ray: BoxRay,
}

/// Rays by their slot; room for one more than there can be, because what does not belong is
/// written too, and then overwritten.
struct List<'a> {
    slots: &'a mut [u32; 2 * RAYS],
    length: usize,
}

/// What a leaf offers a ray.
#[derive(Clone, Copy, Debug, Default)]
#[repr(C, align(64))]
struct Candidates {
    t: [f32; PACK],
    u: [f32; PACK],
    v: [f32; PACK],
    det: [f32; PACK],
    lanes: u32,
}

impl<'a> List<'a> {
    fn empty(slots: &'a mut [u32; 2 * RAYS]) -> Self {
        Self { slots, length: 0 }
    }

    /// Appends a slot if it `belongs`.
    #[inline(always)]
    fn append(&mut self, slot: u32, belongs: bool) {
        self.slots[self.length % (2 * RAYS)] = slot;
        self.length += usize::from(belongs);
    }

    #[inline(always)]
    fn slots(&self) -> &[u32] {
        &self.slots[..self.length.min(2 * RAYS)]
    }
}

impl Default for Scratch {
    fn default() -> Self {
        Self {
            slots: Vec::new(),
            entries: Vec::new(),
            distances: Vec::new(),
            stride: 0,
            lists: [[0; 2 * RAYS]; 6],
            candidates: Vec::new(),
        }
    }
}

impl Scratch {
    /// Makes room for the stacks of a tree that puts up to `need` entries on one.
    fn prepare(&mut self, need: usize) {
        // Below the entries lies the end of the stack; beyond them, a row is written at once.
        let stride = (1 + need + PACK).next_multiple_of(PACK);
        if self.slots.is_empty() || self.stride < stride {
            self.stride = stride;
            self.slots.resize(RAYS, Slot::VACANT);
            // The bottoms of the stacks move, and each must hold the end.
            self.entries.clear();
            self.distances.clear();
            self.entries.resize(RAYS * stride, Child::ABSENT.0);
            self.distances.resize(RAYS * stride, f32::NEG_INFINITY);
            self.candidates.resize(RAYS, Candidates::default());
        }
    }
}

impl Slot {
    const VACANT: Self = Self {
        slab: SlabRay::VACANT,
        origin: [0.0; 3],
        t_min: 0.0,
        dir: [0.0; 3],
        end: 0.0,
        near_rows: [0; 3],
        order_shift: 0,
        at: Child::ABSENT,
        height: 0,
        prim: NONE,
        u: 0.0,
        v: 0.0,
        ray: 0,
        box_ray: BoxRay {
            inv_dir: glam::Vec3A::ZERO,
            origin_plus: glam::Vec3A::ZERO,
            origin_minus: glam::Vec3A::ZERO,
            pad: 0.0,
        },
    };
}

/// Answers those of the rays whose places in the slice are in `which`.
#[inline(always)]
pub(super) fn search<S: Simd, P: Primitives, A: Answer, C: Counters>(
    search: &Search<'_, P>,
    rays: &[Ray],
    which: &[u32],
    answers: &mut [A],
    scratch: &mut Scratch,
    counters: &mut C,
) {
    let tree = search.tree;
    scratch.prepare(tree.need);
    let Scratch {
        slots,
        entries,
        distances,
        stride,
        lists: [nodes, next_nodes, leaves, next_leaves, with_candidate, done],
        candidates,
    } = scratch;
    let stride = *stride;
    let (mut nodes, mut next_nodes) = (List::empty(nodes), List::empty(next_nodes));
    let (mut leaves, mut next_leaves) = (List::empty(leaves), List::empty(next_leaves));
    let (mut with_candidate, mut done) = (List::empty(with_candidate), List::empty(done));
    let candidates: &mut [Candidates; RAYS] =
        candidates.first_chunk_mut().expect("a place for each ray");
    let slots: &mut [Slot; RAYS] = slots.first_chunk_mut().expect("a slot for each ray");
    let mut waiting = which.iter();
    for slot in 0..RAYS as u32 {
        let taken = take::<S, P, A, C>(
            search,
            rays,
            &mut waiting,
            &mut slots[slot as usize],
            counters,
            answers,
        );
        nodes.append(slot, taken);
        if !taken {
            break;
        }
    }
    let zero = S::F8::splat(0.0);
    while nodes.length + leaves.length > 0 {
        next_nodes.length = 0;
        for &id in nodes.slots() {
            let slot = &mut slots[id as usize % RAYS];
            let node = &tree.nodes[slot.at.index()];
            if C::COUNTS {
                counters.boxes(node.present().count() as u32);
            }
            let [x, y, z] = slot.near_rows;
            let (x, y, z) = (x as usize, y as usize, z as usize);
            let inv = splat3::<S::F8, 8>(slot.slab.inv_dir.to_array());
            let near = splat3::<S::F8, 8>(slot.slab.near.to_array());
            let far = splat3::<S::F8, 8>(slot.slab.far.to_array());
            let begin = S::F8::slab(node.planes::<S>(x), inv[0], near[0])
                .max(S::F8::slab(node.planes::<S>(y), inv[1], near[1]))
                .max(
                    S::F8::slab(node.planes::<S>(z), inv[2], near[2]).max(S::F8::splat(slot.t_min)),
                );
            let end = S::F8::slab(node.planes::<S>(x ^ 1), inv[0], far[0])
                .min(S::F8::slab(node.planes::<S>(y ^ 1), inv[1], far[1]))
                .min(
                    S::F8::slab(node.planes::<S>(z ^ 1), inv[2], far[2])
                        .min(S::F8::splat(slot.end)),
                );
            let bottom = id as usize % RAYS * stride;
            let top = bottom + slot.height as usize;
            if A::ANY {
                let mask = begin.le(end).bits();
                S::compress(mask, node.children(), row_mut(entries, top));
                slot.height += mask.count_ones();
            } else {
                slot.height += S::enter(
                    begin,
                    end,
                    node.children(),
                    node.orders(),
                    slot.order_shift,
                    row_mut(entries, top),
                    row_mut(distances, top),
                );
            }
            pop(slot, &entries[bottom..], id, true, &mut next_nodes, &mut leaves, &mut done);
        }
        std::mem::swap(&mut nodes, &mut next_nodes);

        next_leaves.length = 0;
        with_candidate.length = 0;
        for &id in leaves.slots() {
            let slot = &mut slots[id as usize % RAYS];
            let block = slot.at.block();
            if C::COUNTS {
                counters.primitives(slot.at.count());
            }
            let hit = search.packs.of_pack::<S>(
                block,
                splat3::<S::F8, 8>(slot.origin),
                splat3::<S::F8, 8>(slot.dir),
            );
            let t = hit.t / hit.det;
            let inside = zero.le(hit.u) & zero.le(hit.v) & (hit.u + hit.v).le(hit.det);
            let in_reach = S::F8::splat(slot.t_min).le(t) & t.le(S::F8::splat(slot.end));
            let lanes = (inside & in_reach).bits();
            let bottom = id as usize % RAYS * stride;
            if A::ANY {
                // A candidate nearly always ends the search: one surprise a ray at most.
                if lanes != 0 {
                    let mut ts = [0.0; PACK];
                    t.store(&mut ts);
                    if (0..PACK).any(|lane| {
                        lanes >> lane & 1 != 0
                            && slot.box_ray.accepts(&search.packs.bounds(block, lane), ts[lane])
                    }) {
                        slot.prim = 0;
                        slot.height = 1;
                    }
                }
                pop(slot, &entries[bottom..], id, true, &mut nodes, &mut next_leaves, &mut done);
                continue;
            }
            let offered = &mut candidates[with_candidate.length % RAYS];
            t.store(&mut offered.t);
            hit.u.store(&mut offered.u);
            hit.v.store(&mut offered.v);
            hit.det.store(&mut offered.det);
            offered.lanes = lanes;
            // Kept from becoming a branch: whether a leaf has a candidate cannot be foreseen.
            let any = std::hint::black_box(lanes) != 0;
            with_candidate.append(id, any);
            pop(slot, &entries[bottom..], id, !any, &mut nodes, &mut next_leaves, &mut done);
        }

        for (index, &id) in with_candidate.slots().iter().enumerate() {
            let slot = &mut slots[id as usize % RAYS];
            let bottom = id as usize % RAYS * stride;
            if improve::<S, P::Packs>(slot, search.packs, &candidates[index % RAYS]) {
                let height = slot.height as usize;
                let kept = drop_behind::<S>(
                    &mut entries[bottom..bottom + stride],
                    &mut distances[bottom..bottom + stride],
                    height,
                    slot.end,
                );
                slot.height = kept as u32;
            }
            pop(slot, &entries[bottom..], id, true, &mut nodes, &mut next_leaves, &mut done);
        }
        std::mem::swap(&mut leaves, &mut next_leaves);

        for &id in done.slots() {
            let slot = &mut slots[id as usize % RAYS];
            answers[slot.ray as usize] = A::of(slot.hit());
            let taken = take::<S, P, A, C>(search, rays, &mut waiting, slot, counters, answers);
            nodes.append(id, taken);
        }
        done.length = 0;
    }
}

impl Slot {
    fn hit(&self) -> Hit {
        if self.prim == NONE {
            return Hit::MISS;
        }
        Hit { t: self.end, object: 0, prim: self.prim, u: self.u, v: self.v }
    }
}

/// Puts the next ray into a slot. Rays that the slab test cannot take are traced at once, alone.
#[inline(always)]
fn take<S: Simd, P: Primitives, A: Answer, C: Counters>(
    search: &Search<'_, P>,
    rays: &[Ray],
    waiting: &mut std::slice::Iter<'_, u32>,
    slot: &mut Slot,
    counters: &mut C,
    answers: &mut [A],
) -> bool {
    for &index in waiting {
        let ray = &rays[index as usize];
        let box_ray = BoxRay::new(ray, search.padding);
        let Some(slab) = SlabRay::new::<S>(ray, &box_ray, search.padding) else {
            answers[index as usize] = A::alone(search.tree, search.primitives, ray, counters);
            continue;
        };
        // Field by field: a whole slot would be put together elsewhere and copied.
        slot.near_rows = near_rows(slab.octant);
        slot.order_shift = order_shift(slab.octant);
        slot.slab = slab;
        slot.origin = ray.origin.to_array();
        slot.t_min = ray.t_min;
        slot.dir = ray.dir.to_array();
        slot.end = ray.t_max;
        slot.at = Child::node(0);
        slot.height = 1;
        slot.prim = NONE;
        slot.u = 0.0;
        slot.v = 0.0;
        slot.ray = index;
        slot.box_ray = box_ray;
        return true;
    }
    false
}

/// Takes the top of a ray's stack, and appends the ray to the list where it belongs next; does
/// nothing if it is not `free` to go.
#[inline(always)]
fn pop(
    slot: &mut Slot,
    stack: &[u32],
    id: u32,
    free: bool,
    nodes: &mut List<'_>,
    leaves: &mut List<'_>,
    done: &mut List<'_>,
) {
    let top = slot.height - 1;
    let next = Child(stack[top as usize]);
    slot.height = if free { top } else { slot.height };
    slot.at = if free { next } else { slot.at };
    let (leaf, end) = (next.is_leaf(), next == Child::ABSENT);
    nodes.append(id, free & !leaf);
    leaves.append(id, free & leaf & !end);
    done.append(id, free & end);
}

/// Replaces a ray's best hit by the first candidate that its own box accepts, if that comes before.
#[inline(always)]
fn improve<S: Simd, P: Packs>(slot: &mut Slot, packs: &P, offered: &Candidates) -> bool {
    let block = slot.at.block();
    let t = S::F8::load(&offered.t);
    let mut lanes = offered.lanes;
    while lanes != 0 {
        // Ids ascend within a pack: the first of equal lanes is the one that counts.
        let lane = t.first_smallest(lanes) % PACK;
        let (at, prim) = (offered.t[lane], packs.id(block, lane));
        if slot.box_ray.accepts(&packs.bounds(block, lane), at) {
            let better = (at < slot.end) | (prim < slot.prim);
            let det = offered.det[lane];
            let (u, v) = (offered.u[lane] / det, offered.v[lane] / det);
            slot.end = if better { at } else { slot.end };
            slot.prim = if better { prim } else { slot.prim };
            slot.u = if better { u } else { slot.u };
            slot.v = if better { v } else { slot.v };
            return true;
        }
        lanes &= !(1 << lane);
    }
    false
}

/// Takes from a stack what begins behind the end of the search. Returns its height.
#[inline(always)]
fn drop_behind<S: Simd>(
    entries: &mut [u32],
    distances: &mut [f32],
    height: usize,
    end: f32,
) -> usize {
    let end = S::F8::splat(end);
    let (mut kept, mut base) = (0, 0);
    while base < height {
        let begins = S::F8::load(row_mut(distances, base));
        let live = (1u32 << (height - base).min(PACK)) - 1;
        let mask = begins.le(end).bits() & live;
        let row = *row_mut(entries, base);
        S::compress(mask, &row, row_mut(entries, kept));
        S::compress_floats(mask, begins, row_mut(distances, kept));
        kept += mask.count_ones() as usize;
        base += PACK;
    }
    kept
}

#[inline(always)]
fn row_mut<T>(values: &mut [T], at: usize) -> &mut [T; PACK] {
    values[at..].first_chunk_mut().expect("stacks end with room for a row")
}
