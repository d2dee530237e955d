//! Acceleration structures: the interfaces, and one file a structure.
//!
//! A structure is an index over boxes. It offers ranges of primitives that a ray may hit; it never
//! sees a formula and never names a shape. What makes all of them return the same hits, bit for
//! bit, is stated at [`Accel`].
//!
//! | file | structure |
//! |---|---|
//! | `none.rs` | every primitive, every ray |
//! | `ball.rs` | one bounding ball around all |
//! | `bvh.rs` | obvhs's binary tree |
//! | `cwbvh.rs` | obvhs's compressed eight-wide tree |
//! | `bvh8/` | a binary tree collapsed to eight children, many rays at once |

mod ball;
mod bvh;
mod bvh8;
mod config;
mod cwbvh;
mod indexed;
mod none;
mod order;
mod packs;
mod shape;
mod stages;
mod tree;

use std::ops::{ControlFlow, Range};

use glam::Vec3A;
use rayon::iter::{IntoParallelIterator, ParallelIterator};

use crate::counters::{Counters, Counts};
use crate::math::{Aabb, BoxRay, Hit, Padding, Ray};

pub use ball::BoundingBall;
pub use bvh::Bvh;
pub use bvh8::Bvh8;
pub use config::{BuildConfig, Quality};
pub use cwbvh::CompressedWideBvh;
pub use indexed::Indexed;
pub use none::Exhaustive;
pub use order::Order;
pub use packs::{NoPacks, PACK, Packs, ScaledHit};
pub use shape::{LeafHistogram, StructureShape};
pub use stages::BuildStages;
pub use tree::{Tree, TreeNode};

/// A set of things with boxes: all that a structure is built from.
pub trait Bounded: Sync {
    /// How many there are.
    fn count(&self) -> u32;
    /// The box of one of them. Never empty; all coordinates finite.
    fn bounds(&self, index: u32) -> Aabb;
    /// A box around the part of one of them that lies within a box, for builders that split; empty
    /// where there is none. It lies within both boxes, and need not be the smallest.
    ///
    /// A structure must not leave a primitive out by such boxes alone: they do not cover the
    /// primitive's box, as the contract of [`Accel`] demands (`docs/splits.md`).
    fn clipped_bounds(&self, index: u32, to: &Aabb) -> Aabb {
        self.bounds(index).intersection(*to)
    }

    /// The mean of the points that define them; for triangles, of the mesh's vertices.
    fn mean_point(&self) -> Vec3A;

    /// How many slots are tested at once: ranges that begin at a multiple of it are the cheapest.
    fn lanes(&self) -> u32 {
        1
    }

    /// The box around all.
    fn total_bounds(&self) -> Aabb {
        (0..self.count()).map(|i| self.bounds(i)).fold(Aabb::EMPTY, Aabb::union)
    }
}

