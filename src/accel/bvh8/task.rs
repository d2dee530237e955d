//! What the kernels search, and for what.

use crate::accel::{Packs, Primitives, Query};
use crate::math::Padding;
use crate::simd::{Cache, prefetch};

use super::Bvh8;
use super::node::Child;

/// Of a tree with more bytes of nodes and packs, both come mostly from beyond the caches of a core.
const FAR: u64 = 1 << 23;

/// Of one with more than these, packs do, which are most of the bytes; nodes, visited again and again, stay.
const FAR_PACKS: u64 = 1 << 20;

/// The most rays that a wave can have.
pub(super) const MOST_IN_FLIGHT: usize = 64;

/// How many rays go in waves.
#[derive(Clone, Copy, Debug)]
pub(super) struct WaveSize {
    /// Rays in flight.
    pub(super) in_flight: usize,
    /// Rays that are worth a phase: each begins and ends with turns that cannot be foreseen. Fewer wait while others
    /// can go on.
    pub(super) worthwhile: usize,
}

impl WaveSize {
    const USUAL: Self = Self { in_flight: 48, worthwhile: 20 };
    /// Where memory is far away, and more rays are to wait for it together.
    const FAR: Self = Self { in_flight: MOST_IN_FLIGHT, worthwhile: 24 };
}

/// A ray as the formula of primitives takes it.
pub(super) type RayOf<P> = <<P as Primitives>::Packs as Packs>::Ray;

/// What is searched, and for what.
pub(super) struct Task<'a, P: Primitives, Q> {
    pub(super) tree: &'a Bvh8,
    pub(super) query: &'a Q,
    pub(super) primitives: &'a P,
    pub(super) packs: &'a P::Packs,
    pub(super) padding: Padding,
    /// Whether nodes and packs come mostly from beyond the caches of a core, so that they are prefetched.
    pub(super) far: bool,
    /// Whether packs do.
    pub(super) far_packs: bool,
    pub(super) wave: WaveSize,
}

impl<'a, P: Primitives, Q: Query> Task<'a, P, Q> {
    pub(super) fn new(tree: &'a Bvh8, query: &'a Q, primitives: &'a P) -> Self {
        let packs = primitives.packs();
        let bytes = size_of_val(&tree.nodes[..]) as u64 + packs.bytes();
        let padding = primitives.padding();
        let far = bytes > FAR;
        let wave = if far { WaveSize::FAR } else { WaveSize::USUAL };
        let far_packs = bytes > FAR_PACKS;
        Self { tree, query, primitives, packs, padding, far, far_packs, wave }
    }

    /// Prefetches what will be visited soon.
    #[inline(always)]
    pub(super) fn prefetch(&self, child: Child, into: Cache) {
        if child.is_leaf() {
            self.packs.prefetch(child.block(), into);
        } else {
            prefetch(&self.tree.nodes[child.index()], into);
        }
    }
}
