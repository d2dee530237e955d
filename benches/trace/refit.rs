//! Trees that follow a mesh which is deformed, on one thread: the tree alone, without packing triangles, in each way
//! that a structure offers, beside building it anew.

use std::time::{Duration, Instant};

use criterion::{BenchmarkId, Criterion, Throughput};
use glam::{Quat, Vec3};
use rayon::ThreadPool;
use srt::accel::{Accel, BuildConfig, Bvh, Bvh8, ClosestHit, Exhaustive, Indexed, Moved, Update};
use srt::assets::MeshData;
use srt::assets::generate::{MeshKind, generate};
use srt::math::{Hit, Random, Ray};
use srt::shapes::{MeshError, TriangleSet};

use crate::table::Row;

/// Rays whose hits are compared with those of no structure.
const CHECKED: usize = 64;

pub(crate) fn group(criterion: &mut Criterion, rows: &mut Vec<Row>) {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread");
    for triangles in [100_000, 1_000_000] {
        let knot = Wrung::new(triangles);
        measure::<Bvh>("bvh", &knot, &pool, criterion, rows);
        measure::<Bvh8>("bvh8", &knot, &pool, criterion, rows);
    }
}

/// A knot that is wrung a little, and a little more.
struct Wrung {
    triangles: Vec<[u32; 3]>,
    positions: [Vec<Vec3>; 3],
}

impl Wrung {
    fn new(triangles: u32) -> Self {
        let MeshData { positions, triangles, .. } = generate(MeshKind::TorusKnot, triangles, 1);
        let wrung = |degrees: f32| {
            let turned = |p: &Vec3| Quat::from_rotation_z((degrees * p.z).to_radians()) * *p;
            positions.iter().map(turned).collect()
        };
        Self { triangles, positions: [0.0, 5.0, 10.0].map(wrung) }
    }

    fn set(&self, state: usize) -> TriangleSet {
        TriangleSet::new(&self.positions[state], &self.triangles)
    }
}

fn measure<A: Accel + Clone>(
    name: &str,
    knot: &Wrung,
    pool: &ThreadPool,
    criterion: &mut Criterion,
    rows: &mut Vec<Row>,
) {
    let mut group = criterion.benchmark_group("refit");
    group.sample_size(10);
    group.warm_up_time(Duration::from_millis(500)).measurement_time(Duration::from_secs(3));
    let count = knot.triangles.len() as u64;
    group.throughput(Throughput::Elements(count));
    let config = BuildConfig::default();
    let row = |what: &str| {
        let name = format!("{name} {what}");
        (BenchmarkId::new(&name, count), Row::new("refit", &name, Some(count), count, "triangles"))
    };
    let (id, own_row) = row("build");
    rows.push(own_row);
    let set = knot.set(1);
    group.bench_function(id, |b| {
        b.iter_custom(|times| {
            let built = (0..times).map(|_| {
                let own: Indexed<_, A> = Indexed::build(set.clone(), &config);
                // Bringing the triangles into the order of the tree is no part of it.
                let order = own.build_stages().iter().find(|(stage, _)| *stage == "primitives");
                own.build_time() - order.map_or(Duration::ZERO, |(_, time)| time)
            });
            pool.install(|| built.sum())
        });
    });
    let built: Indexed<_, A> = Indexed::build(knot.set(0), &config);
    for &update in A::UPDATES {
        let (id, own_row) = row(match update {
            Update::Refit => "refit",
            Update::Rotate => "rotate",
            Update::Partial => "partial",
        });
        rows.push(own_row);
        let mut own = built.clone();
        let mut state = 0;
        let mut step = || {
            state = 3 - state.max(1);
            follow(&mut own, update, knot, state)
        };
        step();
        group.bench_function(id, |b| {
            b.iter_custom(|times| pool.install(|| (0..times).map(|_| step()).sum()));
        });
        check(&own, &knot.set(state));
    }
    group.finish();
}

/// Moves the triangles; returns the time that the tree took to follow.
fn follow<A: Accel>(
    own: &mut Indexed<TriangleSet, A>,
    update: Update,
    knot: &Wrung,
    state: usize,
) -> Duration {
    let (begin, mut time) = (std::cell::Cell::new(Instant::now()), Duration::ZERO);
    let change = |set: &mut TriangleSet| {
        set.move_to(&knot.positions[state], &knot.triangles)?;
        begin.set(Instant::now());
        Ok::<(), MeshError>(())
    };
    let settle = |set: &mut TriangleSet, bounds: &_| {
        time = begin.get().elapsed();
        set.settle(bounds)
    };
    own.refit(update, Moved::All, change, settle).expect("the triangles can be traced");
    time
}

/// # Panics
/// If a hit differs from that of no structure: what is wrong is not measured.
fn check<A: Accel>(own: &Indexed<TriangleSet, A>, set: &TriangleSet) {
    let none: Indexed<_, Exhaustive> = Indexed::build(set.clone(), &BuildConfig::default());
    let mut random = Random::new(&[11]);
    let mut point = || Vec3::from_array(std::array::from_fn(|_| 2.0 * random.next_f32() - 1.0));
    let rays: Vec<Ray> = (0..CHECKED).map(|_| Ray::new(3.0 * point(), point())).collect();
    let (mut expected, mut hits) = ([Hit::MISS; CHECKED], [Hit::MISS; CHECKED]);
    none.answer(&ClosestHit, &rays, &mut expected);
    own.answer(&ClosestHit, &rays, &mut hits);
    assert!(hits.iter().zip(&expected).all(|(hit, right)| hit.same_bits(right)), "other hits");
}
