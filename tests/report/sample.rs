//! Records to make reports of, with figures as they might be measured.

use std::collections::BTreeMap;

use srt::image_io::{Format, Picture, encode};
use srt::math::{Color, Random};
use srt::record::*;

/// Wall times around a median, with the noise of a quiet machine: mostly narrow, some late.
fn rounds(median_ns: f64, n: usize, key: u64) -> Vec<Round> {
    times(median_ns, n, key)
        .into_iter()
        .map(|wall_ns| Round {
            wall_ns,
            cpu_ns: Some(wall_ns - wall_ns / 200),
            hardware: Some(HardwareCounters {
                cycles: Some(wall_ns * 3),
                instructions: Some(wall_ns * 7),
                branch_misses: Some(wall_ns / 50),
                cache_misses: Some(wall_ns / 400),
            }),
        })
        .collect()
}

fn times(median_ns: f64, n: usize, key: u64) -> Vec<u64> {
    let mut random = Random::new(&[key]);
    let mut noise = || f64::from(random.next_f32());
    (0..n)
        .map(|i| {
            let late = if i % 7 == 5 { 0.04 * noise() } else { 0.0 };
            (median_ns * (0.99 + 0.02 * noise() + late)) as u64
        })
        .collect()
}

/// What is typical of a structure in a scene.
struct Kind {
    name: &'static str,
    build_ms: f64,
    bytes: u64,
    nodes: u64,
    leaves: Vec<u64>,
    /// Nanoseconds, boxes and primitives of a view ray.
    view: (f64, f64, f64),
}

fn class(kind: &Kind, class: RayClass, rays: u64, dearer: f64, key: u64) -> ClassRecord {
    let (ns, boxes, primitives) = kind.view;
    ClassRecord {
        class,
        rays,
        hits: rays / 3,
        boxes: Some((boxes * dearer * rays as f64) as u64),
        primitives: Some((primitives * dearer * rays as f64) as u64),
        rounds: rounds(ns * dearer * rays as f64, 12, key),
    }
}

fn structure(scene: &str, kind: &Kind, triangles: u64, key: u64) -> StructureRecord {
    let mixed = [
        (RayClass::View, 307_200, 1.0),
        (RayClass::Shadow, 512_640, 0.8),
        (RayClass::Mirror, 81_920, 1.6),
        (RayClass::Refraction, 20_480, 1.9),
        (RayClass::Diffuse, 262_144, 2.3),
        (RayClass::Random, 262_144, 1.4),
    ];
    let of_class = |(i, &(name, rays, dearer)): (usize, &(RayClass, u64, f64))| {
        class(kind, name, rays, dearer, key + i as u64)
    };
    let tree = kind.nodes > 1;
    let render_ms = kind.view.0 * 1.2;
    StructureRecord {
        name: kind.name.to_owned(),
        status: Status::Ok,
        build: BuildRecord {
            one_thread_ns: times(kind.build_ms * 1.8e6, 10, key + 50),
            all_threads_ns: times(kind.build_ms * 1e6, 10, key + 51),
        },
        memory: Some(Memory {
            index_bytes: kind.bytes,
            primitive_bytes: triangles * 48,
            peak_resident_bytes: Some(kind.bytes * 3 + triangles * 96),
        }),
        shape: Some(Shape {
            nodes: kind.nodes,
            leaves: kind.leaves.iter().sum(),
            depth: if tree { 23 } else { 0 },
            leaf_sizes: kind.leaves.clone(),
            primitives: triangles,
            references: triangles,
            sah_cost: tree.then_some(38.412),
            epo: tree.then_some(2.871),
        }),
        classes: mixed.iter().enumerate().map(of_class).collect(),
        picture_rounds: times(render_ms * 1e6, 8, key + 60)
            .into_iter()
            .map(|render_ns| PictureRound { build_ns: (kind.build_ms * 1e6) as u64, render_ns })
            .collect(),
        heatmap: Some(picture_file(&format!("pictures/{scene}-{}-heat.png", kind.name), key)),
    }
}

fn picture_file(file: &str, key: u64) -> PictureFile {
    PictureFile { file: file.to_owned(), width: 160, height: 120, hash: hash(key) }
}

/// Something that looks like a SHA-256.
fn hash(key: u64) -> String {
    let mut random = Random::new(&[key, 99]);
    (0..4).map(|_| format!("{:016x}", random.next_u64())).collect()
}

fn leaves(n: u64) -> Vec<u64> {
    vec![0, n / 12, n / 6, n / 9, n / 18, n / 60, n / 90, n / 140, n / 200]
}

