//! The comparison in one plain sentence.

use super::{Report, numbers};
use crate::analysis::{ClassFigures, SceneFigures, StructureFigures, SweepFigures};
use crate::record::{Comparison, Proof, RayClass, SceneRecord, Status, StructureRecord};

/// How many scenes without a whole proof are named; further ones are counted.
const NAMED_SCENES: usize = 3;

/// The whole sentence: see [`Report::verdict`].
pub(super) fn verdict(report: &Report<'_>) -> String {
    match headline(report) {
        (claim, Some(rest)) => format!("{claim}; {rest}"),
        (claim, None) => claim,
    }
}

/// The verdict's claim, and the rest: of how many pictures equality was proved.
pub(super) fn headline(report: &Report<'_>) -> (String, Option<String>) {
    let Report { comparison, analysis, .. } = report;
    let partial = if comparison.run.partial { "Stopped early: " } else { "" };
    if let Some(difference) = difference(comparison) {
        return (format!("{partial}{difference}"), None);
    }
    let without_scenes = comparison.scenes.is_empty();
    let growth = || analysis.sweeps.iter().filter(|_| without_scenes).find_map(growth);
    let scenes = analysis.scenes.iter().zip(&comparison.scenes);
    let speeds: Vec<_> = scenes.filter_map(|(figures, scene)| speed(figures, scene)).collect();
    let chosen = speeds.iter().find(|speed| speed.is_ok()).or(speeds.first()).cloned();
    let speed = chosen.map(|speed| speed.unwrap_or_else(|too_few| too_few));
    let speed = speed.or_else(growth).unwrap_or_else(|| {
        let nothing = "no two structures traced the same rays";
        if analysis.scenes.iter().any(|scene| scene.base.is_some()) {
            nothing.to_owned()
        } else {
            "nothing was traced".to_owned()
        }
    });
    let equality = equality(&comparison.scenes);
    match failures(comparison) {
        Some(failed) => (format!("{partial}{failed}"), Some(format!("{speed}; {equality}."))),
        None => (format!("{partial}{speed}"), Some(format!("{equality}."))),
    }
}

/// The structures that failed, each once, with the first reason. Peers are left out: they do not support all shapes.
fn failures(comparison: &Comparison) -> Option<String> {
    let mut failures: Vec<(&str, String, &str)> = Vec::new();
    let mut add = |name, place, message| {
        if failures.iter().all(|(other, ..)| *other != name) {
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
            let triangles = numbers::count(entry.triangles);
            let place = format!("the sweep, in {} with {triangles} triangles", sweep.mesh);
            add(&entry.structure, place, &entry.reason);
        }
    }
    let text = |(name, place, message): &(&str, String, &str)| {
        format!("{name} FAILED in {place}: {message}")
    };
    let texts: Vec<String> = failures.iter().map(text).collect();
    (!texts.is_empty()).then(|| texts.join("; "))
}

/// The fastest structure of a scene against its base, peers left out; an error if there were too few rounds.
fn speed(scene: &SceneFigures, record: &SceneRecord) -> Option<Result<String, String>> {
    let base = scene.base.as_deref()?;
    let class = scene.classes().into_iter().next()?;
    let (fastest, figures) = fastest(scene, record, class)?;
    let traced = scene.structures.iter().filter(|structure| structure.class(class).is_some());
    let others = traced.count() > 1;
    let scene = &scene.scene;
    let too_few = || Err(format!("{scene} has too few rounds for intervals"));
    if fastest.structure == base {
        let has_interval = figures.ns_per_ray.is_some_and(|estimate| estimate.interval.is_some());
        let none =
            format!("no structure traces {} rays of {scene} faster than {base}", class.name());
        return others.then(|| if has_interval { Ok(none) } else { too_few() });
    }
    let speedup = figures.speedup?;
    let Some(spread) = numbers::spread(speedup) else { return Some(too_few()) };
    Some(Ok(format!(
        "{} traces {} rays of {scene} {}\u{a0}× (95\u{a0}%\u{a0}{spread}) as fast as {base}",
        fastest.structure,
        class.name(),
        numbers::median(speedup),
    )))
}

/// The fastest structure at the largest size of a sweep, and how its cost grows.
fn growth(sweep: &SweepFigures) -> Option<String> {
    let class = sweep.classes().into_iter().next()?;
    let ends = sweep.curves.iter().filter(|curve| curve.class == class);
    let ends = ends.filter_map(|curve| Some((curve, curve.values.last()?)));
    let (curve, end) = ends.min_by(|(_, a), (_, b)| {
        let time = a.ns_per_ray.median.total_cmp(&b.ns_per_ray.median);
        b.triangles.cmp(&a.triangles).then(time)
    })?;
    let slope = curve.fit.map_or_else(String::new, |fit| {
        format!("; its cost grows with the power {:.2} of the number of triangles", fit.slope)
    });
    Some(format!(
        "{} traces {} rays of {} with {} triangles fastest, in {} each{slope}",
        curve.structure,
        class.name(),
        sweep.mesh,
        numbers::count(end.triangles),
        numbers::time(end.ns_per_ray.median),
    ))
}

fn fastest<'a>(
    scene: &'a SceneFigures,
    record: &SceneRecord,
    class: RayClass,
) -> Option<(&'a StructureFigures, &'a ClassFigures)> {
    let is_peer = |name: &str| record.structure(name).is_some_and(|row| row.peer);
    let time = |figures: &ClassFigures| figures.ns_per_ray.map(|estimate| estimate.median);
    scene
        .structures
        .iter()
        .filter(|structure| !is_peer(&structure.structure))
        .filter_map(|structure| Some((structure, structure.class(class)?)))
        .filter(|(_, figures)| time(figures).is_some())
        .min_by(|(_, a), (_, b)| {
            let (a, b) = (time(a).unwrap_or(f64::MAX), time(b).unwrap_or(f64::MAX));
            a.total_cmp(&b)
        })
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

/// How many pictures were proved equal, and why the others were not.
fn equality(scenes: &[SceneRecord]) -> String {
    let compared = |scene: &SceneRecord| {
        let equal = |proof: &Proof| proof.structures.iter().any(|e| e.picture_equal == Some(true));
        scene.proof.as_ref().is_some_and(|proof| proof.structures.len() > 1 && equal(proof))
    };
    let unproved: Vec<String> = scenes.iter().filter_map(unproved).collect();
    let proved = scenes.len() - unproved.len();
    if !scenes.iter().any(compared) {
        return "no pictures were compared".to_owned();
    }
    if unproved.is_empty() {
        return "pictures equal bit for bit".to_owned();
    }
    let others = match unproved.len().saturating_sub(NAMED_SCENES) {
        0 => String::new(),
        others => format!(" and {others} more"),
    };
    format!(
        "{proved} of {} pictures proved equal bit for bit, {} not compared in full: {}{others}",
        scenes.len(),
        unproved.len(),
        unproved[..unproved.len().min(NAMED_SCENES)].join(", "),
    )
}

/// A scene whose picture was not compared in full with every structure, and what the others rendered instead; `None` if
/// it was.
fn unproved(scene: &SceneRecord) -> Option<String> {
    if scene.structures.len() < 2 {
        return Some(format!("{} (nothing to compare it with)", scene.name));
    }
    let (mut without, mut smaller) = (Vec::new(), Vec::new());
    let failed = |row: &&StructureRecord| matches!(row.status, Status::Failed { .. });
    for structure in scene.structures.iter().filter(|row| !failed(row)) {
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
