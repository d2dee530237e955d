//! What the kernels search, and for what.

use crate::accel::{Packs, Primitives, Query};
use crate::math::Padding;
use crate::simd::prefetch;

use super::Bvh8;
use super::node::Child;

/// Bytes that fit into the cache of a core, about; what is larger comes from one that is farther away.
const CORE_CACHE: u64 = 1 << 23;

/// Rays of a wave.
const IN_FLIGHT: usize = 48;

/// Rays of a wave where nodes and packs come from farther away, and more rays are to wait for them together.
pub(super) const MOST_IN_FLIGHT: usize = 64;

/// A ray as the formula of primitives takes it.
pub(super) type RayOf<P> = <<P as Primitives>::Packs as Packs>::Ray;

/// What is searched, and for what.
pub(super) struct Task<'a, P: Primitives, Q> {
    pub(super) tree: &'a Bvh8,
    pub(super) query: &'a Q,
    pub(super) primitives: &'a P,
    pub(super) packs: &'a P::Packs,
    pub(super) padding: Padding,
    /// Whether nodes and packs do not fit into the cache of a core, so that what is about to be read is prefetched.
    pub(super) far: bool,
    /// How many rays a wave has in flight.
    pub(super) in_flight: usize,
}

impl<'a, P: Primitives, Q: Query> Task<'a, P, Q> {
    pub(super) fn new(tree: &'a Bvh8, query: &'a Q, primitives: &'a P) -> Self {
        let packs = primitives.packs();
        let bytes = size_of_val(&tree.nodes[..]) as u64 + packs.bytes();
        let padding = primitives.padding();
        let far = bytes > CORE_CACHE;
        let in_flight = if far { MOST_IN_FLIGHT } else { IN_FLIGHT };
        Self { tree, query, primitives, packs, padding, far, in_flight }
    }

    /// Prefetches what will be visited soon.
    #[inline(always)]
    pub(super) fn prefetch(&self, child: Child) {
        if child.is_leaf() {
            self.packs.prefetch(child.block());
        } else {
            prefetch(&self.tree.nodes[child.index()]);
        }
    }
}
