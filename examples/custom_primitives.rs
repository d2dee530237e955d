//! Primitives of your own: strands of hair as capsules, which are segments with a radius. All
//! structures of the library find them, and their hits are compared with those of no structure.
//!
//! `cargo run --release --no-default-features --example custom_primitives`

#![allow(clippy::print_stdout, reason = "an example prints what it finds")]

use std::ops::Range;
use std::process::ExitCode;

use srt::accel::{
    Accel, AnyHit, Bounded, BoundingBall, BuildConfig, Bvh, Bvh8, ClosestHit, CompressedWideBvh,
    Exhaustive, Indexed, NoPacks, Primitives, Query,
};
use srt::counters::Counters;
use srt::glam::{DVec3, Vec3, Vec3A};
use srt::math::{Aabb, BoxRay, Hit, Padding, Random, Ray};

/// All points within a distance of a segment.
#[derive(Clone, Copy, Debug)]
struct Capsule {
    ends: [Vec3; 2],
    radius: f32,
}

impl Capsule {
    /// Where a ray enters and leaves. The capsule is convex and consists of two balls and the tube
    /// between them, so the ray is within it from the first entrance to the last exit of the three.
    fn crossing(&self, ray: &Ray) -> Option<(f64, f64)> {
        let [start, end] = self.ends.map(|end| ray.origin.as_dvec3() - end.as_dvec3());
        let (dir, radius) = (ray.dir.as_dvec3(), f64::from(self.radius));
        let parts = [
            within_radius(start, dir, radius),
            within_radius(end, dir, radius),
            within_tube(start, start - end, dir, radius),
        ];
        let join = |a: (f64, f64), b: (f64, f64)| (a.0.min(b.0), a.1.max(b.1));
        parts.into_iter().flatten().reduce(join)
    }

    /// The share of the way along the segment at which its point nearest to `point` is.
    fn share(&self, point: Vec3) -> f32 {
        let [start, end] = self.ends;
        let along = end - start;
        ((point - start).dot(along) / along.length_squared()).clamp(0.0, 1.0)
    }

    fn bounds(&self) -> Aabb {
        let [a, b] = self.ends.map(Vec3A::from);
        Aabb { min: a.min(b) - self.radius, max: a.max(b) + self.radius }
    }
}

/// The interval of `t` in which `|from + t·dir|` is at most a radius.
fn within_radius(from: DVec3, dir: DVec3, radius: f64) -> Option<(f64, f64)> {
    let (a, b, c) = (dir.dot(dir), from.dot(dir), from.dot(from) - radius * radius);
    let root = (b * b - a * c).sqrt();
    // The root of a negative number is NaN, and so is a division by the square of no direction.
    let interval = ((-b - root) / a, (-b + root) / a);
    (interval.0 <= interval.1).then_some(interval)
}

/// The interval within a tube around a segment that starts at the origin of `from`.
fn within_tube(from: DVec3, segment: DVec3, dir: DVec3, radius: f64) -> Option<(f64, f64)> {
    let axis = segment.normalize_or_zero();
    let across = |v: DVec3| v - v.dot(axis) * axis;
    let (near, far) = within_radius(across(from), across(dir), radius)?;
    let at = |height: f64| (height - from.dot(axis)) / dir.dot(axis);
    let (bottom, top) = (at(0.0), at(segment.length()));
    let interval = (near.max(bottom.min(top)), far.min(bottom.max(top)));
    (interval.0 <= interval.1).then_some(interval)
}

/// Capsules in slot order, each with its id.
#[derive(Clone, Debug)]
struct Hair {
    capsules: Vec<(Capsule, u32)>,
    mean_point: Vec3A,
    padding: Padding,
}

