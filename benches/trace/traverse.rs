//! Tracing rays of each class with every structure over a torus knot, on one thread.

use std::time::Duration;

use criterion::{Bencher, BenchmarkId, Criterion, Throughput};
use srt::accel::BuildConfig;
use srt::math::Hit;
use srt::scene::STRUCTURES;

use crate::knot::{Knot, spread};
use crate::table::Row;

pub(crate) fn group(criterion: &mut Criterion, knots: &[Knot], rows: &mut Vec<Row>) {
    let mut group = criterion.benchmark_group("traverse");
    group.sample_size(10);
    group.warm_up_time(Duration::from_millis(300)).measurement_time(Duration::from_secs(1));
    for knot in knots {
        for structure in STRUCTURES {
            let world = structure.build(&knot.scene, &BuildConfig::default());
            knot.check(&*world, &knot.sets);
            let linear = matches!(structure.name, "none" | "ball");
            for set in &knot.sets {
                let rays =
                    if linear { spread(&set.rays, knot.linear_rays()) } else { set.rays.clone() };
                let name = format!("{}-{}", set.class, structure.name);
                let id = BenchmarkId::new(&name, knot.triangles);
                group.throughput(Throughput::Elements(rays.len() as u64));
                let mut hits = vec![Hit::MISS; rays.len()];
                let mut blocked = vec![false; rays.len()];
                let closest =
                    |b: &mut Bencher<'_>| b.iter(|| world.intersect(&rays, &mut hits, None));
                let any =
                    |b: &mut Bencher<'_>| b.iter(|| world.occluded(&rays, &mut blocked, None));
                if set.is_shadow() {
                    group.bench_function(id, any)
                } else {
                    group.bench_function(id, closest)
                };
                let (triangles, count) = (Some(knot.triangles), rays.len() as u64);
                rows.push(Row::new("traverse", &name, triangles, count, "rays"));
            }
        }
    }
    group.finish();
}
