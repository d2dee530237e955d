//! The comparison in one plain sentence.

use super::{Report, numbers};
use crate::analysis::{
    Analysis, Finding, SceneFigures, StructureFigures, SweepFigures, SweepValue,
};
use crate::record::{
    Comparison, Conformance, ConformanceOutcome, Proof, RayClass, SceneRecord, Status,
    StructureProof,
};

/// How many scenes without a whole proof are named; further ones are counted.
const NAMED_SCENES: usize = 3;

/// The whole sentence: see [`Report::verdict`].
pub(super) fn verdict(report: &Report<'_>) -> String {
    match headline(report) {
        (claim, Some(rest)) => format!("{claim}; {rest}"),
        (claim, None) => claim,
    }
}

/// The verdict's claim, and the rest: in how much there was no difference.
pub(super) fn headline(report: &Report<'_>) -> (String, Option<String>) {
    let Report { comparison, analysis, .. } = report;
    let partial = if comparison.run.partial { "Stopped early: " } else { "" };
    let unfit = nonconforming(comparison);
    if let Some(difference) = difference(comparison) {
        let unfit = unfit.map_or_else(String::new, |unfit| format!("{unfit}. "));
        return (format!("{partial}{unfit}{difference}"), None);
    }
    let growth = || analysis.sweeps.iter().find_map(growth);
    let speed = match &analysis.finding {
        Some(finding) => found(finding),
        None if comparison.scenes.is_empty() => growth().unwrap_or_else(|| {
            let traced = analysis.sweeps.iter().any(|sweep| !sweep.curves.is_empty());
            if traced { too_few() } else { nothing_traced() }
        }),
        None => nothing_found(analysis),
    };
    let equality = equality(comparison);
    let failed: Vec<String> = unfit.into_iter().chain(failures(comparison)).collect();
    match (!failed.is_empty()).then(|| failed.join("; ")) {
        Some(failed) => (format!("{partial}{failed}"), Some(format!("{speed}; {equality}."))),
        None => (format!("{partial}{speed}"), Some(format!("{equality}."))),
    }
}

/// The structures that do not conform, each with what shows it.
fn nonconforming(comparison: &Comparison) -> Option<String> {
    let text = |own: &Conformance| {
        let what = match &own.outcome {
            ConformanceOutcome::Equal => return None,
            ConformanceOutcome::Differs(first) => {
                format!("it gives other hits than no structure at mesh {}", first.mesh)
            }
            ConformanceOutcome::Failed { message } => message.clone(),
        };
        Some(format!("{} DOES NOT CONFORM and is not timed: {what}", own.structure))
    };
    let texts: Vec<String> = comparison.conformance.iter().filter_map(text).collect();
    (!texts.is_empty()).then(|| texts.join("; "))
}

/// The other structures that failed, each once, with the first reason. Peers are left out: they do not support all
/// shapes.
fn failures(comparison: &Comparison) -> Option<String> {
    let mut failures: Vec<(&str, String, &str)> = Vec::new();
    let conforms = |name: &str| comparison.conformance_of(name).is_none_or(Conformance::holds);
    let mut add = |name, place, message| {
        if conforms(name) && failures.iter().all(|(other, ..)| *other != name) {
            failures.push((name, place, message));
        }
    };
    for scene in &comparison.scenes {
        for row in scene.structures.iter().filter(|row| !row.peer) {
            if let Status::Failed { message } = &row.status {
                add(row.name.as_str(), scene.name.clone(), message.as_str());
            }
        }
    }
    for sweep in &comparison.sweeps {
        for entry in sweep.dropped.iter().filter(|entry| entry.failed) {
            let size = numbers::count(entry.triangles);
            let place = format!("the sweep, in {} with {size} {}", sweep.mesh, sweep.unit);
            add(&entry.structure, place, &entry.reason);
        }
    }
    let text = |(name, place, message): &(&str, String, &str)| {
        format!("{name} FAILED in {place}: {message}")
    };
    let texts: Vec<String> = failures.iter().map(text).collect();
    (!texts.is_empty()).then(|| texts.join("; "))
}

