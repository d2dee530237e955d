//! `srt compare`: scenes and structures → a report. What is measured, and how, is the work of
//! `compare`; what a report looks like, of `report`.

use std::path::{Path, PathBuf};
use std::time::Duration;

use super::compare_args::CompareArguments;
use super::compare_progress::CompareProgress;
use super::exit::{Exit, Failure, Outcome};
use super::fingerprint;
use super::interrupt::Interrupt;
use super::load::{LoadError, load};
use super::output::print;
use super::result_folder::{PictureFiles, ResultFolder, read_record};
use super::terminal::{tell, tell_error};
use crate::accel::BuildConfig;
use crate::compare::{self, PictureOptions, Plan, SceneInput, SweepPlan};
use crate::image_io::{Format, encode};
use crate::record::baseline::{Baseline, Changes};
use crate::record::{Comparison, Dropped};
use crate::report::terminal;

/// Seconds for each scene, and for all, if nobody says how many.
const SECONDS_A_SCENE: u64 = 30;
const MOST_SECONDS: u64 = 150;
const SECONDS_A_SWEEP: u64 = 60;
const SECONDS_A_STUDY: u64 = 60;

/// Fewer seconds than this for a scene seldom leave enough rounds for intervals.
const FEWEST_SECONDS: f64 = 5.0;

/// Compares, writes the report and prints its table.
pub(super) fn run(arguments: &CompareArguments, interrupt: &Interrupt) -> Outcome {
    let baseline = arguments.baseline.as_deref().map(read_record).transpose()?;
    let out = arguments.out.clone().unwrap_or_else(|| default_folder(&arguments.scenes));
    let Some(scenes) = load_all(arguments)? else { return Ok(Exit::Trouble) };
    let folder = ResultFolder::prepare(&out)?;
    let plan = plan(arguments, scenes);
    if let Some(note) = too_short(&plan).filter(|_| !arguments.quiet) {
        tell(note);
    }
    let progress = CompareProgress::start(arguments.quiet, interrupt.clone());
    let outcome = interrupt.heeded_by(|| compare::run(&plan, &arguments.accel, &progress));
    drop(progress);
    let mut outcome = outcome.map_err(Failure::new)?;
    outcome.comparison.baseline = baseline.map(|old| Baseline {
        threshold: arguments.fail_above,
        outcome: Changes::between(&old, &outcome.comparison),
    });
    folder.write(&outcome.comparison, &encoded(&outcome.pictures)?)?;
    let fine = tell_outcome(arguments, &outcome, folder.path())?;
    let compared = |baseline: &Baseline| !baseline.outcome.changes.is_empty();
    let in_vain = !outcome.comparison.baseline.as_ref().is_none_or(compared);
    let partial = outcome.comparison.run.partial;
    if in_vain && !partial {
        tell_error(
            "the baseline has nothing in common with this comparison: there is no class of rays \
             that both measured with the same structure in the same scene",
        );
    }
    Ok(exit(partial, fine, in_vain))
}

/// How a comparison ends: wrong answers weigh more than a baseline that was compared in vain.
fn exit(partial: bool, fine: bool, in_vain: bool) -> Exit {
    match (partial, fine) {
        (true, _) => Exit::Interrupted,
        (false, false) => Exit::Negative,
        (false, true) if in_vain => Exit::Trouble,
        (false, true) => Exit::Fine,
    }
}

/// Prints the table and what changed; whether all is well.
fn tell_outcome(
    arguments: &CompareArguments,
    outcome: &compare::ComparisonResult,
    folder: &Path,
) -> Result<bool, Failure> {
    let mut text = terminal::write(&outcome.comparison);
    let mut fine = outcome.holds();
    if let Some(Baseline { threshold, outcome: changes }) = &outcome.comparison.baseline {
        fine &= changes.regressions(*threshold).next().is_none();
        text += &terminal::write_changes(changes, *threshold);
    }
    differences(&outcome.comparison).iter().for_each(tell_error);
    if !arguments.quiet {
        print(&text)?;
        tell(format_args!("the report is in `{}`", folder.display()));
    }
    Ok(fine)
}

