//! A ray in flight.

use std::hint::select_unpredictable;

use crate::accel::PACK;
use crate::math::{Hit, Lanes as _, Lanes3, Mask as _, NONE};
use crate::simd::{Row as _, Simd, splat3};

use super::super::HEIGHT;
use super::super::diverged::DivergedRay;
use super::super::node::{Child, Node, near_planes, order_shift};
use super::super::slab_ray::SlabRay;

/// Room for the entries, for the row that is written at once beyond them, and up to a whole cache line.
const ROOM: usize = HEIGHT + 2 * PACK;

/// Where [`Slot::near`] has the beginning and the end of the search, the best hit's parameter or the ray's own end.
const T_MIN: usize = 3;
const END: usize = 7;

/// Where [`Slot::far`] has the number of entries on the stack, and the place of the order.
const ENTRIES: usize = 3;
const ORDER: usize = 7;

/// A ray in flight. What a visit of a node reads is in the first cache line, what a visit of a leaf
/// reads in the next. The first two rows are written whole, as [`Terms`](super::columns::Terms) has them.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub(super) struct Slot<R> {
    /// 1/direction, the beginning of the search, offsets of near planes, and the end.
    pub(super) near: [f32; 8],
    /// Offsets of far planes; then as bits: how many entries are on the stack, the places of near planes, and that of
    /// the order of the ray's octant.
    pub(super) far: [f32; 8],

    pub(super) formula: R,
    /// The best hit.
    pub(super) prim: u32,
    u: f32,
    v: f32,
    /// Its number in the caller's slice.
    pub(super) ray: u32,

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

/// Entries on the stack of a ray that is at the root, in [`Slot::far`].
pub(super) const AT_ROOT: f32 = f32::from_bits(1);

/// The place of the near plane along an axis, for rays that run forwards or backwards, as in [`Slot::far`].
#[inline(always)]
pub(super) fn near_plane(axis: usize, backwards: bool) -> f32 {
    f32::from_bits(near_planes(u32::from(backwards) << axis)[axis])
}

/// The place of the order of an octant, as in [`Slot::far`].
#[inline(always)]
pub(super) fn order(octant: u32) -> f32 {
    f32::from_bits(order_shift(octant))
}

impl<R> Slot<R> {
    #[inline(always)]
    pub(super) fn t_min(&self) -> f32 {
        self.near[T_MIN]
    }

    #[inline(always)]
    pub(super) fn end(&self) -> f32 {
        self.near[END]
    }

    #[inline(always)]
    fn height(&self) -> usize {
        self.far[ENTRIES].to_bits() as usize
    }

    #[inline(always)]
    fn set_height(&mut self, height: usize) {
        self.far[ENTRIES] = f32::from_bits(height as u32);
    }

    /// Takes up a ray, by its number, that has hit nothing. It has the coordinates of a miss, as one from a
    /// packet has too, so that [`hit`](Self::hit) need not choose them.
    #[inline(always)]
    pub(super) fn take_up(&mut self, ray: u32) {
        (self.prim, self.u, self.v, self.ray) = (Hit::MISS.prim, Hit::MISS.u, Hit::MISS.v, ray);
    }

    /// The best hit. Without a branch, which compilers make of arithmetic, too: whether there is one cannot be
    /// foreseen.
    #[inline(always)]
    pub(super) fn hit(&self) -> Hit {
        let is_hit = self.prim != NONE;
        let t = select_unpredictable(is_hit, self.end(), Hit::MISS.t);
        // All bits, or none.
        let object = u32::from(is_hit).wrapping_sub(1);
        Hit { t, object, prim: self.prim, u: self.u, v: self.v }
    }

    /// Takes a hit that is no farther than the best one if it is the better one.
    #[inline(always)]
    pub(super) fn offer(&mut self, hit: &Hit) {
        let better = (hit.t < self.end()) | (hit.prim < self.prim);
        self.near[END] = if better { hit.t } else { self.end() };
        self.prim = if better { hit.prim } else { self.prim };
        self.u = if better { hit.u } else { self.u };
        self.v = if better { hit.v } else { self.v };
    }

    /// Where the ray enters and leaves the boxes of a node's children.
    #[inline(always)]
    fn intervals<S: Simd>(&self, node: &Node) -> (S::F8, S::F8) {
        let [ix, iy, iz, t_min, nx, ny, nz, end] = self.near;
        let [fx, fy, fz, _, px, py, pz, _] = self.far;
        let (inv_dir, near, far): (Lanes3<S::F8>, _, _) = (
            splat3::<S::F8>([ix, iy, iz]),
            splat3::<S::F8>([nx, ny, nz]),
            splat3::<S::F8>([fx, fy, fz]),
        );
        let planes = [px.to_bits(), py.to_bits(), pz.to_bits()];
        let searched = [S::F8::splat(t_min), S::F8::splat(end)];
        node.intervals::<S>(planes, inv_dir, near, far, searched)
    }

    /// Puts the children of a node that the ray enters on its stack, the nearest last, and takes the top.
    #[inline(always)]
    pub(super) fn enter<S: Simd>(&mut self, node: &Node) -> Child {
        let intervals = self.intervals::<S>(node);
        self.push::<S>(node, intervals, self.height())
    }

