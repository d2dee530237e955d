//! The limits of a report: sentences on what it does not show and on what is doubtful, for every form.

use super::Report;
use crate::analysis::statistics::Risk;
use crate::analysis::{Analysis, ClassFigures, SceneFigures};
use crate::record::Comparison;

/// How times were measured and how far they carry, in every report.
const ALWAYS: [&str; 9] = [
    "Times are those of this machine on this day. Ratios between structures carry over to other \
     machines better than times do, but not exactly.",
    "Rays were recorded once for each class and replayed to every structure in interleaved rounds. \
     So ratios do not include what slows all structures alike. A replay only traces: it does not \
     shade or make new rays, and its caches are warm.",
    "Where each round traced all recorded rays, the estimate is the geometric mean of the passes' \
     medians; where each round traced a random sample, it is the mean of the rounds, and its interval \
     includes the choice of the rays. Intervals are \
     Student's, of the logarithm, from the differences between passes: pieces of the measurement that \
     are apart in time, for each of which the structures were built anew. So they include what the \
     place in memory and the minutes of this run do, and what is stated to differ between runs, not \
     the effect of another build of the program or of another machine.",
    "Intervals of builds and pictures are exact intervals of medians by order statistics, widened by \
     the same statement. They assume \
     independent rounds, but consecutive rounds are not quite independent. Rounds and passes, those of \
     rays too, end once intervals are narrow. Both make intervals a little too narrow.",
    "The verdict's comparison is the most certain of all pairs of structures and classes of rays. Its \
     interval is widened so that the intervals of all of them hold together with 95 % (Bonferroni).",
    "Times of rays are wall times without waiting for a processor that other programs used. All \
     rounds count. The effects of other programs on caches, memory and clock rate are still \
     included. Times of builds and pictures are wall times.",
    "srt's own structures give equal hits bit for bit, by one formula and one rule for ties. That \
     costs each of them some speed, and some more than others. Peers have formulas of their own.",
    "Break-even points are those of one thread: builds on one thread against rays on one thread. \
     They hold for rays like the picture's mean ray. Other views and lights have other \
     break-even points.",
    "The structures were written or adapted by the authors of this program, who may know some of \
     them better than others.",
];

/// A machine with a larger load is busy.
const BUSY: f64 = 0.5;

/// General limits first, then those of this record.
pub(super) fn limits(report: &Report<'_>) -> Vec<String> {
    let Report { comparison, analysis, .. } = report;
    let mut limits: Vec<String> = ALWAYS.map(str::to_owned).to_vec();
    limits.extend(machine_limits(comparison));
    limits.extend(base_limits(comparison, analysis));
    limits.extend(round_limits(comparison, analysis));
    limits.extend(comparison.notes.iter().cloned());
    limits
}

fn machine_limits(comparison: &Comparison) -> Vec<String> {
    let run = &comparison.run;
    let machine = &run.machine;
    let mut limits = Vec::new();
    if run.partial {
        limits.push("The comparison was stopped before its plan was done.".to_owned());
    }
    match machine.governor.as_deref() {
        None => limits.push("The governor of the clock frequency is not known.".to_owned()),
        Some("performance") => {}
        Some(other) => limits.push(format!(
            "The governor was {other}, not performance: the clock frequency may have changed \
             between rounds."
        )),
    }
    if let Some([load, ..]) = machine.load_at_start.filter(|load| load[0] > BUSY) {
        limits.push(format!("The machine was busy at the start: its load was {load:.2}."));
    }
    if run.commit.as_deref().is_some_and(|commit| commit.ends_with("-dirty")) {
        limits.push("The sources had changed since the named commit.".to_owned());
    }
    limits
}

fn base_limits(comparison: &Comparison, analysis: &Analysis) -> Vec<String> {
    let other = |scene: &SceneFigures| {
        let base = scene.base.as_deref().filter(|base| *base != comparison.base)?;
        Some(format!(
            "{} was not measured in {}; ratios there are to {base}.",
            comparison.base, scene.scene
        ))
    };
    analysis.scenes.iter().filter_map(other).collect()
}