fn proof(structures: &[&str], key: u64) -> Proof {
    let entry = |name: &&str| StructureProof {
        structure: (*name).to_owned(),
        picture_hash: Some(hash(key)),
        picture_equal: Some(true),
        differing_pixels: 0,
        largest_difference: 0.0,
        rays_checked: 1_446_528,
        differing_hits: 0,
        first_difference: None,
    };
    Proof {
        reference: structures[0].to_owned(),
        structures: structures.iter().map(entry).collect(),
    }
}

fn bunny() -> SceneRecord {
    let triangles = 69_451;
    let one_leaf = |n: usize| {
        let mut sizes = vec![0; n + 1];
        sizes[n] = 1;
        sizes
    };
    let kinds = [
        Kind {
            name: "none",
            build_ms: 0.412,
            bytes: 0,
            nodes: 0,
            leaves: one_leaf(1_000),
            view: (61_234.0, 0.0, 69_451.0),
        },
        Kind {
            name: "ball",
            build_ms: 0.688,
            bytes: 16,
            nodes: 1,
            leaves: one_leaf(1_000),
            view: (24_310.0, 1.0, 27_600.0),
        },
        Kind {
            name: "bvh",
            build_ms: 24.6,
            bytes: 4_444_864,
            nodes: 34_718,
            leaves: leaves(triangles),
            view: (142.0, 31.24, 3.71),
        },
        Kind {
            name: "cwbvh",
            build_ms: 31.9,
            bytes: 1_555_700,
            nodes: 9_120,
            leaves: leaves(triangles * 3 / 2),
            view: (161.0, 44.9, 4.2),
        },
    ];
    SceneRecord {
        name: "bunny".to_owned(),
        path: "scenes/bunny.sce".to_owned(),
        hash: hash(1),
        objects: 3,
        triangles,
        lights: 2,
        picture: Some(picture_file("pictures/bunny.png", 1)),
        proof: Some(proof(&["none", "ball", "bvh", "cwbvh"], 1)),
        heat_scale: Some(HeatScale { low: 1.0, high: 412_000.0, spacing: Spacing::Logarithmic }),
        structures: (0..)
            .zip(&kinds)
            .map(|(i, kind)| structure("bunny", kind, triangles, 100 * i))
            .collect(),
    }
}

fn hall() -> SceneRecord {
    let triangles = 279_163;
    let kinds = [
        Kind {
            name: "ball",
            build_ms: 2.9,
            bytes: 16,
            nodes: 1,
            leaves: {
                let mut sizes = vec![0; 1_001];
                sizes[1_000] = 1;
                sizes
            },
            view: (251_000.0, 1.0, 279_163.0),
        },
        Kind {
            name: "bvh",
            build_ms: 101.3,
            bytes: 17_866_432,
            nodes: 139_580,
            leaves: leaves(triangles),
            view: (311.0, 66.1, 5.9),
        },
        Kind {
            name: "cwbvh",
            build_ms: 134.8,
            bytes: 6_253_200,
            nodes: 36_710,
            leaves: leaves(triangles * 3 / 2),
            view: (287.0, 88.3, 6.6),
        },
    ];
    let too_slow = StructureRecord {
        name: "none".to_owned(),
        status: Status::TooSlow { after_seconds: 41.3 },
        build: BuildRecord {
            one_thread_ns: times(1.6e6, 10, 7),
            all_threads_ns: times(1.5e6, 10, 8),
        },
        ..StructureRecord::default()
    };
    let rest = (10..).zip(&kinds).map(|(i, kind)| structure("hall", kind, triangles, 100 * i));
    SceneRecord {
        name: "hall".to_owned(),
        path: "scenes/hall.sce".to_owned(),
        hash: hash(2),
        objects: 1,
        triangles,
        lights: 4,
        picture: Some(picture_file("pictures/hall.png", 2)),
        proof: Some(proof(&["ball", "bvh", "cwbvh"], 2)),
        heat_scale: Some(HeatScale { low: 2.0, high: 1_100_000.0, spacing: Spacing::Logarithmic }),
        structures: std::iter::once(too_slow).chain(rest).collect(),
    }
}

