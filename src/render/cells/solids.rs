//! Boxes, balls and polytopes that are hit where a ray enters them.

use glam::{Vec3, Vec3A};

use crate::accel::RegionForm;
use crate::math::{Aabb, BoxRay, Hit, Ray};

use super::things::Thing;

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
        let begins_outside = near > ray.t_min && near <= far.min(ray.end());
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
                let counts = t > ray.t_min && t <= ray.end() && t >= near;
                let facing = (root / (a.sqrt() * radius)) as f32;
                counts.then_some((t, 0.45 + 0.55 * facing))
            }
            RegionForm::Polytope(kdop) => {
                let (t, side) = kdop.entered_from(ray.origin.as_dvec3(), ray.dir.as_dvec3())?;
                let (t, pair) = (t as f32, side / 2);
                let light = if pair < 3 { FACES[pair] } else { ASLANT[pair - 3] };
                (t > ray.t_min && t <= ray.end()).then_some((t, light))
            }
        }
    }
}

impl Thing for Solid {
    fn bounds(&self) -> Aabb {
        self.bounds()
    }

    fn hit(&self, id: u32, ray: &Ray, box_ray: &BoxRay) -> Option<Hit> {
        let (t, light) = self.entered(ray, box_ray)?;
        Some(Hit { t, object: 0, prim: id, u: light, v: 0.0 })
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
