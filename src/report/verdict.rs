//! The comparison in one plain sentence.

use super::numbers;
use crate::record::derived::{ClassFigures, Derived, SceneFigures, StructureFigures};
use crate::record::{Comparison, Proof, RayClass, SceneRecord};

/// Who is how much faster than whom, at what, how sure that is, and whether the pictures are equal.
///
/// It speaks of the first scene, of view rays if there were any, and of the fastest structure; if
/// anything differs, it says that instead, because unequal work cannot be compared.
#[must_use]
pub fn verdict(comparison: &Comparison) -> String {
    verdict_of(comparison, &Derived::of(comparison))
}

pub(super) fn verdict_of(comparison: &Comparison, derived: &Derived) -> String {
    let partial = if comparison.run.partial { "Stopped early: " } else { "" };
    if let Some(difference) = difference(comparison) {
        return format!("{partial}{difference}");
    }
    let scenes = derived.scenes.iter().zip(&comparison.scenes);
    let speed = scenes.into_iter().find_map(|(figures, scene)| speed(figures, scene));
    let speed = speed.unwrap_or_else(|| {
        let nothing = "no two structures were traced beside each other";
        if derived.scenes.iter().any(|scene| scene.base.is_some()) {
            nothing.to_owned()
        } else {
            "nothing was traced".to_owned()
        }
    });
    format!("{partial}{speed}; {}.", equality(&comparison.scenes))
}

/// The fastest structure of a scene against its base; yardsticks are not in the running.
fn speed(scene: &SceneFigures, record: &SceneRecord) -> Option<String> {
    let base = scene.base.as_deref()?;
    let class = scene.classes().into_iter().next()?;
    let (fastest, figures) = fastest(scene, record, class)?;
    let traced = scene.structures.iter().filter(|structure| structure.class(class).is_some());
    let others = traced.count() > 1;
    let scene = &scene.scene;
    if fastest.structure == base {
        return others.then(|| {
            format!("no structure traces {} rays of {scene} faster than {base}", class.name())
        });
    }
    let speedup = figures.speedup?;
    let sure = numbers::spread(speedup).map_or_else(
        || "too few rounds for an interval".to_owned(),
        |spread| format!("95\u{a0}%\u{a0}{spread}"),
    );
    Some(format!(
        "{} traces {} rays of {scene} {}\u{a0}× ({sure}) as fast as {base}",
        fastest.structure,
        class.name(),
        numbers::median(speedup),
    ))
}

fn fastest<'a>(
    scene: &'a SceneFigures,
    record: &SceneRecord,
    class: RayClass,
) -> Option<(&'a StructureFigures, &'a ClassFigures)> {
    let is_yardstick = |name: &str| record.structure(name).is_some_and(|row| row.yardstick);
    let time = |figures: &ClassFigures| figures.ns_per_ray.map(|estimate| estimate.median);
    scene
        .structures
        .iter()
        .filter(|structure| !is_yardstick(&structure.structure))
        .filter_map(|structure| Some((structure, structure.class(class)?)))
        .filter(|(_, figures)| time(figures).is_some())
        .min_by(|(_, a), (_, b)| {
            let (a, b) = (time(a).unwrap_or(f64::MAX), time(b).unwrap_or(f64::MAX));
            a.total_cmp(&b)
        })
}

/// The first structure whose answers differ, if any.
fn difference(comparison: &Comparison) -> Option<String> {
    let proofs = comparison.scenes.iter().filter_map(|scene| Some((scene, scene.proof.as_ref()?)));
    for (scene, proof) in proofs {
        if let Some(entry) = proof.structures.iter().find(|entry| !entry.holds()) {
            return Some(format!(
                "THE ANSWERS DIFFER: {} disagrees with {} on {} in {} and {}, so its speed \
                 means nothing.",
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

/// What was shown to be equal.
fn equality(scenes: &[SceneRecord]) -> String {
    let compared = |proof: &Proof| {
        proof.structures.len() > 1 && proof.structures.iter().all(|e| e.picture_equal == Some(true))
    };
    let proved = scenes.iter().filter(|scene| scene.proof.as_ref().is_some_and(compared)).count();
    match (proved, scenes.len()) {
        (0, _) => "no pictures were compared".to_owned(),
        (a, b) if a == b => "pictures equal bit for bit".to_owned(),
        (a, b) => format!("pictures equal bit for bit in {a} of {b} scenes, the others unproved"),
    }
}
