//! Many rays against one shape, sixteen at a time.
//!
//! Every lane does what `single.rs` does for one ray, with the same operations in the same order:
//! what is divided, compared and told is the same to the bit.

use crate::math::{Hit, Ray};
use crate::simd::{Kernel, LANES, Lanes, Mask, Row, Simd, dispatch, ones, splat3};

use super::ball::Approach;
use super::cylinder::approach_column;
use super::place::SoFar;
use super::ray_group::Group;
use super::triangle::scaled_hit;
use super::{Ball, Place, Single, Triangle};

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
            let found = match single {
                Single::Ball(ball) => of_ball::<S>(ball, &group),
                Single::Cylinder => of_cylinder::<S>(&group),
                Single::Triangle(triangle) => of_triangle::<S>(triangle, &group),
            };
            found.note(place.object, places, answers);
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

#[inline(always)]
fn of_triangle<S: Simd>(triangle: &Triangle, group: &Group<S>) -> Found<S::F16> {
    let zero = S::F16::splat(0.0);
    let hit = scaled_hit(
        group.origin,
        group.dir,
        splat3::<S::F16, _>(triangle.v0.to_array()),
        splat3::<S::F16, _>(triangle.e1.to_array()),
        splat3::<S::F16, _>(triangle.e2.to_array()),
    );
    let inside = zero.le(hit.u) & zero.le(hit.v) & (hit.u + hit.v).le(hit.det) & zero.le(hit.t);
    let t = hit.t / hit.det;
    let lanes = (inside & group.begin.le(t) & t.le(group.end)).bits();
    Found { t, u: hit.u / hit.det, v: hit.v / hit.det, lanes, part: [0; 2] }
}

#[inline(always)]
fn of_ball<S: Simd>(ball: &Ball, group: &Group<S>) -> Found<S::F16> {
    let center = splat3::<S::F16, _>(ball.center.to_array());
    let origin = group.origin;
    let to_center = [center[0] - origin[0], center[1] - origin[1], center[2] - origin[2]];
    let line = Approach::new(to_center, group.dir, S::F16::splat(ball.radius * ball.radius));
    let (enter, leave) = in_order::<S>(line.roots());
    let first = within::<S>(enter, group);
    let zero = S::F16::splat(0.0);
    let lanes = (first | within::<S>(leave, group)) & met::<S>(&line);
    Found { t: enter.select(first, leave), u: zero, v: zero, lanes, part: [0; 2] }
}

#[inline(always)]
fn of_cylinder<S: Simd>(group: &Group<S>) -> Found<S::F16> {
    let (zero, one) = (S::F16::splat(0.0), S::F16::splat(1.0));
    let (before, behind) = (S::F16::splat(f32::NEG_INFINITY), S::F16::splat(f32::INFINITY));
    // The column; for lines along the axis it is everywhere or nowhere.
    let line = approach_column(group.origin, group.dir, [zero, one]);
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
    let first = within::<S>(enter, group);
    let lanes = (first | within::<S>(leave, group)) & in_column & in_slab & enter.le(leave).bits();
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
fn within<S: Simd>(t: S::F16, group: &Group<S>) -> u32 {
    (group.begin.le(t) & t.le(group.end)).bits()
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
    use crate::math::{BoxRay, Padding, Random, Transform};
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
                let place = Place { to_object: to_object.as_ref(), bounds, padding, object: 9 };
                compare(single, &place, &rays, index);
            }
        }
    }

    fn compare(single: &Single, place: &Place<'_>, rays: &[Ray], index: usize) {
        // All but every eleventh, in an order of their own.
        let which: Vec<_> =
            (0..rays.len() as u32).rev().filter(|ray| ray % 11 != index as u32).collect();
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
