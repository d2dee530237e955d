//! The slab test of a ray that travels alone; the arithmetic is that of `slab.rs`.
//!
//! Equal hits rest on it. A hit counts only if the interval of its primitive's own box reaches what
//! is searched and begins no later than the hit, and a structure may only skip a box whose interval
//! ends before, or begins behind, what is searched. Each operation below rounds monotonically in the
//! plane's coordinate, so the interval of an enclosing box contains that of every box within, to the
//! last bit: what counts is never skipped.

use glam::Vec3A;

use super::slab::{finite_reciprocal, meets, slab};
use super::{Aabb, Lanes, Lanes3, Padding, Ray, within};

/// A ray as boxes see it.
#[derive(Clone, Copy, Debug)]
pub struct BoxRay {
    /// 1/dir, cut to finite values.
    pub inv_dir: Vec3A,
    /// origin + padding: what planes are measured from where the ray runs along the axis.
    pub origin_plus: Vec3A,
    /// origin − padding.
    pub origin_minus: Vec3A,
    /// The padding, a length.
    pub pad: f32,
}

impl BoxRay {
    /// Prepares a ray for boxes with the given padding.
    #[inline]
    #[must_use]
    pub fn new(ray: &Ray, padding: Padding) -> Self {
        let origin = Vec3A::from(ray.origin);
        let pad = padding.of_rays(origin.abs().max_element());
        Self {
            inv_dir: finite_reciprocal(Vec3A::from(ray.dir)),
            origin_plus: origin + Vec3A::splat(pad),
            origin_minus: origin - Vec3A::splat(pad),
            pad,
        }
    }

    /// The same ray with `extra` times its padding added: for boxes that are stored or tested with
    /// less precision than the primitives' own. Its intervals contain those of `self`.
    #[inline]
    #[must_use]
    pub fn widened(&self, extra: f32) -> Self {
        let more = Vec3A::splat(extra * self.pad);
        Self {
            origin_plus: self.origin_plus + more,
            origin_minus: self.origin_minus - more,
            pad: self.pad + extra * self.pad,
            ..*self
        }
    }

    /// The parameters at which the ray enters and leaves the padded box; it misses if near > far.
    ///
    /// The box must not be empty. Where a direction is positive the first product is the near one,
    /// where it is negative the second: the smaller of the two either way.
    #[inline]
    #[must_use]
    pub fn interval(&self, aabb: &Aabb) -> (f32, f32) {
        let origins = [self.origin_plus, self.origin_minus];
        let (near, far) = slab([aabb.min, aabb.max], origins, self.inv_dir);
        (near.max_element(), far.min_element())
    }

    /// [`interval`](Self::interval) of several boxes, by their low and their high corners.
    #[inline(always)]
    #[must_use]
    pub fn intervals<L: Lanes>(&self, [low, high]: [Lanes3<L>; 2]) -> (L, L) {
        let (x, y, z) = (
            self.slabs(0, low[0], high[0]),
            self.slabs(1, low[1], high[1]),
            self.slabs(2, low[2], high[2]),
        );
        (x.0.max(y.0).max(z.0), x.1.min(y.1).min(z.1))
    }

    #[inline(always)]
    fn slabs<L: Lanes>(&self, axis: usize, low: L, high: L) -> (L, L) {
        let origins = [L::splat(self.origin_plus[axis]), L::splat(self.origin_minus[axis])];
        slab([low, high], origins, L::splat(self.inv_dir[axis]))
    }

    /// Where hits count at the earliest in the box, if any between `t_min` and `t_max` count there: the
    /// own-box rule. `None` if its interval is empty, ends before `t_min` or begins behind `t_max`.
    #[inline]
    #[must_use]
    pub fn begin(&self, aabb: &Aabb, [t_min, t_max]: [f32; 2]) -> Option<f32> {
        let (near, far) = self.interval(aabb);
        meets([near, far], [t_min, t_max]).then_some(near)
    }

    /// Whether `t` lies in the interval of the box: all that the own-box rule asks of a hit that is not
    /// moved.
    #[inline]
    #[must_use]
    pub fn accepts(&self, aabb: &Aabb, t: f32) -> bool {
        let (near, far) = self.interval(aabb);
        within(t, [near, far])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Random;
    use glam::Vec3;

    const UNIT: Padding = Padding { largest: 1.0, factor: 1.0 };

    fn unit_box() -> Aabb {
        Aabb { min: Vec3A::splat(-1.0), max: Vec3A::splat(1.0) }
    }

    #[test]
    fn the_interval_of_a_box_is_where_the_ray_crosses_its_planes() {
        let ray = Ray::new(Vec3::new(-3.0, 0.5, 0.0), Vec3::new(2.0, 0.0, 0.0));
        let (near, far) = BoxRay::new(&ray, UNIT).interval(&unit_box());
        assert!((near - 1.0).abs() < 1e-5 && (far - 2.0).abs() < 1e-5, "{near} {far}");
    }

    #[test]
    fn a_ray_beside_a_box_misses_it_even_where_it_runs_along_an_axis() {
        for zero in [0.0, -0.0] {
            let ray = Ray::new(Vec3::new(-3.0, 1.5, 0.0), Vec3::new(1.0, zero, zero));
            let (near, far) = BoxRay::new(&ray, UNIT).interval(&unit_box());
            assert!(near > far, "{near} {far}");
        }
    }

    #[test]
    fn a_ray_in_the_plane_of_a_face_hits_and_is_never_nan() {
        for zero in [0.0, -0.0] {
            let ray = Ray::new(Vec3::new(-3.0, 1.0, 1.0), Vec3::new(1.0, zero, zero));
            let (near, far) = BoxRay::new(&ray, UNIT).interval(&unit_box());
            assert!(near <= 2.0 && far >= 4.0, "{near} {far}");
        }
    }

    #[test]
    fn enclosing_boxes_have_enclosing_intervals_to_the_bit() {
        let mut random = Random::new(&[3]);
        let mut point = |scale: f32| {
            Vec3A::from_array(std::array::from_fn(|_| (random.next_f32() - 0.5) * scale))
        };
        for _ in 0..20_000 {
            let inner = Aabb::of_points([point(2.0), point(2.0)]);
            let outer = inner.union(Aabb::of_points([point(4.0)]));
            let mut dir = Vec3::from(point(2.0));
            if dir.x > 0.5 {
                dir.y = 0.0;
            }
            let ray = Ray::new(Vec3::from(point(6.0)), dir);
            let padding = Padding::of_bounds(&outer);
            let box_ray = BoxRay::new(&ray, padding);
            let (near, far) = box_ray.interval(&inner);
            let row = |corner: Vec3A| corner.to_array().map(glam::Vec4::splat);
            let lanes = box_ray.intervals([row(inner.min), row(inner.max)]);
            assert_eq!((lanes.0[2], lanes.1[2]), (near, far));
            for wider in [box_ray.interval(&outer), box_ray.widened(1.0).interval(&inner)] {
                assert!(wider.0 <= near && far <= wider.1);
            }
        }
    }
}
