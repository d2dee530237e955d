//! Waves: dozens of rays in flight on one thread, without a branch that cannot be foreseen.
//!
//! A ray that walks a tree alone takes a turn at every node that no processor can predict, and
//! waits. Here each ray is in a list: of rays at a node, at a leaf, with a candidate for the
//! closest hit, or done. A phase goes through its list, does the same work for each ray, and notes what
//! the ray has on top of its stack then; eight at a time, the rays go to the lists that they belong to
//! (`list.rs`). The rays of a phase do not depend on each other, so the processor works on several at once. The root
//! is met before, by eight rays together (`root.rs`); those that pass by its children never take a slot, and the others
//! wait until they are eight again (`waiting.rs`).

mod columns;
mod entrance;
mod incoming;
mod list;
mod root;
mod slot;
mod waiting;

use crate::accel::{PACK, Packs, Primitives, Query, Search, search_one};
use crate::counters::Counters;
use crate::math::{BoxRay, NONE, Ray};
use crate::simd::{Cache, Simd};

use self::entrance::Entrance;
use self::incoming::{Arrival, Incoming};
use self::list::{List, Places};
use self::root::Root;
use self::slot::Slot;
use self::waiting::{Ready, Waiting};
use super::candidates::Candidates;
use super::diverged::Diverged;
use super::node::Child;
use super::slab_ray::SlabRay;
use super::task::{MOST_IN_FLIGHT, RayOf, Task};

/// The most rays in flight.
const RAYS: usize = MOST_IN_FLIGHT;

/// The memory of a wave; `R` is a ray as the primitives' formula takes it.
pub(super) struct Memory<R> {
    slots: [Slot<R>; RAYS],
    formulas: [R; PACK],
    candidates: [Candidates; RAYS],
    lists: [Places; 4],
    waiting: Waiting,
}

impl<R: Copy + Default> Default for Memory<R> {
    fn default() -> Self {
        Self {
            slots: [Slot::vacant(); RAYS],
            formulas: [R::default(); PACK],
            candidates: [Candidates::NONE; RAYS],
            lists: [const { Places::new() }; 4],
            waiting: Waiting::NONE,
        }
    }
}

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
    let worthwhile = task.wave.worthwhile;
    let any = const { matches!(Q::SEARCH, Search::First) };
    let tree = &task.tree.nodes[..];
    let Some(root) = tree.first().map(Root::new) else { return };
    let Memory { slots, formulas, candidates, lists: [a, b, c, d], waiting } = memory;
    let (mut nodes, mut leaves) = (List::new(a), List::new(b));
    let (mut improved, mut done) = (List::new(c), List::new(d));
    let mut entrance = Entrance::new(Incoming::new(which, diverged), root, waiting);
    for (id, slot) in slots.iter_mut().enumerate().take(task.wave.in_flight) {
        slot.ray = NONE;
        done.append_if(id as u32, true);
    }
    loop {
        // As long as rays are in flight, those that come next wait until eight slots are free.
        while done.length >= PACK {
            let ready = entrance.next::<S, P, Q, C>(task, rays, answers, counters);
            let Some(Ready { columns, begins, numbers, count }) = ready else { break };
            let ids = done.take_last(count);
            let terms = columns.terms();
            P::Packs::eight_rays::<S>(&columns.origin, &columns.dir, &columns.inv_dir, formulas);
            let begins = S::transpose_eight(begins);
            let mut next = [Child::ABSENT; PACK];
            for lane in 0..count {
                let slot = &mut slots[ids[lane] as usize % RAYS];
                answer::<P, Q>(slot, task, rays, answers);
                next[lane] = match entrance.incoming.arrival(numbers[lane]) {
                    Arrival::AtRoot(ray) => {
                        terms.begin(lane, slot, formulas, ray);
                        slot.enter_root::<S>(entrance.root.node, begins[lane], any)
                    }
                    Arrival::Elsewhere { ray, begun, is_usual } => {
                        terms.begin(lane, slot, formulas, ray);
                        if !is_usual && !take_cut::<S, P, Q, C>(task, slot, rays, counters, answers)
                        {
                            done.append_if(ids[lane], true);
                            continue;
                        }
                        // None is done: those that have nothing to visit do not come.
                        match begun {
                            Some(ray) => slot.go_on(ray, diverged.entries(ray)),
                            None => Child::ROOT,
                        }
                    }
                };
            }
            let next = next.map(|child| child.0);
            List::send_eight::<S>((&ids, &next), count, &mut nodes, &mut leaves);
        }
        if nodes.length + leaves.length == 0 {
            break;
        }

        if task.far {
            prefetch(task, &nodes);
        }
        for place in 0..nodes.length {
            let slot = &mut slots[nodes.slot(place) as usize % RAYS];
            let node = &tree[nodes.next(place).index()];
            if C::COUNTS {
                counters.boxes(node.present().count() as u32);
            }
            let next = if any { slot.enter_any::<S>(node) } else { slot.enter::<S>(node) };
            nodes.set_next(place, next);
        }
        nodes.keep_nodes::<S>(&mut leaves, &mut done);

        if leaves.length < worthwhile && nodes.length >= worthwhile {
            continue;
        }
        if task.far_packs {
            prefetch(task, &leaves);
        }
        // A bit for each leaf that has a candidate.
        let mut offering = 0;
        for place in 0..leaves.length {
            let (id, leaf) = (leaves.slot(place), leaves.next(place));
            let slot = &mut slots[id as usize % RAYS];
            if C::COUNTS {
                counters.primitives(leaf.count());
            }
            let searched = [slot.t_min(), slot.end()];
            let of_rays = (rays, slot.ray as usize);
            let offered = &mut candidates[if any { 0 } else { improved.length % RAYS }];
            let is_met =
                offered.test::<S, P, Q>(task, leaf.block(), of_rays, &slot.formula, searched);
            if any {
                // A candidate nearly always ends the search: at most one misprediction a ray.
                if is_met && offered.any_counts::<S, P, Q>(task, &rays[slot.ray as usize], searched)
                {
                    slot.prim = 0;
                    slot.finish();
                }
                leaves.set_next(place, slot.pop());
                continue;
            }
            // No branch: whether a leaf has a candidate cannot be foreseen.
            improved.append_if(id, is_met);
            offering |= u64::from(is_met) << (place % 64);
            leaves.set_next(place, slot.pop_if(!is_met));
        }
        leaves.keep_leaves::<S>(offering, &mut nodes, &mut done);
        if improved.length < PACK && nodes.length + leaves.length >= worthwhile {
            continue;
        }

        for place in 0..improved.length {
            let slot = &mut slots[improved.slot(place) as usize % RAYS];
            let (ray, searched) = (&rays[slot.ray as usize], [slot.t_min(), slot.end()]);
            if candidates[place % RAYS].first::<S, P, Q>(task, ray, searched, |hit| slot.offer(hit))
            {
                slot.drop_behind::<S>();
            }
            improved.set_next(place, slot.pop());
        }
        improved.empty::<S>(&mut nodes, &mut leaves, &mut done);
    }
    for place in 0..done.length {
        answer::<P, Q>(&slots[done.slot(place) as usize % RAYS], task, rays, answers);
    }
}

