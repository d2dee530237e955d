//! Records to make reports of, with figures as they might be measured.

mod chapters;
mod noise;
mod pictures;
mod scenes;

use srt::record::*;

pub(crate) use pictures::pictures;

use chapters::{sampling, sweep};
use pictures::hash;
use scenes::{bunny, hall};

fn run() -> Run {
    Run {
        command: "srt compare scenes/bunny.sce scenes/hall.sce --accel none,ball,bvh,cwbvh \
                  --sweep 1k..1M --mesh hall --budget 180"
            .to_owned(),
        date: "2026-03-14T15:09:26+01:00".to_owned(),
        version: "0.1.0".to_owned(),
        commit: Some("b103d88f2c51".to_owned()),
        sources: Some("5ace".repeat(16)),
        compiler: "rustc 1.91.0".to_owned(),
        profile: "release".to_owned(),
        flags: String::new(),
        machine: Machine {
            cpu: "Example CPU <16 & more> @ 2.60GHz".to_owned(),
            cores: 2,
            memory_bytes: Some(16_624_877_568),
            os: "Linux 6.1".to_owned(),
            instruction_set: "avx512".to_owned(),
            governor: Some("performance".to_owned()),
            load_at_start: Some([0.12, 0.31, 0.28]),
        },
        seed: 42,
        budget_seconds: Some(180.0),
        elapsed_seconds: 171.8,
        partial: false,
        done: vec!["bunny".to_owned()],
        options: Options {
            threads: 2,
            trace_threads: 1,
            size: Some([640, 480]),
            aa: Some(1),
            light_samples: 2,
            max_recursion: Some(5),
            sampling: "shuffled".to_owned(),
            build: "medium".to_owned(),
        },
        rounds: RoundRule { warmup: 1, at_least: 10, relative_interval: 0.02 },
        between_runs: 0.0,
    }
}

/// Two scenes, four structures, one of them too slow for the second scene, a sweep, a chapter on
/// sampling.
pub(crate) fn full() -> Comparison {
    let mut comparison = Comparison::new(run(), "none");
    comparison.conformance = vec![conforming("grid")];
    comparison.scenes = vec![bunny(), hall()];
    comparison.sweeps = vec![sweep()];
    comparison.sampling = Some(sampling());
    comparison.baseline = Some(baseline());
    comparison.notes = vec!["The hall was generated with seed 1.".to_owned()];
    comparison
}

/// A structure that had no time for the whole check, and differed nowhere.
fn conforming(structure: &str) -> Conformance {
    Conformance {
        structure: structure.to_owned(),
        outcome: ConformanceOutcome::Equal,
        rays: 211_904,
        hits: 98_317,
        meshes_checked: 23,
        meshes: 28,
        seconds: 3.004,
    }
}

/// One that differs and one that panics.
fn nonconforming() -> Vec<Conformance> {
    let difference = ConformanceDifference {
        mesh: "nested".to_owned(),
        scale: 1e6,
        offset: [0.0, -1.5, 1e6],
        build: "medium".to_owned(),
        way: "alone".to_owned(),
        ray: "Ray { origin: Vec3(0.25, 1.0, 5.0), t_min: 0.0, dir: <Vec3> }".to_owned(),
        expected: "Hit { t: 0.5, object: 0, prim: 7, u: 0.25, v: 0.125 }, blocked".to_owned(),
        got: "no hit, not blocked".to_owned(),
    };
    let wrong = |structure: &str, outcome| Conformance {
        structure: structure.to_owned(),
        outcome,
        seconds: 0.25,
        ..Conformance::default()
    };
    vec![
        wrong("kd-tree", ConformanceOutcome::Differs(difference)),
        wrong(
            "mine",
            ConformanceOutcome::Failed { message: "it panicked: out of | luck".to_owned() },
        ),
    ]
}

/// A class that became slower and one that did not, on another machine.
fn baseline() -> Baseline {
    let change = |class, median: f64| Change {
        scene: "bunny".to_owned(),
        structure: "bvh".to_owned(),
        class,
        slowdown: Estimate {
            value: median,
            interval: Some(Interval { low: median - 0.02, high: median + 0.03 }),
            rounds: 12,
        },
    };
    Baseline {
        threshold: 0.1,
        outcome: Changes {
            changes: vec![change(RayClass::View, 1.31), change(RayClass::Shadow, 1.01)],
            warnings: vec![
                "The seed was 1 and is 42. The two runs traced different rays.".to_owned(),
            ],
            doubts: vec!["The compiler was rustc 1.89.0 and is rustc 1.91.0.".to_owned()],
        },
    }
}

/// A scene and a sweep with structures of these names.
pub(crate) fn with_structures<'a>(names: impl IntoIterator<Item = &'a str>) -> Comparison {
    let mut comparison = full();
    comparison.scenes.truncate(1);
    comparison.sampling = None;
    let (scene, sweep) = (&mut comparison.scenes[0], &mut comparison.sweeps[0]);
    let row = scene.structures.remove(2);
    let mut points = std::mem::take(&mut sweep.points);
    points.retain(|point| point.structure == row.name);
    scene.structures.clear();
    for name in names {
        scene.structures.push(StructureRecord { name: name.to_owned(), ..row.clone() });
        let own = |point: &SweepPoint| SweepPoint { structure: name.to_owned(), ..point.clone() };
        sweep.points.extend(points.iter().map(own));
    }
    comparison
}

/// A run in which nothing was measured.
pub(crate) fn minimal() -> Comparison {
    Comparison::new(Run::default(), "none")
}

/// A run that was stopped in its second scene, with a structure that failed and one that differs.
pub(crate) fn partial() -> Comparison {
    let mut comparison = full();
    comparison.run.partial = true;
    comparison.conformance = nonconforming();
    comparison.sweeps.clear();
    comparison.sampling = None;
    let bunny = &mut comparison.scenes[0];
    bunny.structures[1].status =
        Status::Failed { message: "the build ran out of | memory <here>".to_owned() };
    bunny.structures[1].classes.clear();
    let entry = &mut bunny.proof.as_mut().unwrap().structures[3];
    entry.picture_equal = Some(false);
    entry.picture_hash = Some(hash(77));
    entry.differing_pixels = 12;
    entry.largest_difference = 0.031_25;
    entry.differing_hits = 3;
    entry.first_difference =
        Some("origin (0, 1, 5), direction (0, 0, -1): t 4.5 where none has 4.25".to_owned());
    let hall = &mut comparison.scenes[1];
    for structure in &mut hall.structures[2..] {
        structure.status = Status::Stopped;
        structure.classes.truncate(1);
        structure.classes[0].rounds.truncate(3);
        structure.picture_rounds.clear();
        structure.heatmap = None;
    }
    hall.picture = None;
    hall.proof = None;
    comparison
}
