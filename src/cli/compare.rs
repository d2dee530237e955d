//! `srt compare`: scenes and structures → a report. The layer `compare` measures, the layer `report`
//! writes; this file loads the scenes, shows progress, and prints the result.

use std::path::{Path, PathBuf};

use super::compare_args::CompareArguments;
use super::compare_plan::{plan, too_short};
use super::compare_progress::CompareProgress;
use super::exit::{CommandResult, Exit, Failure};
use super::fingerprint;
use super::interrupt::Interrupt;
use super::load::{Described, SceneFile, print_load_error};
use super::mesh_scene::NamedMesh;
use super::output::print;
use super::ray_files::{self, RayFolder};
use super::result_folder::{
    ResultFolder, encoded, pictures_in, read_record, refuse_to_replace_the_baseline,
};
use super::terminal::{print_error, print_message};
use crate::analysis::baseline;
use crate::compare::{self, ComparisonResult, SceneInput};
use crate::record::{Baseline, Comparison, Dropped};
use crate::report::Report;
use crate::sealed::hexadecimal;

/// Compares, writes the report and prints its table.
pub(super) fn run(arguments: &CompareArguments, interrupt: &Interrupt) -> CommandResult {
    if let (Some(baseline), Some(out)) = (&arguments.baseline, &arguments.out) {
        refuse_to_replace_the_baseline(out, baseline)?;
    }
    let old = arguments.baseline.as_deref().map(read_record).transpose()?;
    let Some(scenes) = load_all(arguments)? else { return Ok(Exit::Trouble) };
    let replayed = ray_files::read_for(&arguments.rays, &scenes, &arguments.classes)?;
    let mut plan = plan(arguments, scenes, replayed);
    compare::check_plan(&plan, &arguments.structures()).map_err(Failure::new)?;
    let rays = arguments.save_rays.as_deref();
    let rays = rays.map(|path| RayFolder::prepare(path, &plan.scenes)).transpose()?;
    let folder = match &arguments.out {
        Some(out) => ResultFolder::prepare(out)?,
        None => ResultFolder::claim(Path::new("results"), &default_name(&arguments.scenes))?,
    };
    if arguments.resume {
        plan.resumed = folder.resumable(&plan)?;
    }
    if let Some(note) = too_short(&plan).filter(|_| !arguments.quiet) {
        print_message(note);
    }
    if !arguments.quiet {
        compare::disturbances().iter().for_each(print_message);
    }
    let quiet = arguments.quiet;
    let progress = CompareProgress::start(quiet, interrupt.clone(), rays.as_ref(), Some(&folder));
    let result = interrupt.cancellable(|| compare::run(&plan, &arguments.structures(), &progress));
    drop(progress);
    let mut result = result.map_err(Failure::new)?;
    let Some(folder) = folder_of_result(folder, &result, arguments.quiet)? else {
        return Ok(interrupt.exit());
    };
    result.comparison.baseline =
        old.map(|old| baseline::compare(&old, &result.comparison, arguments.fail_above));
    let report = Report::new(&result.comparison);
    let mut pictures = pictures_in(&result.comparison, folder.path());
    pictures.extend(encoded(&result.pictures)?);
    folder.write(&report, &pictures)?;
    let fine = print_result(arguments, &result, &report, folder.path())?;
    // Last, so that a folder that is full takes nothing of the report away.
    rays.map_or(Ok(()), RayFolder::finish)?;
    let baseline = result.comparison.baseline.as_ref();
    let compared = |baseline: &Baseline| !baseline.outcome.changes.is_empty();
    let unrelated = !baseline.is_none_or(compared);
    let is_warned = |baseline: &&Baseline| !baseline.outcome.warnings.is_empty();
    let warned = baseline.filter(is_warned).filter(|_| !unrelated);
    if let Some(baseline) = warned {
        print_error(format_args!(
            "the baseline cannot show a change of this program: {}",
            baseline.outcome.warnings.join(" ")
        ));
    }
    let partial = result.comparison.run.partial;
    if unrelated && !partial {
        print_error(
            "the baseline has nothing in common with this comparison: there is no class of rays \
             that both measured with the same structure in the same scene",
        );
    }
    Ok(if partial { interrupt.exit() } else { exit(fine, unrelated || warned.is_some()) })
}

