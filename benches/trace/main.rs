//! What parsing, building, tracing and single formulas cost, as criterion measures it.
//!
//! `cargo bench --bench trace` measures the groups `parse`, `build`, `refit`, `traverse` and
//! `shapes` and writes `results/benchmarks.md`; a filter behind `--`, such as the name of a group, measures a
//! part and leaves the table alone. `frames`, which has to be named, measures whole pictures with
//! one thread and with two, and prints. Before anything is measured, its results are compared with
//! those of `none`.

mod build;
mod frames;
mod knot;
mod parse;
mod refit;
mod shapes;
mod table;
mod traverse;

use criterion::Criterion;
use knot::Knot;

fn main() {
    if std::env::args().any(|argument| argument == "frames") {
        frames::measure();
        return;
    }
    // A run with `--test` measures nothing, and so has nothing to write.
    let whole =
        std::env::args().skip(1).all(|argument| argument.starts_with("--") && argument != "--test");
    let mut criterion = Criterion::default().configure_from_args();
    let mut rows = Vec::new();
    let knots = [1_000, 70_000, 1_000_000].map(Knot::new);
    parse::group(&mut criterion, &mut rows);
    build::group(&mut criterion, &knots, &mut rows);
    refit::group(&mut criterion, &mut rows);
    traverse::group(&mut criterion, &knots, &mut rows);
    shapes::group(&mut criterion, &mut rows);
    criterion.final_summary();
    if whole {
        table::write(&rows);
    }
}
