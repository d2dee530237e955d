//! Packets: coherent rays go down the tree together, as many as suit the instruction set.
//!
//! The packet as a whole is tested against a node's eight children at once, by intervals: the
//! slab test with the smallest and the largest of the rays' terms bounds that of every ray from
//! below and above, because each of its operations is monotone. Children, and primitives of a leaf,
//! that the packet as a whole misses cost no more than that; the others are tested with a ray in
//! each lane. After Boulos, Wald, Shirley: *Geometric and Arithmetic Culling Methods for Entire Ray
//! Packets*, 2006.

use crate::accel::{PACK, PackHits, Packs, Primitives, Query, Search};
use crate::counters::Counters;
use crate::math::{Hit, Lanes as _, Mask as _, NONE, Ray, ones, within};
use crate::simd::{Kernel, LARGEST_PACKET, PacketKernel, Row, Simd, dispatch};

use super::HEIGHT;
use super::coherence::CoherenceBudget;
use super::diverged::Diverged;
use super::node::{Child, order_shift};
use super::packet_rays::{Boxes, Packet, all};
use super::task::Task;

/// The lanes of a row, each in its own.
static LANES: [u32; PACK] = [0, 1, 2, 3, 4, 5, 6, 7];

/// The stack of a packet.
pub(super) struct Stack {
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

/// The best hits so far.
struct Best<R, const N: usize> {
    t: R,
    u: R,
    v: R,
    prim: [u32; N],
    /// A bit for each ray that has hit something.
    hit: u32,
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
    stack: &'a mut Stack,
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
        let Self { task, rays: (first, rays), answers, stack, diverged, counters } = self;
        let (Some(rays), Some(answers)) = (rays.first_chunk(), answers.first_chunk_mut()) else {
            return Outcome::Incoherent;
        };
        let rays = (first, rays);
        search::<S, R, P, Q, C, true, N>(task, rays, answers, stack, diverged, counters)
    }
}

