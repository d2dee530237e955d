//! The figures of one rendering: plain data, filled by `render.rs`, shown by `summary.rs`.

use std::time::Duration;

use serde::Serialize;

use crate::accel::StructureShape;
use crate::counters::Counts;

/// What one rendering took.
#[derive(Clone, Debug, Default)]
pub(crate) struct Report {
    /// The scene's file, as typed.
    pub(crate) scene: String,
    /// Width of what was rendered, in pixels.
    pub(crate) width: u32,
    /// Height of the same.
    pub(crate) height: u32,
    /// The name of the structure.
    pub(crate) structure: String,
    /// The quality of its build.
    pub(crate) build: String,
    /// Threads that built and rendered.
    pub(crate) threads: usize,
    /// Whether Ctrl-C ended it early.
    pub(crate) partial: bool,
    /// How long the build took.
    pub(crate) build_time: Duration,
    /// How long the rendering took, without reading, building and writing.
    pub(crate) render_time: Duration,
    /// The structure's size and form.
    pub(crate) shape: StructureShape,
    /// The classes of rays that occurred, in the order of a wave.
    pub(crate) rays: Vec<RayClass>,
}

/// The rays of one class.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RayClass {
    /// `view`, `shadow`, `mirror`, `refraction`.
    pub(crate) name: &'static str,
    /// How many rays.
    pub(crate) rays: u64,
    /// What they tested, where that was counted.
    pub(crate) counts: Option<Counts>,
}

impl Report {
    /// The rays of all classes.
    pub(crate) fn total_rays(&self) -> u64 {
        self.rays.iter().map(|class| class.rays).sum()
    }

    /// What `--stats=json` prints, with a line end.
    pub(crate) fn to_json(&self) -> Result<String, serde_json::Error> {
        serde_json::to_string_pretty(&Document::from(self)).map(|json| json + "\n")
    }
}

/// The version of [`Document`]: raised when a field changes its meaning or goes away.
const VERSION: u32 = 1;

/// A report as programs read it: times in seconds, memory in bytes.
#[derive(Serialize)]
struct Document<'a> {
    version: u32,
    scene: &'a str,
    width: u32,
    height: u32,
    partial: bool,
    structure: Structure<'a>,
    threads: usize,
    build_seconds: f64,
    render_seconds: f64,
    rays: u64,
    rays_per_second: Option<f64>,
    classes: Vec<Class>,
}

#[derive(Serialize)]
struct Structure<'a> {
    name: &'a str,
    build: &'a str,
    bytes: u64,
    nodes: u64,
    leaves: u64,
    depth: u32,
    /// Entry n: leaves with n primitives.
    leaf_sizes: &'a [u64],
}

#[derive(Serialize)]
struct Class {
    class: &'static str,
    rays: u64,
    boxes: Option<u64>,
    primitives: Option<u64>,
    boxes_per_ray: Option<f64>,
    primitives_per_ray: Option<f64>,
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
            partial: report.partial,
            structure: Structure {
                name: &report.structure,
                build: &report.build,
                bytes: report.shape.bytes,
                nodes: report.shape.nodes,
                leaves: report.shape.leaves,
                depth: report.shape.depth,
                leaf_sizes: &report.shape.leaf_sizes,
            },
            threads: report.threads,
            build_seconds: report.build_time.as_secs_f64(),
            render_seconds,
            rays,
            rays_per_second: quotient(rays as f64, render_seconds),
            classes: report.rays.iter().map(Class::from).collect(),
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
pub(crate) mod tests {
    use super::*;

    /// Figures to show.
    pub(crate) fn example() -> Report {
        let class = |name, rays, boxes, primitives| RayClass {
            name,
            rays,
            counts: Some(Counts { boxes, primitives }),
        };
        Report {
            scene: "scenes/hall.sce".to_owned(),
            width: 800,
            height: 600,
            structure: "bvh".to_owned(),
            build: "medium".to_owned(),
            threads: 2,
            partial: false,
            build_time: Duration::from_micros(45_600),
            render_time: Duration::from_millis(1_250),
            shape: StructureShape {
                nodes: 139_999,
                leaves: 70_000,
                depth: 23,
                leaf_sizes: vec![0, 70_000],
                bytes: 4_718_592,
            },
            rays: vec![
                class("view", 1_920_000, 44_928_000, 7_872_000),
                class("shadow", 8_000_000, 96_000_000, 4_000_000),
            ],
        }
    }

    #[test]
    fn json_has_totals_and_means() {
        let json = example().to_json().unwrap();
        let value: serde_json::Value = serde_json::from_str(&json).unwrap();
        assert_eq!(value["version"], 1);
        assert_eq!(value["rays"], 9_920_000);
        assert_eq!(value["rays_per_second"], 7_936_000.0);
        assert_eq!(value["structure"]["depth"], 23);
        assert_eq!(value["classes"][0]["boxes_per_ray"], 23.4);
        assert_eq!(value["classes"][1]["primitives"], 4_000_000);
    }

    #[test]
    fn what_was_not_counted_is_null() {
        let mut report = example();
        report.render_time = Duration::ZERO;
        report.rays = vec![RayClass { name: "view", rays: 0, counts: None }];
        let value: serde_json::Value = serde_json::from_str(&report.to_json().unwrap()).unwrap();
        assert!(value["rays_per_second"].is_null());
        assert!(value["classes"][0]["boxes"].is_null());
    }
}
