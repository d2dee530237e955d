//! What arrives of a light: the shadow rays of a wave.

use glam::Vec3;

use crate::description::Material;
use crate::math::{Color, Hit, Ray};
use crate::scene::Light;

use super::RayClass;
use super::batch::{Batch, Context, Shaded};
use super::shading::LightSum;

/// Shadow rays asked together: few enough to stay in a core's cache.
const RAYS_AT_ONCE: usize = 4096;

/// Light that is dimmed below this by what it passes through is gone.
const LEAST_SHARE: f32 = 1.0 / 16_384.0;

/// The buffers of shadow rays.
#[derive(Default)]
pub(super) struct Shadows {
    rays: Vec<Ray>,
    /// Which of the wave's surfaces the rays leave, and how many rays each, in order.
    owners: Vec<(u32, u32)>,
    blocked: Vec<bool>,
    /// The share of the light that arrives along each ray.
    shares: Vec<f32>,
    sums: Vec<LightSum>,
    points: Vec<[f32; 2]>,
    walk: Walk,
}

/// Shadow rays on their way through transparent objects.
#[derive(Default)]
struct Walk {
    rays: Vec<Ray>,
    hits: Vec<Hit>,
    /// Which of the shadow rays each is.
    indices: Vec<u32>,
}

impl Shadows {
    /// Adds the light of one light to the colours of all surfaces of a wave.
    pub(super) fn add_light(&mut self, context: &Context<'_>, light: usize, batch: &mut Batch) {
        let source = &context.scene.lights[light];
        self.sums.clear();
        self.sums.resize(batch.shaded.len(), LightSum::default());
        for index in 0..batch.shaded.len() {
            self.send(context, light, batch, index);
            if self.rays.len() >= RAYS_AT_ONCE {
                self.arrive(context, batch);
            }
        }
        self.arrive(context, batch);
        let samples = match source {
            Light::Point { .. } => 1,
            Light::Area { .. } => context.light_samples.per_view_sample(),
        };
        for (shaded, sum) in batch.shaded.iter().zip(&self.sums) {
            let material = &context.scene.materials[shaded.surface.material];
            let color = sum.color(material, source.color(), samples);
            batch.colors[shaded.path.sample as usize] += shaded.path.weight() * color;
        }
    }

    /// Puts the rays from one surface to one light into the buffer.
    fn send(&mut self, context: &Context<'_>, light: usize, batch: &Batch, index: usize) {
        let shaded = &batch.shaded[index];
        let material = &context.scene.materials[shaded.surface.material];
        let before = self.rays.len();
        match context.scene.lights[light] {
            Light::Point { position, .. } => {
                self.rays.extend(shadow_ray(shaded, material, position));
            }
            Light::Area { corner, side_u, side_v, .. } => {
                let sample = shaded.path.sample as usize;
                let points = context.light_samples.points(
                    &batch.pixel_orders[batch.pixel_of_sample[sample] as usize],
                    light,
                    batch.samples[sample].number,
                    shaded.path.key,
                    &mut self.points,
                );
                self.rays.reserve(points.len());
                self.rays.extend(points.iter().filter_map(|&[u, v]| {
                    shadow_ray(shaded, material, corner + u * side_u + v * side_v)
                }));
            }
        }
        let sent = self.rays.len() - before;
        if sent > 0 {
            self.owners.push((index as u32, sent as u32));
        }
    }

    /// Traces the buffered rays and adds what arrives to the sums of their surfaces.
    fn arrive(&mut self, context: &Context<'_>, batch: &mut Batch) {
        self.find_shares(context, batch);
        let mut first = 0;
        for &(owner, count) in &self.owners {
            let shaded = &batch.shaded[owner as usize];
            let material = &context.scene.materials[shaded.surface.material];
            let range = first..first + count as usize;
            first = range.end;
            // A surface with many samples may arrive in parts: each goes on with the same sum.
            let dirs = self.rays[range.clone()].iter().map(|ray| &ray.dir);
            let arriving = dirs.zip(&self.shares[range]);
            let mut sum = self.sums[owner as usize];
            sum.add(material, shaded.surface.normal, shaded.dir, arriving);
            self.sums[owner as usize] = sum;
        }
        self.rays.clear();
        self.owners.clear();
    }

