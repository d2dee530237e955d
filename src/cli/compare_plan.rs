//! What was typed for `srt compare` → the plan of the comparison.

use std::collections::BTreeMap;
use std::time::Duration;

use super::compare_args::CompareArguments;
use crate::accel::BuildConfig;
use crate::compare::{PictureOptions, Plan, SceneInput, SweepPlan};
use crate::ray_file::RayFile;
use crate::record::RayClass;

/// The default budget: seconds for each scene, for all scenes at most, for a sweep, and for a study of
/// sampling.
const SECONDS_A_SCENE: u64 = 30;
const MOST_SECONDS: u64 = 150;
const SECONDS_A_SWEEP: u64 = 60;
const SECONDS_A_STUDY: u64 = 60;

/// Fewer seconds than this for a scene seldom leave enough rounds for intervals.
const FEWEST_SECONDS: f64 = 5.0;

/// The plan of some scenes; `replayed` are the files of rays that were given for them.
pub(super) fn plan(
    arguments: &CompareArguments,
    scenes: Vec<SceneInput>,
    replayed: BTreeMap<String, RayFile>,
) -> Plan {
    let for_sweep = if arguments.sweep.is_some() { SECONDS_A_SWEEP } else { 0 };
    let for_study = if arguments.sampling_study { SECONDS_A_STUDY } else { 0 };
    let for_scenes = (SECONDS_A_SCENE * scenes.len() as u64).min(MOST_SECONDS);
    let seconds = for_scenes + for_sweep + for_study;
    let mut plan = Plan::of_scenes(scenes);
    plan.command = command();
    plan.budget = Some(arguments.budget.unwrap_or(Duration::from_secs(seconds)));
    plan.base.clone_from(&arguments.base);
    plan.rounds.at_least = arguments.rounds;
    plan.between_runs = arguments.between_runs;
    plan.build = BuildConfig { quality: arguments.build, ..BuildConfig::default() };
    plan.threads = arguments.threads.map_or(plan.threads, usize::from);
    plan.picture = PictureOptions {
        size: arguments.size.map(|size| [size.width, size.height]),
        aa: arguments.aa,
        seed: arguments.seed,
        ..PictureOptions::default()
    };
    plan.sweep = arguments.sweep.zip(arguments.family).map(|((first, last), family)| SweepPlan {
        family,
        sizes: SweepPlan::sizes_between(first, last),
    });
    plan.sampling_study = arguments.sampling_study;
    if !arguments.classes.is_empty() {
        plan.classes.clone_from(&arguments.classes);
    } else if !replayed.is_empty() {
        let is_there =
            |class: &RayClass| replayed.values().any(|file| file.class(*class).is_some());
        plan.classes = RayClass::ALL.into_iter().filter(is_there).collect();
    }
    plan.replayed = replayed;
    plan.keep_rays = arguments.save_rays.is_some();
    plan
}

/// What to print beforehand about a budget in which there is no time for intervals.
pub(super) fn too_short(plan: &Plan) -> Option<String> {
    let (budget, scenes) = (plan.budget?.as_secs_f64(), plan.scenes.len());
    let parts = scenes + usize::from(plan.sweep.is_some()) + usize::from(plan.sampling_study);
    let each = budget / parts.max(1) as f64;
    let what = match (scenes, parts - scenes) {
        (1, 0) => "1 scene".to_owned(),
        (_, 0) => format!("{scenes} scenes"),
        (0, 1) => "1 part".to_owned(),
        _ => format!("{parts} parts"),
    };
    let enough = (FEWEST_SECONDS * parts as f64).ceil();
    (each < FEWEST_SECONDS).then(|| {
        let share = if parts > 1 { format!(" is {each:.1} s each,") } else { " is".to_owned() };
        format!("note: {what} in {budget} s{share} too little for intervals; --budget {enough}")
    })
}

/// This process's command, quoted for a shell.
fn command() -> String {
    let arguments = std::env::args_os().skip(1);
    let quoted = arguments.map(|argument| quoted(&argument.to_string_lossy()));
    std::iter::once("srt".to_owned()).chain(quoted).collect::<Vec<_>>().join(" ")
}

/// A word as a POSIX shell reads it.
fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "-_./=,:%+@".contains(c);
    match !word.is_empty() && word.chars().all(plain) {
        true => word.to_owned(),
        false => format!("'{}'", word.replace('\'', r"'\''")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_quoted_where_a_shell_would_read_them_otherwise() {
        assert_eq!(quoted("scenes/hall.sce"), "scenes/hall.sce");
        assert_eq!(quoted("my scene's.sce"), r"'my scene'\''s.sce'");
        assert_eq!(quoted(""), "''");
    }

    #[test]
    fn a_budget_without_time_for_intervals_is_noted() {
        let noted = |sweep: bool, seconds| {
            let mut plan = Plan::of_scenes(Vec::new());
            let family = crate::compare::Family::ALL[0];
            plan.sweep = sweep.then(|| SweepPlan { family, sizes: vec![1] });
            plan.sampling_study = true;
            plan.budget = Some(Duration::from_secs(seconds));
            too_short(&plan)
        };
        let note = "note: 2 parts in 6 s is 3.0 s each, too little for intervals; --budget 10";
        assert_eq!(noted(true, 6).as_deref(), Some(note));
        assert_eq!((noted(true, 10), noted(false, 5)), (None, None));
    }
}
