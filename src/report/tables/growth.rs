//! The tables of a sweep: cost at each size, and the slopes.

use super::{Cell, Table};
use crate::analysis::{SweepCurve, SweepFigures};
use crate::record::{Dropped, RayClass, Sweep};
use crate::report::numbers;

/// Slopes, then the cost of a ray at each size.
pub(in crate::report) fn growth_tables(sweep: &Sweep, figures: &SweepFigures) -> Vec<Table> {
    vec![slopes(figures, sweep), costs(figures)]
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
        "The slope is the exponent of the power law fitted to the medians of time per ray against \
         triangles: 0 is constant, 1 is linear. {checked}"
    );
    let mut table = Table::new("Slopes", note, &heads);
    let dropped_at = |entry: &Dropped| {
        format!("at {} triangles: {}", numbers::count(entry.triangles), entry.reason)
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
    let heads = ["Class", "Structure", "#Triangles", "#ns/ray", "#Rounds"];
    let mut table = Table::new("Cost at each size", "", &heads);
    for curve in by_class(figures) {
        table.rows.extend(curve.values.iter().map(|value| {
            vec![
                Cell::text(curve.class.name()),
                Cell::text(&curve.structure),
                Cell::text(numbers::whole(value.triangles)),
                Cell::estimate(Some(value.ns_per_ray)),
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
