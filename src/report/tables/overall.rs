//! All scenes at a glance: how fast each structure is, and in how much its results were compared.

use super::{Cell, Table, agreement, compared_without_difference, structure_name};
use crate::analysis::OverallFigures;
use crate::record::{Comparison, RayClass, SceneRecord, StructureRecord};
use crate::report::{Report, numbers};

/// Geometric means over the scenes, a row for each structure; without rows for a single scene.
pub(in crate::report) fn overall_table(report: &Report<'_>) -> Table {
    let Report { comparison, analysis, .. } = report;
    let traced = |class: &RayClass| analysis.overall.iter().any(|own| own.class == *class);
    let classes: Vec<RayClass> = RayClass::ALL.into_iter().filter(traced).collect();
    let heads: Vec<String> = std::iter::once("Structure".to_owned())
        .chain(classes.iter().map(|class| format!("#{}", class.name())))
        .collect();
    let heads: Vec<&str> = heads.iter().map(String::as_str).collect();
    let note = format!(
        "How many times as fast as {}, per ray: geometric means over the scenes whose ratio has an \
         interval that supports a statement. Below each is the number of these scenes. Only means over \
         the same scenes can be compared.",
        comparison.base
    );
    let mut table = Table::new("All scenes together", note, &heads);
    if comparison.scenes.len() < 2 {
        return table;
    }
    let mut names: Vec<&str> = analysis.overall.iter().map(|own| own.structure.as_str()).collect();
    names.dedup();
    let row = |name: &&str| {
        let cell = |class: &RayClass| {
            let is_own = |own: &&OverallFigures| own.structure == *name && own.class == *class;
            analysis.overall.iter().find(is_own).map_or_else(Cell::nothing, |own| Cell {
                text: numbers::figures(own.speedup),
                spread: Some(numbers::things(own.scenes.into(), "scene")),
            })
        };
        let scene = comparison.scenes.iter().find(|scene| scene.structure(name).is_some());
        let name = scene.map_or_else(|| Cell::text(*name), |scene| structure_name(scene, name));
        std::iter::once(name).chain(classes.iter().map(cell)).collect()
    };
    table.rows = names.iter().map(row).collect();
    table
}

/// What was compared in which scene, a row for each scene; without rows for a single scene, which has a table of its
/// own.
pub(in crate::report) fn proof_matrix(comparison: &Comparison) -> Table {
    let mut names: Vec<&str> = Vec::new();
    for row in comparison.scenes.iter().flat_map(|scene| &scene.structures) {
        if !names.contains(&row.name.as_str()) {
            names.push(&row.name);
        }
    }
    let heads: Vec<&str> = std::iter::once("Scene").chain(names.iter().copied()).collect();
    let note = "In how many recorded rays, and in a picture of which size, results were compared with the \
                reference's, bit for bit; of peers, which are as shipped, how many agree.";
    let mut table = Table::new("What was compared", note, &heads);
    if comparison.scenes.len() < 2 {
        return table;
    }
    let row = |scene: &SceneRecord| {
        let cells = names.iter().map(|name| proved(scene, name));
        std::iter::once(Cell::text(&scene.name)).chain(cells).collect()
    };
    table.rows = comparison.scenes.iter().map(row).collect();
    table
}

fn proved(scene: &SceneRecord, name: &str) -> Cell {
    let failed = scene.structure(name).is_some_and(StructureRecord::has_failed);
    if let Some(peer) = scene.proof.as_ref().and_then(|proof| proof.peer(name)).filter(|_| !failed)
    {
        return Cell::text(agreement(peer));
    }
    let entry = scene.proof.as_ref().and_then(|proof| Some((proof, proof.structure(name)?)));
    let Some((proof, entry)) = entry else {
        return if failed { Cell::text("failed") } else { Cell::nothing() };
    };
    let compared = compared_without_difference(entry);
    let text = match compared {
        _ if !entry.holds() => "DIFFERS",
        _ if failed => "failed",
        _ if proof.reference == name => "the reference",
        Some(_) => "no difference",
        None => return Cell::nothing(),
    };
    Cell { text: text.to_owned(), spread: compared }
}