/// The folder of a report. One that is there already is not replaced where a comparison was interrupted before a part
/// of it was done: what was measured gets a new folder beside it, and `None` is returned if that is nothing.
fn folder_of_result(
    folder: ResultFolder,
    result: &ComparisonResult,
    quiet: bool,
) -> Result<Option<ResultFolder>, Failure> {
    let run = &result.comparison.run;
    if !run.partial || !run.done.is_empty() || !folder.has_report() {
        return Ok(Some(folder));
    }
    let older = folder.path().display();
    // A difference is told, though nothing was timed.
    if result.holds() && !has_measured(&result.comparison) {
        print_error(format_args!(
            "interrupted before anything was measured: the report in `{older}` is the older one"
        ));
        return Ok(None);
    }
    if !quiet {
        print_message(format_args!(
            "interrupted before a part was done: the older report in `{older}` is left as it is"
        ));
    }
    folder.beside("partial").map(Some)
}

/// Whether any rays were timed.
fn has_measured(comparison: &Comparison) -> bool {
    let Comparison { scenes, sweeps, sampling, .. } = comparison;
    let mut structures = scenes.iter().flat_map(|scene| &scene.structures);
    structures.any(|own| !own.classes.is_empty())
        || sweeps.iter().any(|sweep| !sweep.points.is_empty())
        || sampling.is_some()
}

/// How a whole comparison ends: wrong results weigh more than a baseline that shows nothing.
fn exit(fine: bool, baseline_shows_nothing: bool) -> Exit {
    match fine {
        false => Exit::Negative,
        true if baseline_shows_nothing => Exit::Trouble,
        true => Exit::Fine,
    }
}

/// Prints the table and what changed; whether all is well.
fn print_result(
    arguments: &CompareArguments,
    result: &ComparisonResult,
    report: &Report<'_>,
    folder: &Path,
) -> Result<bool, Failure> {
    let text = report.terminal() + &report.terminal_changes().unwrap_or_default();
    // Of another machine, or by other rays, a change is none of this program.
    let is_slower = |baseline: &Baseline| {
        baseline.outcome.warnings.is_empty() && baseline::regressions(baseline).next().is_some()
    };
    let fine = result.holds() && !result.comparison.baseline.as_ref().is_some_and(is_slower);
    differences(&result.comparison).iter().for_each(print_error);
    if !arguments.quiet {
        print(&text)?;
        print_message(format_args!("the report is in `{}`", folder.display()));
    }
    Ok(fine)
}

/// What does not conform, the differences in scenes and the failures in sweeps, a line each.
fn differences(comparison: &Comparison) -> Vec<String> {
    let mut lines = Vec::new();
    for own in &comparison.conformance {
        if let Some(fault) = own.fault() {
            lines.push(format!("{} does not conform: {fault}", own.structure));
        }
    }
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
            let size = format!("{triangles} {}", sweep.unit);
            lines.push(format!("{} of {size}, {structure}: {reason}", sweep.mesh));
        }
    }
    lines
}

