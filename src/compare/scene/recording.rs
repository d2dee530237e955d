//! The second step: records the rays, or takes them from a file, and tries how long each structure takes for one of
//! each class.

use crate::accel::Tracer;
use crate::compare::candidate::Candidate;
use crate::compare::context::SceneContext;
use crate::compare::extra_rays::{FirstHits, probe_rays, random_rays};
use crate::compare::ray_exchange::{file_of, sets_of};
use crate::compare::record_rays::{RaySet, record, recording_tracer};
use crate::compare::trial::{RayTimes, ray_times};
use crate::ray_file::RayFile;
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
    /// The sets as a file, if they were recorded and the plan wants that.
    pub(super) file: Option<RayFile>,
}

/// Records the classes that a renderer sends and the extra classes of the plan, or takes those of a file. How many rays
/// follow from a view sample is recorded in any case.
pub(super) fn record_rays(
    context: &SceneContext<'_>,
    candidates: &mut [Candidate<'_>],
    replayed: Option<&RayFile>,
) -> SceneRays {
    let tracer = recording_tracer(context);
    let recording = record(context, &*tracer, &context.picture_settings(), TRACED);
    let mut sets = match replayed {
        Some(file) => sets_of(file),
        None => with_extra_classes(context, &*tracer, recording.sets),
    };
    sets.retain(|set| !set.rays.is_empty());
    let kept = replayed.is_none() && context.plan.keep_rays;
    let file = kept.then(|| file_of(context.scene, &*tracer, &sets));
    let times = candidates.iter_mut().map(|candidate| ray_times(candidate, &sets)).collect();
    SceneRays { sets, per_sample: recording.per_sample, times, file }
}

/// What a renderer sends, and the extra classes of the plan.
fn with_extra_classes(
    context: &SceneContext<'_>,
    tracer: &dyn Tracer,
    mut sets: Vec<RaySet>,
) -> Vec<RaySet> {
    let seed = context.picture_settings().seed;
    let classes = &context.plan.classes;
    if classes.contains(&RayClass::Diffuse)
        && let Some(view) = sets.iter().find(|set| set.class == RayClass::View)
    {
        let diffuse = FirstHits::new(context.scene, tracer, view).diffuse_rays(seed);
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
    sets
}
