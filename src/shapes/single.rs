//! A shape that is one primitive, whichever it is: one ray against it, its name, box and points.
//!
//! Many rays against one are in `single_many.rs`, by the same formulas.

use crate::math::{Aabb, BoxRay, Hit, Ray};

use super::single_shape::SingleShape;
use super::{Place, Single, SurfacePoint};

impl Single {
    /// The first hit with `ray.t_min ≤ t ≤ ray.t_max`. `box_ray` is the ray with the place's
    /// padding.
    #[inline]
    #[must_use]
    pub fn closest(&self, place: &Place<'_>, ray: &Ray, box_ray: &BoxRay) -> Option<Hit> {
        let own = place.own_ray(ray);
        let counts = |t| own.t_min <= t && t <= own.t_max && box_ray.accepts(&place.bounds, t);
        let hit = for_shape!(self, shape => shape.first_hit(&own, counts))?;
        Some(Hit { object: place.object, ..hit })
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
