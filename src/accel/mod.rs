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
//! | `kdtree/` | a kd-tree by the surface area heuristic |
//! | `grid.rs` | a uniform grid |
//! | `grid2.rs` | a grid of grids |
//! | `octree.rs` | an octree |
//! | `volumes/` | binary trees of bounding balls, and of polytopes between parallel planes |
//!
//! There is no BSP tree: its planes lie aslant, and the rules of equal hits are about boxes along the axes.
//!
//! What partitions of space share is in `cells/`, and `regions.rs` shows the parts of space of all structures.
//! `refit/` lets trees follow primitives that move.
//! `save/` writes built structures to bytes and reads them back.
//! Binary trees, which trees of all layouts are made from, are built in `builder/`.

mod ball;
mod build;
mod builder;
mod bvh;
mod bvh8;
mod cells;
mod config;
mod cwbvh;
mod grid;
mod grid2;
mod indexed;
mod kdtree;
mod none;
mod octree;
mod options;
mod order;
mod packs;
mod query;
mod refit;
mod regions;
mod save;
mod scratch;
mod shape;
mod sphere_ray;
mod stages;
mod tree;
mod volumes;

use std::ops::{ControlFlow, Range};

use glam::{Vec3A, Vec4};

use crate::counters::{Counters, Counts};
use crate::math::{Aabb, BoxRay, Padding, Ray};
use crate::simd::Simd;

pub use ball::BoundingBall;
pub use build::{Build, Built};
pub use bvh::Bvh;
pub use bvh8::Bvh8;
pub use config::{BuildConfig, Quality};
pub use cwbvh::CompressedWideBvh;
pub use grid::Grid;
pub use grid2::TwoLevelGrid;
pub use indexed::Indexed;
pub use kdtree::KdTree;
pub use none::Exhaustive;
pub use octree::Octree;
pub use options::{Allowed, BuildOptions, OptionError, OptionInfo};
pub use order::Order;
pub(crate) use order::in_32_bits;
pub use packs::{NoPacks, NoRay, PACK, PackHits, Packs};
pub use query::{AllHits, Answers, AnyHit, ClosestHit, Filtered, Query, QueryKind, Search};
pub use refit::{Followed, Moved, Update};
pub use regions::{Region, RegionForm, Regions};
pub use save::{Decoder, Encoder, LoadError, Portable, PortablePrimitives, Slots};
pub use scratch::Scratch;
pub use shape::{LeafHistogram, StructureShape};
pub use stages::BuildStages;
pub use tree::{Tree, TreeNode};
pub use volumes::{Ball, BallTree, KDop, KDopTree, Volume, VolumeTree};

/// A set of things with boxes: all that a structure is built from.
pub trait Bounded: Sync {
    /// Whether each box is known to be finite and not empty: then a build does not look at them all beforehand.
    const SOUND_BOXES: bool = false;

    /// How many there are.
    fn count(&self) -> u32;
    /// The box of one of them. Never empty; all coordinates finite.
    fn bounds(&self, index: u32) -> Aabb;
    /// The boxes of eight of them, from a multiple of eight on, a row each: the low corner from the first number on,
    /// the high one from the fifth. The fourth and the eighth number may be anything, and so may rows behind the
    /// last primitive.
    ///
    /// The same boxes as [`bounds`](Self::bounds) gives, one by one. Primitives that stand in packs have all
    /// eight at once.
    #[inline(always)]
    fn bounds_of_eight<S: Simd>(&self, first: u32, rows: &mut [[f32; 8]; PACK]) {
        for (row, index) in rows.iter_mut().zip(first..self.count()) {
            let Aabb { min, max } = self.bounds(index);
            let (low, high) = row.split_at_mut(4);
            Vec4::from((min, 0.0)).write_to_slice(low);
            Vec4::from((max, 0.0)).write_to_slice(high);
        }
    }

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
/// Primitives keep the *own-box rule*: a hit counts only if the interval of its primitive's own box is
/// not empty, does not end before `ray.t_min`, and begins no later than the hit's `t`
/// ([`BoxRay::begin`]). [`BoxRay::interval`] is monotone to the bit, so nothing that counts is ever left
/// out, and every structure that keeps the contract returns the same hits as [`Exhaustive`]. A primitive
/// whose formula puts a hit before its box lets it count where the box begins, or not at all.
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
/// By the own-box rule there is a `t` in the interval of the primitive's box `[a, b]`, from `ray.t_min`
/// on, that is no later than the hit: `L(a) ≤ t ≤ H(b)`. There is a
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
    /// The options that a build looks for in [`BuildConfig::options`], each of its own name.
    const OPTIONS: &'static [OptionInfo] = &[];

