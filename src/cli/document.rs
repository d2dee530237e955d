//! Figures → JSON: what `--stats=json` prints. Times in seconds, memory in bytes; what was not
//! counted, and means of nothing, are null.

use std::collections::BTreeMap;

use serde::Serialize;

use super::figures::{RayClass, Report};
use crate::accel::StructureShape;
use crate::render::{self, Spacing, Stage, StageTimes};

/// The version of [`Document`]: raised when a field changes its meaning or goes away.
const VERSION: u32 = 1;

impl Report {
    /// What `--stats=json` prints, with a line end.
    pub(crate) fn to_json(&self) -> Result<String, serde_json::Error> {
        serde_json::to_string_pretty(&Document::from(self)).map(|json| json + "\n")
    }
}

/// A report as programs read it.
#[derive(Serialize)]
struct Document<'a> {
    version: u32,
    scene: &'a str,
    width: u32,
    height: u32,
    view: &'static str,
    /// Of the colours of a view that shows numbers.
    scale: Option<Scale>,
    partial: bool,
    threads: usize,
    structure: Structure<'a>,
    render_seconds: f64,
    thread_seconds: ThreadSeconds,
    rays: u64,
    rays_per_second: Option<f64>,
    classes: Vec<Class>,
}

#[derive(Serialize)]
struct Scale {
    low: f32,
    high: f32,
    spacing: &'static str,
}

#[derive(Serialize)]
struct Structure<'a> {
    name: &'a str,
    build: &'a str,
    build_seconds: f64,
    /// What these were spent on, stage by stage; empty where the structure does not tell.
    build_stages: Vec<BuildStage>,
    /// The index over the objects.
    objects: Shape,
    /// The indices over the meshes' triangles, each mesh once.
    meshes: Shape,
    /// Triangles of all meshes, each mesh once, and their bytes as they are traced.
    triangles: u64,
    triangle_bytes: u64,
    /// With the index over them.
    bytes_per_triangle: Option<f64>,
}

#[derive(Serialize)]
struct BuildStage {
    stage: &'static str,
    seconds: f64,
}

#[derive(Serialize)]
struct Shape {
    bytes: u64,
    nodes: u64,
    leaves: u64,
    depth: u32,
    /// Number of primitives → how many leaves hold so many.
    leaf_sizes: BTreeMap<usize, u64>,
}

/// What the threads spent their time on, added up over all of them.
#[derive(Serialize)]
struct ThreadSeconds {
    total: f64,
    /// Of all classes; of each, see [`Class`].
    tracing: f64,
    making_rays: f64,
    shading: f64,
    rest: f64,
    /// All but tracing, and its share in the total.
    outside_tracing: f64,
    outside_tracing_share: Option<f64>,
}

#[derive(Serialize)]
struct Class {
    class: &'static str,
    rays: u64,
    hits: u64,
    trace_seconds: f64,
    boxes: Option<u64>,
    primitives: Option<u64>,
    boxes_per_ray: Option<f64>,
    primitives_per_ray: Option<f64>,
}

impl From<render::Scale> for Scale {
    fn from(scale: render::Scale) -> Self {
        let spacing = match scale.spacing {
            Spacing::Linear => "linear",
            Spacing::Logarithmic => "logarithmic",
        };
        Self { low: scale.low, high: scale.high, spacing }
    }
}

impl<'a> From<&'a Report> for Document<'a> {
    fn from(report: &'a Report) -> Self {
        let rays = report.total_rays();
        let render_seconds = report.render_time.as_secs_f64();
        Self {
            version: VERSION,
            scene: &report.scene,
            width: report.width,
            height: report.height,
            view: report.view.name(),
            scale: report.scale.map(Scale::from),
            partial: report.partial,
            threads: report.threads,
            structure: Structure::from(report),
            render_seconds,
            thread_seconds: ThreadSeconds::from(&report.thread_times),
            rays,
            rays_per_second: quotient(rays as f64, render_seconds),
            classes: report.rays.iter().map(Class::from).collect(),
        }
    }
}

impl<'a> From<&'a Report> for Structure<'a> {
    fn from(report: &'a Report) -> Self {
        Self {
            name: report.structure,
            build: report.quality.name(),
            build_seconds: report.build.time.as_secs_f64(),
            build_stages: report
                .build
                .stages
                .iter()
                .map(|(stage, time)| BuildStage { stage, seconds: time.as_secs_f64() })
                .collect(),
            objects: Shape::from(&report.build.objects),
            meshes: Shape::from(&report.build.meshes),
            triangles: report.build.triangles,
            triangle_bytes: report.build.triangle_bytes,
            bytes_per_triangle: report.bytes_per_triangle(),
        }
    }
}

impl From<&StageTimes> for ThreadSeconds {
    fn from(times: &StageTimes) -> Self {
        let seconds = |stage| times.of(stage).as_secs_f64();
        Self {
            total: times.total().as_secs_f64(),
            tracing: times.tracing().as_secs_f64(),
            making_rays: seconds(Stage::MakingRays),
            shading: seconds(Stage::Shading),
            rest: seconds(Stage::Rest),
            outside_tracing: times.outside_tracing().as_secs_f64(),
            outside_tracing_share: times.outside_tracing_share(),
        }
    }
}

impl From<&StructureShape> for Shape {
    fn from(shape: &StructureShape) -> Self {
        let sizes = shape.leaf_sizes.iter().copied().enumerate();
        Self {
            bytes: shape.bytes,
            nodes: shape.nodes,
            leaves: shape.leaves,
            depth: shape.depth,
            leaf_sizes: sizes.filter(|&(_, leaves)| leaves > 0).collect(),
        }
    }
}

impl From<&RayClass> for Class {
    fn from(class: &RayClass) -> Self {
        let boxes = class.counts.map(|counts| counts.boxes);
        let primitives = class.counts.map(|counts| counts.primitives);
        let per_ray = |n: Option<u64>| quotient(n? as f64, class.rays as f64);
        Self {
            class: class.name,
            rays: class.rays,
            hits: class.hits,
            trace_seconds: class.trace_time.as_secs_f64(),
            boxes,
            primitives,
            boxes_per_ray: per_ray(boxes),
            primitives_per_ray: per_ray(primitives),
        }
    }
}

/// JSON knows neither infinity nor NaN.
fn quotient(a: f64, b: f64) -> Option<f64> {
    (b != 0.0).then(|| a / b)
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use serde_json::{Value, from_str, json};

    use super::super::figures::tests::example;
    use super::*;

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
        assert_eq!(value["classes"][1]["trace_seconds"], 1.25);
        assert_eq!(value["structure"]["meshes"]["depth"], 23);
        assert_eq!(value["structure"]["meshes"]["leaf_sizes"], json!({"1": 69_990, "5": 10}));
        assert_eq!(value["structure"]["bytes_per_triangle"], 112.0);
        assert_eq!(value["classes"][0]["boxes_per_ray"], 23.4);
        assert_eq!(value["classes"][1]["primitives"], 4_000_000);
    }

    #[test]
    fn what_was_not_counted_is_null() {
        let mut report = example();
        report.render_time = Duration::ZERO;
        report.build.triangles = 0;
        report.rays = vec![RayClass::default()];
        let value: Value = from_str(&report.to_json().unwrap()).unwrap();
        assert!(value["rays_per_second"].is_null());
        assert!(value["structure"]["bytes_per_triangle"].is_null());
        assert!(value["classes"][0]["boxes"].is_null());
        assert!(value["scale"].is_null());
    }
}
