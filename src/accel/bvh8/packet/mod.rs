//! Packets: coherent rays go down the tree together, as many as suit the instruction set.
//!
//! The packet as a whole is tested against a node's eight children at once, by intervals: the
//! slab test with the smallest and the largest of the rays' terms bounds that of every ray from
//! below and above, because each of its operations is monotone. Children, and primitives of a leaf,
//! that the packet as a whole misses cost no more than that; the others are tested with a ray in
//! each lane, or a leaf with each ray by itself where these are few (`leaf.rs`). After Boulos, Wald,
//! Shirley: *Geometric and Arithmetic Culling Methods for Entire Ray Packets*, 2006.

mod best;
mod leaf;
mod rays;

use std::hint::black_box;

use crate::accel::{Packs, Primitives, Query, Search};
use crate::counters::Counters;
use crate::math::{Hit, Lanes as _, Mask as _, Ray, ones};
use crate::simd::{Cache, Kernel, LARGEST_PACKET, PacketKernel, Row, Simd, dispatch};

use self::best::Best;
use self::leaf::{Formulas, PacketRays};
pub(super) use self::rays::Packet;
use self::rays::all;
use super::HEIGHT;
use super::coherence::Coherence;
use super::diverged::Diverged;
use super::node::{Child, order_shift};
use super::task::{RayOf, Task};

/// The memory of a packet; `R` is a ray as the primitives' formula takes it.
pub(super) struct Memory<R> {
    stack: Stack,
    formulas: Formulas<R>,
    coherence: Coherence,
}

impl<R: Copy + Default> Default for Memory<R> {
    fn default() -> Self {
        Self {
            stack: Stack::default(),
            formulas: Formulas::default(),
            coherence: Coherence::default(),
        }
    }
}

impl<R> Memory<R> {
    /// Forgets how the packets of another slice fared.
    pub(super) fn start_slice(&mut self) {
        self.coherence = Coherence::default();
    }
}

/// The stack of a packet.
struct Stack {
    /// What is to be visited, and by which rays.
    entries: [(Child, u32); HEIGHT],
    /// Where each ray enters it.
    begins: [[f32; LARGEST_PACKET]; HEIGHT],
}

impl Default for Stack {
    fn default() -> Self {
        Self { entries: [(Child::ABSENT, 0); HEIGHT], begins: [[0.0; LARGEST_PACKET]; HEIGHT] }
    }
}

/// The row of a packet, in a row with room for the largest.
#[inline(always)]
fn row<const N: usize>(row: &mut [f32; LARGEST_PACKET]) -> &mut [f32; N] {
    row.first_chunk_mut().expect("no packet is larger than the largest")
}

/// Rays as the formula of primitives takes them, a ray in each lane.
type RaysOf<P, R> = <<P as Primitives>::Packs as Packs>::Rays<R>;

/// What became of the rays of a packet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Outcome {
    /// All are answered.
    Answered,
    /// They do not make a packet; nothing was done.
    Incoherent,
    /// The packet diverged on the way: the rays that are still to visit something were set aside,
    /// the others are answered.
    Diverged,
}

/// A packet of rays, some of which hardly move along an axis, and all that is needed to answer them.
struct AxisAligned<'a, P: Primitives, Q: Query, C> {
    task: &'a Task<'a, P, Q>,
    rays: (u32, &'a [Ray]),
    answers: &'a mut [Q::Answer],
    memory: &'a mut Memory<RayOf<P>>,
    diverged: &'a mut Diverged,
    counters: &'a mut C,
}

impl<P: Primitives, Q: Query, C: Counters> AxisAligned<'_, P, Q, C> {
    /// These have a kernel of their own: with terms from two places, that of usual rays took up to
    /// 1.08 × as long.
    #[cold]
    #[inline(never)]
    fn search(self) -> Outcome {
        dispatch(self)
    }
}

impl<P: Primitives, Q: Query, C: Counters> Kernel for AxisAligned<'_, P, Q, C> {
    type Output = Outcome;

    #[inline(always)]
    fn run<S: Simd>(self) -> Outcome {
        S::in_packets(self)
    }
}

impl<P: Primitives, Q: Query, C: Counters> PacketKernel for AxisAligned<'_, P, Q, C> {
    type Output = Outcome;

    #[inline(always)]
    fn run<S: Simd, R: Row<N>, const N: usize>(self) -> Outcome {
        let Self { task, rays: (first, rays), answers, memory, diverged, counters } = self;
        let (Some(rays), Some(answers)) = (rays.first_chunk(), answers.first_chunk_mut()) else {
            return Outcome::Incoherent;
        };
        let rays = (first, rays);
        let mut packet = Packet::vacant();
        search::<S, R, P, Q, C, true, N>(
            task,
            rays,
            &mut packet,
            answers,
            memory,
            diverged,
            counters,
        )
    }
}