    /// Puts the children of a node that the ray enters on its stack, in any order, and takes the top.
    #[inline(always)]
    pub(super) fn enter_any<S: Simd>(&mut self, node: &Node) -> Child {
        let intervals = self.intervals::<S>(node);
        self.push_any::<S>(node, intervals, self.height())
    }

    /// [`enter`](Self::enter) at the root, where the ray begins; for `any` hit [`enter_any`](Self::enter_any). Where it
    /// enters the children is known, and infinite where it does not.
    #[inline(always)]
    pub(super) fn enter_root<S: Simd>(&mut self, root: &Node, begins: S::F8, any: bool) -> Child {
        let intervals = (begins, S::F8::splat(f32::MAX));
        match any {
            true => self.push_any::<S>(root, intervals, AT_ROOT.to_bits() as usize),
            false => self.push::<S>(root, intervals, AT_ROOT.to_bits() as usize),
        }
    }

    /// Puts the children whose intervals are not empty on the stack, which is so high, and takes the top.
    #[inline(always)]
    fn push<S: Simd>(
        &mut self,
        node: &Node,
        (begins, ends): (S::F8, S::F8),
        height: usize,
    ) -> Child {
        let entered = S::enter(
            begins,
            ends,
            node.children(),
            node.orders(),
            self.far[ORDER].to_bits(),
            row_mut(&mut self.entries.0, height),
            row_mut(&mut self.distances.0, height),
        );
        self.take_top(height + entered as usize)
    }

    /// [`push`](Self::push) in any order.
    #[inline(always)]
    fn push_any<S: Simd>(
        &mut self,
        node: &Node,
        (begins, ends): (S::F8, S::F8),
        height: usize,
    ) -> Child {
        let entered = begins.le(ends).bits();
        S::compress(entered, node.children(), row_mut(&mut self.entries.0, height));
        self.take_top(height + entered.count_ones() as usize)
    }

    /// Takes the top of the stack, which is so high.
    #[inline(always)]
    fn take_top(&mut self, height: usize) -> Child {
        self.set_height(height - 1);
        Child(self.entries.0[(height - 1) % HEIGHT])
    }

    /// Takes the top of the stack.
    #[inline(always)]
    pub(super) fn pop(&mut self) -> Child {
        self.take_top(self.height())
    }

    /// The top of the stack, which is taken from it if the ray is `free` to go there.
    #[inline(always)]
    pub(super) fn pop_if(&mut self, free: bool) -> Child {
        let height = self.height();
        self.set_height(height - usize::from(free));
        Child(self.entries.0[(height - 1) % HEIGHT])
    }

    /// Ends the search: nothing is to be visited any more.
    #[inline(always)]
    pub(super) fn finish(&mut self) {
        self.set_height(1);
    }

    /// Takes from the stack what begins behind the end of the search.
    #[inline(always)]
    pub(super) fn drop_behind<S: Simd>(&mut self) {
        let (end, height) = (S::F8::splat(self.end()), self.height());
        let (mut kept, mut base) = (0, 0);
        while base < height {
            let begins = S::F8::load(row_mut(&mut self.distances.0, base));
            let live = (1u32 << (height - base).min(PACK)) - 1;
            let mask = begins.le(end).bits() & live;
            let row = *row_mut(&mut self.entries.0, base);
            S::compress(mask, &row, row_mut(&mut self.entries.0, kept));
            S::compress_floats(mask, begins, row_mut(&mut self.distances.0, kept));
            kept += mask.count_ones() as usize;
            base += PACK;
        }
        self.set_height(kept);
    }

    /// Gives a ray what it has found on its way, and what it is still to visit; returns what comes first.
    #[inline(always)]
    pub(super) fn go_on(&mut self, ray: &DivergedRay, entries: &[(Child, f32)]) -> Child {
        let Hit { t, prim, u, v, .. } = ray.best;
        (self.near[END], self.prim, self.u, self.v) = (t, prim, u, v);
        let places = self.entries.0[1..HEIGHT].iter_mut().zip(&mut self.distances.0[1..HEIGHT]);
        for ((entry, distance), (child, begin)) in places.zip(entries) {
            (*entry, *distance) = (child.0, *begin);
        }
        self.take_top(1 + entries.len().min(HEIGHT - 1))
    }

    /// Begins at the root, by terms that are not the usual ones.
    pub(super) fn set_terms(&mut self, slab: &SlabRay, [t_min, end]: [f32; 2]) {
        let ([x, y, z], [near_x, near_y, near_z]) = (slab.inv_dir.to_array(), slab.near.to_array());
        self.near = [x, y, z, t_min, near_x, near_y, near_z, end];
        let [x, y, z] = slab.far.to_array();
        let plane = |axis| near_plane(axis, slab.octant >> axis & 1 != 0);
        self.far = [x, y, z, AT_ROOT, plane(0), plane(1), plane(2), order(slab.octant)];
    }
}

impl<R: Copy + Default> Slot<R> {
    pub(super) fn vacant() -> Self {
        Self {
            near: [0.0; 8],
            far: [0.0; 8],
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

/// Eight places of a stack.
#[inline(always)]
fn row_mut<T>(stack: &mut [T; ROOM], at: usize) -> &mut [T; PACK] {
    stack[at % HEIGHT..].first_chunk_mut().expect("a row has room behind every place")
}
