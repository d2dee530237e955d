//! No ray passes between two triangles that share an edge or a corner.
//!
//! Rays begin within closed meshes, where each of them hits something, or far outside and go where a
//! convex mesh faces them. They are aimed at the very edges and corners of triangles, and between them.
//! The proof is in `src/shapes/triangle.rs`.

use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::atomic::{AtomicUsize, Ordering};

use glam::{DMat3, DVec3, Vec3};
use rayon::prelude::*;
use srt::accel::{Accel, AnyHit, Bvh, Bvh8, CompressedWideBvh, Exhaustive, Indexed};
use srt::assets::generate::{MeshKind, generate};
use srt::math::{Random, Ray};
use srt::shapes::TriangleSet;

/// A closed mesh and points within it.
struct Closed {
    name: &'static str,
    positions: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    inside: Vec<DVec3>,
}

/// Sizes, and where meshes of size 1 are moved to.
const PLACES: [(f64, f64); 5] = [(1.0, 0.0), (1e-6, 0.0), (1e6, 0.0), (1.0, 100.0), (1e-3, 3.0)];

impl Closed {
    fn generated(name: &'static str, kind: MeshKind, triangles: u32) -> Self {
        let mesh = generate(kind, triangles, 1);
        let positions = mesh.positions.iter().map(|p| p.as_dvec3()).collect();
        let mut closed = Self { name, positions, triangles: mesh.triangles, inside: Vec::new() };
        closed.fill();
        closed
    }

    /// Boxes at random that reach into each other, turned at random.
    fn boxes() -> Self {
        let mut random = Random::new(&[3]);
        let (mut positions, mut triangles, mut inside) = (Vec::new(), Vec::new(), Vec::new());
        for _ in 0..60 {
            let mut number = || f64::from(random.next_f32());
            let axis = DVec3::new(number() - 0.5, number() - 0.5, number() - 0.5).normalize();
            let turn = DMat3::from_axis_angle(axis, TAU * number());
            let size = DVec3::new(number(), number(), number()) + 0.02;
            let center = 2.0 * DVec3::new(number(), number(), number());
            let first = positions.len() as u32;
            for corner in 0..8 {
                let side = |axis: u32| f64::from(corner >> axis & 1) - 0.5;
                positions.push(center + turn * (size * DVec3::new(side(0), side(1), side(2))));
            }
            for (axis, across, along) in [(1, 2, 4), (2, 4, 1), (4, 1, 2)] {
                for side in [0, axis] {
                    let [a, b] = [first + side, first + side + across];
                    let [c, d] = [b + along, a + along];
                    triangles.extend([[a, b, c], [a, c, d]]);
                }
            }
            inside.push(center);
        }
        Self { name: "boxes", positions, triangles, inside }
    }

    /// Finds points within, by the solid angle of all triangles.
    fn fill(&mut self) {
        let low = self.positions.iter().copied().reduce(DVec3::min).expect("not empty");
        let high = self.positions.iter().copied().reduce(DVec3::max).expect("not empty");
        let mut random = Random::new(&[5]);
        while self.inside.len() < 100 {
            let mut number = || f64::from(random.next_f32());
            let point = low + (high - low) * DVec3::new(number(), number(), number());
            let angles = self.triangles.par_iter().map(|&triangle| {
                let [a, b, c] = triangle.map(|corner| self.positions[corner as usize] - point);
                let [la, lb, lc] = [a.length(), b.length(), c.length()];
                // Van Oosterom, Strackee: The Solid Angle of a Plane Triangle, 1983.
                let below = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
                2.0 * a.dot(b.cross(c)).atan2(below)
            });
            // All of the sphere, seen from within; nothing of it from outside.
            if angles.sum::<f64>().abs() > TAU {
                self.inside.push(point);
            }
        }
    }

    /// The mesh of another size, moved along (1, −1, 1).
    fn placed(&self, (scale, offset): (f64, f64)) -> (Vec<Vec3>, impl Fn(DVec3) -> Vec3 + Sync) {
        let place = move |p: DVec3| (scale * (p + offset * DVec3::new(1.0, -1.0, 1.0))).as_vec3();
        (self.positions.iter().map(|&p| place(p)).collect(), place)
    }
}

/// A point of a triangle: of its inside, an edge or a corner, by turns.
fn target(corners: [Vec3; 3], number: u64, random: &mut Random) -> DVec3 {
    let [a, b, c] = corners.map(|corner| corner.as_dvec3());
    let [s, t] = random.next_pair().map(f64::from);
    match number % 4 {
        0 => a + s * (b - a) + (1.0 - s) * t * (c - a),
        1 | 2 => a.lerp(b, if number % 8 == 1 { 0.5 } else { s }),
        _ => a,
    }
}

