//! Boxes, balls and polytopes as primitives that are hit where a ray enters them.

use std::ops::Range;

use glam::{Vec3, Vec3A};

use crate::accel::{Bounded, NoPacks, Primitives, Query, RegionForm};
use crate::counters::Counters;
use crate::math::{Aabb, BoxRay, Hit, Padding, Ray};

/// How bright the faces of boxes are, by the axis that they lie across.
const FACES: [f32; 3] = [0.78, 0.9, 1.0];

/// How bright the sides of polytopes across diagonals are, in the order of these.
const ASLANT: [f32; 4] = [0.95, 0.7, 0.84, 0.62];

/// A box, a ball or a polytope.
#[derive(Clone, Copy, Debug)]
pub(super) struct Solid(pub(super) RegionForm);

impl Solid {
    /// The box around it.
    pub(super) fn bounds(&self) -> Aabb {
        match self.0 {
            RegionForm::Box(bounds) => bounds,
            RegionForm::Ball { center, radius } => {
                let (center, reach) = (Vec3A::from(center), Vec3A::splat(radius));
                Aabb { min: center - reach, max: center + reach }
            }
            RegionForm::Polytope(kdop) => kdop.bounds(),
        }
    }

    /// Where a ray that begins outside enters, and how bright it is there.
    pub(super) fn entered(&self, ray: &Ray, box_ray: &BoxRay) -> Option<(f32, f32)> {
        let (near, far) = box_ray.interval(&self.bounds());
        let begins_outside = near > ray.t_min && near <= far.min(ray.t_max);
        if !begins_outside {
            return None;
        }
        match self.0 {
            RegionForm::Box(bounds) => Some((near, FACES[face(&bounds, ray.at(near))])),
            RegionForm::Ball { center, radius } => {
                let from = ray.origin.as_dvec3() - center.as_dvec3();
                let (dir, radius) = (ray.dir.as_dvec3(), f64::from(radius));
                let (a, b) = (dir.length_squared(), from.dot(dir));
                let root = (b * b - a * (from.length_squared() - radius * radius)).sqrt();
                // The root of a negative number is NaN: the ray misses the ball.
                let t = ((-b - root) / a) as f32;
                let counts = t > ray.t_min && t <= ray.t_max && t >= near;
                let facing = (root / (a.sqrt() * radius)) as f32;
                counts.then_some((t, 0.45 + 0.55 * facing))
            }
            RegionForm::Polytope(kdop) => {
                let (t, side) = kdop.entered_from(ray.origin.as_dvec3(), ray.dir.as_dvec3())?;
                let (t, pair) = (t as f32, side / 2);
                let light = if pair < 3 { FACES[pair] } else { ASLANT[pair - 3] };
                (t > ray.t_min && t <= ray.t_max).then_some((t, light))
            }
        }
    }
}

/// The axis across which the face of a box lies that a point on it belongs to.
fn face(bounds: &Aabb, point: Vec3) -> usize {
    let from = (Vec3A::from(point) - bounds.center()).abs();
    let half = 0.5 * bounds.size();
    // The face whose plane is nearest; flat boxes have their two large ones.
    let apart = (half - from).abs();
    (0..3).min_by(|&a, &b| apart[a].total_cmp(&apart[b])).unwrap_or(0)
}

/// Solids in slot order, each with its id.
#[derive(Clone, Debug)]
pub(super) struct Solids {
    all: Vec<(Solid, u32)>,
    padding: Padding,
}

impl Solids {
    /// Solids whose ids are their places.
    pub(super) fn new(forms: &[RegionForm]) -> Self {
        let all: Vec<_> = forms.iter().copied().map(Solid).zip(0..).collect();
        let bounds = all.iter().map(|(solid, _)| solid.bounds()).fold(Aabb::EMPTY, Aabb::union);
        Self { all, padding: Padding::of_bounds(&bounds) }
    }
}

impl Bounded for Solids {
    fn count(&self) -> u32 {
        self.all.len() as u32
    }

    fn bounds(&self, slot: u32) -> Aabb {
        self.all[slot as usize].0.bounds()
    }

    fn mean_point(&self) -> Vec3A {
        self.total_bounds().center()
    }
}

impl Primitives for Solids {
    type Packs = NoPacks;

    fn packs(&self) -> &NoPacks {
        &NoPacks
    }

    fn padding(&self) -> Padding {
        self.padding
    }

    fn reorder(&mut self, order: &[u32]) {
        let in_order = order.iter().filter_map(|&from| self.all.get(from as usize).copied());
        self.all = in_order.collect();
    }

    fn test<Q: Query, C: Counters>(
        &self,
        query: &Q,
        slots: Range<u32>,
        ray: &Ray,
        box_ray: &BoxRay,
        answer: &mut Q::Answer,
        _: &mut C,
    ) {
        for (solid, id) in &self.all[slots.start as usize..slots.end as usize] {
            if let Some((t, light)) = solid.entered(ray, box_ray) {
                let hit = Hit { t, object: 0, prim: *id, u: light, v: 0.0 };
                if t <= query.end(ray, answer) && query.accepts(ray, &hit) {
                    query.record(answer, &hit);
                }
            }
        }
    }
}