impl Hair {
    fn new(capsules: &[Capsule]) -> Self {
        let ends = || capsules.iter().flat_map(|capsule| capsule.ends);
        let mean_point = ends().map(Vec3A::from).sum::<Vec3A>() / ends().count().max(1) as f32;
        let bounds = capsules.iter().map(Capsule::bounds).fold(Aabb::EMPTY, Aabb::union);
        let capsules = capsules.iter().copied().zip(0..).collect();
        Self { capsules, mean_point, padding: Padding::of_bounds(&bounds) }
    }

    /// The hit of one capsule, if a ray has one: the first of entrance and exit that lies in the
    /// ray's interval and in the interval of the capsule's own box. This is all that a structure
    /// needs of a formula, and it must not depend on what the ray has found before.
    fn hit(&self, slot: u32, ray: &Ray, box_ray: &BoxRay) -> Option<Hit> {
        let (capsule, id) = &self.capsules[slot as usize];
        let (enter, leave) = capsule.crossing(ray)?;
        let counts =
            |&t: &f32| ray.t_min <= t && t <= ray.end() && box_ray.accepts(&capsule.bounds(), t);
        let t = [enter as f32, leave as f32].into_iter().find(counts)?;
        Some(Hit { t, object: 0, prim: *id, u: capsule.share(ray.at(t)), v: 0.0 })
    }
}

impl Bounded for Hair {
    fn count(&self) -> u32 {
        self.capsules.len() as u32
    }

    fn bounds(&self, slot: u32) -> Aabb {
        self.capsules[slot as usize].0.bounds()
    }

    fn mean_point(&self) -> Vec3A {
        self.mean_point
    }
}

impl Primitives for Hair {
    type Packs = NoPacks;

    fn packs(&self) -> &NoPacks {
        &NoPacks
    }

    fn padding(&self) -> Padding {
        self.padding
    }

    fn reorder(&mut self, order: &[u32]) {
        self.capsules = order.iter().map(|&from| self.capsules[from as usize]).collect();
    }

    fn test<Q: Query, C: Counters>(
        &self,
        query: &Q,
        slots: Range<u32>,
        ray: &Ray,
        box_ray: &BoxRay,
        answer: &mut Q::Answer,
        counters: &mut C,
    ) {
        counters.primitives(slots.len() as u32);
        for hit in slots.filter_map(|slot| self.hit(slot, ray, box_ray)) {
            // What lies behind the end of the search is not wanted; once it is over, nothing is.
            let accepted = !Q::FILTERS || query.accepts(ray, &hit);
            if accepted && hit.t <= query.end(ray, answer) {
                query.record(answer, &hit);
            }
        }
    }
}

/// Strands of eight segments that grow out of a ball of radius 1 and bend down.
fn strands(count: u64) -> Vec<Capsule> {
    let strand = |number: u64| {
        let mut random = Random::new(&[number]);
        let mut point = random_unit(&mut random);
        let mut dir = point;
        (0..8).map(move |_| {
            let start = point;
            dir = (dir + Vec3::new(0.0, 0.0, -0.25) + 0.2 * random_unit(&mut random)).normalize();
            point += 0.08 * dir;
            Capsule { ends: [start, point], radius: 0.006 }
        })
    };
    (0..count).flat_map(strand).collect()
}

/// A random direction. Those to the corners of a cube are more frequent.
fn random_unit(random: &mut Random) -> Vec3 {
    Vec3::from_array([(); 3].map(|()| 2.0 * random.next_f32() - 1.0)).normalize_or(Vec3::Z)
}

/// Rays at the hair: from all around, from within, along an axis, and cut to parts.
fn rays(count: u64) -> Vec<Ray> {
    let ray = |number: u64| {
        let mut random = Random::new(&[7, number]);
        let (from, to) = (random_unit(&mut random), random_unit(&mut random));
        match number % 4 {
            0 => Ray::new(4.0 * from, to - 4.0 * from),
            1 => Ray::new(1.1 * from, to),
            2 => Ray::new(Vec3::new(1.5 * from.x, 1.5 * from.y, 3.0), Vec3::NEG_Z),
            _ => Ray::with_interval(3.0 * from, 1.2 * to - 3.0 * from, 0.5, 0.5 + to.x.abs()),
        }
    };
    (0..count).map(ray).collect()
}

