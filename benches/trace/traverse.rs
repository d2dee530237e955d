//! Tracing rays of each class with every structure over a torus knot, on one thread.

use std::time::Duration;

use criterion::{Bencher, BenchmarkId, Criterion, Throughput};
use srt::accel::{Answers, BuildConfig, Scratch};
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
                let mut scratch = Scratch::default();
                group.bench_function(id, |b: &mut Bencher<'_>| {
                    b.iter(|| {
                        let answers = match set.is_shadow() {
                            true => Answers::AnyHit(&mut blocked),
                            false => Answers::ClosestHit(&mut hits),
                        };
                        world.trace(&rays, answers, &mut scratch, None);
                    });
                });
                let (triangles, count) = (Some(knot.triangles), rays.len() as u64);
                rows.push(Row::new("traverse", &name, triangles, count, "rays"));
            }
        }
    }
    group.finish();
}
