//! The second step: records the rays, and tries how long each structure takes for one of each class.

use crate::compare::candidate::Candidate;
use crate::compare::context::SceneContext;
use crate::compare::extra_rays::{FirstHits, probe_rays, random_rays};
use crate::compare::record_rays::{RaySet, record, recording_tracer};
use crate::compare::trial::{RayTimes, ray_times};
use crate::record::RayClass;

/// Rays that the recording may trace, whatever the budget: figures are of the rays, so these must not depend on it.
const TRACED: u64 = 200_000;

/// Rays of a class that no renderer sends, at most.
const MOST_EXTRA_RAYS: usize = 50_000;

/// The rays of a scene.
pub(super) struct SceneRays {
    /// A set for each class that occurred and each extra one of the plan.
    pub(super) sets: Vec<RaySet>,
    /// Rays of each class for a view sample of the picture.
    pub(super) per_sample: Vec<(RayClass, f64)>,
    /// For each structure, the time of a ray of each set.
    pub(super) times: Vec<RayTimes>,
}

/// Records the classes that a renderer sends and the extra classes of the plan.
pub(super) fn record_rays(
    context: &SceneContext<'_>,
    candidates: &mut [Candidate<'_>],
) -> SceneRays {
    let tracer = recording_tracer(context);
    let settings = context.picture_settings();
    let recording = record(context, &*tracer, &settings, TRACED);
    let mut sets = recording.sets;
    let seed = settings.seed;
    let classes = &context.plan.classes;
    if classes.contains(&RayClass::Diffuse)
        && let Some(view) = sets.iter().find(|set| set.class == RayClass::View)
    {
        let diffuse = FirstHits::new(context.scene, &*tracer, view).diffuse_rays(seed);
        sets.push(diffuse);
    }
    let count = context.plan.rays_per_class.min(MOST_EXTRA_RAYS);
    if classes.contains(&RayClass::Random) {
        sets.push(random_rays(context.scene, count, seed));
    }
    if classes.contains(&RayClass::Probe) {
        let side = count.isqrt() as u32;
        sets.push(probe_rays(context.scene, side, side));
    }
    sets.retain(|set| !set.rays.is_empty());
    let times = candidates.iter_mut().map(|candidate| ray_times(candidate, &sets)).collect();
    SceneRays { sets, per_sample: recording.per_sample, times }
}
