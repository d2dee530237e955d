//! The primitives of a leaf and a packet: a ray in each lane, primitive by primitive, or the primitives in the lanes,
//! ray by ray, whichever costs less.

use crate::accel::{PACK, PackHits, Packs, Primitives, Query, Search};
use crate::math::slab::finite_reciprocal;
use crate::math::{Hit, Lanes as _, Mask as _, Ray, ones, within};
use crate::simd::{LARGEST_PACKET, Row, Simd};

use super::super::candidates::Candidates;
use super::super::node::Child;
use super::super::task::{RayOf, Task};
use super::RaysOf;
use super::best::Best;
use super::rays::{Boxes, Packet};

/// So few rays are tested one by one, without a look at the primitives that the packet as a whole misses.
const FEW: u32 = 4;

/// What a test of one ray with all primitives costs, where that of all rays with one primitive costs as many as they
/// are.
const COST_OF_RAY: u32 = 16;

/// Rays as the formula takes them, for tests of one ray. Most packets need those of few rays, or of none.
pub(super) struct Formulas<R> {
    rays: [R; LARGEST_PACKET],
    /// A bit for each ray whose place holds it.
    known: u32,
}

impl<R: Copy + Default> Default for Formulas<R> {
    fn default() -> Self {
        Self { rays: [R::default(); LARGEST_PACKET], known: 0 }
    }
}

/// What is known of the rays of a packet.
pub(super) struct PacketRays<'a, S: Simd, R: Row<N>, P: Primitives, const N: usize> {
    pub(super) rays: &'a [Ray; N],
    pub(super) packet: &'a Packet<S, R, N>,
    pub(super) of_formula: &'a RaysOf<P, R>,
    pub(super) formulas: &'a mut Formulas<RayOf<P>>,
}

impl<R> Formulas<R> {
    /// Forgets the rays of the packet before.
    #[inline(always)]
    pub(super) fn clear(&mut self) {
        self.known = 0;
    }

    /// Works out what is not yet known of some rays, for eight neighbours at once.
    #[inline(always)]
    fn learn<S: Simd, K: Packs<Ray = R>>(&mut self, rays: &[Ray], of: u32) {
        let unknown = of & !self.known;
        if unknown == 0 {
            return;
        }
        let places = self.rays.as_chunks_mut::<PACK>().0.iter_mut();
        for (number, (eight, places)) in rays.as_chunks::<PACK>().0.iter().zip(places).enumerate() {
            let lanes = 0xff << (number * PACK);
            if unknown & lanes == 0 {
                continue;
            }
            self.known |= lanes;
            let rows = S::F8::of_records(eight.each_ref().map(Ray::as_array));
            let [ox, oy, oz, _, dx, dy, dz, _] = rows;
            let inv_dir = [finite_reciprocal(dx), finite_reciprocal(dy), finite_reciprocal(dz)];
            K::eight_rays::<S>(&[ox, oy, oz], &[dx, dy, dz], &inv_dir, places);
        }
    }
}

/// Tests the primitives of a leaf that the packet as a whole does not miss. `end` is the end of the longest search.
#[inline(always)]
pub(super) fn test<S: Simd, R: Row<N>, P: Primitives, Q: Query, const N: usize>(
    task: &Task<'_, P, Q>,
    of_packet: &mut PacketRays<'_, S, R, P, N>,
    leaf: Child,
    active: u32,
    end: S::F8,
    best: &mut Best<N>,
) {
    let (packs, block) = (task.packs, leaf.block());
    if active.count_ones() <= FEW {
        return one_by_one(task, of_packet, block, active, best);
    }
    let packet = of_packet.packet;
    let boxes = Boxes::new::<S>(packs.boxes::<S>(block));
    let [x, y, z] = packet.near_rows();
    let (near, far) = packet.hull.interval(
        [boxes.row::<S>(x), boxes.row::<S>(y), boxes.row::<S>(z)],
        [boxes.row::<S>(x ^ 1), boxes.row::<S>(y ^ 1), boxes.row::<S>(z ^ 1)],
        end,
    );
    let mut active = active;
    let filled = u32::MAX >> (32 - leaf.count());
    let met = near.le(far).bits() & filled;
    if active.count_ones() * COST_OF_RAY < met.count_ones() * N as u32 {
        return one_by_one(task, of_packet, block, active, best);
    }
    for lane in ones(met) {
        let mut hits = packs.test_lane::<R>(block, lane, of_packet.of_formula);
        let inside = hits.inside.bits() & active;
        if inside == 0 {
            continue;
        }
        for ray in ones(hits.flat() & active) {
            hits.replace(ray, packs.flat_hit(block, lane, &of_packet.rays[ray % N]));
        }
        let (t, ends) = (hits.t / hits.scale, best.ends::<R>());
        let mut found = within(t, [packet.t_min, ends]).bits() & inside;
        if found == 0 {
            continue;
        }
        let (t, counts) = packet.placed(&boxes, lane, t, ends);
        found &= counts;
        if Q::FILTERS {
            found = filtered::<R, P, Q, N>(task, of_packet.rays, (block, lane), t, &hits, found);
        }
        if const { matches!(Q::SEARCH, Search::First) } {
            best.hit |= found;
            active &= !found;
            if active == 0 {
                return;
            }
            continue;
        }
        best.offer([t, hits.u / hits.scale, hits.v / hits.scale], packs.id(block, lane), found);
    }
}

/// Tests some rays one by one, each with all primitives of a leaf at once: what few rays meet costs less than with most
/// lanes idle.
#[inline(always)]
fn one_by_one<S: Simd, R: Row<N>, P: Primitives, Q: Query, const N: usize>(
    task: &Task<'_, P, Q>,
    of_packet: &mut PacketRays<'_, S, R, P, N>,
    block: usize,
    active: u32,
    best: &mut Best<N>,
) {
    let PacketRays { rays, formulas, .. } = of_packet;
    formulas.learn::<S, P::Packs>(&rays[..], active);
    for place in ones(active) {
        let (ray, formula) = (&rays[place % N], &formulas.rays[place % LARGEST_PACKET]);
        let searched = [ray.t_min, best.end(place)];
        let mut candidates = Candidates::NONE;
        if !candidates.test::<S, P, Q>(task, block, (&rays[..], place), formula, searched) {
            continue;
        }
        if const { matches!(Q::SEARCH, Search::First) } {
            let counts = candidates.any_counts::<S, P, Q>(task, ray, searched);
            best.hit |= u32::from(counts) << place;
        } else {
            candidates.first::<S, P, Q>(task, ray, searched, |hit| best.offer_one(place, hit));
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
    let mut rows = [[0.0; N]; 3];
    t.store(&mut rows[0]);
    (hits.u / hits.scale).store(&mut rows[1]);
    (hits.v / hits.scale).store(&mut rows[2]);
    let prim = task.packs.id(block, lane);
    for ray in ones(found) {
        let [t, u, v] = [rows[0][ray % N], rows[1][ray % N], rows[2][ray % N]];
        if !task.query.accepts(&rays[ray % N], &Hit { t, object: 0, prim, u, v }) {
            found &= !(1 << ray);
        }
    }
    found
}