/// The hits of some rays, and whether each hits anything.
type Found = (Vec<Hit>, Vec<bool>);

fn trace<A: Accel>(hair: &[Capsule], rays: &[Ray]) -> Found {
    let index: Indexed<Hair, A> = Indexed::build(Hair::new(hair), &BuildConfig::default());
    let mut found = (vec![Hit::MISS; rays.len()], vec![false; rays.len()]);
    index.answer(&ClosestHit, rays, &mut found.0);
    index.answer(&AnyHit, rays, &mut found.1);
    found
}

/// How many rays have other hits, by a bit, or are blocked otherwise.
fn differences(a: &Found, b: &Found) -> usize {
    let hits = a.0.iter().zip(&b.0).map(|(a, b)| !a.same_bits(b));
    let blocked = a.1.iter().zip(&b.1).map(|(a, b)| a != b);
    hits.zip(blocked).filter(|&(hit, blocked)| hit || blocked).count()
}

/// Every structure with how many rays it answers otherwise than none at all.
fn compare(hair: &[Capsule], rays: &[Ray]) -> (Found, [(&'static str, usize); 4]) {
    let expected = trace::<Exhaustive>(hair, rays);
    let compared = [
        ("ball", differences(&expected, &trace::<BoundingBall>(hair, rays))),
        ("bvh", differences(&expected, &trace::<Bvh>(hair, rays))),
        ("cwbvh", differences(&expected, &trace::<CompressedWideBvh>(hair, rays))),
        ("bvh8", differences(&expected, &trace::<Bvh8>(hair, rays))),
    ];
    (expected, compared)
}

fn main() -> ExitCode {
    let (hair, rays) = (strands(500), rays(10_000));
    let (expected, compared) = compare(&hair, &rays);
    let hits = expected.0.iter().filter(|hit| hit.is_hit()).count();
    println!("{} segments, {} rays, {hits} of them hit", hair.len(), rays.len());
    for (name, differing) in compared {
        println!("{name:>6}: {differing} differ");
    }
    match compared.iter().all(|&(_, differing)| differing == 0) {
        true => ExitCode::SUCCESS,
        false => ExitCode::FAILURE,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_structures_find_the_same_hits() {
        let (hair, rays) = (strands(200), rays(2_000));
        let (expected, compared) = compare(&hair, &rays);
        let hits = expected.0.iter().filter(|hit| hit.is_hit()).count();
        assert!((200..1_800).contains(&hits), "{hits} hits");
        assert_eq!(compared.map(|(_, differing)| differing), [0; 4]);
        for (hit, &blocked) in expected.0.iter().zip(&expected.1) {
            assert_eq!(hit.is_hit(), blocked);
        }
    }

    #[test]
    fn a_ray_meets_the_tube_and_the_caps() {
        let capsule = Capsule { ends: [Vec3::ZERO, 4.0 * Vec3::X], radius: 1.0 };
        let crossing = |origin: Vec3, dir: Vec3| capsule.crossing(&Ray::new(origin, dir));
        assert_eq!(crossing(Vec3::new(2.0, 0.0, 5.0), Vec3::NEG_Z), Some((4.0, 6.0)));
        assert_eq!(crossing(Vec3::new(-3.0, 0.0, 0.0), Vec3::X), Some((2.0, 8.0)));
        assert_eq!(
            crossing(Vec3::new(4.5, 0.0, 5.0), Vec3::NEG_Z).map(|(t, _)| t > 4.0),
            Some(true)
        );
        assert_eq!(crossing(Vec3::new(5.1, 0.0, 5.0), Vec3::NEG_Z), None);
        assert_eq!(capsule.share(Vec3::new(1.0, 1.0, 0.0)), 0.25);
    }
}
