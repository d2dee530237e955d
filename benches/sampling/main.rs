//! What random numbers and shuffling cost, and small frames with either method of sampling.
//!
//! `cargo bench --bench sampling` measures. Everything is checked before it is measured: samples
//! must cover the light evenly, and frames must be those of `none`. How much noise the methods
//! leave is measured by `srt compare --sampling-study`.

mod frames;
mod points;

use criterion::Criterion;

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    let mut group = criterion.benchmark_group("sampling");
    points::measure(&mut group);
    frames::measure(&mut group);
    group.finish();
    criterion.final_summary();
}
