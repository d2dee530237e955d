//! A record against an older one: what became slower, what faster, and how sure that is.

use serde::{Deserialize, Serialize};

use super::derived::own_ns_per_ray;
use super::statistics::{Estimate, unpaired_ratio};
use super::{ClassRecord, Comparison, RayClass, Run};

/// What came of setting a comparison against an older one.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Baseline {
    /// How much slower is a regression: 0.1 is 10 %.
    pub threshold: f64,
    /// What changed.
    pub outcome: Changes,
}

/// One scene, structure and class that both records have.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Change {
    /// The name of the scene.
    pub scene: String,
    /// The structure.
    pub structure: String,
    /// The class of rays.
    pub class: RayClass,
    /// New time over old time, ray for ray: above 1 is slower.
    pub slowdown: Estimate,
}

/// What changed from an old record to a new one.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Changes {
    /// All that can be compared, in the new record's order.
    pub changes: Vec<Change>,
    /// Why none of it says anything of the program, one sentence each: another processor, other
    /// rays.
    pub warnings: Vec<String>,
    /// Why some of it should be doubted, one sentence each: other settings, changed scenes, things
    /// that only one record has.
    pub doubts: Vec<String>,
}

impl Changes {
    /// Compares a new record with an old one. Scenes whose files changed are not compared.
    #[must_use]
    pub fn between(old: &Comparison, new: &Comparison) -> Self {
        let mut this = Self {
            changes: Vec::new(),
            warnings: run_warnings(&old.run, &new.run),
            doubts: run_doubts(&old.run, &new.run),
        };
        for scene in &new.scenes {
            let Some(old_scene) = old.scenes.iter().find(|old| old.name == scene.name) else {
                this.doubts.push(format!("The baseline has no scene {}.", scene.name));
                continue;
            };
            if old_scene.hash != scene.hash {
                let doubt = format!("The scene {} has changed and is not compared.", scene.name);
                this.doubts.push(doubt);
                continue;
            }
            for structure in &scene.structures {
                for class in &structure.classes {
                    let old = old_scene.structure(&structure.name);
                    let old = old.and_then(|old| old.class(class.class));
                    this.add(&scene.name, &structure.name, old, class);
                }
            }
        }
        this.doubts.extend(missing(old, new));
        this
    }

    fn add(&mut self, scene: &str, structure: &str, old: Option<&ClassRecord>, new: &ClassRecord) {
        let place = format!("{} rays of {scene} with {structure}", new.class.name());
        let Some(old) = old else {
            self.doubts.push(format!("The baseline has no {place}."));
            return;
        };
        if old.rays != new.rays {
            self.doubts.push(format!(
                "{} {place} were traced where the baseline traced {}: compared ray for ray.",
                new.rays, old.rays
            ));
        }
        let times = |class: &ClassRecord| own_ns_per_ray(&class.rounds, class.rays);
        if let Some(slowdown) = unpaired_ratio(&times(new), &times(old)) {
            self.changes.push(Change {
                scene: scene.to_owned(),
                structure: structure.to_owned(),
                class: new.class,
                slowdown,
            });
        }
    }

    /// What became slower by more than `threshold` (0.1 is 10 %) for sure: the whole interval of
    /// the slowdown lies above `1 + threshold`. Without an interval nothing is sure.
    pub fn regressions(&self, threshold: f64) -> impl Iterator<Item = &Change> {
        let beyond = move |change: &&Change| {
            change.slowdown.interval.is_some_and(|i| i.low > 1.0 + threshold)
        };
        self.changes.iter().filter(beyond)
    }

    /// What became faster by more than `threshold` for sure: the whole interval of the slowdown
    /// lies below `1 / (1 + threshold)`.
    pub fn improvements(&self, threshold: f64) -> impl Iterator<Item = &Change> {
        let bound = 1.0 / (1.0 + threshold);
        let beyond =
            move |change: &&Change| change.slowdown.interval.is_some_and(|i| i.high < bound);
        self.changes.iter().filter(beyond)
    }
}

/// What the old record measured and the new one did not: it may have failed or become too slow.
fn missing(old: &Comparison, new: &Comparison) -> Vec<String> {
    let mut doubts = Vec::new();
    for scene in &old.scenes {
        let Some(new_scene) = new.scenes.iter().find(|new| new.name == scene.name) else {
            doubts.push(format!("The scene {} of the baseline was not measured.", scene.name));
            continue;
        };
        for structure in scene.structures.iter().filter(|structure| !structure.classes.is_empty()) {
            let new = new_scene.structure(&structure.name);
            if new.is_none_or(|new| new.classes.is_empty()) {
                let (structure, scene) = (&structure.name, &scene.name);
                doubts
                    .push(format!("{structure} was not measured in {scene}, but in the baseline."));
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

/// Differences between the runs that make times those of something else.
fn run_warnings(old: &Run, new: &Run) -> Vec<String> {
    let processor = ("processor", old.machine.cpu.clone(), new.machine.cpu.clone());
    let seed = ("seed", old.seed.to_string(), new.seed.to_string());
    let mut warnings = differences(vec![processor], " Times of two machines say nothing of srt.");
    warnings.extend(differences(vec![seed], " The rays are others."));
    warnings
}

/// A sentence of each fact that differs, and what follows from it.
fn differences(facts: Vec<(&str, String, String)>, consequence: &str) -> Vec<String> {
    let differs = |(_, old, new): &(&str, String, String)| old != new;
    let sentence = |(name, old, new)| format!("The {name} was {old} and is {new}.{consequence}");
    facts.into_iter().filter(differs).map(sentence).collect()
}
