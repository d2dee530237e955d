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

mod config;
mod shape;

use std::ops::{ControlFlow, Range};

use glam::Vec3A;

use crate::counters::{Counters, Counts};
use crate::math::{Aabb, BoxRay, Hit, Padding, Ray};

pub use config::{BuildConfig, Quality};
pub use shape::{LeafHistogram, StructureShape};

/// A set of things with boxes: all that a structure is built from.
pub trait Bounded: Sync {
    /// How many there are.
    fn count(&self) -> u32;
    /// The box of one of them. Never empty; all coordinates finite.
    fn bounds(&self, index: u32) -> Aabb;
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
/// with a wider padding ([`Padding::scaled`]).
///
/// Primitives count a hit only inside the interval of their own box, and [`BoxRay::interval`] is
/// monotone to the bit, so nothing that counts is ever left out, and every structure that keeps
/// the contract returns the same hits as [`Exhaustive`].
pub trait Accel: Sized + Send + Sync {
    /// Builds the index. `primitives` may be empty.
    fn build(primitives: &impl Bounded, config: &BuildConfig) -> Self;

    /// Slot → primitive id, where the build put the primitives into an order of its own.
    fn order(&self) -> Option<&[u32]>;

    /// Offers ranges of slots that the ray may hit, near ones first where it can.
    ///
    /// The search starts at `ray.t_max`. `leaf` tests a range and returns the new end of the
    /// search (at most the one before), or breaks to end it.
    fn traverse<C: Counters>(
        &self,
        ray: &Ray,
        counters: &mut C,
        padding: Padding,
        leaf: impl FnMut(Range<u32>, &BoxRay, &mut C) -> ControlFlow<(), f32>,
    );

    /// Nodes, leaves, depth and bytes.
    fn shape(&self) -> StructureShape;
}

/// Primitives in slot order, with the formula that all structures share.
pub trait Primitives: Bounded + Send + Sync {
    /// The padding that every box test of these primitives uses.
    fn padding(&self) -> Padding;

    /// Puts the primitives into the order of a structure: slot `i` gets primitive `order[i]`.
    /// Hits go on to speak of ids.
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
