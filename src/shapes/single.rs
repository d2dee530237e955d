//! A shape that is one primitive, whichever it is: one ray against it, its name, box and points.
//!
//! Many rays against one are in `single_many.rs`, by the same formulas.

use crate::accel::{Query, Search};
use crate::math::{Aabb, BoxRay, Hit, Ray};

use super::single_shape::{Reach, SingleShape};
use super::{Instance, Single, SurfacePoint};

impl Single {
    /// Records the hits of a ray that count: see [`Primitives::test`](crate::accel::Primitives::test).
    /// `box_ray` is the ray with the padding of the instance.
    #[inline]
    pub fn test<Q: Query>(
        &self,
        query: &Q,
        instance: &Instance<'_>,
        ray: &Ray,
        box_ray: &BoxRay,
        answer: &mut Q::Answer,
    ) {
        let t_max = query.end(ray, answer);
        // The smaller or the larger of a number and what is none is the number: a ray with such an end would hit.
        let searches = ray.t_min <= t_max;
        if !searches {
            return;
        }
        let (near, far) = box_ray.interval(&instance.bounds);
        let in_box = [near.max(ray.t_min), far.min(t_max)];
        let reach = Reach { of_ray: [ray.t_min, t_max], in_box };
        let own = instance.own_ray(&Ray { t_max, ..*ray });
        // Records a hit that counts. Returns whether what lies farther on the shape is of no interest.
        let mut offer = |(t, counts): (f32, u32), hit: Hit| {
            let hit = Hit { t, object: instance.object, ..hit };
            let recorded = counts & 1 != 0 && (!Q::FILTERS || query.accepts(&own, &hit));
            if recorded {
                query.record(answer, &hit);
            }
            recorded && const { Q::KEEPS_ONE_HIT || matches!(Q::SEARCH, Search::First) }
        };
        for_shape!(self, shape => shape.offer_hits(&own, |hit| offer(placed(shape, hit.t, &reach), hit)));
    }

    /// The noun that messages use for it, after `a`.
    #[must_use]
    pub fn name(&self) -> &'static str {
        fn name_of<T: SingleShape>(_: &T) -> &'static str {
            T::NAME
        }
        for_shape!(self, shape => name_of(shape))
    }

    /// The smallest box around it, rounded outwards.
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        for_shape!(self, shape => shape.bounds())
    }

    /// Its largest extent.
    #[must_use]
    pub fn size(&self) -> f64 {
        for_shape!(self, shape => shape.size())
    }

    /// The point of the surface at a hit of a ray in its own space.
    #[inline]
    #[must_use]
    pub fn surface_point(&self, ray: &Ray, hit: &Hit) -> SurfacePoint {
        for_shape!(self, shape => SingleShape::surface_point(shape, ray, hit))
    }
}

/// [`SingleShape::placed`] of whichever shape it is.
#[inline(always)]
fn placed<T: SingleShape>(_: &T, t: f32, reach: &Reach<f32>) -> (f32, u32) {
    T::placed(t, reach)
}
