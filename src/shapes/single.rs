//! The shapes that are one primitive: one ray against one of them.
//!
//! Many rays against one are in `single_many.rs`, by the same formulas.

use crate::math::{BoxRay, Hit, Ray};

use super::{Ball, Cylinder, Place, Triangle};

/// A shape that is one primitive, in its own space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Single {
    /// A ball.
    Ball(Ball),
    /// The canonical cylinder.
    Cylinder,
    /// A triangle.
    Triangle(Triangle),
}

impl Single {
    /// The first hit with `ray.t_min ≤ t ≤ ray.t_max`. `box_ray` is the ray with the place's
    /// padding.
    #[inline]
    #[must_use]
    pub fn closest(&self, place: &Place<'_>, ray: &Ray, box_ray: &BoxRay) -> Option<Hit> {
        let own = place.own_ray(ray);
        let hit = |t, prim, u, v| Hit { t, object: place.object, prim, u, v };
        let crossings = match self {
            Self::Ball(ball) => {
                let (enter, leave) = ball.crossing(&own)?;
                [(enter, 0), (leave, 0)]
            }
            Self::Cylinder => Cylinder::crossing(&own)?,
            Self::Triangle(triangle) => {
                let (t, u, v) = triangle.intersect(&own)?;
                return box_ray.accepts(&place.bounds, t).then(|| hit(t, 0, u, v));
            }
        };
        let counts = |t| own.t_min <= t && t <= own.t_max && box_ray.accepts(&place.bounds, t);
        let (t, prim) = crossings.into_iter().find(|&(t, _)| counts(t))?;
        Some(hit(t, prim, 0.0, 0.0))
    }
}