fn sweep() -> Sweep {
    let mut points = Vec::new();
    for (s, (name, at_1k, slope)) in
        [("none", 850.0, 1.0), ("ball", 410.0, 0.98), ("bvh", 61.0, 0.19), ("cwbvh", 74.0, 0.16)]
            .into_iter()
            .enumerate()
    {
        for (i, triangles) in [1_000_u64, 10_000, 100_000, 1_000_000].into_iter().enumerate() {
            if s < 2 && triangles > 100_000 {
                continue;
            }
            for class in [RayClass::View, RayClass::Diffuse] {
                let dearer = if class == RayClass::View { 1.0 } else { 1.7 };
                let wobble = 1.0 + 0.04 * ((i * 3 + s) % 4) as f64;
                let ns = at_1k * (triangles as f64 / 1e3).powf(slope) * dearer * wobble;
                points.push(SweepPoint {
                    triangles,
                    structure: name.to_owned(),
                    class,
                    rays: 65_536,
                    rounds: rounds(ns * 65_536.0, 10, (s * 10 + i) as u64),
                    build_ns: triangles * 300,
                    index_bytes: triangles * 64,
                });
            }
        }
    }
    let dropped = |structure: &str| Dropped {
        structure: structure.to_owned(),
        triangles: 1_000_000,
        reason: "a round would take more than its part of the budget".to_owned(),
    };
    Sweep { mesh: "hall".to_owned(), points, dropped: vec![dropped("none"), dropped("ball")] }
}

fn sampling() -> SamplingChapter {
    let cost = |operation: &str, ns: f64, key| OperationCost {
        operation: operation.to_owned(),
        count: 1_000_000,
        rounds_ns: times(ns * 1e6, 15, key),
    };
    let share = |scene: &str, part: &str, share| FrameShare {
        scene: scene.to_owned(),
        part: part.to_owned(),
        share,
    };
    let noise = |sampling: &str, pairing, pixel_samples, seconds, rmse| NoisePoint {
        scene: "bunny".to_owned(),
        sampling: sampling.to_owned(),
        pairing,
        pixel_samples,
        light_samples: 4,
        seconds,
        rmse,
    };
    SamplingChapter {
        costs: vec![cost("a random number", 1.21, 201), cost("a shuffle of 64", 93.7, 202)],
        shares: vec![
            share("bunny", "random numbers", 0.0093),
            share("bunny", "shuffling", 0.0214),
            share("hall", "random numbers", 0.0048),
            share("hall", "shuffling", 0.0121),
        ],
        noise: vec![
            noise("shuffled", Pairing::EqualSamples, 16, 1.432, 0.01211),
            noise("independent", Pairing::EqualSamples, 16, 1.401, 0.01987),
            noise("shuffled", Pairing::EqualTime, 16, 1.432, 0.01211),
            noise("independent", Pairing::EqualTime, 16, 1.433, 0.01966),
        ],
        default: "shuffled".to_owned(),
    }
}

fn run() -> Run {
    Run {
        command: "srt compare scenes/bunny.sce scenes/hall.sce --accel none,ball,bvh,cwbvh \
                  --sweep 1k..1M --mesh hall --budget 180"
            .to_owned(),
        date: "2026-03-14T15:09:26+01:00".to_owned(),
        version: "0.1.0".to_owned(),
        commit: Some("b103d88f2c51".to_owned()),
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
    }
}

/// Two scenes, four structures, one of them too slow for the second scene, a sweep, a chapter on
/// sampling.
pub(crate) fn full() -> Comparison {
    let mut comparison = Comparison::new(run(), "none");
    comparison.scenes = vec![bunny(), hall()];
    comparison.sweeps = vec![sweep()];
    comparison.sampling = Some(sampling());
    comparison.notes = vec!["The hall was generated with seed 1.".to_owned()];
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

/// The PNG files that a record names.
pub(crate) fn pictures(comparison: &Comparison) -> BTreeMap<String, Vec<u8>> {
    let mut pictures = BTreeMap::new();
    for scene in &comparison.scenes {
        let heats = scene.structures.iter().filter_map(|structure| structure.heatmap.as_ref());
        for (i, file) in scene.picture.iter().chain(heats).enumerate() {
            let picture = paint(file, i);
            pictures.insert(file.file.clone(), encode(&picture, Format::Png).unwrap());
        }
    }
    pictures
}

/// A ball on a plane; in colour, or as a heatmap that darkens with `kind`.
fn paint(file: &PictureFile, kind: usize) -> Picture {
    let mut picture = Picture::new(file.width, file.height);
    for (i, pixel) in (0..).zip(&mut picture.pixels) {
        let x = (i % file.width) as f32 / file.width as f32 * 2.0 - 1.0;
        let y = (i / file.width) as f32 / file.height as f32 * 2.0 - 1.0;
        let r2 = (x * x * 1.78 + y * y) * 2.0;
        let light = if r2 < 1.0 { (1.0 - r2).sqrt() * 0.8 + 0.1 } else { 0.15 + 0.2 * y.max(0.0) };
        *pixel = match kind {
            0 => Color::new(light, light * 0.8, light * 0.6),
            _ => Color::new(light, light * light, 0.3 * light) * (1.2 / kind as f32),
        };
    }
    picture
}
