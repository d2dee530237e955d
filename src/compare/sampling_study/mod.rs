//! A study of sampling: what does a random number cost, what does shuffling cost, what share of a
//! frame is either, and how much noise does each method of sampling leave?
//!
//! Costs are timed in batches (`operations.rs`). Noise is that of small frames against a converged
//! picture (`frames.rs`, `converged.rs`). The frames are timed too, on one thread as the batches
//! are, and their uses of random numbers are counted. Everything that is timed runs in interleaved
//! rounds; the frames are traced with one structure.

mod converged;
mod frames;
mod operations;

use crate::accel::BuildConfig;
use crate::record::SamplingChapter;
use crate::render::Sampling;
use crate::scene::{Light, Scene, structure_named};

use super::budget::Budget;
use super::context::SceneContext;
use super::plan::{Plan, SceneInput};
use super::pools::Pools;
use super::progress::PartProgress;
use super::rounds::Repeat;

/// The structure of all frames.
const STRUCTURE: &str = "bvh";

/// Costs take this share of the study's time.
const SHARE_OF_COSTS: f64 = 0.1;

/// A scene's converged picture takes this share of the scene's time.
const SHARE_OF_CONVERGED: f64 = 0.35;

/// What the study measured.
pub(super) struct Study {
    pub(super) chapter: SamplingChapter,
    /// What a reader should know of it.
    pub(super) notes: Vec<String>,
}

/// Studies sampling in all scenes that have an area light.
pub(super) fn sampling_study(
    plan: &Plan,
    pools: &Pools,
    budget: Budget,
    progress: &PartProgress<'_>,
) -> Study {
    let default = Sampling::default().name().to_owned();
    let mut study = Study {
        chapter: SamplingChapter { default, ..SamplingChapter::default() },
        notes: Vec::new(),
    };
    progress.step("sampling: timing random numbers", budget);
    let cancelled = || progress.cancelled();
    let repeat = Repeat::new(plan.rounds.clone(), budget.share(SHARE_OF_COSTS), &cancelled);
    study.chapter.costs = operations::measure(plan.picture.light_samples, &repeat);
    let (lit, unlit): (Vec<_>, Vec<_>) =
        plan.scenes.iter().partition(|input| has_area_light(&input.scene));
    study.notes.extend(note_left_out(&unlit));
    for (done, input) in lit.iter().enumerate() {
        if progress.cancelled() {
            break;
        }
        progress.step(&format!("{}: sampling", input.name), budget);
        let scene = &input.scene;
        let context = SceneContext { scene, plan, pools, cancelled: &cancelled };
        let share = budget.share(1.0 / (lit.len() - done) as f64);
        study_scene(&input.name, &context, share, &mut study.chapter);
    }
    study
}

fn has_area_light(scene: &Scene) -> bool {
    scene.lights.iter().any(|light| matches!(light, Light::Area { .. }))
}

fn note_left_out(unlit: &[&SceneInput]) -> Option<String> {
    let names: Vec<&str> = unlit.iter().map(|input| input.name.as_str()).collect();
    let (verb, own) = if names.len() == 1 { ("was", "it has") } else { ("were", "they have") };
    (!names.is_empty()).then(|| {
        format!(
            "{} {verb} left out of the study of sampling: {own} no area light.",
            names.join(", ")
        )
    })
}

/// Adds the measurements of one scene to the chapter; nothing if it is cancelled before there is a
/// frame.
fn study_scene(
    name: &str,
    context: &SceneContext<'_>,
    budget: Budget,
    chapter: &mut SamplingChapter,
) {
    let Some(structure) = structure_named(STRUCTURE) else { return };
    let build = || structure.build(context.scene, &BuildConfig::default());
    let world = context.pools.all.install(build);
    let Some(settings) = frames::settings(context, &*world, budget) else { return };
    let share = budget.share(SHARE_OF_CONVERGED);
    let Some(converged) = converged::render(context, &*world, &settings, share) else { return };
    let measured = frames::measure(context, &*world, &settings, &converged.picture, budget);
    chapter.converged.push(converged.record(name));
    for frame in measured {
        chapter.parts.extend(frame.parts(name, context.scene));
        chapter.noise.extend(frame.point(name));
    }
}