/// Answers the rays of a packet, the first of which has the place `first` in the slice, or sets some aside
/// that diverged. They are laid out in `packet`. Their terms are the usual ones, or those that are `CUT`.
#[inline(always)]
pub(super) fn search<
    S: Simd,
    R: Row<N>,
    P: Primitives,
    Q: Query,
    C: Counters,
    const CUT: bool,
    const N: usize,
>(
    task: &Task<'_, P, Q>,
    (first, rays): (u32, &[Ray; N]),
    packet: &mut Packet<S, R, N>,
    answers: &mut [Q::Answer; N],
    memory: &mut Memory<RayOf<P>>,
    diverged: &mut Diverged,
    counters: &mut C,
) -> Outcome {
    let any = const { matches!(Q::SEARCH, Search::First) };
    let Some((ends, fits)) = packet.load(rays, task.padding) else {
        return Outcome::Incoherent;
    };
    if CUT {
        if !packet.cut(task.padding) {
            return Outcome::Incoherent;
        }
    } else if !fits {
        let rays = (first, &rays[..]);
        return AxisAligned { task, rays, answers, memory, diverged, counters }.search();
    }
    // As if it were other memory: what the compiler knows of its rows it keeps in registers, and copies to its stack.
    let packet = black_box(&*packet);
    let of_formula = <P::Packs as Packs>::rays::<R>(&packet.origin, &packet.dir, &packet.inv_dir);
    let Memory { stack, formulas, coherence } = memory;
    let mut budget = coherence.budget(N as u32);
    let mut best = Best::none_before(ends);
    formulas.clear();
    let mut of_packet = PacketRays { rays, packet, of_formula: &of_formula, formulas };
    let tree = task.tree;
    let Stack { entries, begins } = stack;
    entries[0] = (Child::ROOT, all(N));
    begins[0] = [f32::NEG_INFINITY; LARGEST_PACKET];
    let mut top = 1;
    let mut end = S::F8::splat(best.ends::<R>().largest());
    let shift = order_shift(packet.octant);
    while top > 0 {
        top -= 1;
        let (child, mut active) = entries[top % HEIGHT];
        if any {
            active &= !best.hit;
        } else {
            active &= R::load(row(&mut begins[top % HEIGHT])).le(best.ends()).bits();
        }
        if active == 0 {
            continue;
        }
        if !budget.pay(active) {
            best.answer::<R, Q>(task.query, rays, answers);
            let hits: [Hit; N] = std::array::from_fn(|ray| best.of_ray(ray));
            let answered = if any { best.hit } else { 0 };
            stack.set_aside(top + 1, first, &hits, answered, any, diverged);
            return Outcome::Diverged;
        }
        if child.is_leaf() {
            if C::COUNTS {
                counters.primitives(child.count() * active.count_ones());
            }
            if task.far {
                coherence.note_leaf(active);
            }
            leaf::test(task, &mut of_packet, child, active, end, &mut best);
            if any && best.hit == all(N) {
                break;
            }
            if !any {
                end = S::F8::splat(best.ends::<R>().largest());
            }
            continue;
        }
        let node = &tree.nodes[child.index()];
        if C::COUNTS {
            counters.boxes(node.present().count() as u32 * active.count_ones());
        }
        let (near, far) = packet.hull_of_node(node, end);
        let (crossed, count) = S::crossed(near, far, node.orders(), shift);
        for number in 0..count {
            let lane = S::crossed_lane(&crossed, number);
            let (near, far) = packet.interval(node, lane, best.ends());
            let entering = near.le(far).bits() & active;
            let child = Child(node.children()[lane]);
            entries[top % HEIGHT] = (child, entering);
            if task.far {
                task.prefetch(child, Cache::First);
            }
            if !any {
                near.store(row(&mut begins[top % HEIGHT]));
            }
            top += usize::from(entering != 0);
        }
    }
    best.answer::<R, Q>(task.query, rays, answers);
    Outcome::Answered
}

impl Stack {
    /// Sets those rays aside that are still to visit something of the lowest `height` entries before
    /// their end, but for those that are `answered`. Where `any` hit will do, no entry is beyond it.
    #[inline(never)]
    fn set_aside(
        &self,
        height: usize,
        first: u32,
        hits: &[Hit],
        answered: u32,
        any: bool,
        diverged: &mut Diverged,
    ) {
        for ray in ones(all(hits.len()) & !answered) {
            let entries = self.entries[..height].iter().zip(&self.begins[..height]);
            let own = entries.filter(|((_, active), begins)| {
                active >> ray & 1 != 0 && (any || begins[ray] <= hits[ray].t)
            });
            let own = own.map(|(&(child, _), begins)| (child, begins[ray]));
            diverged.add(first + ray as u32, hits[ray], own);
        }
    }
}
