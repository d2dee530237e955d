//! Tracing rays of each class with every structure over a torus knot, on one thread.

use std::time::Duration;

use criterion::{BenchmarkId, Criterion, Throughput};
use srt::accel::BuildConfig;
use srt::scene::STRUCTURES;

use crate::knot::Knot;
use crate::table::Row;

pub(crate) fn group(criterion: &mut Criterion, knots: &[Knot], rows: &mut Vec<Row>) {
    let mut group = criterion.benchmark_group("traverse");
    group.sample_size(10);
    group.warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(1));
    for knot in knots {
        for structure in STRUCTURES {
            let world = structure.build(&knot.scene, &BuildConfig::default());
            knot.check(&*world);
            let linear = matches!(structure.name, "none" | "ball");
            for set in &knot.sets {
                let set = if linear { set.spread(knot.linear_rays()) } else { set.clone() };
                let name = format!("{}-{}", set.class.name(), structure.name);
                let id = BenchmarkId::new(&name, knot.triangles);
                let rays = &set.rays;
                group.throughput(Throughput::Elements(rays.len() as u64));
                let mut results = set.results();
                group.bench_function(id, |b| b.iter(|| results.trace(&*world, rays)));
                let (triangles, count) = (Some(knot.triangles), rays.len() as u64);
                rows.push(Row::new("traverse", &name, triangles, count, "rays"));
            }
        }
    }
    group.finish();
}