/// Measurements with too few rounds, wide intervals, samples or much waiting.
fn round_limits(comparison: &Comparison, analysis: &Analysis) -> Vec<String> {
    let goal = target(comparison);
    let classes = classes(analysis);
    let width = |class: &ClassFigures| class.ns_per_ray.and_then(|e| e.relative_half_width());
    let counts = [
        count(&classes, ClassFigures::is_disturbed),
        count(&classes, ClassFigures::is_sampled),
        count(&classes, |class| width(class).is_none()),
        count(&classes, |class| width(class).is_some_and(|w| w > goal)),
    ];
    let what = [
        "had to wait for the processor: their wall time is more than 1.1 times their own time (†)",
        "are estimates from samples of the recorded rays",
        "have too few passes for an interval",
        "have a wider interval than the target",
    ];
    let some = counts.into_iter().zip(what).filter(|(n, _)| *n > 0);
    let own =
        some.map(|(n, what)| format!("{n} of {} measurements of rays {what}.", classes.len()));
    own.chain(not_built_anew(comparison)).collect()
}

/// The half width that rounds aim at, with what differs between runs, which no round makes less.
fn target(comparison: &Comparison) -> f64 {
    comparison
        .run
        .rounds
        .relative_interval
        .hypot(Risk::USUAL.normal() * comparison.run.between_runs)
}

/// The scenes whose intervals do not include the place in memory.
fn not_built_anew(comparison: &Comparison) -> Option<String> {
    let scenes = comparison.scenes.iter().filter(|scene| !scene.built_anew);
    let names: Vec<&str> = scenes.map(|scene| scene.name.as_str()).collect();
    (!names.is_empty()).then(|| {
        format!(
            "Structures were not built anew for each pass, since that takes too long: {}.",
            names.join(", ")
        )
    })
}

/// What weakens the verdict of this record, in a sentence to stand beside it; `None` if nothing does.
pub(super) fn weaknesses(report: &Report<'_>) -> Option<String> {
    let Report { comparison, analysis, .. } = report;
    let classes = classes(analysis);
    let all = classes.len();
    let ratio = |class: &ClassFigures| class.speedup.or(class.ns_per_ray);
    let unsupported =
        count(&classes, |class| ratio(class).is_none_or(|e| !e.supports_a_statement()));
    let sampled = count(&classes, ClassFigures::is_sampled);
    let disturbed = count(&classes, ClassFigures::is_disturbed);
    let load = comparison.run.machine.load_at_start.map(|load| load[0]).filter(|load| *load > BUSY);
    let points = || analysis.sweeps.iter().flat_map(|sweep| &sweep.curves).flat_map(|c| &c.values);
    let unsupported_points = points().filter(|own| !own.ns_per_ray.supports_a_statement()).count();
    let parts: Vec<String> = [
        comparison.run.partial.then(|| "the comparison was stopped early".to_owned()),
        load.map(|load| format!("the machine was busy at the start (load {load:.2})")),
        (disturbed > 0)
            .then(|| format!("{disturbed} of {all} measurements had to wait for the processor")),
        (unsupported > 0).then(|| {
            format!("{unsupported} of {all} ratios have too few passes or too wide an interval")
        }),
        (unsupported_points > 0).then(|| {
            let all = points().count();
            format!("{unsupported_points} of {all} times of sweeps have too few passes or too wide an interval")
        }),
        (sampled > 0)
            .then(|| format!("{sampled} of {all} measurements are of samples of the rays")),
    ]
    .into_iter()
    .flatten()
    .collect();
    (!parts.is_empty()).then(|| format!("What weakens this: {}.", parts.join("; ")))
}

/// All measurements of rays in scenes.
fn classes(analysis: &Analysis) -> Vec<&ClassFigures> {
    let structures = analysis.scenes.iter().flat_map(|scene| &scene.structures);
    structures.flat_map(|structure| &structure.classes).collect()
}

fn count(classes: &[&ClassFigures], fits: impl Fn(&ClassFigures) -> bool) -> usize {
    classes.iter().filter(|class| fits(class)).count()
}
