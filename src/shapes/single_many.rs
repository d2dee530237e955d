//! Many rays against one shape, sixteen at a time.
//!
//! Every lane does what `single.rs` does for one ray, with the same operations in the same order:
//! what is divided, compared and returned is the same to the bit.

use crate::accel::{Query, Search};
use crate::math::{BoxRay, Hit, Ray, ones};
use crate::simd::{Kernel, LANES, Row, Simd, dispatch};

use super::ray_group::RayGroup;
use super::single_shape::{Found, SingleShape as _};
use super::{Instance, Single};

impl Single {
    /// [`test`](Self::test) for some of a slice of rays. `which` has their places in both slices.
    pub fn test_many<Q: Query>(
        &self,
        query: &Q,
        instance: &Instance<'_>,
        (rays, which): (&[Ray], &[u32]),
        answers: &mut [Q::Answer],
    ) {
        if const { Q::FILTERS || !Q::KEEPS_ONE_HIT || matches!(Q::SEARCH, Search::All) } {
            // Not only where a ray hits first may be of interest.
            for &place in which {
                let (ray, answer) = (&rays[place as usize], &mut answers[place as usize]);
                self.test(query, instance, ray, &BoxRay::new(ray, instance.padding), answer);
            }
        } else {
            dispatch(Many { single: self, query, instance, rays, which, answers });
        }
    }
}

struct Many<'a, Q: Query> {
    single: &'a Single,
    query: &'a Q,
    instance: &'a Instance<'a>,
    rays: &'a [Ray],
    which: &'a [u32],
    answers: &'a mut [Q::Answer],
}

impl<Q: Query> Kernel for Many<'_, Q> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let Self { single, query, instance, rays, which, answers } = self;
        let mut records = [[0.0; 8]; LANES];
        for places in which.chunks(LANES) {
            let mut group =
                RayGroup::<S>::load(instance, query, (rays, places), answers, &mut records);
            if group.meets() == 0 {
                continue;
            }
            group.enter_own_space(instance);
            let found = for_shape!(single, shape => shape.first_hits(&group));
            found.record(query, instance.object, places, answers);
        }
    }
}

impl<R: Row<LANES>> Found<R> {
    #[inline(always)]
    fn record<Q: Query>(&self, query: &Q, object: u32, group: &[u32], answers: &mut [Q::Answer]) {
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
            query.record(&mut answers[group[lane] as usize], &hit);
        }
    }
}

#[cfg(test)]
pub(super) mod tests {
    use glam::{DAffine3, DQuat, DVec3, Vec3};

    use super::*;
    use crate::accel::{AnyHit, ClosestHit};
    use crate::math::{Padding, Random, Transform};

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
            let instance = Instance { to_object: to_object.as_ref(), bounds, padding, object: 9 };
            for left_out in 0..3 {
                compare(single, &instance, &rays, left_out);
            }
        }
    }

    fn compare(single: &Single, instance: &Instance<'_>, rays: &[Ray], left_out: u32) {
        // All but every eleventh, in an order of their own.
        let which: Vec<_> =
            (0..rays.len() as u32).rev().filter(|ray| ray % 11 != left_out).collect();
        let mut best: Vec<_> = rays.iter().map(|ray| Hit::none_before(ray.t_max)).collect();
        let mut blocked = vec![false; rays.len()];
        single.test_many(&ClosestHit, instance, (rays, &which), &mut best);
        single.test_many(&AnyHit, instance, (rays, &which), &mut blocked);
        let mut hits = 0;
        for (place_in_slice, ray) in rays.iter().enumerate() {
            let tested = which.contains(&(place_in_slice as u32));
            let mut expected = Hit::none_before(ray.t_max);
            if tested {
                let box_ray = BoxRay::new(ray, instance.padding);
                single.test(&ClosestHit, instance, ray, &box_ray, &mut expected);
            }
            let found = best[place_in_slice];
            assert!(found.same_bits(&expected), "{single:?}: {ray:?} {found:?} {expected:?}");
            assert_eq!(blocked[place_in_slice], expected.is_hit());
            hits += usize::from(expected.is_hit());
        }
        assert!(hits > 200, "{single:?}: only {hits} hits");
    }
}