/// An index over primitives.
///
/// # The contract
/// `traverse` may leave a primitive out only if the interval of its box ([`BoxRay::interval`]),
/// or of a box around it, ends before `ray.t_min` or begins behind the current end of the search.
/// The comparison is inclusive: a box that begins *at* the end is visited, because a tie in `t` is
/// decided by the primitives' ids. Boxes that are stored with less precision than `f32` are tested
/// with a wider padding ([`BoxRay::widened`]).
///
/// Primitives count a hit only inside the interval of their own box, and [`BoxRay::interval`] is
/// monotone to the bit, so nothing that counts is ever left out, and every structure that keeps
/// the contract returns the same hits as [`Exhaustive`].
///
/// # Cells
/// A space partition, or a builder that splits boxes, refers to a primitive from several boxes of
/// which none need hold all of it. It may leave such a box out by the box's own interval, if:
///
/// * the boxes that refer to a primitive cover the primitive's *box*. In a partition each closed cell
///   that touches the closed box refers to it, not only those that the primitive itself touches;
/// * the planes between cells are measured as [`BoxRay::interval`] measures them: `origin_plus` for
///   the low side of a cell, `origin_minus` for its high side. Comparisons are inclusive;
/// * nothing else ends the search. A hit found in a cell may lie behind the cell's end, and the next
///   cell, whose interval begins before that, may have a nearer one, or a tie of a smaller id.
///
/// *Proof.* Along one axis let `inv_dir > 0`, and for a float `p` let `L(p) = (p − origin_plus) ·
/// inv_dir` and `H(p) = (p − origin_minus) · inv_dir`, rounded as in [`BoxRay::interval`]. Rounding
/// is monotone, so neither falls as `p` grows, and `L(p) ≤ H(p)`, as `origin_minus ≤ origin_plus`.
/// The interval of a box `[low, high]` is `[L(low), H(high)]`: two cells that share the plane `p`
/// overlap, as the one ends at `H(p)` and the other begins at `L(p)`.
///
/// Let `t` lie in the interval of the primitive's box `[a, b]`, so `L(a) ≤ t ≤ H(b)`. There is a
/// point `x` of `[a, b]` such that `t` lies in the interval of *every* closed box that holds `x`:
/// let `p` be the last float of `[a, b]` with `L(p) ≤ t`. If `t ≤ H(p)`, let `x = p`. Otherwise
/// `p < b`, the float `q` after `p` has `t < L(q) ≤ H(q)`, and `x` is any point between `p` and `q`.
/// A low side at or before `x` is not behind `p`, so its `L` is at most `L(p) ≤ t`. A high side at or
/// behind `x` is not before `p` in the first case, nor before `q` in the second, so its `H` is at
/// least `t`. Where `inv_dir < 0`, neither rises, `H(p) ≤ L(p)`, the interval is `[H(high), L(low)]`,
/// and the same holds with the sides exchanged.
///
/// The `x` of the three axes are a point of the primitive's box. One of the boxes that cover it holds
/// this point. Its interval contains `t`, and so do those of all boxes around it, so it is visited as
/// long as the search does not end before `t`; and it refers to the primitive. How the boxes lie does
/// not matter: this holds for trees and grids of cells, and for boxes that overlap.
pub trait Accel: Sized + Send + Sync {
    /// Builds the index. `primitives` may be empty.
    fn build(primitives: &impl Bounded, config: &BuildConfig) -> Built<Self>;

    /// [`Accel::build`], with the time of each of its stages noted. A structure that tells none
    /// apart is built in one.
    fn build_in_stages(
        primitives: &impl Bounded,
        config: &BuildConfig,
        stages: &mut BuildStages,
    ) -> Built<Self> {
        stages.time("structure", || Self::build(primitives, config))
    }

    /// Offers ranges of slots that the ray may hit, near ones first where it can.
    ///
    /// The search starts at `ray.t_max`. `leaf` tests a range and returns the new end of the
    /// search (at most the one before), or breaks to end it. `box_ray` is the ray with the padding
    /// of the primitives.
    fn traverse<C: Counters>(
        &self,
        ray: &Ray,
        box_ray: &BoxRay,
        counters: &mut C,
        leaf: impl FnMut(Range<u32>, &mut C) -> ControlFlow<(), f32>,
    );

    /// The closest hits of many rays. A structure that has nothing better walks them one by one.
    fn intersect_many<P: Primitives, C: Counters>(
        &self,
        primitives: &P,
        rays: &[Ray],
        hits: &mut [Hit],
        counters: &mut C,
    ) {
        for (ray, hit) in rays.iter().zip(hits) {
            *hit = closest(self, primitives, ray, counters);
        }
    }

    /// Whether each of many rays hits anything.
    fn occluded_many<P: Primitives, C: Counters>(
        &self,
        primitives: &P,
        rays: &[Ray],
        answers: &mut [bool],
        counters: &mut C,
    ) {
        for (ray, answer) in rays.iter().zip(answers) {
            *answer = blocked(self, primitives, ray, counters);
        }
    }

    /// Nodes, leaves, depth and bytes.
    fn shape(&self) -> StructureShape;

    /// All nodes with their boxes, for measures of quality ([`Tree::of`] walks a structure); `None`
    /// where there is no tree.
    fn tree(&self) -> Option<Tree> {
        None
    }
}

/// The first hit of a ray in the order `(t, object, prim)`, or [`Hit::MISS`].
#[inline]
fn closest<A: Accel, P: Primitives, C: Counters>(
    accel: &A,
    primitives: &P,
    ray: &Ray,
    counters: &mut C,
) -> Hit {
    let box_ray = BoxRay::new(ray, primitives.padding());
    let mut best = Hit::none_before(ray.t_max);
    accel.traverse(ray, &box_ray, counters, |slots, counters| {
        primitives.intersect(slots, ray, &box_ray, &mut best, counters);
        ControlFlow::Continue(best.t)
    });
    if best.is_hit() { best } else { Hit::MISS }
}

