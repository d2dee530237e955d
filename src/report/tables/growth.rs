//! The tables of a sweep: cost at each size, and the slopes.

use super::{Cell, Table};
use crate::analysis::{SweepCurve, SweepFigures};
use crate::record::{Dropped, RayClass, Sweep};
use crate::report::numbers;

/// Slopes, then the cost of a ray at each size.
pub(in crate::report) fn growth_tables(sweep: &Sweep, figures: &SweepFigures) -> Vec<Table> {
    vec![slopes(figures, sweep), costs(figures)]
}

/// The time of a ray in nanoseconds for each structure, and each size in a column of its own; a table for each class.
pub(in crate::report) fn size_tables(figures: &SweepFigures) -> Vec<Table> {
    figures.classes().into_iter().map(|class| size_table(figures, class)).collect()
}

fn size_table(figures: &SweepFigures, class: RayClass) -> Table {
    let curves = || figures.curves.iter().filter(move |curve| curve.class == class);
    let mut sizes: Vec<u64> =
        curves().flat_map(|curve| curve.values.iter().map(|value| value.triangles)).collect();
    sizes.sort_unstable();
    sizes.dedup();
    let heads: Vec<String> = std::iter::once("structure".to_owned())
        .chain(sizes.iter().map(|&size| format!("#{}", numbers::count(size))))
        .chain(["#slope".to_owned()])
        .collect();
    let heads: Vec<&str> = heads.iter().map(String::as_str).collect();
    let title = format!("{}: ns per {} ray by {}", figures.mesh, class.name(), figures.unit);
    let mut table = Table::new(title, "", &heads);
    let row = |curve: &SweepCurve| {
        let at = |size: &u64| {
            let value = curve.values.iter().find(|value| value.triangles == *size);
            Cell::compared(value.map(|value| value.ns_per_ray))
        };
        std::iter::once(Cell::text(&curve.structure))
            .chain(sizes.iter().map(at))
            .chain([Cell::of(curve.fit, |fit| format!("{:.2}", fit.slope))])
            .collect()
    };
    table.rows = curves().map(row).collect();
    table
}

fn slopes(figures: &SweepFigures, sweep: &Sweep) -> Table {
    let heads = ["Class", "Structure", "#Slope", "#Standard error", "#Sizes", "Stopped"];
    let checked = match sweep.rays_checked {
        0 => "No hits were compared.".to_owned(),
        rays => format!(
            "At each size hits were compared bit for bit before anything was timed: {} in all.",
            numbers::things(rays, "result")
        ),
    };
    let note = format!(
        "The slope is the exponent of the power law fitted to time per ray against {}: 0 is \
         constant, 1 is linear. It is a summary over all sizes; the local slopes below show whether \
         one power holds. {checked}",
        figures.unit
    );
    let mut table = Table::new("Slopes", note, &heads);
    let dropped_at = |entry: &Dropped| {
        format!("at {} {}: {}", numbers::count(entry.triangles), sweep.unit, entry.reason)
    };
    let dropped =
        |curve: &SweepCurve| sweep.dropped.iter().find(|entry| entry.structure == curve.structure);
    for curve in by_class(figures) {
        table.rows.push(vec![
            Cell::text(curve.class.name()),
            Cell::text(&curve.structure),
            Cell::of(curve.fit, |fit| format!("{:.2}", fit.slope)),
            Cell::of(curve.fit.and_then(|fit| fit.slope_error), |error| format!("{error:.2}")),
            Cell::text(curve.values.len().to_string()),
            Cell::of(dropped(curve), dropped_at),
        ]);
    }
    // A structure that was dropped before anything was timed has no curve, but a reason.
    let timed = |entry: &Dropped| figures.curves.iter().any(|c| c.structure == entry.structure);
    for entry in sweep.dropped.iter().filter(|entry| !timed(entry)) {
        table.rows.push(vec![
            Cell::nothing(),
            Cell::text(&entry.structure),
            Cell::nothing(),
            Cell::nothing(),
            Cell::text("0"),
            Cell::text(dropped_at(entry)),
        ]);
    }
    table
}

fn costs(figures: &SweepFigures) -> Table {
    let size = if figures.unit == "objects" { "#Objects" } else { "#Triangles" };
    let heads = ["Class", "Structure", size, "#ns/ray", "#Local slope", "#Rounds"];
    let note = "The local slope is the exponent of the power law from the size before to this one.";
    let mut table = Table::new("Cost at each size", note, &heads);
    for curve in by_class(figures) {
        table.rows.extend(curve.values.iter().map(|value| {
            vec![
                Cell::text(curve.class.name()),
                Cell::text(&curve.structure),
                Cell::text(numbers::whole(value.triangles)),
                Cell::compared(Some(value.ns_per_ray)),
                Cell::of(value.slope, |slope| format!("{slope:.2}")),
                Cell::text(value.ns_per_ray.rounds.to_string()),
            ]
        }));
    }
    table
}

/// The curves, those of a class together.
fn by_class(figures: &SweepFigures) -> impl Iterator<Item = &SweepCurve> {
    let of_class =
        |class: RayClass| figures.curves.iter().filter(move |curve| curve.class == class);
    RayClass::ALL.into_iter().flat_map(of_class)
}