    fn find_shares(&mut self, context: &Context<'_>, batch: &mut Batch) {
        self.shares.clear();
        if context.transparent {
            self.shares.resize(self.rays.len(), 1.0);
            self.walk.run(context, batch, &self.rays, &mut self.shares);
            return;
        }
        self.blocked.clear();
        self.blocked.resize(self.rays.len(), false);
        let stats = batch.stats.class_mut(RayClass::Shadow);
        let counts = context.count.then_some(&mut stats.tests);
        context.observer.rays_sent(RayClass::Shadow, &self.rays);
        context.tracer.occluded(&self.rays, &mut self.blocked, counts);
        self.shares.extend(self.blocked.iter().map(|&blocked| f32::from(u8::from(!blocked))));
        stats.rays += self.rays.len() as u64;
        stats.hits += self.blocked.iter().filter(|&&blocked| blocked).count() as u64;
    }
}

/// The ray from a surface to a point of a light, unless the answer is known: an opaque surface is
/// in its own shadow on the side away from the light, and light that falls from behind the shading
/// normal on a surface without highlights adds nothing.
#[inline]
fn shadow_ray(shaded: &Shaded, material: &Material, light: Vec3) -> Option<Ray> {
    let to_light = light - shaded.origin;
    let surface = &shaded.surface;
    let hidden = material.alpha >= 1.0 && surface.geometric_normal.dot(to_light) <= 0.0;
    let dark = material.specular == Color::ZERO && surface.normal.dot(to_light) <= 0.0;
    // Only what lies between the point and the light counts. The surface itself is left behind by
    // where the ray starts.
    let t_max = 1.0f32.next_down();
    (!(hidden || dark)).then_some(Ray { origin: shaded.origin, t_min: 0.0, dir: to_light, t_max })
}

impl Walk {
    /// Follows rays from hit to hit: an opaque object takes all of the light, a transparent one
    /// the share of its opacity. The rays are not bent.
    fn run(&mut self, context: &Context<'_>, batch: &mut Batch, rays: &[Ray], shares: &mut [f32]) {
        self.rays.clear();
        self.rays.extend_from_slice(rays);
        self.indices.clear();
        self.indices.extend(0..rays.len() as u32);
        while !self.rays.is_empty() {
            self.hits.clear();
            self.hits.resize(self.rays.len(), Hit::MISS);
            let stats = batch.stats.class_mut(RayClass::Shadow);
            let counts = context.count.then_some(&mut stats.tests);
            context.observer.rays_sent(RayClass::Shadow, &self.rays);
            context.tracer.intersect(&self.rays, &mut self.hits, counts);
            stats.rays += self.rays.len() as u64;
            stats.hits += self.hits.iter().filter(|hit| hit.is_hit()).count() as u64;
            self.dim_and_keep(context, shares);
        }
    }

    /// Dims the rays that hit something, and keeps those that still carry light.
    fn dim_and_keep(&mut self, context: &Context<'_>, shares: &mut [f32]) {
        let mut kept = 0;
        for i in 0..self.rays.len() {
            let hit = self.hits[i];
            if !hit.is_hit() {
                continue;
            }
            let index = self.indices[i];
            let object = &context.scene.objects[hit.object as usize];
            let share = &mut shares[index as usize];
            *share *= 1.0 - context.scene.materials[object.material].alpha;
            if *share < LEAST_SHARE {
                *share = 0.0;
            } else {
                // The next hit behind this one. On the same ray the same primitive gives the same
                // parameter, so it is not met again.
                self.rays[kept] = Ray { t_min: hit.t.next_up(), ..self.rays[i] };
                self.indices[kept] = index;
                kept += 1;
            }
        }
        self.rays.truncate(kept);
        self.indices.truncate(kept);
    }
}
