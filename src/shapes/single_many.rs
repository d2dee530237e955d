//! Many rays against one shape, sixteen at a time.
//!
//! Every lane does what `single.rs` does for one ray, with the same operations in the same order:
//! what is divided, compared and told is the same to the bit.

use crate::math::{Hit, Ray};
use crate::simd::{Kernel, LANES, Mask, Row, Simd, dispatch, ones};

use super::place::SoFar;
use super::ray_group::Group;
use super::single_shape::{Found, SingleShape};
use super::{Place, Single};

impl Single {
    /// Notes where some rays hit the shape, or that they do. `which` has the rays' places in both
    /// slices.
    pub fn ask<A: SoFar>(&self, place: &Place<'_>, rays: &[Ray], which: &[u32], answers: &mut [A]) {
        dispatch(Many { single: self, place, rays, which, answers });
    }
}

struct Many<'a, A> {
    single: &'a Single,
    place: &'a Place<'a>,
    rays: &'a [Ray],
    which: &'a [u32],
    answers: &'a mut [A],
}

impl<A: SoFar> Kernel for Many<'_, A> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { single, place, rays, which, answers } = self;
        let mut records = [[0.0; 8]; LANES];
        for places in which.chunks(LANES) {
            let mut group = Group::<S>::load(place, rays, places, answers, &mut records);
            if group.begin.le(group.end).bits() == 0 {
                continue;
            }
            group.enter_own_space(place);
            let found = for_shape!(single, shape => shape.first_hits(&group));
            found.note(place.object, places, answers);
        }
    }
}

impl<R: Row<LANES>> Found<R> {
    #[inline(always)]
    fn note<A: SoFar>(&self, object: u32, group: &[u32], answers: &mut [A]) {
        if self.lanes == 0 {
            return;
        }
        let (mut t, mut u, mut v) = ([0.0; LANES], [0.0; LANES], [0.0; LANES]);
        self.t.store(&mut t);
        self.u.store(&mut u);
        self.v.store(&mut v);
        for lane in ones(self.lanes) {
            let bit = |of: u32| of >> lane & 1;
            let prim = bit(self.part[0]) | bit(self.part[1]) << 1;
            let at = lane % LANES;
            let hit = Hit { t: t[at], object, prim, u: u[at], v: v[at] };
            answers[group[lane] as usize].note(&hit);
        }
    }
}

#[cfg(test)]
pub(super) mod tests {
    use glam::{DAffine3, DQuat, DVec3, Vec3};

    use super::*;
    use crate::math::{BoxRay, Padding, Random, Transform};

    /// Rays from inside, from outside and along the axes, some of them beside the shapes.
    fn rays() -> Vec<Ray> {
        let mut random = Random::new(&[7]);
        let mut point = || Vec3::from_array(std::array::from_fn(|_| random.next_f32() - 0.5));
        (0..4000)
            .map(|i| {
                let mut ray = Ray::new([1.0, 6.0, 40.0][i % 3] * point(), Vec3::ZERO);
                ray.dir = 3.0 * point() - ray.origin;
                if i % 5 == 0 {
                    ray.dir[i % 3] = if i % 2 == 0 { 0.0 } else { -0.0 };
                }
                if i % 7 == 0 {
                    ray.dir[(i + 1) % 3] = 0.0;
                }
                if i % 4 == 0 {
                    ray.t_max = 1.0;
                }
                ray
            })
            .collect()
    }

    /// Compares what a shape's two formulas find, without and under a transform.
    pub(in crate::shapes) fn assert_same_bits(single: &Single) {
        let turned = DAffine3::from_scale_rotation_translation(
            DVec3::new(1.5, -0.4, 1.0),
            DQuat::from_rotation_x(0.7),
            DVec3::new(0.2, 0.0, -0.5),
        );
        let rays = rays();
        for transform in [None, Some(Transform::new(turned).unwrap())] {
            let own = single.bounds();
            let bounds = transform.as_ref().map_or(own, |t| t.bounds_to_world(&own));
            let to_object = transform.as_ref().map(Transform::ray_to_object);
            let padding = Padding { factor: 4.0, ..Padding::of_bounds(&bounds) };
            let place = Place { to_object: to_object.as_ref(), bounds, padding, object: 9 };
            for left_out in 0..3 {
                compare(single, &place, &rays, left_out);
            }
        }
    }

    fn compare(single: &Single, place: &Place<'_>, rays: &[Ray], left_out: u32) {
        // All but every eleventh, in an order of their own.
        let which: Vec<_> =
            (0..rays.len() as u32).rev().filter(|ray| ray % 11 != left_out).collect();
        let mut best: Vec<_> = rays.iter().map(|ray| Hit::none_before(ray.t_max)).collect();
        let mut blocked = vec![false; rays.len()];
        single.ask(place, rays, &which, &mut best);
        single.ask(place, rays, &which, &mut blocked);
        let mut hits = 0;
        for (place_in_slice, ray) in rays.iter().enumerate() {
            let asked = which.contains(&(place_in_slice as u32));
            let alone = single.closest(place, ray, &BoxRay::new(ray, place.padding));
            let expected = alone.filter(|_| asked);
            let found = best[place_in_slice];
            assert!(
                found.same_bits(&expected.unwrap_or(Hit::none_before(ray.t_max))),
                "{single:?}: {ray:?} {found:?} {expected:?}"
            );
            assert_eq!(blocked[place_in_slice], expected.is_some());
            hits += usize::from(expected.is_some());
        }
        assert!(hits > 200, "{single:?}: only {hits} hits");
    }
}
