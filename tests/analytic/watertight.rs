//! How many rays pass between two triangles that share an edge.
//!
//! Some do. The formula of Möller and Trumbore rounds each triangle's edge tests on its own, so a
//! ray that comes within a rounding of an edge may be outside of both its triangles. That is a
//! choice: it is the quickest formula, and the one of the fast modes of other ray tracers. Tests
//! that give neighbours the same number with opposite signs, as in Woop, Benthin, Wald: *Watertight
//! Ray/Triangle Intersection*, JCGT 2(1), 2013, leave no gap and take longer. Here is what the
//! choice costs, so that it cannot grow unseen.

use std::f64::consts::TAU;

use glam::{DMat3, DVec3};
use srt::accel::{Answers, BuildConfig, Scratch};
use srt::description::Shape;
use srt::math::{Hit, Random, Ray};
use srt::scene::{Scene, structure_named};

use super::common::scene;
use super::view::View;

const RAYS: usize = 1_000_000;

/// A closed mesh about the origin, of radius 1.
fn ball_of_triangles(triangles: u32) -> Scene {
    let view = View {
        eye: DVec3::ZERO,
        dir: DVec3::Y,
        up: DVec3::Z,
        fovy_degrees: 60.0,
        width: 1,
        height: 1,
    };
    scene(&format!("{}object_flat generate:icosphere:{triangles}\n", view.commands()))
}

/// Rays through points of random edges, from `distance` away, outside of the mesh.
fn rays_through_edges(scene: &Scene, distance: f32) -> Vec<Ray> {
    let Shape::Mesh { mesh, .. } = scene.objects[0].shape else { panic!("not a mesh") };
    let mesh = &scene.meshes()[mesh];
    let mut random = Random::new(&[7]);
    let mut ray = || {
        let triangle = mesh.triangles[random.below(mesh.triangles.len() as u32) as usize];
        let corner = random.below(3) as usize;
        let [a, b] =
            [corner, (corner + 1) % 3].map(|c| mesh.positions[triangle[c] as usize].as_dvec3());
        let on_edge = a.lerp(b, f64::from(random.next_f32()));
        // Slanted by up to 60 degrees from the normal, about the normal anywhere.
        let [turn, slant] = random.next_pair().map(f64::from);
        let normal = on_edge.normalize();
        let across = DMat3::from_axis_angle(normal, TAU * turn) * normal.any_orthonormal_vector();
        let out = normal + 1.7 * slant * across;
        let origin = (on_edge + f64::from(distance) * out.normalize()).as_vec3();
        Ray::new(origin, (on_edge - origin.as_dvec3()).as_vec3())
    };
    (0..RAYS).map(|_| ray()).collect()
}

/// How many rays get past the near side.
fn leaks(scene: &Scene, rays: &[Ray]) -> usize {
    let bvh = structure_named("bvh").expect("bvh exists");
    let world = bvh.build(scene, &BuildConfig::default());
    let mut hits = vec![Hit::MISS; rays.len()];
    world.trace(rays, Answers::ClosestHit(&mut hits), &mut Scratch::default(), None);
    let outside = |ray: &Ray, hit: &Hit| hit.is_hit() && !scene.surface(ray, hit).from_inside;
    rays.iter().zip(&hits).filter(|(ray, hit)| !outside(ray, hit)).count()
}

/// Rays from random points at `distance` to random points of the disc that the ball is seen as.
fn random_rays(distance: f64) -> Vec<Ray> {
    let mut random = Random::new(&[11]);
    let mut ray = || {
        let [turn, height] = random.next_pair().map(f64::from);
        let z = 2.0 * height - 1.0;
        let around = (TAU * turn).sin_cos();
        let across = (1.0 - z * z).sqrt();
        let out = DVec3::new(across * around.1, across * around.0, z);
        let [turn, area] = random.next_pair().map(f64::from);
        let aside = DMat3::from_axis_angle(out, TAU * turn) * out.any_orthonormal_vector();
        // Not at the rim, where the ball of triangles is a little smaller than the ball.
        let target = 0.95 * area.sqrt() * aside;
        let origin = (distance * out).as_vec3();
        Ray::new(origin, (target - origin.as_dvec3()).as_vec3())
    };
    (0..RAYS).map(|_| ray()).collect()
}

#[test]
fn few_random_rays_get_through_edges() {
    let scene = ball_of_triangles(70_000);
    // Measured: 0, 3, 16, 184 and 2039. They grow with the distance, as the rounding of the edge
    // tests does; about three times as many are allowed, since other seeds give other numbers.
    for (distance, most) in [(0.1, 10), (1.0, 10), (10.0, 50), (100.0, 600), (1000.0, 6000)] {
        let through = leaks(&scene, &random_rays(1.0 + distance));
        assert!(through <= most, "from {distance}: {through} of {RAYS}, not {most} at most");
    }
}

#[test]
fn most_rays_aimed_at_the_very_edges_are_stopped() {
    // Measured: one in eight gets through, from near and far. Only rays that are made for it come
    // so close to an edge.
    let scene = ball_of_triangles(5_000);
    for distance in [0.1, 1.0, 10.0, 100.0, 1000.0] {
        let through = leaks(&scene, &rays_through_edges(&scene, distance));
        assert!(through < RAYS / 4, "from {distance}: {through} of {RAYS}");
    }
}
