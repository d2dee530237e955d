//! Two scenes and the structures over them.

use srt::record::*;

use super::noise::{rounds, times};
use super::pictures::{hash, picture_file};

/// What is typical of a structure in a scene.
struct Typical {
    name: &'static str,
    build_ms: f64,
    bytes: u64,
    nodes: u64,
    leaves: Vec<u64>,
    /// Nanoseconds, boxes and primitives of a view ray.
    view: (f64, f64, f64),
}

fn class(typical: &Typical, class: RayClass, rays: u64, cost: f64, key: u64) -> ClassRecord {
    let (ns, boxes, primitives) = typical.view;
    let sampled = typical.name == "cwbvh" && class == RayClass::Random;
    let sample = BlockSample { blocks: 16, rays_per_block: 64, of_rays: rays };
    let rays = if sampled { sample.blocks * sample.rays_per_block } else { rays };
    ClassRecord {
        class,
        rays,
        sample: sampled.then_some(sample),
        counted_rays: rays,
        hits: rays / 3,
        boxes: Some((boxes * cost * rays as f64) as u64),
        primitives: Some((primitives * cost * rays as f64) as u64),
        rounds: rounds(ns * cost * rays as f64, 12, key),
        passes: vec![3; 4],
    }
}

fn structure(scene: &str, typical: &Typical, triangles: u64, key: u64) -> StructureRecord {
    let mixed = [
        (RayClass::View, 307_200, 1.0),
        (RayClass::Shadow, 512_640, 0.8),
        (RayClass::Mirror, 81_920, 1.6),
        (RayClass::Refraction, 20_480, 1.9),
        (RayClass::Diffuse, 262_144, 2.3),
        (RayClass::Random, 262_144, 1.4),
    ];
    let of_class = |(i, &(name, rays, cost)): (usize, &(RayClass, u64, f64))| {
        class(typical, name, rays, cost, key + i as u64)
    };
    let tree = typical.nodes > 1;
    let render_ms = typical.view.0 * 1.2;
    StructureRecord {
        name: typical.name.to_owned(),
        peer: false,
        status: Status::Ok,
        build: BuildRecord {
            one_thread_ns: times(typical.build_ms * 1.8e6, 10, key + 50),
            all_threads_ns: times(typical.build_ms * 1e6, 10, key + 51),
            stages: stages(typical),
        },
        memory: Some(Memory {
            index_bytes: typical.bytes,
            primitive_bytes: triangles * 48,
            peak_resident_bytes: Some(typical.bytes * 3 + triangles * 96),
        }),
        shape: Some(ShapeRecord {
            nodes: typical.nodes,
            leaves: typical.leaves.iter().sum(),
            depth: if tree { 23 } else { 0 },
            leaf_sizes: typical.leaves.clone(),
            primitives: triangles,
            references: triangles,
            sah_cost: tree.then_some(38.412),
            epo: tree.then_some(2.871),
            epo_standard_error: tree.then_some(0.034),
            epo_samples: tree.then_some(20_000),
        }),
        classes: mixed.iter().enumerate().map(of_class).collect(),
        picture_rounds: times(render_ms * 1e6, 8, key + 60)
            .into_iter()
            .map(|render_ns| PictureRound { build_ns: (typical.build_ms * 1e6) as u64, render_ns })
            .collect(),
        heatmap: Some(picture_file(&format!("pictures/{scene}-{}-heat.png", typical.name), key)),
    }
}

/// Those of a tree tell more.
fn stages(typical: &Typical) -> Vec<BuildStage> {
    let shares: &[(&str, f64)] = if typical.nodes > 1 {
        &[
            ("mesh", 0.031),
            ("boxes", 0.044),
            ("tree", 0.682),
            ("collapse", 0.158),
            ("primitives", 0.063),
            ("objects", 0.0002),
        ]
    } else {
        &[("mesh", 0.313), ("structure", 0.0), ("primitives", 0.6), ("objects", 0.0041)]
    };
    let stage = |&(name, share): &(&str, f64)| BuildStage {
        name: name.to_owned(),
        ns: (typical.build_ms * share * 1e6) as u64,
    };
    shares.iter().map(stage).collect()
}

