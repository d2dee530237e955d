//! What the kernels search, and for what.

use crate::accel::{Packs, Primitives, Query};
use crate::math::Padding;
use crate::simd::prefetch;

use super::Bvh8;
use super::node::Child;

/// Bytes that a processor's caches hold, about.
const CACHE: u64 = 1 << 25;

/// What is searched, and for what.
pub(super) struct Task<'a, P: Primitives, Q> {
    pub(super) tree: &'a Bvh8,
    pub(super) query: &'a Q,
    pub(super) primitives: &'a P,
    pub(super) packs: &'a P::Packs,
    pub(super) padding: Padding,
    /// Whether nodes and packs do not fit into the caches, so that what rays are
    /// about to read is prefetched.
    pub(super) large: bool,
}

impl<'a, P: Primitives, Q: Query> Task<'a, P, Q> {
    pub(super) fn new(tree: &'a Bvh8, query: &'a Q, primitives: &'a P) -> Self {
        let packs = primitives.packs();
        let bytes = size_of_val(&tree.nodes[..]) as u64 + packs.bytes();
        let padding = primitives.padding();
        Self { tree, query, primitives, packs, padding, large: bytes > CACHE }
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