/// Answers the rays of a packet, the first of which has the place `first` in the slice, or sets some aside
/// that diverged. Their terms are the usual ones, or those that are `CUT`.
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
    answers: &mut [Q::Answer; N],
    stack: &mut Stack,
    diverged: &mut Diverged,
    counters: &mut C,
) -> Outcome {
    let any = const { matches!(Q::SEARCH, Search::First) };
    let Some((mut packet, ends, fits)) = Packet::<S, R, N>::load(rays, task.padding) else {
        return Outcome::Incoherent;
    };
    if CUT {
        if !packet.cut(task.padding) {
            return Outcome::Incoherent;
        }
    } else if !fits {
        let rays = (first, &rays[..]);
        return AxisAligned { task, rays, answers, stack, diverged, counters }.search();
    }
    let of_formula = <P::Packs as Packs>::rays::<R>(&packet.origin, &packet.dir, &packet.inv_dir);
    let mut budget = CoherenceBudget::new(N, task.large);
    let zero = R::splat(0.0);
    let mut best = Best { t: ends, u: zero, v: zero, prim: [NONE; N], hit: 0 };
    let tree = task.tree;
    let Stack { entries, begins } = stack;
    entries[0] = (Child::ROOT, all(N));
    begins[0] = [f32::NEG_INFINITY; LARGEST_PACKET];
    let mut top = 1;
    let (mut lanes, mut entries_of) = ([0; PACK], [0.0; PACK]);
    let mut end = S::F8::splat(best.t.largest());
    let shift = order_shift(packet.octant);
    while top > 0 {
        top -= 1;
        let (child, mut active) = entries[top % HEIGHT];
        if any {
            active &= !best.hit;
        } else {
            active &= R::load(row(&mut begins[top % HEIGHT])).le(best.t).bits();
        }
        if active == 0 {
            continue;
        }
        if !budget.pay(active) {
            best.answer(task.query, rays, answers);
            let mut hits = [Hit::MISS; N];
            best.write(&mut hits);
            let answered = if any { best.hit } else { 0 };
            stack.set_aside(top + 1, first, &hits, answered, any, diverged);
            return Outcome::Diverged;
        }
        if child.is_leaf() {
            if C::COUNTS {
                counters.primitives(child.count() * active.count_ones());
            }
            let of_rays = (rays, &packet, &of_formula);
            test_leaf::<S, R, P, Q, N>(task, of_rays, child, active, end, &mut best);
            if any && best.hit == all(N) {
                break;
            }
            if !any {
                end = S::F8::splat(best.t.largest());
            }
            continue;
        }
        let node = &tree.nodes[child.index()];
        if C::COUNTS {
            counters.boxes(node.present().count() as u32 * active.count_ones());
        }
        let (near, far) = packet.hull_of_node(node, end);
        let crossed =
            S::enter(near, far, &LANES, node.orders(), shift, &mut lanes, &mut entries_of);
        for &lane in &lanes[..crossed as usize % (PACK + 1)] {
            let lane = lane as usize % PACK;
            let (near, far) = packet.interval(node, lane, best.t);
            let entering = near.le(far).bits() & active;
            let child = Child(node.children()[lane]);
            entries[top % HEIGHT] = (child, entering);
            if task.large {
                task.prefetch(child);
            }
            if !any {
                near.store(row(&mut begins[top % HEIGHT]));
            }
            top += usize::from(entering != 0);
        }
    }
    best.answer(task.query, rays, answers);
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

/// Tests the primitives of a leaf that the packet as a whole does not miss.
#[inline(always)]
fn test_leaf<S: Simd, R: Row<N>, P: Primitives, Q: Query, const N: usize>(
    task: &Task<'_, P, Q>,
    (rays, packet, of_formula): (&[Ray; N], &Packet<S, R, N>, &RaysOf<P, R>),
    leaf: Child,
    active: u32,
    end: S::F8,
    best: &mut Best<R, N>,
) {
    let (packs, block) = (task.packs, leaf.block());
    let boxes = Boxes::new::<S>(packs.boxes::<S>(block));
    let [x, y, z] = packet.near_rows();
    let (near, far) = packet.hull.interval(
        [boxes.row::<S>(x), boxes.row::<S>(y), boxes.row::<S>(z)],
        [boxes.row::<S>(x ^ 1), boxes.row::<S>(y ^ 1), boxes.row::<S>(z ^ 1)],
        end,
    );
    let mut active = active;
    let filled = u32::MAX >> (32 - leaf.count());
    for lane in ones(near.le(far).bits() & filled) {
        let mut hits = packs.test_lane::<R>(block, lane, of_formula);
        let inside = hits.inside.bits() & active;
        if inside == 0 {
            continue;
        }
        for ray in ones(hits.flat() & active) {
            hits.replace(ray, packs.flat_hit(block, lane, &rays[ray % N]));
        }
        let t = hits.t / hits.scale;
        let mut found = within(t, [packet.t_min, best.t]).bits() & inside;
        if found == 0 {
            continue;
        }
        let (t, counts) = packet.placed(&boxes, lane, t, best.t);
        found &= counts;
        if Q::FILTERS {
            found = filtered::<R, P, Q, N>(task, rays, (block, lane), t, &hits, found);
        }
        if const { matches!(Q::SEARCH, Search::First) } {
            best.hit |= found;
            active &= !found;
            if active == 0 {
                return;
            }
            continue;
        }
        let prim = packs.id(block, lane);
        // Equal parameters are rare: the smaller id goes before.
        for ray in ones(best.t.le(t).bits() & found) {
            if prim >= best.prim[ray] {
                found &= !(1 << ray);
            }
        }
        best.t = t.select(found, best.t);
        best.u = (hits.u / hits.scale).select(found, best.u);
        best.v = (hits.v / hits.scale).select(found, best.v);
        best.hit |= found;
        for ray in ones(found) {
            best.prim[ray % N] = prim;
        }
    }
}

/// Those of some rays whose hit on a primitive the query accepts.
#[inline(always)]
fn filtered<R: Row<N>, P: Primitives, Q: Query, const N: usize>(
    task: &Task<'_, P, Q>,
    rays: &[Ray; N],
    (block, lane): (usize, usize),
    t: R,
    hits: &PackHits<R>,
    mut found: u32,
) -> u32 {
    let as_best = Best::<R, N> {
        t,
        u: hits.u / hits.scale,
        v: hits.v / hits.scale,
        prim: [task.packs.id(block, lane); N],
        hit: found,
    };
    let mut own = [Hit::MISS; N];
    as_best.write(&mut own);
    for ray in ones(found) {
        if !task.query.accepts(&rays[ray], &own[ray]) {
            found &= !(1 << ray);
        }
    }
    found
}

impl<R: Row<N>, const N: usize> Best<R, N> {
    /// The answers of all rays.
    #[inline(always)]
    fn answer<Q: Query>(&self, query: &Q, rays: &[Ray; N], answers: &mut [Q::Answer; N]) {
        let (mut t, mut u, mut v) = ([0.0; N], [0.0; N], [0.0; N]);
        let mut object = [0; N];
        if const { matches!(Q::SEARCH, Search::First) } {
            for (ray, object) in object.iter_mut().enumerate() {
                *object = if self.hit >> ray & 1 != 0 { 0 } else { NONE };
            }
        } else {
            self.t.select(self.hit, R::splat(Hit::MISS.t)).store(&mut t);
            self.u.store(&mut u);
            self.v.store(&mut v);
            for (object, prim) in object.iter_mut().zip(self.prim) {
                *object = if prim == NONE { NONE } else { 0 };
            }
        }
        for (ray, answer) in answers.iter_mut().enumerate() {
            let (prim, object) = (self.prim[ray], object[ray]);
            let found = Hit { t: t[ray], object, prim, u: u[ray], v: v[ray] };
            *answer = query.of_one(&rays[ray], &found);
        }
    }

    /// The hits; of rays without one, the end of the search in their place.
    #[inline(always)]
    fn write(&self, hits: &mut [Hit; N]) {
        let mut rows = [[0.0; N]; 3];
        self.t.store(&mut rows[0]);
        self.u.store(&mut rows[1]);
        self.v.store(&mut rows[2]);
        for (ray, hit) in hits.iter_mut().enumerate() {
            let [t, u, v] = [rows[0][ray], rows[1][ray], rows[2][ray]];
            *hit = Hit { t, object: 0, prim: self.prim[ray], u, v };
        }
    }
}
