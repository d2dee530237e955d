//! The whole plan, from the first scene to the record.

use std::collections::HashSet;
use std::time::Instant;

use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};
use thiserror::Error;

use crate::image_io::Picture;
use crate::record::{Comparison, Options, Proof, Run, SceneRecord, Status, StructureRecord};
use crate::scene::Structure;

use super::Pools;
use super::budget::Budget;
use super::machine::build_of_program;
use super::observer::Observer;
use super::plan::Plan;
use super::progress::Progress;
use super::sampling_study::sampling_study;
use super::scene::{base_name, compare_scene};
use super::sweep::sweep;

/// What came of a plan.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// The record.
    pub comparison: Comparison,
    /// The pictures that the record names, by the names of their files.
    pub pictures: Vec<(String, Picture)>,
}

impl Outcome {
    /// Whether no structure failed: all gave the same hits and pictures wherever that was checked,
    /// and enough of a yardstick's agreed. (One that does not know the scene's shapes is no failure.)
    #[must_use]
    pub fn holds(&self) -> bool {
        let scenes = &self.comparison.scenes;
        let asked = |scene: &SceneRecord, row: &StructureRecord| {
            let traced = scene.proof.as_ref().and_then(|proof| proof.peer(&row.name));
            !row.peer || traced.is_some()
        };
        let failed = |row: &StructureRecord| matches!(row.status, Status::Failed { .. });
        let mut dropped = self.comparison.sweeps.iter().flat_map(|sweep| &sweep.dropped);
        scenes.iter().filter_map(|scene| scene.proof.as_ref()).all(Proof::holds)
            && !dropped.any(|structure| structure.failed)
            && !scenes
                .iter()
                .any(|scene| scene.structures.iter().any(|row| failed(row) && asked(scene, row)))
    }
}

/// Why a plan cannot be begun.
#[derive(Debug, Error)]
pub enum CompareError {
    /// There is nothing to compare.
    #[error("no structure was named")]
    NoStructure,
    /// Rows are told apart by name.
    #[error("`{name}` was named twice")]
    Twice {
        /// The name of two structures or two scenes.
        name: String,
    },
    /// The system gives no threads.
    #[error("cannot start {threads} threads: {source}")]
    Threads {
        /// How many were asked for.
        threads: usize,
        /// Why not.
        source: ThreadPoolBuildError,
    },
}

/// Compares structures as a plan says. Ratios are taken to `none` if it is among them, else to the
/// first.
///
/// When the observer cancels, what is done until then is returned, marked as partial. A structure
/// that panics or is too slow is a row that says so.
///
/// # Errors
/// Before any work: without structures, with two of a name, or if threads cannot be started.
pub fn run(
    plan: &Plan,
    structures: &[Structure],
    observer: &dyn Observer,
) -> Result<Outcome, CompareError> {
    if structures.is_empty() {
        return Err(CompareError::NoStructure);
    }
    refuse_twins(structures.iter().map(|structure| structure.name))?;
    refuse_twins(plan.scenes.iter().map(|scene| scene.name.as_str()))?;
    let pools = Pools { one: pool(1)?, all: pool(plan.threads)? };
    let start = Instant::now();
    let mut comparison = Comparison::new(describe(plan), base_name(structures));
    let mut pictures = Vec::new();
    let budget = Budget::from_now(plan.budget);
    let parts =
        plan.scenes.len() + usize::from(plan.sweep.is_some()) + usize::from(plan.sampling_study);
    for (done, input) in plan.scenes.iter().enumerate() {
        if observer.cancelled() {
            break;
        }
        let from = done as f64 / parts as f64;
        let to = (done + 1) as f64 / parts as f64;
        let progress = Progress { observer, from, to };
        let share = scene_budget(plan, budget, parts, parts - done);
        let outcome = progress
            .watch(share, || compare_scene(input, structures, plan, &pools, share, &progress));
        comparison.scenes.push(outcome.record);
        comparison.notes.extend(outcome.notes);
        pictures.extend(outcome.pictures);
    }
    if let Some(growth) = plan.sweep.as_ref().filter(|_| !observer.cancelled()) {
        let done = plan.scenes.len();
        let from = done as f64 / parts as f64;
        let to = (done + 1) as f64 / parts as f64;
        let progress = Progress { observer, from, to };
        let share = scene_budget(plan, budget, parts, parts - done);
        let work = || sweep(growth, structures, plan, &pools, share, &progress);
        comparison.sweeps.push(progress.watch(share, work));
    }
    if plan.sampling_study && !observer.cancelled() {
        let progress = Progress { observer, from: (parts - 1) as f64 / parts as f64, to: 1.0 };
        let share = scene_budget(plan, budget, parts, 1);
        let work = || sampling_study(plan, &pools, share, &progress);
        let study = progress.watch(share, work);
        comparison.sampling = Some(study.chapter);
        comparison.notes.extend(study.notes);
    }
    comparison.run.partial = observer.cancelled();
    comparison.run.elapsed_seconds = start.elapsed().as_secs_f64();
    comparison.notes.extend(general_notes());
    Ok(Outcome { comparison, pictures })
}

/// An even share of what is left for each of the scenes that are left, but never less than half of
/// an even share of the whole: a scene that took too long takes nothing beyond that from others.
fn scene_budget(plan: &Plan, budget: Budget, parts: usize, left: usize) -> Budget {
    let Some(whole) = plan.budget else { return Budget::from_now(None) };
    let share = budget.left().div_f64(left.max(1) as f64);
    let floor = whole.div_f64(2.0 * parts.max(1) as f64);
    Budget::from_now(Some(share.max(floor)))
}

fn pool(threads: usize) -> Result<ThreadPool, CompareError> {
    let pool = ThreadPoolBuilder::new().num_threads(threads).build();
    pool.map_err(|source| CompareError::Threads { threads, source })
}

fn refuse_twins<'a>(names: impl Iterator<Item = &'a str>) -> Result<(), CompareError> {
    let mut seen = HashSet::new();
    for name in names {
        if !seen.insert(name) {
            return Err(CompareError::Twice { name: name.to_owned() });
        }
    }
    Ok(())
}

/// What the record says of the run before it is done.
fn describe(plan: &Plan) -> Run {
    Run {
        command: plan.command.clone(),
        date: jiff::Zoned::now().strftime("%Y-%m-%dT%H:%M:%S%:z").to_string(),
        seed: plan.picture.seed,
        budget_seconds: plan.budget.map(|budget| budget.as_secs_f64()),
        options: Options {
            threads: u32::try_from(plan.threads).unwrap_or(u32::MAX),
            trace_threads: 1,
            size: plan.picture.size,
            aa: plan.picture.aa,
            light_samples: plan.picture.light_samples,
            max_recursion: plan.picture.max_recursion,
            sampling: plan.picture.sampling.name().to_owned(),
            build: plan.build.quality.name().to_owned(),
        },
        rounds: plan.rounds.clone(),
        ..build_of_program()
    }
}

fn general_notes() -> Vec<String> {
    vec![
        "Rays were replayed on one thread, in calls of 1024 as a renderer's waves send them."
            .into(),
        "A structure that had no time for all recorded rays of a class traced as many as its row \
         says, evenly spread over them. Its ratio to the base is that of the rays that both \
         traced, in every round; its nanoseconds per ray are those of its own rays, which lie \
         further apart than all of them, and carry the uncertainty of the choice beside that of \
         the rounds."
            .into(),
    ]
}
