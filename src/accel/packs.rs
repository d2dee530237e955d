//! Primitives in packs of eight, for kernels that test eight primitives, or sixteen rays, at once.

use crate::math::{Aabb, Lanes, Lanes3};
use crate::simd::Simd;

/// Lanes of a pack.
pub const PACK: usize = 8;

/// What a formula finds for rays and primitives, lane by lane, before a box is consulted. The
/// parameter and the coordinates are quotients; dividing is left to those who need the result.
#[derive(Clone, Copy, Debug)]
pub struct PackHits<L: Lanes> {
    /// Where the ray's line meets the primitive.
    pub inside: L::Mask,
    /// The parameter, times `scale`.
    pub t: L,
    /// First surface coordinate, times `scale`.
    pub u: L,
    /// Second surface coordinate, times `scale`.
    pub v: L,
    /// What these are divided by. Where that gives a NaN, nothing is hit.
    pub scale: L,
}

/// Primitives by packs and lanes. Slot `i` is lane `i % 8` of pack `i / 8`. Empty lanes give a
/// parameter that is NaN.
pub trait Packs: Sync {
    /// How many slots a single ray is tested with at once: ranges that begin at a multiple of it are
    /// the cheapest. 1 means that there are no packs, and that none of the methods is called.
    const GRAIN: u32;

    /// One ray against the eight primitives of a pack.
    fn test_pack<S: Simd>(
        &self,
        pack: usize,
        origin: Lanes3<S::F8>,
        dir: Lanes3<S::F8>,
    ) -> PackHits<S::F8>;

    /// Sixteen rays against one primitive.
    fn test_lane<S: Simd>(
        &self,
        pack: usize,
        lane: usize,
        origin: Lanes3<S::F16>,
        dir: Lanes3<S::F16>,
    ) -> PackHits<S::F16>;

    /// The primitives' own boxes, lane by lane: low and high corners, the same as those of
    /// [`Packs::bounds`]. Hits are accepted by either.
    fn boxes<S: Simd>(&self, pack: usize) -> [Lanes3<S::F8>; 2];

    /// Prefetches a pack that will be tested soon.
    fn prefetch(&self, pack: usize);

    /// Bytes of all packs.
    fn bytes(&self) -> u64;

    /// One primitive's own box.
    fn bounds(&self, pack: usize, lane: usize) -> Aabb;

    /// One primitive's id.
    fn id(&self, pack: usize, lane: usize) -> u32;
}

/// For primitives that are tested one by one: there are no packs.
#[derive(Clone, Copy, Debug)]
pub struct NoPacks;

/// Why a method of [`NoPacks`] is not called.
const NONE: &str = "a grain of 1 means that there are no packs";

impl Packs for NoPacks {
    const GRAIN: u32 = 1;

    fn test_pack<S: Simd>(&self, _: usize, _: Lanes3<S::F8>, _: Lanes3<S::F8>) -> PackHits<S::F8> {
        unreachable!("{NONE}")
    }

    fn test_lane<S: Simd>(
        &self,
        _: usize,
        _: usize,
        _: Lanes3<S::F16>,
        _: Lanes3<S::F16>,
    ) -> PackHits<S::F16> {
        unreachable!("{NONE}")
    }

    fn boxes<S: Simd>(&self, _: usize) -> [Lanes3<S::F8>; 2] {
        unreachable!("{NONE}")
    }

    fn prefetch(&self, _: usize) {
        unreachable!("{NONE}")
    }

    fn bytes(&self) -> u64 {
        0
    }

    fn bounds(&self, _: usize, _: usize) -> Aabb {
        unreachable!("{NONE}")
    }

    fn id(&self, _: usize, _: usize) -> u32 {
        unreachable!("{NONE}")
    }
}