/// The best supported finding, in words.
fn found(finding: &Finding) -> String {
    let Finding { faster, slower, class, ratio, lowest, highest, scenes, rays, .. } = finding;
    let place = match &scenes[..] {
        [scene] => format!("in {scene}"),
        many => format!(
            "in the geometric mean of {} scenes ({}–{}\u{a0}×)",
            many.len(),
            numbers::figures(*lowest),
            numbers::figures(*highest)
        ),
    };
    let class = class.name();
    let rays = format!("{} rays", numbers::count(*rays));
    let spread = match ratio.interval {
        // What the sentence says shall not be rounded away; four decimals do that seldom.
        Some(own) if own.low > 1.0 && numbers::figures(own.low) == numbers::figures(1.0) => {
            Some(format!("{:.4}–{:.4}", own.low, own.high))
        }
        _ => numbers::spread(*ratio),
    };
    let spread = spread.map_or_else(
        || "too few rounds for an interval".to_owned(),
        |spread| format!("95\u{a0}%\u{a0}{spread}"),
    );
    let times = format!("{}\u{a0}× ({spread})", numbers::value(*ratio));
    if finding.is_certain() {
        format!("{faster} traces {class} rays {times} as fast as {slower}, {place}, by {rays}")
    } else {
        format!(
            "{faster} and {slower} are not told apart by {class} rays: {times}, {place}, by {rays}"
        )
    }
}

/// Why there is no finding.
fn nothing_found(analysis: &Analysis) -> String {
    let traced = |structure: &&StructureFigures| !structure.classes.is_empty();
    let several = |scene: &SceneFigures| scene.structures.iter().filter(traced).count() > 1;
    if analysis.scenes.iter().any(several) {
        too_few()
    } else if analysis.scenes.iter().any(|scene| scene.base.is_some()) {
        "no two structures traced the same rays".to_owned()
    } else {
        nothing_traced()
    }
}

fn too_few() -> String {
    "the passes are too few, or their intervals too wide, for any statement".to_owned()
}

fn nothing_traced() -> String {
    "nothing was traced".to_owned()
}

/// The fastest structure at the largest size of a sweep at which any supports a statement, and how its cost grows.
/// `None` if there is none.
fn growth(sweep: &SweepFigures) -> Option<String> {
    let supported = |value: &&SweepValue| value.ns_per_ray.supports_a_statement();
    let of_class = |class: RayClass| {
        let curves = sweep.curves.iter().filter(move |curve| curve.class == class);
        curves.filter_map(|curve| Some((curve, curve.values.iter().rfind(supported)?)))
    };
    let class = sweep.classes().into_iter().find(|&class| of_class(class).next().is_some())?;
    let largest = of_class(class).map(|(_, end)| end.triangles).max()?;
    let mut ends: Vec<_> = of_class(class).filter(|(_, end)| end.triangles == largest).collect();
    ends.sort_by(|(_, a), (_, b)| a.ns_per_ray.value.total_cmp(&b.ns_per_ray.value));
    let (curve, end) = *ends.first()?;
    let slope = curve.fit.map_or_else(String::new, |fit| {
        format!("; its cost grows with the power {:.2} of the number of {}", fit.slope, sweep.unit)
    });
    let upper = end.ns_per_ray.interval?.high;
    let reaches = |own: &SweepValue| own.ns_per_ray.interval.is_some_and(|i| i.low <= upper);
    let alike: Vec<&str> = ends[1..]
        .iter()
        .filter(|(_, own)| reaches(own))
        .map(|(curve, _)| curve.structure.as_str())
        .collect();
    let rank = match (ends.len(), alike.as_slice()) {
        (1, _) => String::new(),
        (_, []) => " fastest".to_owned(),
        (_, alike) => format!(" fastest, but is not told apart from {}", alike.join(", ")),
    };
    Some(format!(
        "{} traces {} rays of {} with {} {}{rank}, in {} each{slope}",
        curve.structure,
        class.name(),
        sweep.mesh,
        numbers::count(end.triangles),
        sweep.unit,
        numbers::time(end.ns_per_ray.value),
    ))
}

