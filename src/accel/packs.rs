//! Primitives in packs of eight, for kernels that test eight primitives, or sixteen rays, at once.

use crate::math::Aabb;
use crate::simd::{Lanes3, Simd};

/// Lanes of a pack.
pub const PACK: usize = 8;

/// A hit before its division: the ray is inside the primitive if `u ≥ 0`, `v ≥ 0` and
/// `u + v ≤ det`, and then hits it at `t / det`. The other quotients are the hit's coordinates.
#[derive(Clone, Copy, Debug)]
pub struct ScaledHit<L> {
    /// First coordinate, times `det`.
    pub u: L,
    /// Second coordinate, times `det`.
    pub v: L,
    /// Ray parameter, times `det`.
    pub t: L,
    /// The scale: not negative. Where it is 0, nothing is hit.
    pub det: L,
}

/// Primitives by packs and lanes. Slot `i` is lane `i % 8` of pack `i / 8`. Empty lanes give a
/// quotient `t / det` that is NaN.
pub trait Packs: Sync {
    /// One ray against the eight primitives of a pack.
    fn of_pack<S: Simd>(
        &self,
        pack: usize,
        origin: Lanes3<S::F8>,
        dir: Lanes3<S::F8>,
    ) -> ScaledHit<S::F8>;

    /// Sixteen rays against one primitive.
    fn of_lane<S: Simd>(
        &self,
        pack: usize,
        lane: usize,
        origin: Lanes3<S::F16>,
        dir: Lanes3<S::F16>,
    ) -> ScaledHit<S::F16>;

    /// The primitives' own boxes, lane by lane: low and high corners, the same as those of
    /// [`Packs::bounds`]. Hits are accepted by either.
    fn boxes<S: Simd>(&self, pack: usize) -> [Lanes3<S::F8>; 2];

    /// Asks the caches for a pack that will be tested soon.
    fn prefetch(&self, pack: usize);

    /// Bytes of all packs.
    fn bytes(&self) -> u64;

    /// One primitive's own box.
    fn bounds(&self, pack: usize, lane: usize) -> Aabb;

    /// One primitive's id.
    fn id(&self, pack: usize, lane: usize) -> u32;
}

/// For primitives that are tested one by one: has no packs.
#[derive(Clone, Copy, Debug)]
pub enum NoPacks {}

impl Packs for NoPacks {
    fn of_pack<S: Simd>(&self, _: usize, _: Lanes3<S::F8>, _: Lanes3<S::F8>) -> ScaledHit<S::F8> {
        match *self {}
    }

    fn of_lane<S: Simd>(
        &self,
        _: usize,
        _: usize,
        _: Lanes3<S::F16>,
        _: Lanes3<S::F16>,
    ) -> ScaledHit<S::F16> {
        match *self {}
    }

    fn boxes<S: Simd>(&self, _: usize) -> [Lanes3<S::F8>; 2] {
        match *self {}
    }

    fn prefetch(&self, _: usize) {
        match *self {}
    }

    fn bytes(&self) -> u64 {
        match *self {}
    }

    fn bounds(&self, _: usize, _: usize) -> Aabb {
        match *self {}
    }

    fn id(&self, _: usize, _: usize) -> u32 {
        match *self {}
    }
}
