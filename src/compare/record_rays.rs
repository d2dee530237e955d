//! The same rays for all structures: those of each class that a small rendering sends, recorded once.
//!
//! Which structure traces during the recording does not matter: all give the same hits, so the same
//! rays follow. The rendering runs on one thread, so that rays stand in the order in which a
//! renderer's thread sends them, and are the same in every run.

use std::sync::Mutex;
use std::sync::PoisonError;

use crate::accel::{BuildConfig, Bvh, QueryKind};
use crate::math::Ray;
use crate::record::RayClass;
use crate::render::{self, RenderStats, Settings, render};
use crate::scene::{Scene, Structure, TracedWorld};

use super::context::SceneContext;
use super::picture_size::fit_pixels;
use super::trace::RAYS_PER_CALL;

/// View samples of the small rendering that shows how many rays follow from each.
const TRIAL_SAMPLES: u32 = 2_000;

/// View samples of the recording, if few rays follow from each.
const MOST_SAMPLES: u32 = 60_000;

/// As many calls are kept at least: where fewer would be, pieces of calls are.
const FEWEST_CALLS: usize = 32;

/// The structure that traces during a recording.
pub(super) const RECORDING_STRUCTURE: Structure =
    Structure::new::<Bvh, Bvh>("bvh", "obvhs's binary tree");

/// The rays of a class.
#[derive(Clone, Debug)]
pub struct RaySet {
    /// The class.
    pub class: RayClass,
    /// The rays, in the order in which a renderer sends them.
    pub rays: Vec<Ray>,
    pub(super) query: QueryKind,
}

impl RaySet {
    /// Rays whose query is the closest hit.
    pub(super) fn closest_hit(class: RayClass, rays: Vec<Ray>) -> Self {
        Self { class, rays, query: QueryKind::ClosestHit }
    }

    /// Rays whose query is whether they hit anything.
    pub(super) fn any_hit(class: RayClass, rays: Vec<Ray>) -> Self {
        Self { class, rays, query: QueryKind::AnyHit }
    }

    /// At most `count` of its rays, evenly spread.
    #[must_use]
    pub fn spread(&self, count: usize) -> Self {
        Self { rays: spread(&self.rays, count), ..*self }
    }
}

/// The rays of a scene.
#[derive(Clone, Debug, Default)]
pub(super) struct Recording {
    /// The classes that occurred, in the order of reports.
    pub(super) sets: Vec<RaySet>,
    /// Rays of each class for a view sample of the picture.
    pub(super) per_sample: Vec<(RayClass, f64)>,
}

/// The structure that traces during a recording, built on all threads.
pub(super) fn recording_tracer(context: &SceneContext<'_>) -> Box<dyn TracedWorld> {
    let build = || RECORDING_STRUCTURE.build(context.scene, &BuildConfig::default());
    context.pools.all.install(build)
}

/// Records the rays that a renderer sends for a picture, on one thread. Tracing them all takes at most
/// `traced` rays.
pub(super) fn record(
    context: &SceneContext<'_>,
    tracer: &dyn TracedWorld,
    picture: &Settings,
    traced: u64,
) -> Recording {
    context.pools.one.install(|| {
        let trial = render_recorded(context, tracer, &small(picture, TRIAL_SAMPLES)).1;
        let per_sample = (trial.total_rays() / u64::from(TRIAL_SAMPLES)).max(1);
        let affordable = u32::try_from(traced / per_sample).unwrap_or(u32::MAX);
        let settings = small(picture, affordable.clamp(TRIAL_SAMPLES, MOST_SAMPLES));
        let (recorder, stats) = render_recorded(context, tracer, &settings);
        let samples = f64::from(settings.width * settings.height * settings.samples_per_pixel());
        let rate = |class| stats.class(class).rays as f64 / samples;
        Recording {
            sets: recorder.sets(context.scene),
            per_sample: RayClass::RENDERED.map(|class| (class, rate(class))).into(),
        }
    })
}

/// The rays that a renderer sends for a picture, on the threads of the current pool: at most so many of each class.
pub(super) fn rays_of_picture(
    scene: &Scene,
    tracer: &dyn TracedWorld,
    picture: &Settings,
    limit: usize,
) -> Vec<RaySet> {
    let recorder = Recorder::new(limit, &|| false);
    render(scene, tracer, picture, &recorder);
    recorder.sets(scene)
}

