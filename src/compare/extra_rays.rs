//! Rays that the renderer does not send: the first bounce of diffuse light, and random ones.

use glam::Vec3;

use crate::accel::{Answers, Scratch, Tracer};
use crate::math::{Hit, Random, Ray};
use crate::record::RayClass;
use crate::scene::Scene;

use super::record_rays::{Query, RaySet};

/// Keeps the streams of random numbers apart.
const DIFFUSE_STREAM: u64 = 0x6469_6666;
const RANDOM_STREAM: u64 = 0x7261_6e64;

/// From what view rays hit, a ray each in a random direction about the normal.
pub(super) fn diffuse(scene: &Scene, tracer: &dyn Tracer, view: &[Ray], seed: u64) -> RaySet {
    let mut hits = vec![Hit::MISS; view.len()];
    tracer.trace(view, Answers::ClosestHit(&mut hits), &mut Scratch::default(), None);
    let mut random = Random::new(&[seed, DIFFUSE_STREAM]);
    let bounce = |(ray, hit): (&Ray, &Hit)| {
        let surface = scene.surface(ray, hit);
        Ray::new(surface.origin_outside(), about(surface.normal, &mut random))
    };
    let hit = view.iter().zip(&hits).filter(|(_, hit)| hit.is_hit());
    RaySet { class: RayClass::Diffuse, query: Query::Closest, rays: hit.map(bounce).collect() }
}

/// From random points of the scene's box in random directions, both uniform.
pub(super) fn random(scene: &Scene, count: usize, seed: u64) -> RaySet {
    let bounds = scene.bounds();
    let mut random = Random::new(&[seed, RANDOM_STREAM]);
    let mut ray = || {
        let place = Vec3::from_array(std::array::from_fn(|_| random.next_f32()));
        let origin = Vec3::from(bounds.min) + place * Vec3::from(bounds.size());
        Ray::new(origin, on_sphere(&mut random))
    };
    let count = if bounds.is_empty() { 0 } else { count };
    let rays = (0..count).map(|_| ray()).collect();
    RaySet { class: RayClass::Random, query: Query::Closest, rays }
}

/// A direction about a unit normal, with a density proportional to its cosine: the normal plus a
/// point of the unit sphere.
fn about(normal: Vec3, random: &mut Random) -> Vec3 {
    (normal + on_sphere(random)).normalize_or(normal)
}

/// A uniform point of the unit sphere (Archimedes: heights on it are uniform).
fn on_sphere(random: &mut Random) -> Vec3 {
    let [u, v] = random.next_pair();
    let (z, angle) = (1.0 - 2.0 * u, std::f32::consts::TAU * v);
    let r = (1.0 - z * z).max(0.0).sqrt();
    Vec3::new(r * libm::cosf(angle), r * libm::sinf(angle), z)
}
