//! Rays of each class, in the order in which a renderer of tiles would send them.

use clap::ValueEnum;
use glam::Vec3;
use srt::accel::{Answers, Scratch, Tracer};
use srt::math::{Hit, Random, Ray};
use srt::scene::Scene;

/// Sides of a tile and of a block in it, in pixels: sixteen rays in a row see one block.
const TILE: u32 = 16;
const BLOCK: u32 = 4;

/// A class of rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Class {
    /// From the eye.
    View,
    /// To a point light, from what view rays hit.
    Shadow,
    /// In random directions about the normal, from what view rays hit.
    Diffuse,
    /// Mirrored off what view rays hit.
    Mirror,
    /// Down an axis, the one along which the scene is flattest, from a grid above it: as a height
    /// field is probed, or a plan drawn.
    Probe,
}

/// The rays of a class. Shadow rays ask whether anything is hit, all others what is hit first.
pub(crate) struct RaySet {
    pub(crate) class: Class,
    pub(crate) rays: Vec<Ray>,
}

/// All classes, in the order of [`Class`].
pub(crate) fn ray_sets(scene: &Scene, tracer: &dyn Tracer, light: Vec3) -> [RaySet; 5] {
    let view = view_rays(scene);
    let mut hits = vec![Hit::MISS; view.len()];
    tracer.trace(&view, Answers::ClosestHit(&mut hits), &mut Scratch::default(), None);
    let mut random = Random::new(&[1]);
    let (mut shadow, mut diffuse, mut mirror) = (vec![], vec![], vec![]);
    for (ray, hit) in view.iter().zip(&hits).filter(|(_, hit)| hit.is_hit()) {
        let surface = scene.surface(ray, hit);
        let (origin, normal) = (surface.origin_outside(), surface.geometric_normal);
        shadow.push(Ray::with_interval(origin, light - origin, 0.0, 1.0f32.next_down()));
        diffuse.push(Ray::new(origin, about(normal, &mut random)));
        mirror.push(Ray::new(origin, ray.dir - 2.0 * ray.dir.dot(normal) * normal));
    }
    [
        RaySet { class: Class::View, rays: view },
        RaySet { class: Class::Shadow, rays: shadow },
        RaySet { class: Class::Diffuse, rays: diffuse },
        RaySet { class: Class::Mirror, rays: mirror },
        RaySet { class: Class::Probe, rays: probes(scene) },
    ]
}

/// A ray through the centre of each pixel.
fn view_rays(scene: &Scene) -> Vec<Ray> {
    let ray = |(x, y)| scene.camera.ray(f64::from(x), f64::from(y));
    pixels(scene.camera.width, scene.camera.height).into_iter().map(ray).collect()
}

/// A ray for each pixel, spread over the scene's box, along the shortest of its edges.
fn probes(scene: &Scene) -> Vec<Ray> {
    let (width, height) = (scene.camera.width, scene.camera.height);
    let bounds = scene.bounds();
    let size = Vec3::from(bounds.size());
    let down = if size.y <= size.x.min(size.z) { 1 } else { 2 * usize::from(size.z < size.x) };
    let (across, along) = ((down + 1) % 3, (down + 2) % 3);
    let mut dir = Vec3::ZERO;
    dir[down] = -1.0;
    let ray = |(x, y): (u32, u32)| {
        let mut origin = Vec3::from(bounds.max);
        origin[down] += size[down];
        origin[across] -= size[across] * (x as f32 + 0.5) / width as f32;
        origin[along] -= size[along] * (y as f32 + 0.5) / height as f32;
        Ray::new(origin, dir)
    };
    pixels(width, height).into_iter().map(ray).collect()
}

/// The pixels of a picture: tile by tile, in a tile block by block.
fn pixels(width: u32, height: u32) -> Vec<(u32, u32)> {
    let mut all = Vec::with_capacity(width as usize * height as usize);
    for (tile_x, tile_y) in cells(0, 0, width.max(height), TILE) {
        for (block_x, block_y) in cells(tile_x, tile_y, TILE, BLOCK) {
            let pixels = cells(block_x, block_y, BLOCK, 1);
            all.extend(pixels.filter(|&(x, y)| x < width && y < height));
        }
    }
    all
}

/// The corners of the cells of a square, row by row.
fn cells(x: u32, y: u32, side: u32, step: u32) -> impl Iterator<Item = (u32, u32)> {
    let places = move || (0..side).step_by(step as usize);
    places().flat_map(move |dy| places().map(move |dx| (x + dx, y + dy)))
}

/// A direction about a unit normal, with a density proportional to its cosine: the normal plus a
/// point of the unit sphere.
fn about(normal: Vec3, random: &mut Random) -> Vec3 {
    let [u, v] = random.next_pair();
    let (z, angle) = (1.0 - 2.0 * u, std::f32::consts::TAU * v);
    let r = (1.0 - z * z).max(0.0).sqrt();
    (normal + Vec3::new(r * angle.cos(), r * angle.sin(), z)).normalize_or(normal)
}
