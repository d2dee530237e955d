//! The figures of one rendering as plain data: what `--stats=json` prints, and what `summary.rs` puts
//! into words.
//!
//! Times are in seconds, memory is in bytes. What was not counted, and means of nothing, are null.

use std::collections::BTreeMap;
use std::time::Duration;

use serde::{Serialize, Serializer};

use super::options::RenderOptions;
use super::refine::{Outcome, StoppedBy};
use super::source;
use crate::accel::StructureShape;
use crate::render::{self, RayClass, RenderStats, Settings, Spacing, Stage, StageTimes};
use crate::scene::BuildReport;

/// The version of the JSON: raised when a field changes its meaning or goes away.
const VERSION: u32 = 1;

/// What one rendering took.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Figures {
    version: u32,
    /// The scene's file, as typed, or `standard input`.
    scene: String,
    /// The frame of it.
    pub(crate) frame: u32,
    /// Width and height of what was rendered, in pixels.
    pub(crate) width: u32,
    pub(crate) height: u32,
    /// What the pixels show.
    view: &'static str,
    /// The scale of its colours, where numbers became colours.
    scale: Option<ScaleEnds>,
    /// Whether it was ended early.
    pub(crate) partial: bool,
    /// By what: `signal`, `time` or `noise`.
    pub(crate) stopped_by: Option<&'static str>,
    /// The pixels that were rendered, at least in part: all, unless it was ended early.
    pub(crate) rendered_pixels: u64,
    /// The samples of a pixel that were rendered, on average, and of how many.
    pub(crate) samples_per_pixel: f64,
    #[serde(skip)]
    pub(crate) all_samples_per_pixel: u32,
    /// The noise that is left, where it is known.
    pub(crate) noise: Option<f64>,
    /// Threads that built and rendered.
    pub(crate) threads: usize,
    pub(crate) structure: BuiltStructure,
    /// How long the rendering took, without reading, building and writing.
    pub(crate) render_seconds: f64,
    pub(crate) thread_seconds: ThreadSeconds,
    /// Rays of all classes.
    pub(crate) rays: u64,
    rays_per_second: Option<f64>,
    /// The classes of rays that occurred, in the order of a wave.
    pub(crate) classes: Vec<RaysOfClass>,
}

/// What the ends of a colour scale stand for.
#[derive(Clone, Copy, Debug, Serialize)]
struct ScaleEnds {
    low: f32,
    high: f32,
    spacing: &'static str,
}

/// The structure, and what building it took and gave.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct BuiltStructure {
    pub(crate) name: &'static str,
    /// The quality of its build.
    pub(crate) build: &'static str,
    pub(crate) build_seconds: f64,
    /// What these were spent on; empty where the structure does not measure its stages.
    pub(crate) build_stages: Vec<StageTime>,
    /// The index over the objects.
    pub(crate) objects: Index,
    /// The indices over the meshes' triangles, each mesh once.
    pub(crate) meshes: Index,
    /// Triangles of all meshes, each mesh once, and their bytes as they are traced.
    pub(crate) triangles: u64,
    pub(crate) triangle_bytes: u64,
    /// The bytes that a triangle of a mesh takes, with its part of the index.
    pub(crate) bytes_per_triangle: Option<f64>,
}

/// A stage of the build.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct StageTime {
    pub(crate) stage: &'static str,
    pub(crate) seconds: f64,
}

/// The size of an index.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Index {
    pub(crate) bytes: u64,
    pub(crate) nodes: u64,
    pub(crate) leaves: u64,
    pub(crate) depth: u32,
    /// Number of primitives → how many leaves hold so many.
    pub(crate) leaf_sizes: BTreeMap<usize, u64>,
}

/// What the threads spent their time on, added up over all of them.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct ThreadSeconds {
    pub(crate) total: f64,
    /// Of all classes; of each, see [`RaysOfClass`].
    pub(crate) tracing: f64,
    pub(crate) making_rays: f64,
    pub(crate) shading: f64,
    pub(crate) rest: f64,
    /// All but tracing, and its share in the total.
    pub(crate) outside_tracing: f64,
    pub(crate) outside_tracing_share: Option<f64>,
}

/// The rays of one class.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct RaysOfClass {
    #[serde(serialize_with = "name")]
    pub(crate) class: RayClass,
    pub(crate) rays: u64,
    /// How many of them hit something.
    hits: u64,
    /// How long threads were tracing them, added up.
    pub(crate) trace_seconds: f64,
    /// What they tested, where that was counted.
    pub(crate) boxes: Option<u64>,
    pub(crate) primitives: Option<u64>,
    pub(crate) boxes_per_ray: Option<f64>,
    pub(crate) primitives_per_ray: Option<f64>,
}

