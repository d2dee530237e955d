//! The same rays for all: each class's rays of a scene, recorded once from a small rendering.
//!
//! Who traces during the recording does not matter: all structures give the same hits, so the
//! same rays follow. The rendering runs on one thread, so that rays stand in the order in which a
//! renderer's thread sends them, and are the same in every run.

use std::sync::Mutex;
use std::sync::PoisonError;

use crate::accel::Tracer;
use crate::math::Ray;
use crate::record::RayClass;
use crate::render::{self, Settings, render};
use crate::scene::Scene;

use super::plan::fit;

/// View samples of the rendering that tells how many rays follow from each.
const PROBE_SAMPLES: u32 = 2_000;

/// View samples of the recording, if few rays follow from each.
const MOST_SAMPLES: u32 = 60_000;

/// What is asked of a ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Query {
    /// The closest hit.
    Closest,
    /// Whether there is any.
    Any,
}

/// The rays of a class.
#[derive(Clone, Debug)]
pub(super) struct RaySet {
    pub(super) class: RayClass,
    pub(super) query: Query,
    pub(super) rays: Vec<Ray>,
}

/// The rays of a scene.
#[derive(Clone, Debug, Default)]
pub(super) struct Recording {
    /// The classes that occurred, in the order of reports.
    pub(super) sets: Vec<RaySet>,
    /// Rays of each class for a view sample of the picture.
    pub(super) per_sample: Vec<(RayClass, f64)>,
}

impl Recording {
    /// Rays of a class for each view sample; 0 for those that a renderer does not send.
    pub(super) fn rays_per_sample(&self, class: RayClass) -> f64 {
        self.per_sample.iter().find(|(other, _)| *other == class).map_or(0.0, |(_, rays)| *rays)
    }
}

/// How much is recorded.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    /// Rays of a class.
    pub(super) per_class: usize,
    /// Rays that the recording may trace in all.
    pub(super) traced: u64,
}

/// Records the rays that a renderer sends for a picture. On the threads of the current rayon pool,
/// which should be one.
pub(super) fn record(
    scene: &Scene,
    tracer: &dyn Tracer,
    picture: &Settings,
    limits: Limits,
    cancelled: &(dyn Fn() -> bool + Sync),
) -> Recording {
    let probe = Recorder::new(limits.per_class, cancelled);
    let sent = render(scene, tracer, &small(picture, PROBE_SAMPLES), &probe).stats.total_rays();
    let per_sample = (sent / u64::from(PROBE_SAMPLES)).max(1);
    let affordable = u32::try_from(limits.traced / per_sample).unwrap_or(u32::MAX);
    let settings = small(picture, affordable.clamp(PROBE_SAMPLES, MOST_SAMPLES));
    let recorder = Recorder::new(limits.per_class, cancelled);
    let stats = render(scene, tracer, &settings, &recorder).stats;
    let samples = f64::from(settings.width * settings.height * settings.samples_per_pixel());
    let rate = |class| stats.class(class).rays as f64 / samples;
    Recording {
        sets: recorder.sets(scene),
        per_sample: RayClass::RENDERED.map(|class| (class, rate(class))).into(),
    }
}

/// The picture, so small that it takes about as many view samples.
fn small(picture: &Settings, samples: u32) -> Settings {
    let pixels = f64::from(samples / picture.samples_per_pixel()).max(1.0);
    let (width, height) = (f64::from(picture.width), f64::from(picture.height));
    let side = (pixels / (width * height)).sqrt() * width.max(height);
    let [width, height] = fit([picture.width, picture.height], (side as u32).max(1));
    Settings { width, height, crop: None, ..picture.clone() }
}

/// Keeps the rays that a rendering sends.
struct Recorder<'a> {
    kept: Mutex<[Thinned; RayClass::RENDERED.len()]>,
    cancelled: &'a (dyn Fn() -> bool + Sync),
}

impl<'a> Recorder<'a> {
    fn new(limit: usize, cancelled: &'a (dyn Fn() -> bool + Sync)) -> Self {
        Self { kept: Mutex::new(std::array::from_fn(|_| Thinned::new(limit))), cancelled }
    }

    fn sets(self, scene: &Scene) -> Vec<RaySet> {
        // Through transparent objects the renderer follows shadow rays from hit to hit.
        let shadow = if scene.has_transparency() { Query::Closest } else { Query::Any };
        let kept = self.kept.into_inner().unwrap_or_else(PoisonError::into_inner);
        let set = |(class, thinned): (RayClass, Thinned)| RaySet {
            class,
            query: if class == RayClass::Shadow { shadow } else { Query::Closest },
            rays: thinned.rays,
        };
        let sets = RayClass::RENDERED.into_iter().zip(kept).map(set);
        sets.filter(|set| !set.rays.is_empty()).collect()
    }
}

impl render::Observer for Recorder<'_> {
    fn tile_done(&self, _: u64, _: u64) {}

    fn cancelled(&self) -> bool {
        (self.cancelled)()
    }

    fn rays_sent(&self, class: RayClass, rays: &[Ray]) {
        let mut kept = self.kept.lock().unwrap_or_else(PoisonError::into_inner);
        kept[class as usize].extend(rays);
    }
}

/// At most so many rays, evenly spread over all that come: every second is dropped, and from then
/// on skipped, whenever there are too many.
#[derive(Debug)]
struct Thinned {
    rays: Vec<Ray>,
    limit: usize,
    step: usize,
    seen: usize,
}

impl Thinned {
    fn new(limit: usize) -> Self {
        Self { rays: Vec::new(), limit: limit.max(1), step: 1, seen: 0 }
    }

    fn extend(&mut self, rays: &[Ray]) {
        for &ray in rays {
            if self.seen.is_multiple_of(self.step) {
                if self.rays.len() == self.limit {
                    let mut place = 0;
                    self.rays.retain(|_| {
                        place += 1;
                        place % 2 == 1
                    });
                    self.step *= 2;
                }
                if self.seen.is_multiple_of(self.step) {
                    self.rays.push(ray);
                }
            }
            self.seen += 1;
        }
    }
}

/// At most `count` of some rays, evenly spread.
pub(super) fn spread(rays: &[Ray], count: usize) -> Vec<Ray> {
    let count = count.min(rays.len());
    (0..count).map(|i| rays[i * rays.len() / count]).collect()
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::*;

    fn rays(count: usize) -> Vec<Ray> {
        (0..count).map(|i| Ray::new(Vec3::splat(i as f32), Vec3::X)).collect()
    }

    #[test]
    fn what_is_kept_is_spread_over_all() {
        let mut thinned = Thinned::new(10);
        rays(95).chunks(7).for_each(|chunk| thinned.extend(chunk));
        let kept: Vec<f32> = thinned.rays.iter().map(|ray| ray.origin.x).collect();
        assert_eq!(kept, [0.0, 16.0, 32.0, 48.0, 64.0, 80.0]);
    }

    #[test]
    fn a_spread_has_as_many_as_asked() {
        let origins =
            |count| spread(&rays(9), count).iter().map(|r| r.origin.x).collect::<Vec<_>>();
        assert_eq!(origins(3), [0.0, 3.0, 6.0]);
        assert_eq!(origins(100).len(), 9);
        assert_eq!(origins(0).len(), 0);
    }
}
