//! One scene, step by step: the table of contents of its measurements.
//!
//! Each step takes what it needs and returns what it made: first what proves, then what measures.

mod build_times;
mod building;
mod comparing_hits;
mod heatmaps;
mod overlap;
mod picture_times;
mod recording;
mod rendering;

use crate::image_io::Picture;
use crate::ray_file::RayFile;
use crate::record::{Conformance, PictureFile, SceneRecord};
use crate::scene::Structure;

use super::budget::Budget;
use super::candidate::Candidate;
use super::context::SceneContext;
use super::picture_file::{heatmap_name, picture_file, picture_name};
use super::plan::{Plan, SceneInput};
use super::pools::Pools;
use super::progress::PartProgress;
use super::ray_exchange::record_of;
use super::replay::replay_all;

/// What was measured in a scene.
pub(super) struct SceneResult {
    pub(super) record: SceneRecord,
    /// Pictures by the names of their files.
    pub(super) pictures: Vec<(String, Picture)>,
    /// What a reader should know of it.
    pub(super) notes: Vec<String>,
}

/// Compares structures in a scene. `checked` is what the check of conformance showed.
pub(super) fn compare_scene(
    input: &SceneInput,
    structures: &[Structure],
    checked: &[Conformance],
    plan: &Plan,
    pools: &Pools,
    budget: Budget,
    progress: &PartProgress<'_>,
) -> SceneResult {
    let cancelled = || progress.cancelled();
    let context = SceneContext { scene: &input.scene, plan, pools, cancelled: &cancelled };
    let candidate = |structure| Candidate::new(structure).judged_by(checked);
    let mut candidates: Vec<Candidate<'_>> = structures.iter().map(candidate).collect();
    let mut result = SceneResult::of(input);
    let begin = |step: &str| {
        let goes_on = !progress.cancelled();
        if goes_on {
            progress.step(&format!("{}: {step}", input.name), budget);
        }
        goes_on.then_some(())
    };
    let keep = |file: &RayFile| progress.observer.rays_recorded(&input.name, file);
    // `None` if it was cancelled: what was made until then stays.
    let _ = take_steps(&context, &mut candidates, budget, begin, keep, &mut result);
    if progress.cancelled() {
        candidates.iter_mut().for_each(Candidate::mark_stopped);
    }
    result.record.structures = candidates.into_iter().map(|own| own.record).collect();
    result
}

/// All steps, in their order. `begin` is given a step's name, and returns `None` to end before it; `keep` gets the rays
/// that are to be kept.
fn take_steps(
    context: &SceneContext<'_>,
    candidates: &mut [Candidate<'_>],
    budget: Budget,
    begin: impl Fn(&str) -> Option<()>,
    keep: impl Fn(&RayFile),
    result: &mut SceneResult,
) -> Option<()> {
    begin("building")?;
    building::build_all(context, candidates);
    begin("recording rays")?;
    let replayed = context.plan.replayed.get(&result.record.name);
    let mut rays = recording::record_rays(context, candidates, replayed);
    let recorded = rays.file.take();
    recorded.iter().for_each(keep);
    let file = replayed.or(recorded.as_ref());
    result.record.rays = file.map(|file| record_of(file, replayed.is_some()));
    drop(recorded);
    begin("comparing hits")?;
    result.record.proof = comparing_hits::compare_hits(context, candidates, &rays, budget);
    // Its hits in this scene are worth knowing, its times are not.
    candidates.iter_mut().for_each(Candidate::fail_if_unfit);
    begin("rendering")?;
    let proof = result.record.proof.as_mut();
    let rendered = rendering::render_all(context, candidates, &rays, proof, budget);
    result.add_picture(rendered.picture);
    result.add_notes(rendered.notes);
    begin("drawing heatmaps")?;
    let heatmaps = heatmaps::draw_all(context, candidates, &rays, budget);
    result.add_notes(heatmaps.notes);
    result.record.heat_scale = heatmaps.scale;
    for (index, picture) in heatmaps.pictures {
        let file = heatmap_name(&result.record.name, candidates[index].name());
        candidates[index].record.heatmap = Some(result.keep(file, picture));
    }
    begin("measuring overlap")?;
    result.add_notes(overlap::measure(context, candidates, budget));
    begin("timing builds")?;
    build_times::measure(context, candidates, budget.share(0.25));
    begin("timing rays")?;
    let replayed = replay_all(context, candidates, &rays.sets, &rays.times, budget);
    result.record.built_anew = replayed.built_anew;
    replayed.whole.then_some(())
}

impl SceneResult {
    /// The scene, of which nothing has been measured.
    fn of(input: &SceneInput) -> Self {
        let record = SceneRecord {
            name: input.name.clone(),
            path: input.path.clone(),
            hash: input.hash.clone(),
            objects: input.scene.objects.len() as u64,
            triangles: input.scene.triangle_count(),
            stored_triangles: input.scene.stored_triangle_count(),
            lights: input.scene.lights.len() as u64,
            ..SceneRecord::default()
        };
        Self { record, pictures: Vec::new(), notes: Vec::new() }
    }

    /// Takes the scene's picture, if it was rendered.
    fn add_picture(&mut self, picture: Option<Picture>) {
        let file = picture_name(&self.record.name);
        self.record.picture = picture.map(|picture| self.keep(file, picture));
    }

    /// Keeps a picture for its file.
    fn keep(&mut self, file: String, picture: Picture) -> PictureFile {
        let entry = picture_file(file.clone(), &picture);
        self.pictures.push((file, picture));
        entry
    }

    /// Takes what a step notes, behind the name of the scene.
    fn add_notes(&mut self, notes: impl IntoIterator<Item = String>) {
        let name = &self.record.name;
        self.notes.extend(notes.into_iter().map(|note| format!("{name}: {note}")));
    }
}