/// Asks for what the rays of a list visit next.
#[inline(always)]
fn prefetch<P: Primitives, Q: Query>(task: &Task<'_, P, Q>, list: &List<'_>) {
    for place in 0..list.length {
        task.prefetch(list.next(place), Cache::Second);
    }
}

/// Answers the ray of a slot, if it has one.
#[inline(always)]
fn answer<P: Primitives, Q: Query>(
    slot: &Slot<RayOf<P>>,
    task: &Task<'_, P, Q>,
    rays: &[Ray],
    answers: &mut [Q::Answer],
) {
    if let Some(ray) = rays.get(slot.ray as usize) {
        answers[slot.ray as usize] = task.query.of_one(ray, &slot.hit());
    }
}

/// Gives the ray of a slot, which hardly moves along an axis, terms that serve, or searches it alone and returns false
/// if the slab test cannot take it; then the slot has none. Apart, for the sake of usual rays.
#[cold]
#[inline(never)]
fn take_cut<S: Simd, P: Primitives, Q: Query, C: Counters>(
    task: &Task<'_, P, Q>,
    slot: &mut Slot<RayOf<P>>,
    rays: &[Ray],
    counters: &mut C,
    answers: &mut [Q::Answer],
) -> bool {
    let index = std::mem::replace(&mut slot.ray, NONE);
    let ray = &rays[index as usize];
    let box_ray = BoxRay::new(ray, task.padding);
    let Some(slab) = SlabRay::cut::<S>(ray, &box_ray, task.padding) else {
        answers[index as usize] = search_one(task.tree, task.query, task.primitives, ray, counters);
        return false;
    };
    slot.set_terms(&slab, [ray.t_min, ray.end()]);
    slot.formula = P::Packs::ray(ray, &box_ray.inv_dir.to_array());
    slot.ray = index;
    true
}