/// Whether a ray has any hit.
#[inline]
fn blocked<A: Accel, P: Primitives, C: Counters>(
    accel: &A,
    primitives: &P,
    ray: &Ray,
    counters: &mut C,
) -> bool {
    let box_ray = BoxRay::new(ray, primitives.padding());
    let mut blocked = false;
    accel.traverse(ray, &box_ray, counters, |slots, counters| {
        blocked = primitives.occluded(slots, ray, &box_ray, counters);
        if blocked { ControlFlow::Break(()) } else { ControlFlow::Continue(ray.t_max) }
    });
    blocked
}

/// What a build returns.
#[derive(Debug)]
pub struct Built<A> {
    /// The structure.
    pub accel: A,
    /// Which primitive stands in which slot; `None` where slots are indices. A structure that refers
    /// to a primitive from several leaves either offers its one slot several times, or has it copied
    /// ([`Order::References`]), so that every leaf is a range and is tested in packs.
    pub order: Option<Order>,
}

/// Primitives in slot order, with the formula that all structures share.
pub trait Primitives: Bounded + Send + Sync {
    /// How kernels see them; [`NoPacks`] if they are tested one by one.
    type Packs: Packs;

    /// Themselves in packs of eight, if they are that.
    fn packs(&self) -> Option<&Self::Packs>;

    /// The padding that every box test of these primitives uses.
    fn padding(&self) -> Padding;

    /// Puts the primitives into the order of a structure: slot `i` gets a copy of primitive
    /// `order[i]`, or stays empty. Hits go on to speak of ids: the indices before any reordering.
    fn reorder(&mut self, order: &[u32]);

    /// Replaces `best` by the first hit in the order `(t, object, prim)` among some slots and
    /// itself. Hits count for `ray.t_min ≤ t ≤ best.t` within their primitive's own box.
    fn intersect<C: Counters>(
        &self,
        slots: Range<u32>,
        ray: &Ray,
        box_ray: &BoxRay,
        best: &mut Hit,
        counters: &mut C,
    );

    /// Whether any of some slots has a hit that counts, with `ray.t_min ≤ t ≤ ray.t_max`.
    fn occluded<C: Counters>(
        &self,
        slots: Range<u32>,
        ray: &Ray,
        box_ray: &BoxRay,
        counters: &mut C,
    ) -> bool;

    /// [`intersect`](Self::intersect) of those of a slice of rays whose places are in `which`, with
    /// the best hit of each in `best`.
    fn intersect_stream<C: Counters>(
        &self,
        slots: Range<u32>,
        rays: &[Ray],
        which: &[u32],
        best: &mut [Hit],
        counters: &mut C,
    ) {
        for &place in which {
            let (ray, best) = (&rays[place as usize], &mut best[place as usize]);
            let box_ray = BoxRay::new(ray, self.padding());
            self.intersect(slots.clone(), ray, &box_ray, best, counters);
        }
    }

    /// [`occluded`](Self::occluded) of those of a slice of rays whose places are in `which`, none of
    /// them blocked so far; notes in `blocked` which are.
    fn occluded_stream<C: Counters>(
        &self,
        slots: Range<u32>,
        rays: &[Ray],
        which: &[u32],
        blocked: &mut [bool],
        counters: &mut C,
    ) {
        for &place in which {
            let ray = &rays[place as usize];
            let box_ray = BoxRay::new(ray, self.padding());
            blocked[place as usize] = self.occluded(slots.clone(), ray, &box_ray, counters);
        }
    }
}

/// Many rays at once: what the renderer, the benches and the tests call.
///
/// The order and the number of the rays in a slice never change a result. Counting is asked for by
/// the call; without it the search is compiled without counters.
pub trait Tracer: Send + Sync {
    /// The closest hit of each ray, or [`Hit::MISS`].
    ///
    /// # Panics
    /// If the slices differ in length.
    fn intersect(&self, rays: &[Ray], hits: &mut [Hit], counts: Option<&mut Counts>);

    /// Whether each ray hits anything at all.
    ///
    /// # Panics
    /// If the slices differ in length.
    fn occluded(&self, rays: &[Ray], blocked: &mut [bool], counts: Option<&mut Counts>);
}

/// The primitives' boxes as obvhs's builders take them.
fn obvhs_boxes(primitives: &impl Bounded) -> Vec<obvhs::aabb::Aabb> {
    (0..primitives.count())
        .into_par_iter()
        .map(|i| {
            let Aabb { min, max } = primitives.bounds(i);
            obvhs::aabb::Aabb { min, max }
        })
        .collect()
}
