//! A record against an older one: what became slower, what faster, at 95 % confidence.

use super::class::ray_times;
use super::statistics::{BetweenRuns, unpaired_ratio_of_estimates};
use crate::record::{Baseline, Change, Changes, ClassRecord, Comparison, Run, SceneRecord};

/// What follows where rays differ.
const OTHER_RAYS: &str = " The two runs traced different rays.";

/// Compares a new record with an old one. Scenes whose files changed are not compared. A change is a regression above
/// a slowdown of `threshold`: 0.1 is 10 %.
#[must_use]
pub fn compare(old: &Comparison, new: &Comparison, threshold: f64) -> Baseline {
    let mut changes = Changes {
        changes: Vec::new(),
        warnings: run_warnings(&old.run, &new.run),
        doubts: run_doubts(&old.run, &new.run),
    };
    // Both runs are of one machine, whichever of them says how its runs differ.
    let deviation = old.run.between_runs.max(new.run.between_runs);
    let between_runs = BetweenRuns(deviation).of_two_runs();
    for scene in &new.scenes {
        let Some(old_scene) = old.scenes.iter().find(|old| old.name == scene.name) else {
            changes.doubts.push(format!("The baseline has no scene {}.", scene.name));
            continue;
        };
        if old_scene.hash != scene.hash {
            let doubt = format!("The scene {} has changed and is not compared.", scene.name);
            changes.doubts.push(doubt);
            continue;
        }
        changes.warnings.extend(other_rays(old_scene, scene));
        for structure in &scene.structures {
            for class in &structure.classes {
                let old = old_scene.structure(&structure.name);
                let old = old.and_then(|old| old.class(class.class));
                let name = (scene.name.as_str(), structure.name.as_str());
                add(&mut changes, name, old, class, between_runs);
            }
        }
    }
    changes.doubts.extend(missing(old, new));
    Baseline { threshold, outcome: changes }
}

/// The changes that are slower by more than the threshold at 95 % confidence: the whole interval of the slowdown lies
/// above 1 + threshold. A change without an interval is not among them.
pub fn regressions(baseline: &Baseline) -> impl Iterator<Item = &Change> {
    let bound = 1.0 + baseline.threshold;
    let is_slower = move |change: &&Change| change.slowdown.interval.is_some_and(|i| i.low > bound);
    baseline.outcome.changes.iter().filter(is_slower)
}

/// The changes that are faster by more than the threshold at 95 % confidence: the whole interval of the slowdown lies
/// below 1 / (1 + threshold).
pub fn improvements(baseline: &Baseline) -> impl Iterator<Item = &Change> {
    let bound = 1.0 / (1.0 + baseline.threshold);
    let is_faster =
        move |change: &&Change| change.slowdown.interval.is_some_and(|i| i.high < bound);
    baseline.outcome.changes.iter().filter(is_faster)
}

fn add(
    changes: &mut Changes,
    (scene, structure): (&str, &str),
    old: Option<&ClassRecord>,
    new: &ClassRecord,
    between_runs: BetweenRuns,
) {
    let what = format!("{} rays of {scene} with {structure}", new.class.name());
    let Some(old) = old else {
        changes.doubts.push(format!("The baseline has no {what}."));
        return;
    };
    let recorded = new.recorded_rays();
    if old.recorded_rays() != recorded {
        changes.doubts.push(format!(
            "{recorded} {what} were recorded, {} in the baseline; times per ray are compared.",
            old.recorded_rays()
        ));
    }
    if let Some(slowdown) = unpaired_ratio_of_estimates(&ray_times(new), &ray_times(old)) {
        changes.changes.push(Change {
            scene: scene.to_owned(),
            structure: structure.to_owned(),
            class: new.class,
            slowdown: between_runs.widen(slowdown),
        });
    }
}

/// That both records name the rays of a scene, and these are not the same.
fn other_rays(old: &SceneRecord, new: &SceneRecord) -> Option<String> {
    let hash = |scene: &SceneRecord| scene.rays.as_ref().map(|rays| rays.hash.clone());
    let (old, own) = (hash(old)?, hash(new)?);
    let name = &new.name;
    (old != own)
        .then(|| format!("The rays of {name} had the hash {old} and have {own}.{OTHER_RAYS}"))
}

/// What only the old record measured: the structure may have failed or become too slow, for one class of rays or for
/// all.
fn missing(old: &Comparison, new: &Comparison) -> Vec<String> {
    let mut doubts = Vec::new();
    for scene in &old.scenes {
        let Some(new_scene) = new.scenes.iter().find(|new| new.name == scene.name) else {
            doubts.push(format!("The scene {} of the baseline was not measured.", scene.name));
            continue;
        };
        for structure in scene.structures.iter().filter(|structure| !structure.classes.is_empty()) {
            let new = new_scene.structure(&structure.name);
            let is_missing =
                |class: &&ClassRecord| new.is_none_or(|new| new.class(class.class).is_none());
            let classes: Vec<&str> =
                structure.classes.iter().filter(is_missing).map(|own| own.class.name()).collect();
            if !classes.is_empty() {
                let (structure, scene) = (&structure.name, &scene.name);
                doubts.push(format!(
                    "The baseline measured {} rays of {scene} with {structure}; the new run did not.",
                    classes.join(", ")
                ));
            }
        }
    }
    doubts
}

/// Differences between the runs that change times by themselves.
fn run_doubts(old: &Run, new: &Run) -> Vec<String> {
    let (old_machine, new_machine) = (&old.machine, &new.machine);
    let facts = [
        ("number of cores", old_machine.cores.to_string(), new_machine.cores.to_string()),
        (
            "instruction set",
            old_machine.instruction_set.clone(),
            new_machine.instruction_set.clone(),
        ),
        ("compiler", old.compiler.clone(), new.compiler.clone()),
        ("build profile", old.profile.clone(), new.profile.clone()),
        (
            "number of tracing threads",
            old.options.trace_threads.to_string(),
            new.options.trace_threads.to_string(),
        ),
        ("quality of builds", old.options.build.clone(), new.options.build.clone()),
    ];
    differences(facts.into(), "")
}

/// Differences between the runs after which their times measure different things.
fn run_warnings(old: &Run, new: &Run) -> Vec<String> {
    let processor = ("processor", old.machine.cpu.clone(), new.machine.cpu.clone());
    let seed = ("seed", old.seed.to_string(), new.seed.to_string());
    let other_machine = " Times of two machines do not show a change of srt.";
    let mut warnings = differences(vec![processor], other_machine);
    warnings.extend(differences(vec![seed], OTHER_RAYS));
    warnings
}

/// A sentence for each fact that differs, with its consequence.
fn differences(facts: Vec<(&str, String, String)>, consequence: &str) -> Vec<String> {
    let differs = |(_, old, new): &(&str, String, String)| old != new;
    let sentence = |(name, old, new)| format!("The {name} was {old} and is {new}.{consequence}");
    facts.into_iter().filter(differs).map(sentence).collect()
}