fn leaves(n: u64) -> Vec<u64> {
    vec![0, n / 12, n / 6, n / 9, n / 18, n / 60, n / 90, n / 140, n / 200]
}

fn proof(structures: &[&str], key: u64) -> Proof {
    let entry = |name: &&str| StructureProof {
        structure: (*name).to_owned(),
        picture_hash: Some(hash(key)),
        picture_equal: Some(true),
        picture_size: Some([300, 200]),
        differing_pixels: 0,
        largest_difference: 0.0,
        rays_checked: 1_446_528,
        differing_hits: 0,
        first_difference: None,
    };
    Proof {
        reference: structures[0].to_owned(),
        witness: Some(structures[2].to_owned()),
        structures: structures.iter().map(entry).collect(),
        peers: vec![PeerAgreement {
            structure: "other".to_owned(),
            rays_checked: 1_446_528,
            rays_agreeing: 1_446_520,
            close: 1e-4,
        }],
    }
}

pub(super) fn bunny() -> SceneRecord {
    let triangles = 69_451;
    let one_leaf = |n: usize| {
        let mut sizes = vec![0; n + 1];
        sizes[n] = 1;
        sizes
    };
    let all = [
        Typical {
            name: "none",
            build_ms: 0.412,
            bytes: 0,
            nodes: 0,
            leaves: one_leaf(1_000),
            view: (61_234.0, 0.0, 69_451.0),
        },
        Typical {
            name: "ball",
            build_ms: 0.688,
            bytes: 16,
            nodes: 1,
            leaves: one_leaf(1_000),
            view: (24_310.0, 1.0, 27_600.0),
        },
        Typical {
            name: "bvh",
            build_ms: 24.6,
            bytes: 4_444_864,
            nodes: 34_718,
            leaves: leaves(triangles),
            view: (142.0, 31.24, 3.71),
        },
        Typical {
            name: "cwbvh",
            build_ms: 31.9,
            bytes: 1_555_700,
            nodes: 9_120,
            leaves: leaves(triangles * 3 / 2),
            view: (161.0, 44.9, 4.2),
        },
    ];
    SceneRecord {
        built_anew: true,
        name: "bunny".to_owned(),
        path: "scenes/bunny.sce".to_owned(),
        hash: hash(1),
        objects: 3,
        triangles,
        stored_triangles: triangles,
        lights: 2,
        rays: Some(RecordedRays { hash: hash(31), geometry: hash(32), replayed: true }),
        picture: Some(picture_file("pictures/bunny.png", 1)),
        proof: Some(proof(&["none", "ball", "bvh", "cwbvh"], 1)),
        heat_scale: Some(HeatScale { low: 1.0, high: 412_000.0, spacing: Spacing::Logarithmic }),
        structures: (0..)
            .zip(&all)
            .map(|(i, typical)| structure("bunny", typical, triangles, 100 * i))
            .collect(),
    }
}

pub(super) fn hall() -> SceneRecord {
    let triangles = 279_163;
    let all = [
        Typical {
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
        Typical {
            name: "bvh",
            build_ms: 101.3,
            bytes: 17_866_432,
            nodes: 139_580,
            leaves: leaves(triangles),
            view: (311.0, 66.1, 5.9),
        },
        Typical {
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
            stages: vec![],
        },
        ..StructureRecord::default()
    };
    let rest = (10..).zip(&all).map(|(i, typical)| structure("hall", typical, triangles, 100 * i));
    SceneRecord {
        built_anew: true,
        name: "hall".to_owned(),
        path: "scenes/hall.sce".to_owned(),
        hash: hash(2),
        objects: 1,
        triangles,
        stored_triangles: triangles,
        lights: 4,
        rays: None,
        picture: Some(picture_file("pictures/hall.png", 2)),
        proof: Some(proof(&["ball", "bvh", "cwbvh"], 2)),
        heat_scale: Some(HeatScale { low: 2.0, high: 1_100_000.0, spacing: Spacing::Logarithmic }),
        structures: std::iter::once(too_slow).chain(rest).collect(),
    }
}
