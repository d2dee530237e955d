//! What a shape that is one primitive provides, all of it in its own space.

use crate::math::{Aabb, Hit, Lanes, Mask as _, NONE, Ray, within};
use crate::simd::Simd;

use super::SurfacePoint;
use super::ray_group::RayGroup;

/// A shape that is one primitive: implemented in the shape's own file.
pub(super) trait SingleShape {
    /// The noun that messages use for it, after `a`.
    const NAME: &'static str;

    /// The smallest box around it, rounded outwards.
    fn bounds(&self) -> Aabb;

    /// Its largest extent: a shape of which it is too small for single precision is refused.
    fn size(&self) -> f64 {
        f64::from(self.bounds().size().max_element())
    }

    /// Where a hit counts that the formula puts at `t`, and a bit for each lane in which it does: between
    /// the ray's own ends, and by the box of the shape.
    #[inline(always)]
    fn placed<L: Lanes>(t: L, reach: &Reach<L>) -> (L, u32) {
        (t, within(t, reach.in_box).bits())
    }

    /// Offers the crossings of a ray, the nearer one first, until one of them is taken; the object's id
    /// is left open. A shape of several parts, as a cylinder's side and caps, numbers them by `prim`.
    fn offer_hits(&self, ray: &Ray, take: impl FnMut(Hit) -> bool);

    /// The first crossing that counts, for sixteen rays: the same operations in the same order.
    fn first_hits<S: Simd>(&self, rays: &RayGroup<S>) -> Found<S::F16>;

    /// The point of the surface at a hit of a ray.
    fn surface_point(&self, ray: &Ray, hit: &Hit) -> SurfacePoint;
}

/// The parameters between which hits of rays count.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reach<L> {
    /// From where the ray begins to the end of the search.
    pub(super) of_ray: [L; 2],
    /// The part of it within the shape's box; empty where the first is larger.
    pub(super) in_box: [L; 2],
}

/// Where sixteen rays first hit.
pub(super) struct Found<R> {
    pub(super) t: R,
    pub(super) u: R,
    pub(super) v: R,
    /// A bit for each ray that hits.
    pub(super) lanes: u32,
    /// The two bits of the part that each of them hits.
    pub(super) part: [u32; 2],
}

/// A hit on a part of a shape without surface coordinates.
pub(super) fn hit_of_part(t: f32, part: u32) -> Hit {
    Hit { t, object: NONE, prim: part, u: 0.0, v: 0.0 }
}
