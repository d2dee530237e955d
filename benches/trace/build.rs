//! Building every structure over a torus knot, on all threads.

use std::time::Duration;

use criterion::{BenchmarkId, Criterion, Throughput};
use srt::accel::BuildConfig;
use srt::scene::STRUCTURES;

use crate::knot::Knot;
use crate::table::Row;

pub(crate) fn group(criterion: &mut Criterion, knots: &[Knot], rows: &mut Vec<Row>) {
    let mut group = criterion.benchmark_group("build");
    group.sample_size(10);
    group.warm_up_time(Duration::from_millis(500)).measurement_time(Duration::from_secs(3));
    for knot in knots {
        group.throughput(Throughput::Elements(knot.triangles));
        for structure in STRUCTURES {
            let config = BuildConfig::default();
            knot.check(&*structure.build(&knot.scene, &config));
            let id = BenchmarkId::new(structure.name, knot.triangles);
            group.bench_function(id, |b| b.iter(|| structure.build(&knot.scene, &config)));
            let triangles = knot.triangles;
            rows.push(Row::new("build", structure.name, Some(triangles), triangles, "triangles"));
        }
    }
    group.finish();
}
