//! The limits of a report: sentences on what it does not show and on what is doubtful, for every form.

use super::Report;
use crate::analysis::{Analysis, ClassFigures, SceneFigures};
use crate::record::Comparison;

/// How times were measured and how far they carry, in every report.
const ALWAYS: [&str; 8] = [
    "Times are those of this machine on this day. Ratios between structures carry over to other \
     machines better than times do, but not exactly.",
    "Rays were recorded once for each class and replayed to every structure in interleaved rounds. \
     So ratios do not include what slows all structures alike. A replay only traces: it does not \
     shade or make new rays, and its caches are warm.",
    "Intervals are exact 95 % intervals of the median by order statistics. Intervals of changes \
     against a baseline are bootstrap intervals. They show the noise of this run, not the effect of \
     another build, memory layout or machine.",
    "Intervals assume independent rounds, but consecutive rounds are not quite independent. Rounds \
     end once intervals are narrow. Both make intervals a little too narrow.",
    "Times of rays are wall times without waiting for a processor that other programs used. All \
     rounds count. The effects of other programs on caches, memory and clock rate are still \
     included. Times of builds and pictures are wall times.",
    "Every structure here gives equal hits bit for bit, by one formula and one rule for ties. That \
     costs each structure some speed, and some structures more than others.",
    "Break-even points hold for rays like the picture's mean ray. Other views and lights have other \
     break-even points.",
    "The structures were written or adapted by the authors of this program, who may know some of \
     them better than others.",
];

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
    if let Some([load, ..]) = machine.load_at_start.filter(|load| load[0] > 0.5) {
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

/// Measurements with too few rounds, wide intervals or much waiting.
fn round_limits(comparison: &Comparison, analysis: &Analysis) -> Vec<String> {
    let classes: Vec<&ClassFigures> = analysis
        .scenes
        .iter()
        .flat_map(|scene| &scene.structures)
        .flat_map(|structure| &structure.classes)
        .collect();
    let goal = comparison.run.rounds.relative_interval;
    let width = |class: &ClassFigures| class.ns_per_ray.and_then(|e| e.relative_half_width());
    let without = classes.iter().filter(|class| width(class).is_none()).count();
    let wide = classes.iter().filter(|class| width(class).is_some_and(|w| w > goal)).count();
    let disturbed = classes.iter().filter(|class| class.is_disturbed()).count();
    let all = classes.len();
    [
        (disturbed, "had to wait for the processor: their wall time is more than 1.1 times their own time (†)"),
        (without, "have too few rounds for an interval"),
        (wide, "have a wider interval than the target"),
    ]
    .into_iter()
    .filter(|(n, _)| *n > 0)
    .map(|(n, what)| format!("{n} of {all} measurements of rays {what}."))
    .collect()
}