    /// Whether [`search`](Self::search) is left as it is here. Then a slice of rays may be cut anywhere,
    /// and neither its time nor its counts change: the renderer cuts it to be stopped at once. If this
    /// is left at `false`, a rendering stops at the ends of whole slices.
    const ONE_BY_ONE: bool = false;

    /// The bytes that a build takes at its peak for each primitive, roughly, the index itself included
    /// and the primitives not: what does not fit into memory is refused before it is built.
    const BUILD_BYTES: u64 = 0;

    /// In which ways it can follow primitives that move: [`refit`](Self::refit).
    const UPDATES: &'static [Update] = &[];

    /// Builds the index. `primitives` may be empty.
    fn build(primitives: &impl Bounded, build: &mut Build<'_>) -> Built<Self>;

    /// Offers ranges of slots that the ray may hit, near ones first where it can.
    ///
    /// The search starts at [`Ray::end`]. `leaf` tests a range and returns the new end of the
    /// search (at most the one before), or breaks to end it. `box_ray` is the ray with the padding
    /// of the primitives.
    fn traverse<C: Counters>(
        &self,
        ray: &Ray,
        box_ray: &BoxRay,
        counters: &mut C,
        leaf: impl FnMut(Range<u32>, &mut C) -> ControlFlow<(), f32>,
    );

    /// Answers a query for many rays. A structure that has nothing better walks them one by one.
    fn search<P: Primitives, Q: Query, C: Counters>(
        &self,
        query: &Q,
        primitives: &P,
        rays: &[Ray],
        answers: &mut [Q::Answer],
        scratch: &mut Scratch,
        counters: &mut C,
    ) {
        let _ = scratch;
        for (ray, answer) in rays.iter().zip(answers) {
            *answer = search_one(self, query, primitives, ray, counters);
        }
    }

    /// Follows primitives that have moved: the same ones, in slot order, with other boxes. Afterwards the contract
    /// holds for the new boxes. Called only with one of [`UPDATES`](Self::UPDATES), which a structure names that
    /// overrides this, or that has nothing to follow with; `build` is that of the structure, for one that builds parts
    /// anew.
    fn refit<P: Primitives>(
        &mut self,
        update: Update,
        primitives: &P,
        moved: Moved<'_>,
        build: &Build<'_>,
    ) -> Followed {
        let _ = (update, moved, build);
        Followed::in_place(primitives.total_bounds())
    }

    /// Bytes of the index itself, without the primitives.
    fn bytes(&self) -> u64;

    /// All nodes with their boxes, for measures of quality ([`Tree::of`] walks a structure); `None`
    /// where there is no tree.
    fn tree(&self) -> Option<Tree> {
        None
    }

    /// The parts of space that it tests rays against, level by level, for pictures: by default the nodes of its tree.
    fn regions(&self) -> Regions {
        self.tree().as_ref().map(Regions::of_tree).unwrap_or_default()
    }

    /// Nodes, leaves, depth and bytes: by default those of its tree.
    fn shape(&self) -> StructureShape {
        StructureShape::of_tree(self.tree().as_ref(), self.bytes())
    }
}

/// Answers a query for one ray.
#[inline]
fn search_one<A: Accel, P: Primitives, Q: Query, C: Counters>(
    accel: &A,
    query: &Q,
    primitives: &P,
    ray: &Ray,
    counters: &mut C,
) -> Q::Answer {
    let box_ray = BoxRay::new(ray, primitives.padding());
    let mut answer = query.start(ray);
    accel.traverse(ray, &box_ray, counters, |slots, counters| {
        primitives.test(query, slots, ray, &box_ray, &mut answer, counters);
        let end = query.end(ray, &answer);
        let is_over = Q::SEARCH == Search::First && end == f32::NEG_INFINITY;
        if is_over { ControlFlow::Break(()) } else { ControlFlow::Continue(end) }
    });
    query.finish(&mut answer);
    answer
}

/// Primitives in slot order, with the formula that all structures share.
pub trait Primitives: Bounded + Send + Sync {
    /// How kernels see them; [`NoPacks`] if they are tested one by one.
    type Packs: Packs;