/// Loads all scenes, each under a name of its own; `None` if one is wrong, whose errors are printed.
fn load_all(arguments: &CompareArguments) -> Result<Option<Vec<SceneInput>>, Failure> {
    let mut scenes: Vec<SceneInput> = Vec::new();
    for path in &arguments.scenes {
        let read = SceneFile::read(path, arguments.lenient);
        let read = read.and_then(|mut file| Ok((file.usual_frame()?, file)));
        let (Described { loaded, description, .. }, file) = match read {
            Ok(read) => read,
            Err(error) => {
                print_load_error(&error);
                return Ok(None);
            }
        };
        if !arguments.quiet && !loaded.warnings.is_empty() {
            print_message(&loaded.warnings);
        }
        let hash = fingerprint::of_source(file.source(), &description).map_err(|error| {
            Failure::new(format_args!("cannot read `{}` again: {error}", path.display()))
        })?;
        let name = new_name(&stem(path), &scenes);
        let path = path.display().to_string();
        scenes.push(SceneInput { name, path, hash: hexadecimal(&hash), scene: loaded.scene });
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
    if let Some(NamedMesh::Generated(recipe)) = NamedMesh::of(path) {
        // Files are named by it.
        return recipe.split(':').skip(1).collect::<Vec<_>>().join("-");
    }
    path.file_stem().map_or_else(|| "scene".to_owned(), |stem| stem.to_string_lossy().into_owned())
}

/// `<date>-<scene>`: the name of the folder for a report that is given none.
fn default_name(scenes: &[PathBuf]) -> String {
    let date = jiff::Zoned::now().strftime("%Y-%m-%d").to_string();
    let first = scenes.first().map_or_else(|| "sweep".to_owned(), |path| stem(path));
    let more = match scenes.len() {
        0 | 1 => String::new(),
        n => format!("-and-{}-more", n - 1),
    };
    format!("{date}-{first}{more}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::{ClassRecord, RayClass, SceneRecord, StructureRecord};

    #[test]
    fn wrong_results_weigh_more_than_an_unrelated_baseline() {
        assert_eq!(exit(false, true), Exit::Negative);
        assert_eq!(exit(true, true), Exit::Trouble);
        assert_eq!(exit(true, false), Exit::Fine);
    }

    #[test]
    fn a_failure_in_a_sweep_is_printed() {
        let mut comparison = Comparison::new(crate::record::Run::default(), "none");
        let entry = |structure: &str, failed| Dropped {
            structure: structure.to_owned(),
            triangles: 1_000,
            reason: "its results differ".to_owned(),
            failed,
        };
        let sweep = crate::record::Sweep {
            mesh: "hall".to_owned(),
            dropped: vec![entry("slow", false), entry("wrong", true)],
            ..Default::default()
        };
        comparison.sweeps.push(sweep);
        let lines = ["hall of 1000 triangles, wrong: its results differ"];
        assert_eq!(differences(&comparison), lines);
    }

    #[test]
    fn folders_are_named_by_their_scenes() {
        let folder = |scenes: &[&str]| {
            let scenes: Vec<_> = scenes.iter().map(PathBuf::from).collect();
            default_name(&scenes)
        };
        assert!(folder(&["a/hall-x.sce"]).ends_with("-hall-x"));
        assert!(folder(&["generate:hall:20k:1"]).ends_with("-hall-20k-1"));
        assert!(folder(&["hall-x.sce", "b.sce", "c.sce"]).ends_with("-hall-x-and-2-more"));
    }

    /// A comparison that was interrupted in its first scene, with or without rays that were timed.
    fn interrupted(timed: bool) -> ComparisonResult {
        let class = ClassRecord {
            class: RayClass::View,
            rays: 1,
            sample: None,
            counted_rays: 1,
            hits: 0,
            boxes: None,
            primitives: None,
            rounds: Vec::new(),
            passes: Vec::new(),
        };
        let classes = if timed { vec![class] } else { Vec::new() };
        let row = StructureRecord { classes, ..StructureRecord::default() };
        let scene = SceneRecord { structures: vec![row], ..SceneRecord::default() };
        let run = crate::record::Run { partial: true, ..Default::default() };
        let mut comparison = Comparison::new(run, "none");
        comparison.scenes.push(scene);
        ComparisonResult { comparison, pictures: Vec::new() }
    }

    #[test]
    fn an_older_report_is_replaced_by_parts_that_are_done() {
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().join("out");
        let prepared = || ResultFolder::prepare(&out).unwrap();
        let name = |result: &ComparisonResult| {
            let folder = folder_of_result(prepared(), result, true).unwrap()?;
            Some(folder.path().file_name()?.to_string_lossy().into_owned())
        };
        assert_eq!(name(&interrupted(false)).as_deref(), Some("out"), "there is none to replace");
        std::fs::write(out.join("report.json"), "an older report").unwrap();
        assert_eq!(name(&interrupted(false)), None);
        assert_eq!(name(&interrupted(true)).as_deref(), Some("out-partial"));
        assert_eq!(name(&interrupted(true)).as_deref(), Some("out-partial-2"));
        let mut done = interrupted(true);
        done.comparison.run.done.push("a scene".to_owned());
        assert_eq!(name(&done).as_deref(), Some("out"));
        let mut whole = interrupted(true);
        whole.comparison.run.partial = false;
        assert_eq!(name(&whole).as_deref(), Some("out"));
    }
}