/// Renders, and records the rays on the way.
fn render_recorded<'a>(
    context: &SceneContext<'a>,
    tracer: &dyn TracedWorld,
    settings: &Settings,
) -> (Recorder<'a>, RenderStats) {
    let recorder = Recorder::new(context.plan.rays_per_class, context.cancelled);
    let stats = render(context.scene, tracer, settings, &recorder).stats;
    (recorder, stats)
}

/// The picture, so small that it takes about as many view samples.
fn small(picture: &Settings, samples: u32) -> Settings {
    let pixels = f64::from(samples / picture.samples_per_pixel()).max(1.0);
    let [width, height] = fit_pixels([picture.width, picture.height], pixels);
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
        let opaque = !scene.has_transparency();
        let kept = self.kept.into_inner().unwrap_or_else(PoisonError::into_inner);
        let set = |(class, thinned): (RayClass, Thinned)| match class {
            RayClass::Shadow if opaque => RaySet::any_hit(class, thinned.whole_calls()),
            _ => RaySet::closest_hit(class, thinned.whole_calls()),
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

/// At most so many rays, in whole calls that are evenly spread over all that are recorded: whenever there are too many,
/// every second call is dropped, and from then on skipped. Within a call rays stay as a renderer sends them.
#[derive(Debug)]
struct Thinned {
    rays: Vec<Ray>,
    /// Rays of a call, or of a piece of one where few rays are kept.
    call: usize,
    limit: usize,
    step: usize,
    seen: usize,
}

impl Thinned {
    fn new(limit: usize) -> Self {
        // Few whole calls would be a few places of the picture.
        Self::in_calls(limit, RAYS_PER_CALL.min(limit / FEWEST_CALLS))
    }

    fn in_calls(limit: usize, call: usize) -> Self {
        let call = call.max(1);
        Self { rays: Vec::new(), call, limit: limit / call * call, step: 1, seen: 0 }
    }

    fn extend(&mut self, rays: &[Ray]) {
        for &ray in rays {
            let (call, first) = (self.seen / self.call, self.seen.is_multiple_of(self.call));
            if first && call.is_multiple_of(self.step) && self.rays.len() >= self.limit.max(1) {
                let mut place = 0;
                self.rays.retain(|_| {
                    place += 1;
                    ((place - 1) / self.call).is_multiple_of(2)
                });
                self.step *= 2;
            }
            if call.is_multiple_of(self.step) {
                self.rays.push(ray);
            }
            self.seen += 1;
        }
    }

    /// The rays of whole calls: of a last call with fewer rays, kernels could not make as much.
    fn whole_calls(mut self) -> Vec<Ray> {
        if self.rays.len() > self.call {
            self.rays.truncate(self.rays.len() / self.call * self.call);
        }
        self.rays
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
    fn whole_calls_are_kept_and_spread_over_all() {
        let mut thinned = Thinned::in_calls(13, 3);
        rays(95).chunks(7).for_each(|chunk| thinned.extend(chunk));
        let kept: Vec<f32> = thinned.whole_calls().iter().map(|ray| ray.origin.x).collect();
        // Every eighth call of three rays, of which the first two are whole or the last is cut off.
        assert_eq!(kept, [0.0, 1.0, 2.0, 24.0, 25.0, 26.0, 48.0, 49.0, 50.0, 72.0, 73.0, 74.0]);
    }

    #[test]
    fn a_single_call_is_kept_even_if_it_is_not_whole() {
        let mut thinned = Thinned::in_calls(100, 10);
        thinned.extend(&rays(7));
        assert_eq!(thinned.whole_calls().len(), 7);
        let mut few = Thinned::new(40);
        few.extend(&rays(50));
        assert_eq!(few.whole_calls().len(), 25, "every second of single rays");
    }

    #[test]
    fn a_spread_has_as_many_rays_as_requested() {
        let origins =
            |count| spread(&rays(9), count).iter().map(|r| r.origin.x).collect::<Vec<_>>();
        assert_eq!(origins(3), [0.0, 3.0, 6.0]);
        assert_eq!(origins(100).len(), 9);
        assert_eq!(origins(0).len(), 0);
    }
}
