//! A batch of view samples, followed wave by wave to its colours.

use glam::Vec3;

use crate::accel::Tracer;
use crate::math::{Color, Hit, Ray, hash_u64};
use crate::scene::{Light, Scene, Surface};

use super::finish::Finish;
use super::light_samples::{LightSamples, SampleAssignment};
use super::optics::{mirror, refract};
use super::shadows::Shadows;
use super::times::Stopwatch;
use super::view_rays::{Pixel, ViewRays};
use super::{Observer, RayClass, RenderStats, Settings, Stage};

/// A way of light from a surface to the eye that is being followed backwards.
#[derive(Clone, Copy, Debug)]
pub(super) struct Path {
    /// Which of the batch's samples it belongs to.
    pub(super) sample: u32,
    /// What the light found along it is multiplied by.
    weight: Color,
    /// Its own stream of random numbers.
    pub(super) key: u64,
}

/// A path that has hit something.
#[derive(Clone, Copy)]
pub(super) struct Shaded {
    pub(super) path: Path,
    pub(super) surface: Surface,
    /// Direction from the eye, or the surface before, to this one; a unit vector where the surface
    /// has highlights, mirrors or refracts.
    pub(super) dir: Vec3,
    /// Where rays start that leave the surface.
    pub(super) origin: Vec3,
}

/// What all batches of a rendering share.
pub(super) struct Context<'a> {
    pub(super) scene: &'a Scene,
    pub(super) tracer: &'a dyn Tracer,
    pub(super) observer: &'a dyn Observer,
    pub(super) settings: &'a Settings,
    pub(super) view_rays: ViewRays,
    pub(super) light_samples: LightSamples,
    /// The scene's materials, in its order.
    pub(super) finishes: Vec<Finish>,
    pub(super) transparent: bool,
    pub(super) count: bool,
}

/// The buffers of a batch; made once a thread and used again.
pub(super) struct Batch {
    pub(super) stats: RenderStats,
    /// Of which pixels all samples are followed.
    pub(super) pixels: Vec<Pixel>,
    /// The colours of the samples, pixel by pixel.
    pub(super) colors: Vec<Color>,
    pub(super) shaded: Vec<Shaded>,
    /// For each light, the samples that go to each view sample.
    pub(super) assignment: Vec<SampleAssignment>,
    stopwatch: Stopwatch,
    hits: Vec<Hit>,
    waves: [Wave; 5],
    shadows: Shadows,
}

/// Rays of one class, each with the path that it continues.
#[derive(Default)]
struct Wave {
    rays: Vec<Ray>,
    paths: Vec<Path>,
}

impl Wave {
    fn push(&mut self, ray: Ray, path: Path) {
        self.rays.push(ray);
        self.paths.push(path);
    }

    fn clear(&mut self) {
        self.rays.clear();
        self.paths.clear();
    }
}

/// Paths of less weight than this are dropped: a sixty-fourth of the step between two 8-bit
/// colours. Without it, rays between glass surfaces double with every bounce.
const LEAST_WEIGHT: f32 = 1.0 / 16_384.0;

impl Batch {
    /// Buffers for a scene of some number of lights. Time counts from now on.
    pub(super) fn new(lights: usize) -> Self {
        Self {
            stats: RenderStats::default(),
            pixels: Vec::new(),
            colors: Vec::new(),
            shaded: Vec::new(),
            assignment: std::iter::repeat_with(SampleAssignment::default).take(lights).collect(),
            stopwatch: Stopwatch::start(),
            hits: Vec::new(),
            waves: Default::default(),
            shadows: Shadows::default(),
        }
    }

    /// Computes the colours of all samples of `self.pixels`, into `self.colors`.
    pub(super) fn run(&mut self, context: &Context<'_>) {
        let [mut view, mut mirrored, mut refracted, mut next_mirrored, mut next_refracted] =
            std::mem::take(&mut self.waves);
        self.send_view_rays(context, &mut view);
        for bounce in 0..=context.settings.max_recursion {
            let goes_on = bounce < context.settings.max_recursion;
            for (class, wave) in [
                (RayClass::View, &mut view),
                (RayClass::Mirror, &mut mirrored),
                (RayClass::Refraction, &mut refracted),
            ] {
                if wave.rays.is_empty() {
                    continue;
                }
                self.find(context, class, wave);
                wave.clear();
                self.shadows_of_all_lights(context);
                if goes_on {
                    self.continue_paths(context, &mut next_mirrored, &mut next_refracted);
                    self.lap(Stage::MakingRays);
                }
            }
            std::mem::swap(&mut mirrored, &mut next_mirrored);
            std::mem::swap(&mut refracted, &mut next_refracted);
        }
        // Where the bounces ended, the rays of the next one were never made.
        self.waves = [view, mirrored, refracted, next_mirrored, next_refracted];
    }

    /// Gives the time since the last lap to a stage.
    pub(super) fn lap(&mut self, stage: Stage) {
        self.stats.thread_times.add(stage, self.stopwatch.lap());
    }

    /// Traces rays, counts them, and takes the time.
    pub(super) fn intersect(
        &mut self,
        context: &Context<'_>,
        class: RayClass,
        rays: &[Ray],
        hits: &mut [Hit],
    ) {
        context.observer.rays_sent(class, rays);
        let stats = self.stats.class_mut(class);
        context.tracer.intersect(rays, hits, context.count.then_some(&mut stats.tests));
        stats.rays += rays.len() as u64;
        stats.hits += hits.iter().filter(|hit| hit.is_hit()).count() as u64;
        self.lap(Stage::Tracing(class));
    }

