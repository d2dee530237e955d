use serde_json::{Value, from_str, json};

use super::*;
use crate::accel::BuildStages;

fn build() -> BuildReport {
    let mut leaf_sizes = vec![0, 69_990];
    leaf_sizes.resize(5, 0);
    leaf_sizes.push(10);
    let meshes = StructureShape {
        nodes: 139_999,
        leaves: 70_000,
        depth: 23,
        leaf_sizes,
        bytes: 4_480_000,
        sah_cost: None,
    };
    let objects = StructureShape {
        nodes: 3,
        leaves: 2,
        depth: 1,
        leaf_sizes: vec![0, 2],
        bytes: 96,
        sah_cost: None,
    };
    let mut stages = BuildStages::default();
    stages.add("mesh", Duration::from_micros(5_600));
    stages.add("structure", Duration::from_millis(40));
    BuildReport {
        time: Duration::from_micros(45_600),
        stages,
        objects,
        meshes,
        triangles: 70_000,
        triangle_bytes: 3_360_000,
    }
}

fn thread_times() -> StageTimes {
    let mut times = StageTimes::default();
    for (stage, milliseconds) in [
        (Stage::Tracing(RayClass::View), 250),
        (Stage::Tracing(RayClass::Shadow), 1_250),
        (Stage::MakingRays, 400),
        (Stage::Shading, 500),
        (Stage::Rest, 50),
    ] {
        times.add(stage, Duration::from_millis(milliseconds));
    }
    times
}

/// Figures to show.
pub(crate) fn example() -> Figures {
    let class = |class, rays, tests| {
        let time = thread_times().of(Stage::Tracing(class));
        RaysOfClass::new(class, [rays, rays / 2], time, Some(tests))
    };
    Figures {
        version: VERSION,
        scene: "scenes/hall.sce".to_owned(),
        frame: 0,
        width: 800,
        height: 600,
        view: "color",
        scale: None,
        partial: false,
        stopped_by: None,
        rendered_pixels: 480_000,
        samples_per_pixel: 1.0,
        all_samples_per_pixel: 1,
        noise: None,
        threads: 2,
        structure: BuiltStructure::new("bvh", "medium", &build()),
        render_seconds: 1.25,
        thread_seconds: ThreadSeconds::from(&thread_times()),
        rays: 9_920_000,
        rays_per_second: quotient(9_920_000.0, 1.25),
        classes: vec![
            class(RayClass::View, 1_920_000, [44_928_000, 7_872_000]),
            class(RayClass::Shadow, 8_000_000, [96_000_000, 4_000_000]),
        ],
    }
}

#[test]
fn totals_and_means() {
    let value: Value = from_str(&example().to_json().unwrap()).unwrap();
    assert_eq!(value["version"], 1);
    assert_eq!(value["rays"], 9_920_000);
    assert_eq!(value["rays_per_second"], 7_936_000.0);
    assert_eq!(value["thread_seconds"]["total"], 2.45);
    assert_eq!(value["thread_seconds"]["tracing"], 1.5);
    assert_eq!(value["thread_seconds"]["making_rays"], 0.4);
    assert_eq!(value["thread_seconds"]["outside_tracing"], 0.95);
    assert_eq!(value["thread_seconds"]["outside_tracing_share"], 0.95 / 2.45);
    assert_eq!(value["classes"][1]["class"], "shadow");
    assert_eq!(value["classes"][1]["trace_seconds"], 1.25);
    assert_eq!(value["structure"]["meshes"]["depth"], 23);
    assert_eq!(value["structure"]["meshes"]["leaf_sizes"], json!({"1": 69_990, "5": 10}));
    assert_eq!(value["structure"]["build_stages"][1]["stage"], "structure");
    assert_eq!(value["structure"]["bytes_per_triangle"], 112.0);
    assert_eq!(value["classes"][0]["boxes_per_ray"], 23.4);
    assert_eq!(value["classes"][1]["primitives"], 4_000_000);
}

#[test]
fn what_was_not_counted_is_null() {
    let figures = Figures {
        structure: BuiltStructure::new("bvh", "medium", &BuildReport::default()),
        classes: classes(&RenderStats::default(), false),
        ..example()
    };
    let value: Value = from_str(&figures.to_json().unwrap()).unwrap();
    assert!(value["structure"]["bytes_per_triangle"].is_null());
    assert_eq!(value["classes"].as_array().unwrap().len(), 1, "view rays are always there");
    assert!(value["classes"][0]["boxes"].is_null());
    assert!(value["classes"][0]["boxes_per_ray"].is_null());
    assert!(value["scale"].is_null());
    let counted = &classes(&RenderStats::default(), true)[0];
    assert_eq!((counted.boxes, counted.boxes_per_ray), (Some(0), None), "a mean of nothing");
}
