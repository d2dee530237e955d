//! The whole plan, from the first scene to the record.

use std::collections::HashSet;
use std::time::{Duration, Instant};

use rayon::ThreadPoolBuildError;
use thiserror::Error;

use crate::image_io::Picture;
use crate::record::{Comparison, Conformance, Options, Proof, Run, SceneRecord, StructureRecord};
use crate::scene::{Scene, Structure};

use super::budget::Budget;
use super::conformance::check_conformance;
use super::machine::build_of_program;
use super::observer::Observer;
use super::plan::{Plan, SceneInput};
use super::pools::Pools;
use super::progress::PartProgress;
use super::record_so_far::RecordSoFar;
use super::resume::Before;
use super::sampling_study::sampling_study;
use super::scene::compare_scene;
use super::sweep::sweep;

/// What was measured.
#[derive(Clone, Debug)]
pub struct ComparisonResult {
    /// The record.
    pub comparison: Comparison,
    /// The pictures that the record names, by the names of their files.
    pub pictures: Vec<(String, Picture)>,
}

impl ComparisonResult {
    /// Whether no structure failed: all gave the same hits and pictures wherever that was checked,
    /// in the check of conformance too, and enough of a peer's results agreed. A peer that cannot trace
    /// the scene's shapes is no failure.
    #[must_use]
    pub fn holds(&self) -> bool {
        let Comparison { conformance, scenes, sweeps, .. } = &self.comparison;
        let mut dropped = sweeps.iter().flat_map(|sweep| &sweep.dropped);
        scenes.iter().filter_map(|scene| scene.proof.as_ref()).all(Proof::holds)
            && conformance.iter().all(Conformance::holds)
            && !dropped.any(|structure| structure.failed)
            && !scenes.iter().any(|scene| scene.structures.iter().any(|row| failed(scene, row)))
    }
}

/// Whether a structure failed in a scene. Of a peer only that counts which it did after its first
/// rays.
fn failed(scene: &SceneRecord, row: &StructureRecord) -> bool {
    let traced = scene.proof.as_ref().and_then(|proof| proof.peer(&row.name));
    row.has_failed() && (!row.peer || traced.is_some())
}

/// Why a plan cannot be begun.
#[derive(Debug, Error)]
pub enum CompareError {
    /// There is nothing to compare.
    #[error("no structure was named")]
    NoStructure,
    /// Rows are distinguished by their names.
    #[error("`{name}` was named twice")]
    Twice {
        /// The name of two structures or two scenes.
        name: String,
    },
    /// Ratios are to be taken to a structure that is not compared.
    #[error("ratios cannot be taken to `{name}`, which is not compared: there are {compared}")]
    Base {
        /// The structure.
        name: String,
        /// Those that are compared.
        compared: String,
    },
    /// The system starts no threads.
    #[error("cannot start {threads} threads: {source}")]
    Threads {
        /// How many were to start.
        threads: usize,
        /// Why they did not.
        source: ThreadPoolBuildError,
    },
}

/// Compares structures by a plan. Ratios are taken to the plan's base. Structures that are not the program's own are
/// checked for conformance before that; one that differs there is not timed.
///
/// When the observer cancels, what is done until then is returned, marked as partial. A structure
/// that panics or is too slow gets a row with the reason.
///
/// # Errors
/// Before any work: without structures, with two of a name, with a base that is not among them, or if threads cannot be
/// started.
pub fn run(
    plan: &Plan,
    structures: &[Structure],
    observer: &dyn Observer,
) -> Result<ComparisonResult, CompareError> {
    check_plan(plan, structures)?;
    let base = base_name(plan, structures)?;
    let pools = Pools::start(plan.threads)
        .map_err(|(threads, source)| CompareError::Threads { threads, source })?;
    let start = Instant::now();
    let mut comparison = Comparison::new(describe(plan), base);
    let before = Before::of(plan);
    let mut parts = Parts::new(plan, observer, &before);
    // A comparison that is gone on with is of the same program: what was found then, holds for what is left.
    comparison.conformance = match before.conformance() {
        Some(checked) => checked.to_vec(),
        None => check_conformance(structures, &pools, parts.budget, observer),
    };
    let checked = comparison.conformance.clone();
    let mut record = RecordSoFar::new(plan, comparison, observer, &before, start);
    for place in cheapest_first(&plan.scenes) {
        let input = &plan.scenes[place];
        if before.scene(input).is_some() {
            continue;
        }
        let result = parts.next(|budget, progress| {
            compare_scene(input, structures, &checked, plan, &pools, budget, progress)
        });
        record.add_scene(&input.name, result);
    }
    if let Some(growth) = &plan.sweep
        && before.sweep(growth.family.name()).is_none()
    {
        let result = parts.next(|budget, progress| {
            sweep(growth, structures, &checked, plan, &pools, budget, progress)
        });
        record.add_sweep(result);
    }
    if plan.sampling_study && before.study().is_none() {
        let result = parts.next(|budget, progress| sampling_study(plan, &pools, budget, progress));
        record.add_study(result);
    }
    Ok(record.finish())
}

