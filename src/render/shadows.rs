//! What arrives of a light: the shadow rays of a wave.

use glam::Vec3;

use crate::math::{Hit, Ray};
use crate::scene::Light;

use super::batch::{Batch, Context};
use super::incidence::{Incidence, LANES, LightPlane, Receiver};
use super::{RayClass, Stage};

/// Shadow rays asked together: few enough to stay in a core's cache.
const RAYS_AT_ONCE: usize = 4096;

/// Light that is dimmed below this by what it passes through is gone.
const LEAST_SHARE: f32 = 1.0 / 16_384.0;

/// The buffers of shadow rays.
#[derive(Default)]
pub(super) struct Shadows {
    rays: Vec<Ray>,
    /// What light along each ray adds, if all of it arrives: see [`Incidence`].
    diffuse: Vec<f32>,
    specular: Vec<f32>,
    /// Which of the wave's surfaces the rays leave, and how many rays each, in order.
    owners: Vec<(u32, u32)>,
    blocked: Vec<bool>,
    /// The share of the light that arrives along each ray.
    shares: Vec<f32>,
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
        let plane = LightPlane::new(&context.scene.lights[light]);
        for index in 0..batch.shaded.len() {
            self.send(context, light, &plane, batch, index);
            if self.rays.len() >= RAYS_AT_ONCE {
                self.arrive(context, light, batch);
            }
        }
        self.arrive(context, light, batch);
    }

    /// Puts the rays from one surface to one light into the buffer.
    fn send(
        &mut self,
        context: &Context<'_>,
        light: usize,
        plane: &LightPlane,
        batch: &Batch,
        index: usize,
    ) {
        let shaded = &batch.shaded[index];
        let receiver = Receiver::new(shaded, &context.finishes[shaded.surface.material]);
        let samples = match context.scene.lights[light] {
            Light::Point { .. } => &[[0.0; 2]],
            Light::Area { .. } => context.light_samples.points(
                &batch.dealt[light],
                light,
                shaded.path.sample as usize,
                shaded.path.key,
                &mut self.points,
            ),
        };
        let before = self.rays.len();
        for samples in samples.chunks(LANES) {
            let incidence = receiver.light(plane, samples);
            let rays = shadow_rays(shaded.origin, &incidence);
            if incidence.lanes == (1 << LANES) - 1 {
                self.rays.extend_from_slice(&rays);
                self.diffuse.extend_from_slice(&incidence.diffuse.to_array());
                self.specular.extend_from_slice(&incidence.specular.to_array());
            } else {
                for lane in (0..LANES).filter(|lane| incidence.lanes >> lane & 1 == 1) {
                    self.rays.push(rays[lane]);
                    self.diffuse.push(incidence.diffuse[lane]);
                    self.specular.push(incidence.specular[lane]);
                }
            }
        }
        let sent = self.rays.len() - before;
        if sent > 0 {
            self.owners.push((index as u32, sent as u32));
        }
    }

    /// Traces the buffered rays and adds what arrives to the colours.
    fn arrive(&mut self, context: &Context<'_>, light: usize, batch: &mut Batch) {
        batch.lap(Stage::MakingRays);
        if self.rays.is_empty() {
            return;
        }
        self.find_shares(context, batch);
        let (samples, color) = match context.scene.lights[light] {
            Light::Point { color, .. } => (1, color),
            Light::Area { color, .. } => (context.light_samples.per_view_sample(), color),
        };
        let color = color / samples as f32;
        let mut first = 0;
        for &(owner, count) in &self.owners {
            let shaded = &batch.shaded[owner as usize];
            let finish = &context.finishes[shaded.surface.material];
            let range = first..first + count as usize;
            first = range.end;
            let shares = &self.shares[range.clone()];
            let mut sent = weighted_sum(&self.diffuse[range.clone()], shares) * finish.diffuse;
            if finish.shines {
                sent += weighted_sum(&self.specular[range], shares) * finish.specular;
            }
            batch.colors[shaded.path.sample as usize] += shaded.path.weight() * color * sent;
        }
        self.rays.clear();
        self.diffuse.clear();
        self.specular.clear();
        self.owners.clear();
        batch.lap(Stage::Shading);
    }

    fn find_shares(&mut self, context: &Context<'_>, batch: &mut Batch) {
        let count = self.rays.len();
        self.shares.clear();
        if context.transparent {
            self.shares.resize(count, 1.0);
            self.walk.run(context, batch, &self.rays, &mut self.shares);
            return;
        }
        if self.blocked.len() < count {
            self.blocked.resize(count, false);
        }
        let blocked = &mut self.blocked[..count];
        batch.occluded(context, &self.rays, blocked);
        self.shares.extend(blocked.iter().map(|&blocked| f32::from(u8::from(!blocked))));
    }
}

/// The rays to the four points, whether or not light may arrive from them. Only what lies between
/// the surface and the point counts; the surface itself is left behind by where the rays start.
#[inline(always)]
fn shadow_rays(origin: Vec3, incidence: &Incidence) -> [Ray; LANES] {
    let [x, y, z] = incidence.to_light.map(|row| row.to_array());
    std::array::from_fn(|lane| Ray {
        origin,
        t_min: 0.0,
        dir: Vec3::new(x[lane], y[lane], z[lane]),
        t_max: 1.0f32.next_down(),
    })
}

/// Σ value · share, in four sums of every fourth product, which are added up in the end: an order
/// that depends on nothing but the number of values.
#[inline]
fn weighted_sum(values: &[f32], shares: &[f32]) -> f32 {
    let mut sums = [0.0; LANES];
    let (rows, rest) = values.as_chunks::<LANES>();
    let (row_shares, rest_shares) = shares.as_chunks::<LANES>();
    for (row, shares) in rows.iter().zip(row_shares) {
        for lane in 0..LANES {
            sums[lane] += row[lane] * shares[lane];
        }
    }
    for ((sum, value), share) in sums.iter_mut().zip(rest).zip(rest_shares) {
        *sum += value * share;
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3])
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
            batch.intersect(context, RayClass::Shadow, &self.rays, &mut self.hits);
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
            *share *= context.finishes[object.material].transparency;
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_are_weighted_and_whole() {
        let values: Vec<f32> = (1..=11u8).map(f32::from).collect();
        for count in 0..=values.len() {
            let shares: Vec<f32> = (0..count).map(|i| [1.0, 0.0, 0.5][i % 3]).collect();
            let expected: f32 = values.iter().zip(&shares).map(|(v, s)| v * s).sum();
            assert_eq!(weighted_sum(&values[..count], &shares), expected, "{count}");
        }
    }
}