/// How many of `count` rays hit nothing. `ray` makes one of them from its number.
fn leaks<A: Accel>(
    mesh: &Indexed<TriangleSet, A>,
    count: u64,
    ray: impl Fn(u64, &mut Random) -> Ray + Sync,
) -> usize {
    const AT_ONCE: u64 = 1 << 14;
    let leaks = AtomicUsize::new(0);
    (0..count.div_ceil(AT_ONCE)).into_par_iter().for_each(|part| {
        let mut random = Random::new(&[part]);
        let numbers = part * AT_ONCE..count.min((part + 1) * AT_ONCE);
        let rays: Vec<_> = numbers.map(|number| ray(number, &mut random)).collect();
        let mut hit = vec![false; rays.len()];
        mesh.answer(&AnyHit, &rays, &mut hit);
        leaks.fetch_add(hit.iter().filter(|&&hit| !hit).count(), Ordering::Relaxed);
    });
    leaks.into_inner()
}

fn leaks_from_inside<A: Accel>(closed: &Closed, place: (f64, f64), rays: u64) -> usize {
    let (positions, to_place) = closed.placed(place);
    let set = TriangleSet::new(&positions, &closed.triangles);
    let mesh = Indexed::<_, A>::build(set, &Default::default());
    leaks(&mesh, rays, |number, random| {
        let inside = closed.inside[random.below(closed.inside.len() as u32) as usize];
        let origin = to_place(inside);
        let triangle = closed.triangles[random.below(closed.triangles.len() as u32) as usize];
        let corners = triangle.map(|corner| positions[corner as usize]);
        let to = target(corners, number, random);
        Ray::new(origin, (to - origin.as_dvec3()).as_vec3())
    })
}

/// Rays at a ball about the origin, from `distance` outside of it.
fn leaks_from_outside(distance: f64, rays: u64) -> usize {
    let ball = generate(MeshKind::Icosphere, 5000, 1);
    let set = TriangleSet::new(&ball.positions, &ball.triangles);
    let mesh = Indexed::<_, Bvh8>::build(set, &Default::default());
    leaks(&mesh, rays, |number, random| {
        let triangle = ball.triangles[random.below(ball.triangles.len() as u32) as usize];
        let to = target(triangle.map(|corner| ball.positions[corner as usize]), number, random);
        // Slanted by up to 60 degrees from the normal, about the normal anywhere.
        let [turn, slant] = random.next_pair().map(f64::from);
        let normal = to.normalize();
        let across = DMat3::from_axis_angle(normal, TAU * turn) * normal.any_orthonormal_vector();
        let out = normal + (slant * FRAC_PI_2 / 1.5).tan() * across;
        let origin = (to + distance * out.normalize()).as_vec3();
        let dir = to - origin.as_dvec3();
        // It ends in the middle of the ball: the far side does not stop it.
        let middle = distance + 0.5;
        Ray { t_max: (middle / distance) as f32, ..Ray::new(origin, dir.as_vec3()) }
    })
}

/// All meshes in all places, with so many rays each; with the brute force, a thousandth of them.
fn assert_closed(rays: u64) {
    let meshes = [
        Closed::generated("ball", MeshKind::Icosphere, 5000),
        Closed::generated("torus knot", MeshKind::TorusKnot, 20_000),
        Closed::boxes(),
    ];
    for closed in &meshes {
        for place in PLACES {
            let through = [
                leaks_from_inside::<Bvh8>(closed, place, rays),
                leaks_from_inside::<Bvh>(closed, place, rays / 10),
                leaks_from_inside::<CompressedWideBvh>(closed, place, rays / 10),
                leaks_from_inside::<Exhaustive>(closed, place, rays / 1000),
            ];
            assert_eq!(through, [0; 4], "{} at {place:?}", closed.name);
        }
    }
    for distance in [0.1, 1.0, 10.0, 100.0, 1000.0] {
        assert_eq!(leaks_from_outside(distance, rays), 0, "from {distance}");
    }
}

#[test]
fn no_ray_gets_through() {
    assert_closed(200_000);
}

/// `cargo test --release --test analytic -- --ignored hundred`: a step of `.ci/run`.
#[test]
#[ignore = "takes ten seconds, and minutes without optimization"]
fn no_ray_of_a_hundred_million_gets_through() {
    assert_closed(5_000_000);
}
