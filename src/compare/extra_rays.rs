//! Rays without a rendering: view rays; from what they hit to a light, in the mirror direction and in
//! random directions; parallel rays along an axis; random rays.

use glam::Vec3;

use crate::accel::Tracer;
use crate::math::{Hit, Random, Ray};
use crate::record::RayClass;
use crate::render::pixel_order;
use crate::scene::{Scene, Surface};

use super::record_rays::RaySet;
use super::trace::closest_hits;

/// Keep the streams of random numbers apart.
const DIFFUSE_STREAM: u64 = 0x6469_6666;
const RANDOM_STREAM: u64 = 0x7261_6e64;

/// A ray through the centre of each pixel of the scene's picture, in the order of a renderer.
#[must_use]
pub fn view_rays(scene: &Scene) -> RaySet {
    let camera = &scene.camera;
    let ray = |[x, y]: [u32; 2]| camera.ray(f64::from(x), f64::from(camera.height - 1 - y));
    let pixels = pixel_order(camera.width, camera.height);
    RaySet::closest_hit(RayClass::View, pixels.map(ray).collect())
}

/// What view rays hit first: where the rays of other classes start.
#[derive(Debug)]
pub struct FirstHits<'a> {
    scene: &'a Scene,
    view: &'a RaySet,
    hits: Vec<Hit>,
}

impl<'a> FirstHits<'a> {
    /// Traces view rays.
    #[must_use]
    pub fn new(scene: &'a Scene, tracer: &dyn Tracer, view: &'a RaySet) -> Self {
        Self { scene, view, hits: closest_hits(tracer, &view.rays) }
    }

    /// Each view ray that hits something, and the surface there.
    fn surfaces(&self) -> impl Iterator<Item = (&Ray, Surface)> {
        let hit = self.view.rays.iter().zip(&self.hits).filter(|(_, hit)| hit.is_hit());
        hit.map(|(ray, hit)| (ray, self.scene.surface(ray, hit)))
    }

    /// From each surface a ray to a point light, up to just before it.
    #[must_use]
    pub fn shadow_rays(&self, light: Vec3) -> RaySet {
        let ray = |(_, surface): (&Ray, Surface)| {
            let origin = surface.origin_outside();
            Ray::with_interval(origin, light - origin, 0.0, 1.0f32.next_down())
        };
        RaySet::any_hit(RayClass::Shadow, self.surfaces().map(ray).collect())
    }

    /// From each surface a ray in the mirror direction of the view ray.
    #[must_use]
    pub fn mirror_rays(&self) -> RaySet {
        let ray = |(view, surface): (&Ray, Surface)| {
            let normal = surface.normal;
            Ray::new(surface.origin_outside(), view.dir - 2.0 * view.dir.dot(normal) * normal)
        };
        RaySet::closest_hit(RayClass::Mirror, self.surfaces().map(ray).collect())
    }

    /// From each surface a ray in a random direction about the normal: the first bounce of diffuse
    /// light.
    #[must_use]
    pub fn diffuse_rays(&self, seed: u64) -> RaySet {
        let mut random = Random::new(&[seed, DIFFUSE_STREAM]);
        let ray = |(_, surface): (&Ray, Surface)| {
            Ray::new(surface.origin_outside(), about(surface.normal, &mut random))
        };
        RaySet::closest_hit(RayClass::Diffuse, self.surfaces().map(ray).collect())
    }
}

/// Parallel rays down the axis along which the scene's box is shortest, from a grid of `width` × `height`
/// points above it, in the order of a renderer: as a height field is probed, or a plan drawn.
#[must_use]
pub fn probe_rays(scene: &Scene, width: u32, height: u32) -> RaySet {
    let bounds = scene.bounds();
    let size = Vec3::from(bounds.size());
    let down = if size.y <= size.x.min(size.z) { 1 } else { 2 * usize::from(size.z < size.x) };
    let (across, along) = ((down + 1) % 3, (down + 2) % 3);
    let mut dir = Vec3::ZERO;
    dir[down] = -1.0;
    let ray = |[x, y]: [u32; 2]| {
        let mut origin = Vec3::from(bounds.max);
        origin[down] += size[down];
        origin[across] -= size[across] * (x as f32 + 0.5) / width as f32;
        origin[along] -= size[along] * (y as f32 + 0.5) / height as f32;
        Ray::new(origin, dir)
    };
    let (width, height) = if bounds.is_empty() { (0, 0) } else { (width, height) };
    RaySet::closest_hit(RayClass::Probe, pixel_order(width, height).map(ray).collect())
}

/// From random points of the scene's box in random directions, both uniform.
pub(super) fn random_rays(scene: &Scene, count: usize, seed: u64) -> RaySet {
    let bounds = scene.bounds();
    let mut random = Random::new(&[seed, RANDOM_STREAM]);
    let mut ray = || {
        let place = Vec3::from_array(std::array::from_fn(|_| random.next_f32()));
        let origin = Vec3::from(bounds.min) + place * Vec3::from(bounds.size());
        Ray::new(origin, on_sphere(&mut random))
    };
    let count = if bounds.is_empty() { 0 } else { count };
    RaySet::closest_hit(RayClass::Random, (0..count).map(|_| ray()).collect())
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
