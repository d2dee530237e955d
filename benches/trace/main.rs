//! Parsing, building, and rays of each class, for every structure on generated meshes.
//!
//! `cargo bench --bench trace` measures and writes `results/benchmarks.md`; a filter behind `--`
//! measures a part and leaves the table alone. Every group first checks its answers against
//! `none`: a wrong structure is not measured.

mod measure;
mod rays;
mod table;

use criterion::Criterion;

fn main() {
    let whole = std::env::args().skip(1).all(|argument| argument.starts_with("--"));
    let mut criterion = Criterion::default().configure_from_args();
    let mut rows = Vec::new();
    measure::parsing(&mut criterion, &mut rows);
    for triangles in [1_000, 70_000, 1_000_000] {
        measure::mesh(&mut criterion, triangles, &mut rows);
    }
    criterion.final_summary();
    if whole {
        table::write(&rows);
    }
}
