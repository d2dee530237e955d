//! The shapes that are one primitive: one ray against one of them.
//!
//! Many rays against one are in `single_many.rs`, by the same formulas.

use crate::accel::{Query, Search};
use crate::math::{BoxRay, Hit, Ray, within};

use super::{Ball, Cylinder, Instance, Triangle};

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
        let own = instance.own_ray(&Ray { t_max, ..*ray });
        // Returns whether what lies farther on the shape is of no interest.
        let mut offer = |t, prim, u, v| {
            let counts = within(t, [own.t_min, own.t_max]) && box_ray.accepts(&instance.bounds, t);
            let hit = Hit { t, object: instance.object, prim, u, v };
            let recorded = counts && query.accepts(&own, &hit);
            if recorded {
                query.record(answer, &hit);
            }
            recorded && !matches!(Q::SEARCH, Search::All)
        };
        match self {
            Self::Ball(ball) => {
                let crossing = ball.crossing(&own);
                let _ = crossing.is_some_and(|(enter, leave)| {
                    offer(enter, 0, 0.0, 0.0) || offer(leave, 0, 0.0, 0.0)
                });
            }
            Self::Cylinder => {
                let crossings = Cylinder::crossing(&own).into_iter().flatten();
                let _ = crossings.into_iter().any(|(t, part)| offer(t, part, 0.0, 0.0));
            }
            Self::Triangle(triangle) => {
                let hit = triangle.intersect(&own);
                let _ = hit.is_some_and(|(t, u, v)| offer(t, 0, u, v));
            }
        }
    }
}
