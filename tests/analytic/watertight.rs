//! No ray passes between two triangles that share an edge.
//!
//! The formula of Möller and Trumbore rounds each triangle's edge tests on its own, so a ray aimed
//! at an edge may be outside of both. Tests that give neighbours the same number with opposite
//! signs, as in Woop, Benthin, Wald: *Watertight Ray/Triangle Intersection*, JCGT 2(1), 2013, leave
//! no gap; until the formula is one of these, the test is not run unless asked for.

use std::f64::consts::TAU;

use glam::DMat3;
use srt::accel::BuildConfig;
use srt::math::{Hit, Random, Ray};
use srt::scene::{Form, Scene, structure_named};

use super::common::scene;
use super::view::View;

const RAYS: usize = 1_000_000;

/// A closed mesh about the origin, of radius 1, with edges of about a twelfth.
fn ball_of_triangles() -> Scene {
    let view = View {
        eye: glam::DVec3::ZERO,
        dir: glam::DVec3::Y,
        up: glam::DVec3::Z,
        fovy_degrees: 60.0,
        width: 1,
        height: 1,
    };
    scene(&format!("{}object_flat generate:icosphere:5000\n", view.commands()))
}

/// Rays through points of random edges, from `distance` away, outside of the mesh.
fn rays_through_edges(scene: &Scene, distance: f32) -> Vec<Ray> {
    let Form::Mesh { mesh, .. } = scene.objects[0].form else { panic!("not a mesh") };
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
    world.intersect(rays, &mut hits, None);
    let outside = |ray: &Ray, hit: &Hit| hit.is_hit() && !scene.surface(ray, hit).from_inside;
    rays.iter().zip(&hits).filter(|(ray, hit)| !outside(ray, hit)).count()
}

#[test]
#[ignore = "the edge tests of neighbouring triangles round on their own: one in eight gets through"]
fn no_ray_gets_through_an_edge() {
    let scene = ball_of_triangles();
    let through = [0.1, 1.0, 10.0, 100.0, 1000.0]
        .map(|distance| (distance, leaks(&scene, &rays_through_edges(&scene, distance))));
    assert!(through.iter().all(|&(_, leaks)| leaks == 0), "of {RAYS} from each: {through:?}");
}
