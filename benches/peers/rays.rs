//! The rays of each class through a scene, and the time that tracers take for them.

use srt::accel::Tracer;
use srt::compare::measure::{FirstHits, RaySet, fixed_rounds, probe_rays, timed, view_rays};
use srt::glam::Vec3;
use srt::record::RayClass;
use srt::scene::Scene;

/// The classes that can be measured, in the order of the tables.
pub(crate) const CLASSES: [RayClass; 5] =
    [RayClass::View, RayClass::Shadow, RayClass::Diffuse, RayClass::Mirror, RayClass::Probe];

/// Rays in a call.
const RAYS_PER_CALL: usize = 4096;

const SEED: u64 = 1;

/// A set for each of [`CLASSES`], with the rays of all views: a view ray through each pixel's centre; from what these
/// hit, shadow rays to a point light, diffuse and mirror rays; as many parallel rays along an axis as pixels.
pub(crate) fn ray_sets(views: &[(Scene, Vec3)], tracer: &dyn Tracer) -> Vec<RaySet> {
    let of_views = views.iter().map(|(scene, light)| sets_of_view(scene, tracer, *light));
    let joined = of_views.reduce(|mut sets, more| {
        for (set, more) in sets.iter_mut().zip(more) {
            set.rays.extend(more.rays);
        }
        sets
    });
    joined.unwrap_or_default()
}

fn sets_of_view(scene: &Scene, tracer: &dyn Tracer, light: Vec3) -> Vec<RaySet> {
    let view = view_rays(scene);
    let hits = FirstHits::new(scene, tracer, &view);
    let (shadow, diffuse, mirror) =
        (hits.shadow_rays(light), hits.diffuse_rays(SEED), hits.mirror_rays());
    let probe = probe_rays(scene, scene.camera.width, scene.camera.height);
    vec![view, shadow, diffuse, mirror, probe]
}

/// Seconds for all rays of a set: for each tracer, one for each round.
pub(crate) fn seconds(tracers: &[&dyn Tracer], set: &RaySet, rounds: usize) -> Vec<Vec<f64>> {
    let mut results = set.results();
    fixed_rounds(tracers.len(), rounds, |index| {
        let trace = || {
            for rays in set.rays.chunks(RAYS_PER_CALL) {
                results.trace(tracers[index], rays);
            }
        };
        timed(trace).1.own_ns() as f64 / 1e9
    })
}
