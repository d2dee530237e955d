//! Rays of each class in a scene, as a renderer would send them.

use glam::Vec3;
use srt::accel::{Answers, Scratch, Tracer};
use srt::math::{Hit, Random, Ray};
use srt::scene::Scene;

/// The rays of a class. Shadow rays ask whether anything is hit, all others what is hit first.
pub(crate) struct RaySet {
    pub(crate) class: &'static str,
    pub(crate) rays: Vec<Ray>,
}

impl RaySet {
    pub(crate) fn is_shadow(&self) -> bool {
        self.class == "shadow"
    }
}

/// View rays on a grid of about `count` pixels, and from what they hit: shadow rays to a point
/// light, mirror rays, and diffuse rays in random directions about the normal.
pub(crate) fn ray_sets(scene: &Scene, tracer: &dyn Tracer, light: Vec3, count: u32) -> Vec<RaySet> {
    let side = count.isqrt();
    let camera = scene.camera.resized(side, side);
    let pixel = |i: u32| camera.ray(f64::from(i % side), f64::from(i / side));
    let view: Vec<Ray> = (0..side * side).map(pixel).collect();
    let mut hits = vec![Hit::MISS; view.len()];
    tracer.trace(&view, Answers::ClosestHit(&mut hits), &mut Scratch::default(), None);
    let mut random = Random::new(&[1]);
    let (mut shadow, mut mirror, mut diffuse) = (vec![], vec![], vec![]);
    for (ray, hit) in view.iter().zip(&hits).filter(|(_, hit)| hit.is_hit()) {
        let surface = scene.surface(ray, hit);
        let (origin, normal) = (surface.origin_outside(), surface.geometric_normal);
        let end = 1.0f32.next_down();
        shadow.push(Ray::with_interval(origin, light - origin, 0.0, end));
        mirror.push(Ray::new(origin, ray.dir - 2.0 * ray.dir.dot(normal) * normal));
        diffuse.push(Ray::new(origin, about(normal, &mut random)));
    }
    [("view", view), ("shadow", shadow), ("mirror", mirror), ("diffuse", diffuse)]
        .map(|(class, rays)| RaySet { class, rays })
        .into()
}

/// A direction about a unit normal, with a density proportional to its cosine: the normal plus a
/// point of the unit sphere.
fn about(normal: Vec3, random: &mut Random) -> Vec3 {
    let [u, v] = random.next_pair();
    let (z, angle) = (1.0 - 2.0 * u, std::f32::consts::TAU * v);
    let r = (1.0 - z * z).sqrt();
    (normal + Vec3::new(r * angle.cos(), r * angle.sin(), z)).normalize_or(normal)
}
