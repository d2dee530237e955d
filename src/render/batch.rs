//! A batch of view samples, followed wave by wave to its colours.

use glam::Vec3;

use crate::accel::Tracer;
use crate::math::{Color, Hit, Random, Ray, hash_u64};
use crate::scene::{Camera, Scene, Surface};

use super::light_samples::{LightSamples, PixelOrder};
use super::optics::{mirror, refract};
use super::shadows::Shadows;
use super::{Observer, RayClass, RenderStats, Settings};

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
pub(super) struct Shaded {
    pub(super) path: Path,
    pub(super) surface: Surface,
    /// Unit direction from the eye, or the surface before, to this one.
    pub(super) dir: Vec3,
    /// Where rays start that leave the surface.
    pub(super) origin: Vec3,
}

/// A pixel's sample in a batch.
#[derive(Clone, Copy, Debug)]
pub(super) struct ViewSample {
    /// Column from the left in the whole picture.
    pub(super) x: u32,
    /// Row from the top in the whole picture.
    pub(super) y: u32,
    /// Number of the sample in its pixel.
    pub(super) number: u32,
}

/// What all batches of a rendering share.
pub(super) struct Context<'a> {
    pub(super) scene: &'a Scene,
    pub(super) tracer: &'a dyn Tracer,
    pub(super) observer: &'a dyn Observer,
    pub(super) settings: &'a Settings,
    pub(super) camera: Camera,
    pub(super) light_samples: LightSamples,
    pub(super) transparent: bool,
    pub(super) count: bool,
}

/// The buffers of a batch; made once a thread and used again.
#[derive(Default)]
pub(super) struct Batch {
    pub(super) stats: RenderStats,
    pub(super) colors: Vec<Color>,
    pub(super) shaded: Vec<Shaded>,
    pub(super) samples: Vec<ViewSample>,
    /// The light samples of the pixels of the batch, and which of them each sample belongs to.
    pub(super) pixel_orders: Vec<PixelOrder>,
    pub(super) pixel_of_sample: Vec<u32>,
    hits: Vec<Hit>,
    waves: [Wave; 3],
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
    /// Computes the colours of some samples, into `self.colors`.
    pub(super) fn run(&mut self, context: &Context<'_>) {
        self.colors.clear();
        self.colors.resize(self.samples.len(), Color::ZERO);
        let [mut view, mut mirrored, mut refracted] = std::mem::take(&mut self.waves);
        let [mut next_mirrored, mut next_refracted] = <[Wave; 2]>::default();
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
                self.add_ambient_light(context);
                self.shadows_of_all_lights(context);
                if goes_on {
                    self.continue_paths(context, &mut next_mirrored, &mut next_refracted);
                }
            }
            std::mem::swap(&mut mirrored, &mut next_mirrored);
            std::mem::swap(&mut refracted, &mut next_refracted);
        }
        self.waves = [view, mirrored, refracted];
    }

    fn send_view_rays(&mut self, context: &Context<'_>, wave: &mut Wave) {
        wave.clear();
        for (index, sample) in self.samples.iter().enumerate() {
            let number = u64::from(sample.number);
            let key = Random::new(&[context.settings.seed, sample.pixel_key(), number]).next_u64();
            let path = Path { sample: index as u32, weight: Color::ONE, key };
            wave.push(sample.ray(context, key), path);
        }
    }

    /// Traces a wave: misses see the background, hits become `self.shaded`.
    fn find(&mut self, context: &Context<'_>, class: RayClass, wave: &Wave) {
        let rays = &wave.rays;
        self.hits.clear();
        self.hits.resize(rays.len(), Hit::MISS);
        let stats = self.stats.class_mut(class);
        let counts = context.count.then_some(&mut stats.tests);
        context.observer.rays_sent(class, rays);
        context.tracer.intersect(rays, &mut self.hits, counts);
        stats.rays += rays.len() as u64;
        self.shaded.clear();
        for ((ray, hit), path) in rays.iter().zip(&self.hits).zip(&wave.paths) {
            if hit.is_hit() {
                let surface = context.scene.surface(ray, hit);
                let origin = surface.origin_outside();
                self.shaded.push(Shaded { path: *path, surface, dir: ray.dir.normalize(), origin });
            } else {
                let seen = path.weight * context.scene.options.background;
                self.colors[path.sample as usize] += seen;
            }
        }
        stats.hits += self.shaded.len() as u64;
    }

    fn add_ambient_light(&mut self, context: &Context<'_>) {
        for shaded in &self.shaded {
            let material = &context.scene.materials[shaded.surface.material];
            let ambient = material.alpha * material.ambient_light * material.reflectance;
            self.colors[shaded.path.sample as usize] += shaded.path.weight * ambient;
        }
    }

    fn shadows_of_all_lights(&mut self, context: &Context<'_>) {
        let mut shadows = std::mem::take(&mut self.shadows);
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
            let material = &context.scene.materials[shaded.surface.material];
            let clear = (Color::ONE - material.specular).max(Color::ZERO) * (1.0 - material.alpha);
            let mut mirror_share = material.specular;
            if clear.max_element() > 0.0 {
                let inside = shaded.surface.from_inside;
                let index = material.refractive_index;
                let eta = if inside { index } else { 1.0 / index };
                let border = refract(shaded.dir, shaded.surface.normal, eta);
                mirror_share += border.reflected * clear;
                if let Some(dir) = border.dir {
                    let through = (1.0 - border.reflected) * clear;
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

impl ViewSample {
    /// What a pixel's random numbers depend on.
    pub(super) fn pixel_key(&self) -> u64 {
        u64::from(self.y) << 32 | u64::from(self.x)
    }

    /// The ray through the sample's place in the pixel: its centre, or a random place in the
    /// sample's cell of n × n.
    fn ray(&self, context: &Context<'_>, key: u64) -> Ray {
        let row_from_bottom = f64::from(context.settings.height - 1 - self.y);
        let (mut i, mut j) = (f64::from(self.x), row_from_bottom);
        let n = context.settings.aa;
        if n > 0 {
            let [dx, dy] = Random::new(&[key]).next_pair().map(f64::from);
            i += (f64::from(self.number % n) + dx) / f64::from(n) - 0.5;
            j += (f64::from(self.number / n) + dy) / f64::from(n) - 0.5;
        }
        context.camera.ray(i, j)
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