impl Figures {
    /// The figures of a rendering.
    pub(crate) fn new(
        options: &RenderOptions,
        settings: &Settings,
        build: &BuildReport,
        outcome: &Outcome,
    ) -> Self {
        let (work, rendering) = (&options.work, &outcome.rendering);
        let region = settings.region();
        let stats = &rendering.stats;
        let render_seconds = stats.time.as_secs_f64();
        let rays = stats.total_rays();
        Self {
            version: VERSION,
            scene: source::name(&work.scene),
            frame: work.frame,
            width: region.width(),
            height: region.height(),
            view: settings.view.name(),
            scale: None,
            partial: !rendering.complete,
            stopped_by: outcome.stopped_by.map(StoppedBy::name),
            rendered_pixels: rendering.pixels,
            samples_per_pixel: rendering.samples as f64 / region.pixels() as f64,
            all_samples_per_pixel: settings.film_samples(),
            noise: outcome.noise,
            threads: work.threads,
            structure: BuiltStructure::new(work.structure.name, work.build.quality.name(), build),
            render_seconds,
            thread_seconds: ThreadSeconds::from(&stats.thread_times),
            rays,
            rays_per_second: quotient(rays as f64, render_seconds),
            classes: classes(stats, settings.count),
        }
    }

    /// With the scale of the colours, where numbers became colours.
    pub(crate) fn with_scale(self, scale: Option<render::Scale>) -> Self {
        Self { scale: scale.map(ScaleEnds::from), ..self }
    }

    /// What `--stats=json` prints, with a line end.
    pub(crate) fn to_json(&self) -> Result<String, serde_json::Error> {
        serde_json::to_string_pretty(self).map(|json| json + "\n")
    }
}

impl BuiltStructure {
    fn new(name: &'static str, quality: &'static str, build: &BuildReport) -> Self {
        let BuildReport { triangles, triangle_bytes, .. } = *build;
        let bytes = (build.meshes.bytes + triangle_bytes) as f64;
        let stage = |(stage, time): (_, Duration)| StageTime { stage, seconds: time.as_secs_f64() };
        Self {
            name,
            build: quality,
            build_seconds: build.time.as_secs_f64(),
            build_stages: build.stages.iter().map(stage).collect(),
            objects: Index::from(&build.objects),
            meshes: Index::from(&build.meshes),
            triangles,
            triangle_bytes,
            bytes_per_triangle: quotient(bytes, triangles as f64),
        }
    }
}

impl RaysOfClass {
    /// Of some number of rays, how many hit something, how long they were traced, and what they
    /// tested if that was counted.
    fn new(
        class: RayClass,
        [rays, hits]: [u64; 2],
        trace_time: Duration,
        tests: Option<[u64; 2]>,
    ) -> Self {
        let [boxes, primitives] = tests.map_or([None, None], |tests| tests.map(Some));
        let per_ray = |n: Option<u64>| quotient(n? as f64, rays as f64);
        Self {
            class,
            rays,
            hits,
            trace_seconds: trace_time.as_secs_f64(),
            boxes,
            primitives,
            boxes_per_ray: per_ray(boxes),
            primitives_per_ray: per_ray(primitives),
        }
    }
}

/// The classes that occurred; view rays always, so that there is one.
fn classes(stats: &RenderStats, counted: bool) -> Vec<RaysOfClass> {
    let of_class = |class: RayClass| {
        let own = stats.class(class);
        let time = stats.thread_times.of(Stage::Tracing(class));
        let tests = counted.then_some([own.tests.boxes, own.tests.primitives]);
        RaysOfClass::new(class, [own.rays, own.hits], time, tests)
    };
    let classes = RayClass::ALL.into_iter().map(of_class);
    classes.filter(|own| own.rays > 0 || own.class == RayClass::View).collect()
}

impl From<render::Scale> for ScaleEnds {
    fn from(scale: render::Scale) -> Self {
        let spacing = match scale.spacing {
            Spacing::Linear => "linear",
            Spacing::Logarithmic => "logarithmic",
        };
        Self { low: scale.low, high: scale.high, spacing }
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

impl From<&StructureShape> for Index {
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

/// A class by its name.
fn name<S: Serializer>(class: &RayClass, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(class.name())
}

/// JSON has neither infinity nor NaN.
pub(super) fn quotient(a: f64, b: f64) -> Option<f64> {
    (b != 0.0).then(|| a / b)
}

#[cfg(test)]
pub(crate) mod tests;