    /// Themselves in packs of eight, if they are that.
    fn packs(&self) -> &Self::Packs;

    /// The padding that every box test of these primitives uses.
    fn padding(&self) -> Padding;

    /// How many slots there are, empty ones included: [`count`](Bounded::count), unless some stay empty or have
    /// copies that are not counted.
    fn slots(&self) -> u32 {
        self.count()
    }

    /// Puts the primitives into the order of a structure: slot `i` gets a copy of primitive
    /// `order[i]`, or stays empty. Hits go on to speak of ids: the indices before any reordering. If it
    /// is done again, `order` has slots as they are by then.
    ///
    /// # Panics
    /// It may, if `order` names a slot that there is not.
    fn reorder(&mut self, order: &[u32]);

    /// Makes the slots from 0 on, as many as there are primitives, hold each of them, as a build expects it. Primitives
    /// that [`reorder`](Self::reorder) leaves like that, having neither empty slots nor copies that are not counted,
    /// have nothing to do.
    ///
    /// # Panics
    /// If an order has left a primitive out.
    fn close_ranks(&mut self) {}

    /// Records in `answer` what some slots have for a ray that has not ended: every hit that counts,
    /// or enough of them to make the answer whole. `box_ray` is the ray with the padding of the
    /// primitives.
    fn test<Q: Query, C: Counters>(
        &self,
        query: &Q,
        slots: Range<u32>,
        ray: &Ray,
        box_ray: &BoxRay,
        answer: &mut Q::Answer,
        counters: &mut C,
    );

    /// [`test`](Self::test) for those of a slice of rays whose places are in `which`, each with its
    /// answer so far in `answers`.
    fn test_stream<Q: Query, C: Counters>(
        &self,
        query: &Q,
        slots: Range<u32>,
        (rays, which): (&[Ray], &[u32]),
        answers: &mut [Q::Answer],
        scratch: &mut Scratch,
        counters: &mut C,
    ) {
        let _ = scratch;
        for &place in which {
            let (ray, answer) = (&rays[place as usize], &mut answers[place as usize]);
            let box_ray = BoxRay::new(ray, self.padding());
            self.test(query, slots.clone(), ray, &box_ray, answer, counters);
        }
    }
}

/// What a structure is built over, and what becomes primitives in its order.
///
/// Primitives are that themselves. What is not stored as rays are tested against it, as the triangles of a mesh, need
/// not be so before the order is known.
///
/// Equal hits rest on this: a structure leaves primitives out by the boxes from before, and hits count by those of
/// the primitives, with their padding. Both must be the same, primitive by primitive.
pub trait IntoPrimitives: Bounded {
    /// What rays are tested against.
    type Primitives: Primitives;

    /// Makes ready for a build, which asks for the boxes of the indices up to [`count`](Bounded::count): primitives
    /// that stand in the order of another structure [close their ranks](Primitives::close_ranks).
    ///
    /// # Panics
    /// If that is not possible.
    fn prepare(&mut self) {}

    /// The primitives in an order, as [`Primitives::reorder`] has it; none if they are to stay as they are.
    fn into_primitives(self, order: Option<&[u32]>) -> Self::Primitives;
}

impl<P: Primitives> IntoPrimitives for P {
    type Primitives = Self;

    fn prepare(&mut self) {
        self.close_ranks();
    }

    fn into_primitives(mut self, order: Option<&[u32]>) -> Self {
        if let Some(order) = order {
            self.reorder(order);
        }
        self
    }
}

/// Many rays at once, whatever the structure: what the renderer, the benches and the tests call.
///
/// The order and the number of the rays in a slice never change an answer. Counting is chosen by
/// the call; without it the search is compiled without counters.
pub trait Tracer: Send + Sync {
    /// Answers the query that the kind of `answers` stands for, for each ray.
    ///
    /// # Panics
    /// If the slices differ in length.
    fn trace(
        &self,
        rays: &[Ray],
        answers: Answers<'_>,
        scratch: &mut Scratch,
        counts: Option<&mut Counts>,
    );

    /// Whether rays are searched one by one, so that it does not matter how many are in a slice
    /// ([`Accel::ONE_BY_ONE`]).
    fn is_one_by_one(&self) -> bool {
        false
    }
}