/// The order in which scenes are measured: those that take the least time first, so that what they leave of their
/// shares goes to those that need more. The number of what is to be hit says roughly which these are.
fn cheapest_first(scenes: &[SceneInput]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..scenes.len()).collect();
    let primitives = |scene: &Scene| scene.triangle_count() + scene.objects.len() as u64;
    order.sort_by_key(|&place| primitives(&scenes[place].scene));
    order
}

/// The parts of a plan, one after the other: its scenes, the sweep, the study of sampling.
struct Parts<'a> {
    plan: &'a Plan,
    observer: &'a dyn Observer,
    budget: Budget,
    count: usize,
    done: usize,
}

impl<'a> Parts<'a> {
    /// What was done before has had its time; that of the others begins.
    fn new(plan: &'a Plan, observer: &'a dyn Observer, before: &Before<'_>) -> Self {
        let others = usize::from(plan.sweep.is_some()) + usize::from(plan.sampling_study);
        let scenes = plan.scenes.iter().filter(|input| before.scene(input).is_some()).count();
        let sweep = plan.sweep.as_ref().and_then(|own| before.sweep(own.family.name()));
        let study = before.study().filter(|_| plan.sampling_study);
        let done = scenes + usize::from(sweep.is_some()) + usize::from(study.is_some());
        let spent = Duration::try_from_secs_f64(before.seconds()).unwrap_or_default();
        let budget = Budget::from_now(plan.budget.map(|whole| whole.saturating_sub(spent)));
        Self { plan, observer, budget, count: plan.scenes.len() + others, done }
    }

    /// Does the next part; `None` if the comparison is cancelled before it.
    fn next<T>(&mut self, work: impl FnOnce(Budget, &PartProgress<'_>) -> T) -> Option<T> {
        if self.observer.cancelled() {
            return None;
        }
        let share_of_plan = |parts: usize| parts as f64 / self.count as f64;
        let (from, to) = (share_of_plan(self.done), share_of_plan(self.done + 1));
        let progress = PartProgress { observer: self.observer, from, to };
        let budget = self.budget_of_part();
        self.done += 1;
        Some(progress.watch(budget, || work(budget, &progress)))
    }

    /// An even share of what is left for each of the parts that are left, but never less than half
    /// of an even share of the whole: a part that took too long takes nothing beyond that from
    /// others.
    fn budget_of_part(&self) -> Budget {
        let Some(whole) = self.plan.budget else { return Budget::from_now(None) };
        let left = self.count - self.done;
        let share = self.budget.left().div_f64(left.max(1) as f64);
        let floor = whole.div_f64(2.0 * self.count.max(1) as f64);
        Budget::from_now(Some(share.max(floor)))
    }
}

/// Whether a plan can be begun with these structures, as far as that is known without threads.
///
/// # Errors
/// Without structures, with two of a name, or with a base that is not among them.
pub fn check_plan(plan: &Plan, structures: &[Structure]) -> Result<(), CompareError> {
    check_names(plan, structures)?;
    base_name(plan, structures).map(|_| ())
}

/// The structure that ratios are taken to: the plan's, or `none` if it is among them, or the first.
fn base_name(plan: &Plan, structures: &[Structure]) -> Result<&'static str, CompareError> {
    let named = |name: &str| structures.iter().find(|structure| structure.name == name);
    let Some(name) = &plan.base else {
        return Ok(named("none").or(structures.first()).map_or("", |base| base.name));
    };
    named(name).map(|base| base.name).ok_or_else(|| {
        let compared: Vec<&str> = structures.iter().map(|structure| structure.name).collect();
        CompareError::Base { name: name.clone(), compared: compared.join(", ") }
    })
}

/// There must be a structure, and no two structures or scenes of one name.
fn check_names(plan: &Plan, structures: &[Structure]) -> Result<(), CompareError> {
    if structures.is_empty() {
        return Err(CompareError::NoStructure);
    }
    check_unique(structures.iter().map(|structure| structure.name))?;
    check_unique(plan.scenes.iter().map(|scene| scene.name.as_str()))
}

fn check_unique<'a>(names: impl Iterator<Item = &'a str>) -> Result<(), CompareError> {
    let mut seen = HashSet::new();
    for name in names {
        if !seen.insert(name) {
            return Err(CompareError::Twice { name: name.to_owned() });
        }
    }
    Ok(())
}

/// How a plan is run, before it is: program, machine, options.
#[must_use]
pub fn describe(plan: &Plan) -> Run {
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
        between_runs: plan.between_runs,
        ..build_of_program()
    }
}
