//! What a report does not show, and what should be doubted: sentences for every form of report.

use super::Report;
use crate::analysis::{Analysis, ClassFigures, SceneFigures};
use crate::record::Comparison;

/// How times were taken and what that means, whatever was measured.
const ALWAYS: [&str; 7] = [
    "The times are those of this machine on this day. Ratios between structures carry over to other \
     machines better than times do, but not exactly.",
    "Rays were recorded once for each class and replayed to every structure in interleaved rounds, \
     so ratios leave out what slows all alike. A replay traces only: it neither shades nor makes \
     new rays, and its caches are warm.",
    "Intervals are exact 95 % intervals of the median by order statistics; where two runs are set \
     against each other, bootstrap intervals. They show the noise of this run, not what another \
     build, memory layout or machine would change. They take rounds as independent, which rounds \
     one after the other are not quite, and rounds stop once intervals are narrow, which makes \
     these a little too narrow.",
    "Times of rays are wall times without what was spent waiting for a processor that other \
     programs had, by the clock of the processor: all rounds count, and none is thrown away. What \
     other programs do to caches, memory and clock rate is in them nevertheless. Times of builds \
     and pictures are wall times.",
    "Every structure here answers equal hits bit for bit, by one formula and one rule for ties. \
     That costs each of them some speed, and not each the same.",
    "Break-even points hold for rays like the picture's mean ray; a scene with other views or \
     lights has others.",
    "The structures were written or adapted by the authors of this program, who may know some of \
     them better than others.",
];

/// General limits first, then what is particular to this record.
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
        None => limits.push("How the system chose the clock is not known.".to_owned()),
        Some("performance") => {}
        Some(other) => limits.push(format!(
            "The governor was {other}, not performance: the clock may have changed between rounds."
        )),
    }
    if let Some([load, ..]) = machine.load_at_start.filter(|load| load[0] > 0.5) {
        limits.push(format!("The machine was busy at the start: its load was {load:.2}."));
    }
    if run.commit.as_deref().is_some_and(|commit| commit.ends_with("-dirty")) {
        limits.push("Sources had changed since the commit that is named.".to_owned());
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

/// Measurements with too few rounds, or with wide intervals.
fn round_limits(comparison: &Comparison, analysis: &Analysis) -> Vec<String> {
    let classes: Vec<&ClassFigures> = analysis
        .scenes
        .iter()
        .flat_map(|scene| &scene.structures)
        .flat_map(|structure| &structure.classes)
        .collect();
    let goal = comparison.run.rounds.relative_interval;
    let width = |class: &&&ClassFigures| class.ns_per_ray.and_then(|e| e.relative_half_width());
    let without = classes.iter().filter(|class| width(class).is_none()).count();
    let wide = classes.iter().filter(|class| width(class).is_some_and(|w| w > goal)).count();
    let disturbed = classes.iter().filter(|class| class.is_disturbed()).count();
    let mut limits = Vec::new();
    if disturbed > 0 {
        limits.push(format!(
            "In {disturbed} of {} measurements of rays other programs had the processor for more \
             than a tenth of the time (†).",
            classes.len()
        ));
    }
    if without > 0 {
        limits.push(format!(
            "{without} of {} measurements of rays have too few rounds for an interval.",
            classes.len()
        ));
    }
    if wide > 0 {
        limits.push(format!(
            "{wide} of {} measurements of rays have an interval wider than was aimed at.",
            classes.len()
        ));
    }
    limits
}
