//! Every raw round, in nanoseconds and counts, as it was measured.

use super::{Cell, Table};
use crate::record::{HardwareCounters, Round, SceneRecord, StructureRecord};

/// All rounds of a scene, a row for each measurement.
pub(in crate::report) fn round_table(scene: &SceneRecord) -> Table {
    let heads = ["Measured", "Structure", "Unit", "Rounds, in the order of measurement"];
    let mut table = Table::new("Every raw round", "", &heads);
    for structure in &scene.structures {
        for (measured, unit, values) in lines(structure) {
            table.rows.push(vec![
                Cell::text(measured),
                Cell::text(&structure.name),
                Cell::text(unit),
                Cell::text(list(&values)),
            ]);
        }
    }
    table
}

type Line = (String, &'static str, Vec<u64>);

fn lines(structure: &StructureRecord) -> Vec<Line> {
    let picture = &structure.picture_rounds;
    let mut lines: Vec<Line> = vec![
        ("build, 1 thread".to_owned(), "ns", structure.build.one_thread_ns.clone()),
        ("build, all threads".to_owned(), "ns", structure.build.all_threads_ns.clone()),
        ("picture, build".to_owned(), "ns", picture.iter().map(|r| r.build_ns).collect()),
        ("picture, render".to_owned(), "ns", picture.iter().map(|r| r.render_ns).collect()),
    ];
    for class in &structure.classes {
        lines.extend(class_lines(class.class.name(), &class.rounds));
    }
    lines.retain(|(_, _, values)| !values.is_empty());
    lines
}

fn class_lines(class: &str, rounds: &[Round]) -> Vec<Line> {
    let line = |what: &str, unit, get: &dyn Fn(&Round) -> Option<u64>| {
        (format!("{class} rays, {what}"), unit, rounds.iter().filter_map(get).collect())
    };
    let hardware = |get: fn(&HardwareCounters) -> Option<u64>| {
        move |round: &Round| round.hardware.as_ref().and_then(get)
    };
    vec![
        line("wall", "ns", &|round| Some(round.wall_ns)),
        line("CPU", "ns", &|round| round.cpu_ns),
        line("cycles", "count", &hardware(|h| h.cycles)),
        line("instructions", "count", &hardware(|h| h.instructions)),
        line("branch misses", "count", &hardware(|h| h.branch_misses)),
        line("cache misses", "count", &hardware(|h| h.cache_misses)),
    ]
}

fn list(values: &[u64]) -> String {
    values.iter().map(u64::to_string).collect::<Vec<_>>().join(" ")
}
