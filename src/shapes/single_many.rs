//! Many rays against one shape, sixteen at a time.
//!
//! Every lane does what `single.rs` does for one ray, with the same operations in the same order:
//! what is divided, compared and returned is the same to the bit.

use crate::accel::{Query, Search};
use crate::math::{BoxRay, Hit, Lanes, Mask as _, Ray, ones, within};
use crate::simd::{Kernel, LANES, Row, Simd, dispatch, splat3};

use super::ball::Approach;
use super::cylinder::approach_column;
use super::ray_group::RayGroup;
use super::triangle::scaled_hit;
use super::{Ball, Instance, Single, Triangle};

impl Single {
    /// [`test`](Self::test) for some of a slice of rays. `which` has their places in both slices.
    pub fn test_many<Q: Query>(
        &self,
        query: &Q,
        instance: &Instance<'_>,
        (rays, which): (&[Ray], &[u32]),
        answers: &mut [Q::Answer],
    ) {
        if const { Q::FILTERS || matches!(Q::SEARCH, Search::All) } {
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
            if group.begin.le(group.end).bits() == 0 {
                continue;
            }
            group.enter_own_space(instance);
            let found = match single {
                Single::Ball(ball) => of_ball::<S>(ball, &group),
                Single::Cylinder => of_cylinder::<S>(&group),
                Single::Triangle(triangle) => of_triangle::<S>(triangle, &group),
            };
            found.record(query, instance.object, places, answers);
        }
    }
}

/// Where rays first hit.
struct Found<R> {
    t: R,
    u: R,
    v: R,
    /// A bit for each ray that hits.
    lanes: u32,
    /// The two bits of the part that each of them hits.
    part: [u32; 2],
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

#[inline(always)]
fn of_triangle<S: Simd>(triangle: &Triangle, group: &RayGroup<S>) -> Found<S::F16> {
    let zero = S::F16::splat(0.0);
    let hit = scaled_hit(
        group.origin,
        group.dir,
        splat3(triangle.v0.to_array()),
        splat3(triangle.e1.to_array()),
        splat3(triangle.e2.to_array()),
    );
    let inside = hit.inside() & zero.le(hit.t);
    let t = hit.t / hit.det;
    let lanes = (inside & within(t, [group.begin, group.end])).bits();
    Found { t, u: hit.u / hit.det, v: hit.v / hit.det, lanes, part: [0; 2] }
}

#[inline(always)]
fn of_ball<S: Simd>(ball: &Ball, group: &RayGroup<S>) -> Found<S::F16> {
    let center: [S::F16; 3] = splat3(ball.center.to_array());
    let origin = group.origin;
    let to_center = [center[0] - origin[0], center[1] - origin[1], center[2] - origin[2]];
    let line = Approach::new(to_center, group.dir, S::F16::splat(ball.radius * ball.radius));
    let (enter, leave) = in_order::<S>(line.roots());
    let first = counts::<S>(enter, group);
    let zero = S::F16::splat(0.0);
    let lanes = (first | counts::<S>(leave, group)) & met::<S>(&line);
    Found { t: enter.select(first, leave), u: zero, v: zero, lanes, part: [0; 2] }
}

#[inline(always)]
fn of_cylinder<S: Simd>(group: &RayGroup<S>) -> Found<S::F16> {
    let (zero, one) = (S::F16::splat(0.0), S::F16::splat(1.0));
    let (before, behind) = (S::F16::splat(f32::NEG_INFINITY), S::F16::splat(f32::INFINITY));
    // The column; for lines along the axis it is everywhere or nowhere.
    let line = approach_column(group.origin, group.dir);
    let (column_in, column_out) = in_order::<S>(line.roots());
    let along = line.a.le(zero).bits();
    let column_in = before.select(along, column_in);
    let column_out = behind.select(along, column_out);
    let in_column = (met::<S>(&line) & !along) | (line.c.le(zero).bits() & along);
    // The slab between the caps; for lines across it is everywhere or nowhere.
    let (z, dz) = (group.origin[2], group.dir[2]);
    let (bottom, top) = ((zero - z) / dz, (one - z) / dz);
    let across = dz.abs().le(zero).bits();
    let down = dz.le(zero).bits();
    let slab_in = before.select(across, top.select(down, bottom));
    let slab_out = behind.select(across, bottom.select(down, top));
    let in_slab = !across | (zero.le(z) & z.le(one)).bits();
    // The solid is where both are.
    let side_in = slab_in.le(column_in).bits();
    let side_out = column_out.le(slab_out).bits();
    let enter = column_in.select(side_in, slab_in);
    let leave = column_out.select(side_out, slab_out);
    let first = counts::<S>(enter, group);
    let lanes = (first | counts::<S>(leave, group)) & in_column & in_slab & enter.le(leave).bits();
    // Upwards a line enters by the bottom and leaves by the top.
    let cap = (first & !side_in) | (!first & !side_out);
    let at_bottom = cap & (first ^ down);
    Found {
        t: enter.select(first, leave),
        u: zero,
        v: zero,
        lanes,
        part: [at_bottom, cap & !at_bottom],
    }
}

/// Two parameters, the smaller one first.
#[inline(always)]
fn in_order<S: Simd>((t0, t1): (S::F16, S::F16)) -> (S::F16, S::F16) {
    let ordered = t0.le(t1).bits();
    (t0.select(ordered, t1), t1.select(ordered, t0))
}

/// Which parameters count.
#[inline(always)]
fn counts<S: Simd>(t: S::F16, group: &RayGroup<S>) -> u32 {
    within(t, [group.begin, group.end]).bits()
}

/// Which lines meet the ball, not all of it behind their origin: [`Approach::roots_if_met`].
#[inline(always)]
fn met<S: Simd>(line: &Approach<S::F16>) -> u32 {
    let zero = S::F16::splat(0.0);
    let ahead = line.c.le(zero).bits() | zero.le(line.b).bits();
    ahead & zero.le(line.discriminant).bits()
}

#[cfg(test)]
mod tests {
    use glam::{DAffine3, DQuat, DVec3, Vec3};