/// What differs in scenes, and who failed in a sweep, a line each.
fn differences(comparison: &Comparison) -> Vec<String> {
    let mut lines = Vec::new();
    for scene in &comparison.scenes {
        for entry in scene.proof.iter().flat_map(|proof| &proof.structures) {
            if let Some(difference) = &entry.first_difference {
                lines.push(format!("{}, {}: {difference}", scene.name, entry.structure));
            }
        }
    }
    for sweep in &comparison.sweeps {
        for entry in sweep.dropped.iter().filter(|entry| entry.failed) {
            let Dropped { structure, triangles, reason, .. } = entry;
            lines.push(format!("{} of {triangles} triangles, {structure}: {reason}", sweep.mesh));
        }
    }
    lines
}

/// Loads all scenes, each under a name of its own; `None` if one is wrong, which has been told.
fn load_all(arguments: &CompareArguments) -> Result<Option<Vec<SceneInput>>, Failure> {
    let mut scenes: Vec<SceneInput> = Vec::new();
    for path in &arguments.scenes {
        let loaded = match load(path, arguments.lenient) {
            Ok(loaded) => loaded,
            Err(error) => {
                if let LoadError::Invalid { text, .. } = &error {
                    tell(format_args!("{text}\n"));
                }
                tell_error(error);
                return Ok(None);
            }
        };
        if !arguments.quiet && !loaded.warnings.is_empty() {
            tell(&loaded.warnings);
        }
        let hash = fingerprint::of_scene(path, &loaded.description).map_err(|error| {
            Failure::new(format_args!("cannot read `{}` again: {error}", path.display()))
        })?;
        let name = new_name(&stem(path), &scenes);
        let path = path.display().to_string();
        scenes.push(SceneInput { name, path, hash, scene: loaded.scene });
    }
    Ok(Some(scenes))
}

/// A name that no scene has yet.
fn new_name(stem: &str, scenes: &[SceneInput]) -> String {
    let is_new = |name: &String| scenes.iter().all(|scene| scene.name != *name);
    let numbered = (2..).map(|number| format!("{stem}-{number}"));
    std::iter::once(stem.to_owned()).chain(numbered).find(is_new).unwrap_or_default()
}

fn stem(path: &Path) -> String {
    path.file_stem().map_or_else(|| "scene".to_owned(), |stem| stem.to_string_lossy().into_owned())
}

/// `results/<date>-<scene>`, with a number behind it where that is taken.
fn default_folder(scenes: &[PathBuf]) -> PathBuf {
    let date = jiff::Zoned::now().strftime("%Y-%m-%d").to_string();
    let first = scenes.first().map_or_else(|| "sweep".to_owned(), |path| stem(path));
    let more = match scenes.len() {
        0 | 1 => String::new(),
        n => format!("-and-{}-more", n - 1),
    };
    let name = format!("{date}-{first}{more}");
    let numbered = (2..).map(|number| format!("{name}-{number}"));
    let mut paths =
        std::iter::once(name.clone()).chain(numbered).map(|name| Path::new("results").join(name));
    paths.find(|path| !path.exists()).unwrap_or_else(|| Path::new("results").join(name))
}

fn plan(arguments: &CompareArguments, scenes: Vec<SceneInput>) -> Plan {
    let for_sweep = if arguments.sweep.is_some() { SECONDS_A_SWEEP } else { 0 };
    let for_study = if arguments.sampling_study { SECONDS_A_STUDY } else { 0 };
    let for_scenes = (SECONDS_A_SCENE * scenes.len() as u64).min(MOST_SECONDS);
    let seconds = for_scenes + for_sweep + for_study;
    let mut plan = Plan::of_scenes(scenes);
    plan.command = command();
    plan.budget = Some(arguments.budget.unwrap_or(Duration::from_secs(seconds)));
    plan.rounds.at_least = arguments.rounds;
    plan.build = BuildConfig { quality: arguments.build, ..BuildConfig::default() };
    plan.threads = arguments.threads.map_or(plan.threads, usize::from);
    plan.picture = PictureOptions {
        size: arguments.size.map(|size| [size.width, size.height]),
        aa: arguments.aa,
        seed: arguments.seed,
        ..PictureOptions::default()
    };
    plan.sweep = arguments.sweep.zip(arguments.mesh).map(|((first, last), mesh)| SweepPlan {
        mesh,
        sizes: SweepPlan::sizes_between(first, last),
    });
    plan.sampling_study = arguments.sampling_study;
    if !arguments.classes.is_empty() {
        plan.classes.clone_from(&arguments.classes);
    }
    plan
}

