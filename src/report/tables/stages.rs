//! The stages of builds and their times.

use super::{Cell, Table};
use crate::record::{SceneRecord, StructureRecord};
use crate::report::numbers;

/// The stages of the builds, in order. A structure with a single stage has no row: that is its whole build.
pub(in crate::report) fn stage_table(scene: &SceneRecord, threads: u32) -> Table {
    let note = format!(
        "Wall times of one build on {}: that of the structure that was traced. Shares are of all \
         stages together.",
        numbers::things(u64::from(threads), "thread")
    );
    let heads = ["Structure", "Stage", "#Time", "#Share"];
    let mut table = Table::new("Stages of the builds", note, &heads);
    let staged = scene.structures.iter().filter(|own| own.build.stages.len() > 1);
    table.rows = staged.flat_map(stage_rows).collect();
    table
}

fn stage_rows(structure: &StructureRecord) -> impl Iterator<Item = Vec<Cell>> {
    let stages = &structure.build.stages;
    let all = stages.iter().map(|stage| stage.ns).fold(0, u64::saturating_add);
    stages.iter().map(move |stage| {
        let share = (all > 0).then(|| stage.ns as f64 / all as f64);
        vec![
            Cell::text(&structure.name),
            Cell::text(&stage.name),
            Cell::text(numbers::time(stage.ns as f64)),
            Cell::of(share, numbers::percent),
        ]
    })
}