    use super::*;
    use crate::accel::{AnyHit, ClosestHit};
    use crate::math::{Padding, Random, Transform};
    use crate::shapes::Cylinder;

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

    #[test]
    fn many_rays_find_what_each_of_them_finds() {
        let shapes = [
            Single::Ball(Ball { center: Vec3::new(0.1, -0.2, 0.3), radius: 0.9 }),
            Single::Cylinder,
            Single::Triangle(Triangle::new([
                Vec3::new(-2.0, -1.0, 0.0),
                Vec3::X,
                Vec3::splat(1.5),
            ])),
        ];
        let turned = DAffine3::from_scale_rotation_translation(
            DVec3::new(1.5, -0.4, 1.0),
            DQuat::from_rotation_x(0.7),
            DVec3::new(0.2, 0.0, -0.5),
        );
        let rays = rays();
        for (index, single) in shapes.iter().enumerate() {
            for transform in [None, Some(Transform::new(turned).unwrap())] {
                let own = match single {
                    Single::Ball(ball) => ball.bounds(),
                    Single::Cylinder => Cylinder::bounds(),
                    Single::Triangle(triangle) => triangle.bounds(),
                };
                let bounds = transform.as_ref().map_or(own, |t| t.bounds_to_world(&own));
                let to_object = transform.as_ref().map(Transform::ray_to_object);
                let padding = Padding { factor: 4.0, ..Padding::of_bounds(&bounds) };
                let instance =
                    Instance { to_object: to_object.as_ref(), bounds, padding, object: 9 };
                compare(single, &instance, &rays, index);
            }
        }
    }

    fn compare(single: &Single, instance: &Instance<'_>, rays: &[Ray], index: usize) {
        // All but every eleventh, in an order of their own.
        let which: Vec<_> =
            (0..rays.len() as u32).rev().filter(|ray| ray % 11 != index as u32).collect();
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