/// What to tell beforehand of a budget in which there is no time for intervals.
fn too_short(plan: &Plan) -> Option<String> {
    let (budget, scenes) = (plan.budget?.as_secs_f64(), plan.scenes.len());
    let parts = scenes + usize::from(plan.sweep.is_some()) + usize::from(plan.sampling_study);
    let each = budget / parts.max(1) as f64;
    let what = match (scenes, parts - scenes) {
        (1, 0) => "1 scene".to_owned(),
        (_, 0) => format!("{scenes} scenes"),
        _ => format!("{parts} parts"),
    };
    let enough = (FEWEST_SECONDS * parts as f64).ceil();
    (each < FEWEST_SECONDS).then(|| {
        let share = if parts > 1 { format!(" is {each:.1} s each,") } else { " is".to_owned() };
        format!("note: {what} in {budget} s{share} too little for intervals; --budget {enough}")
    })
}

fn encoded(pictures: &[(String, crate::image_io::Picture)]) -> Result<PictureFiles, Failure> {
    let png = |(name, picture): &(String, _)| {
        encode(picture, Format::Png).map(|bytes| (name.clone(), bytes)).map_err(Failure::new)
    };
    pictures.iter().map(png).collect()
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
    fn wrong_answers_weigh_more_than_a_baseline_in_vain() {
        assert_eq!(exit(false, false, true), Exit::Negative);
        assert_eq!(exit(false, true, true), Exit::Trouble);
        assert_eq!(exit(false, true, false), Exit::Fine);
        assert_eq!(exit(true, false, true), Exit::Interrupted);
    }

    #[test]
    fn who_fails_in_a_sweep_is_told() {
        let mut comparison = Comparison::new(crate::record::Run::default(), "none");
        let entry = |structure: &str, failed| Dropped {
            structure: structure.to_owned(),
            triangles: 1_000,
            reason: "its answers differ".to_owned(),
            failed,
        };
        let sweep = crate::record::Sweep {
            mesh: "hall".to_owned(),
            dropped: vec![entry("slow", false), entry("wrong", true)],
            ..Default::default()
        };
        comparison.sweeps.push(sweep);
        let lines = ["hall of 1000 triangles, wrong: its answers differ"];
        assert_eq!(differences(&comparison), lines);
    }

    #[test]
    fn a_budget_without_time_for_intervals_is_told() {
        let told = |sweep: bool, seconds| {
            let mut plan = Plan::of_scenes(Vec::new());
            let mesh = crate::assets::generate::Kind::ALL[0];
            plan.sweep = sweep.then(|| SweepPlan { mesh, sizes: vec![1] });
            plan.sampling_study = true;
            plan.budget = Some(Duration::from_secs(seconds));
            too_short(&plan)
        };
        let note = "note: 2 parts in 6 s is 3.0 s each, too little for intervals; --budget 10";
        assert_eq!(told(true, 6).as_deref(), Some(note));
        assert_eq!((told(true, 10), told(false, 5)), (None, None));
    }

    #[test]
    fn folders_are_named_by_their_scenes() {
        let folder = |scenes: &[&str]| {
            let scenes: Vec<_> = scenes.iter().map(PathBuf::from).collect();
            default_folder(&scenes).display().to_string()
        };
        assert!(folder(&["a/hall-x.sce"]).contains("-hall-x"));
        assert!(folder(&["hall-x.sce", "b.sce", "c.sce"]).contains("-hall-x-and-2-more"));
    }
}