    /// As [`intersect`](Self::intersect), for shadow rays.
    pub(super) fn occluded(&mut self, context: &Context<'_>, rays: &[Ray], blocked: &mut [bool]) {
        context.observer.rays_sent(RayClass::Shadow, rays);
        let stats = self.stats.class_mut(RayClass::Shadow);
        context.tracer.occluded(rays, blocked, context.count.then_some(&mut stats.tests));
        stats.rays += rays.len() as u64;
        stats.hits += blocked.iter().filter(|&&blocked| blocked).count() as u64;
        self.lap(Stage::Tracing(RayClass::Shadow));
    }

    fn send_view_rays(&mut self, context: &Context<'_>, wave: &mut Wave) {
        wave.clear();
        for &pixel in &self.pixels {
            for (key, ray) in context.view_rays.of_pixel(pixel) {
                let sample = wave.rays.len() as u32;
                wave.push(ray, Path { sample, weight: Color::ONE, key });
            }
        }
        self.colors.clear();
        self.colors.resize(wave.rays.len(), Color::ZERO);
        let lights = context.scene.lights.iter().zip(&mut self.assignment).enumerate();
        // Point lights need no samples.
        for (light, (_, assignment)) in lights.filter(|(_, (l, _))| matches!(l, Light::Area { .. }))
        {
            assignment.clear();
            for &pixel in &self.pixels {
                context.light_samples.assign(pixel.key(), light, assignment);
            }
        }
        self.lap(Stage::MakingRays);
    }

    /// Traces a wave: misses see the background, hits become `self.shaded`, lit by ambient light.
    fn find(&mut self, context: &Context<'_>, class: RayClass, wave: &Wave) {
        let mut hits = std::mem::take(&mut self.hits);
        let count = wave.rays.len();
        if hits.len() < count {
            hits.resize(count, Hit::MISS);
        }
        self.intersect(context, class, &wave.rays, &mut hits[..count]);
        self.shaded.clear();
        for ((ray, hit), path) in wave.rays.iter().zip(&hits).zip(&wave.paths) {
            let seen = if hit.is_hit() {
                let surface = context.scene.surface(ray, hit);
                let origin = surface.origin_outside();
                let finish = &context.finishes[surface.material];
                let dir = if finish.goes_on() { ray.dir.normalize() } else { ray.dir };
                self.shaded.push(Shaded { path: *path, surface, dir, origin });
                finish.ambient
            } else {
                context.scene.options.background
            };
            self.colors[path.sample as usize] += path.weight * seen;
        }
        self.hits = hits;
        self.lap(Stage::Shading);
    }

    fn shadows_of_all_lights(&mut self, context: &Context<'_>) {
        let mut shadows = std::mem::take(&mut self.shadows);
        shadows.receive(context, &self.shaded);
        for light in 0..context.scene.lights.len() {
            shadows.add_light(context, light, self);
        }
        self.shadows = shadows;
    }

    /// Sends mirrored and refracted rays from what was hit.
    ///
    /// A surface mirrors the share `cp`. Of the rest, the share 1 − alpha meets the border of a
    /// clear medium, where Fresnel's equations part it into what is mirrored and what goes through.
    fn continue_paths(&self, context: &Context<'_>, mirrored: &mut Wave, refracted: &mut Wave) {
        for shaded in &self.shaded {
            let finish = &context.finishes[shaded.surface.material];
            if !finish.goes_on() {
                continue;
            }
            let mut mirror_share = finish.specular;
            if finish.clear.max_element() > 0.0 {
                let inside = shaded.surface.from_inside;
                let index = finish.refractive_index;
                let eta = if inside { index } else { 1.0 / index };
                let border = refract(shaded.dir, shaded.surface.normal, eta);
                mirror_share += border.reflected * finish.clear;
                if let Some(dir) = border.dir {
                    let through = (1.0 - border.reflected) * finish.clear;
                    if let Some(path) = shaded.path.continued(through, 2) {
                        refracted.push(shaded.through(dir), path);
                    }
                }
            }
            if let Some(path) = shaded.path.continued(mirror_share, 1) {
                mirrored.push(shaded.mirrored(), path);
            }
        }
    }
}

impl Path {
    pub(super) fn weight(&self) -> Color {
        self.weight
    }

    /// The path that goes on with `share` of the light, if that is worth following.
    fn continued(&self, share: Color, branch: u64) -> Option<Self> {
        let weight = self.weight * share;
        let key = hash_u64(self.key ^ branch);
        (weight.abs().max_element() >= LEAST_WEIGHT).then_some(Self { weight, key, ..*self })
    }
}

impl Shaded {
    /// The ray along the mirror direction. Where an interpolated normal would send it into the
    /// surface, the surface's own normal is used.
    fn mirrored(&self) -> Ray {
        let geometric = self.surface.geometric_normal;
        let mut dir = mirror(self.dir, self.surface.normal);
        if dir.dot(geometric) <= 0.0 {
            dir = mirror(self.dir, geometric);
        }
        Ray::new(self.origin, dir)
    }

    /// The ray through the surface along `dir`, or straight on where an interpolated normal would
    /// not let it through.
    fn through(&self, dir: Vec3) -> Ray {
        let enters = dir.dot(self.surface.geometric_normal) < 0.0;
        let dir = if enters { dir } else { self.dir };
        Ray::new(self.surface.origin_behind(), dir)
    }
}
