//! Primitives in packs of eight, for kernels that test eight primitives, or a packet of rays, at once.

use crate::math::{Lanes, Lanes3, Mask as _, Ray};
use crate::simd::{Cache, Simd};

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

impl<L: Lanes> PackHits<L> {
    /// Bits of the lanes that are inside but have a scale of zero: there
    /// [`Packs::flat_hit`] knows.
    #[inline(always)]
    #[must_use]
    pub fn flat(&self) -> u32 {
        (self.inside & self.scale.abs().le(L::splat(0.0))).bits()
    }

    /// Puts a parameter and coordinates into a lane.
    #[inline(always)]
    pub fn replace(&mut self, lane: usize, [t, u, v]: [f32; 3]) {
        let mask = 1 << lane;
        self.t = L::splat(t).select(mask, self.t);
        self.u = L::splat(u).select(mask, self.u);
        self.v = L::splat(v).select(mask, self.v);
        self.scale = L::splat(1.0).select(mask, self.scale);
    }
}

/// Primitives by packs and lanes. Slot `i` is lane `i % 8` of pack `i / 8`. Empty lanes give a
/// parameter that is NaN.
///
/// What a formula needs of rays is worked out once, before they are tested with many packs.
pub trait Packs: Sync {
    /// How many slots a single ray is tested with at once: ranges that begin at a multiple of it are
    /// the cheapest. 1 means that there are no packs, and that none of the methods is called.
    const GRAIN: u32;

    /// A ray as the formula takes it.
    type Ray: Copy + Default + Send + 'static;

    /// Several rays as the formula takes them, a ray in each lane.
    type Rays<R: Lanes>: Copy;

    /// A ray as the formula takes it; `inv_dir` is 1/direction, cut to finite values.
    fn ray(ray: &Ray, inv_dir: &[f32; 3]) -> Self::Ray;

    /// Eight rays, a ray in each lane, by their origins, directions, and 1/direction, each as [`ray`](Self::ray) gives
    /// it.
    fn eight_rays<S: Simd>(
        origin: &Lanes3<S::F8>,
        dir: &Lanes3<S::F8>,
        inv_dir: &Lanes3<S::F8>,
        rays: &mut [Self::Ray; PACK],
    );

    /// Several rays, by their origins, directions, and 1/direction.
    fn rays<R: Lanes>(origin: &Lanes3<R>, dir: &Lanes3<R>, inv_dir: &Lanes3<R>) -> Self::Rays<R>;

    /// One ray against the eight primitives of a pack.
    fn test_pack<S: Simd>(&self, pack: usize, ray: &Self::Ray) -> PackHits<S::F8>;

    /// Several rays against one primitive.
    fn test_lane<R: Lanes>(&self, pack: usize, lane: usize, rays: &Self::Rays<R>) -> PackHits<R>;

    /// The parameter and the coordinates of a hit that is [`flat`](PackHits::flat); the parameter is NaN if
    /// there is none.
    fn flat_hit(&self, pack: usize, lane: usize, ray: &Ray) -> [f32; 3];

    /// The primitives' own boxes, lane by lane: low and high corners, the same as those of
    /// [`Bounded::bounds`](super::Bounded::bounds).
    fn boxes<S: Simd>(&self, pack: usize) -> [Lanes3<S::F8>; 2];

    /// Prefetches a pack that will be tested soon.
    fn prefetch(&self, pack: usize, into: Cache);

    /// Bytes of all packs.
    fn bytes(&self) -> u64;

    /// One primitive's id.
    fn id(&self, pack: usize, lane: usize) -> u32;
}

/// For primitives that are tested one by one: there are no packs.
#[derive(Clone, Copy, Debug)]
pub struct NoPacks;

/// What rays are for [`NoPacks`].
#[derive(Clone, Copy, Debug, Default)]
pub struct NoRay;

/// Why a method of [`NoPacks`] is not called.
const NONE: &str = "a grain of 1 means that there are no packs";

impl Packs for NoPacks {
    const GRAIN: u32 = 1;

    type Ray = NoRay;
    type Rays<R: Lanes> = NoRay;

    fn ray(_: &Ray, _: &[f32; 3]) -> NoRay {
        unreachable!("{NONE}")
    }

    fn eight_rays<S: Simd>(
        _: &Lanes3<S::F8>,
        _: &Lanes3<S::F8>,
        _: &Lanes3<S::F8>,
        _: &mut [NoRay; PACK],
    ) {
        unreachable!("{NONE}")
    }

    fn rays<R: Lanes>(_: &Lanes3<R>, _: &Lanes3<R>, _: &Lanes3<R>) -> NoRay {
        unreachable!("{NONE}")
    }

    fn test_pack<S: Simd>(&self, _: usize, _: &NoRay) -> PackHits<S::F8> {
        unreachable!("{NONE}")
    }

    fn test_lane<R: Lanes>(&self, _: usize, _: usize, _: &NoRay) -> PackHits<R> {
        unreachable!("{NONE}")
    }

    fn flat_hit(&self, _: usize, _: usize, _: &Ray) -> [f32; 3] {
        unreachable!("{NONE}")
    }

    fn boxes<S: Simd>(&self, _: usize) -> [Lanes3<S::F8>; 2] {
        unreachable!("{NONE}")
    }

    fn prefetch(&self, _: usize, _: Cache) {
        unreachable!("{NONE}")
    }

    fn bytes(&self) -> u64 {
        0
    }

    fn id(&self, _: usize, _: usize) -> u32 {
        unreachable!("{NONE}")
    }
}