/// The first structure whose results differ, if any.
fn difference(comparison: &Comparison) -> Option<String> {
    let proofs = comparison.scenes.iter().filter_map(|scene| Some((scene, scene.proof.as_ref()?)));
    for (scene, proof) in proofs {
        if let Some(entry) = proof.structures.iter().find(|entry| !entry.holds()) {
            return Some(format!(
                "RESULTS DIFFER: {} disagrees with {} on {} in {} and {}, so its speed cannot be \
                 compared.",
                entry.structure,
                proof.reference,
                scene.name,
                numbers::things(entry.differing_pixels, "pixel"),
                numbers::things(entry.differing_hits, "hit"),
            ));
        }
    }
    None
}

/// In how many rays and pictures there was no difference, and which pictures were not compared in full.
fn equality(comparison: &Comparison) -> String {
    let scenes = &comparison.scenes;
    let others = |proof: &Proof| -> Vec<u64> {
        let is_other = |entry: &&StructureProof| entry.structure != proof.reference;
        proof.structures.iter().filter(is_other).map(|entry| entry.rays_checked).collect()
    };
    let of_scenes = scenes.iter().filter_map(|scene| scene.proof.as_ref()).flat_map(others);
    let of_sweeps = comparison.sweeps.iter().map(|sweep| sweep.rays_checked);
    // A record may state any numbers.
    let rays = of_scenes.chain(of_sweeps).fold(0, u64::saturating_add);
    let unproved: Vec<String> = scenes.iter().filter_map(unproved).collect();
    let (proved, all) = (scenes.len() - unproved.len(), scenes.len());
    let rays = (rays > 0).then(|| format!("{} compared rays", numbers::count(rays)));
    let pictures = match (proved, all) {
        (0, _) => None,
        (1, 1) => Some("the whole picture".to_owned()),
        (proved, all) if proved == all => Some(format!("{all} whole pictures")),
        (proved, all) => Some(format!("{proved} of {all} whole pictures")),
    };
    let compared: Vec<String> = rays.into_iter().chain(pictures).collect();
    if compared.is_empty() {
        return "no results were compared".to_owned();
    }
    let without = format!("no difference in {}", compared.join(" and "));
    if unproved.is_empty() {
        return without;
    }
    let others = match unproved.len().saturating_sub(NAMED_SCENES) {
        0 => String::new(),
        others => format!(" and {others} more"),
    };
    let named = unproved[..unproved.len().min(NAMED_SCENES)].join(", ");
    format!("{without}; not compared in a whole picture: {named}{others}")
}

/// A scene whose picture was not compared in full with every structure, and what the others rendered instead; `None` if
/// it was.
fn unproved(scene: &SceneRecord) -> Option<String> {
    if scene.structures.len() < 2 {
        return Some(format!("{} (nothing to compare it with)", scene.name));
    }
    let (mut without, mut smaller) = (Vec::new(), Vec::new());
    for structure in scene.structures.iter().filter(|row| !row.has_failed()) {
        let entry = scene.proof.as_ref().and_then(|proof| proof.structure(&structure.name));
        match entry.map(|entry| (entry.picture_equal, entry.picture_hash.is_some())) {
            Some((Some(true), true)) => {}
            Some((Some(true), false)) => smaller.push(structure.name.as_str()),
            _ => without.push(structure.name.as_str()),
        }
    }
    let reasons: Vec<String> = [("no picture", without), ("a smaller one", smaller)]
        .into_iter()
        .filter(|(_, names)| !names.is_empty())
        .map(|(what, names)| format!("{what} from {}", names.join(", ")))
        .collect();
    (!reasons.is_empty()).then(|| format!("{} ({})", scene.name, reasons.join("; ")))
}
