//! The figures of one rendering: plain data, shown by `summary.rs` and `document.rs`.

use std::time::Duration;

use super::options::RenderOptions;
use super::source;
use crate::accel::Quality;
use crate::counters::Counts;
use crate::render::{self, RenderStats, Rendering, Scale, Settings, Stage, StageTimes, View};
use crate::scene::BuildReport;

/// What one rendering took.
#[derive(Clone, Debug, Default)]
pub(crate) struct Report {
    /// The scene's file, as typed, or `standard input`.
    pub(crate) scene: String,
    /// Width of what was rendered, in pixels.
    pub(crate) width: u32,
    /// Height of the same.
    pub(crate) height: u32,
    /// What the pixels show.
    pub(crate) view: View,
    /// The scale of its colours, where numbers became colours.
    pub(crate) scale: Option<Scale>,
    /// The name of the structure.
    pub(crate) structure: &'static str,
    /// The quality of its build.
    pub(crate) quality: Quality,
    /// What building it took and gave.
    pub(crate) build: BuildReport,
    /// Threads that built and rendered.
    pub(crate) threads: usize,
    /// Whether Ctrl-C ended it early.
    pub(crate) partial: bool,
    /// How long the rendering took, without reading, building and writing.
    pub(crate) render_time: Duration,
    /// What the threads spent their time on.
    pub(crate) thread_times: StageTimes,
    /// The classes of rays that occurred, in the order of a wave.
    pub(crate) rays: Vec<RayClass>,
}

/// The rays of one class.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct RayClass {
    /// `view`, `shadow`, `mirror`, `refraction`.
    pub(crate) name: &'static str,
    /// How many rays.
    pub(crate) rays: u64,
    /// How many of them hit something.
    pub(crate) hits: u64,
    /// How long threads were tracing them, added up.
    pub(crate) trace_time: Duration,
    /// What they tested, where that was counted.
    pub(crate) counts: Option<Counts>,
}

impl Report {
    /// The figures of a rendering.
    pub(crate) fn new(
        options: &RenderOptions,
        settings: &Settings,
        build: BuildReport,
        rendering: &Rendering,
    ) -> Self {
        let region = settings.region();
        let counted = settings.count;
        Self {
            scene: source::name(&options.scene),
            width: region.width(),
            height: region.height(),
            view: settings.view,
            scale: None,
            structure: options.structure.name,
            quality: options.build.quality,
            build,
            threads: options.threads,
            partial: !rendering.complete,
            render_time: rendering.stats.time,
            thread_times: rendering.stats.thread_times,
            rays: classes(&rendering.stats, counted),
        }
    }

    /// The rays of all classes.
    pub(crate) fn total_rays(&self) -> u64 {
        self.rays.iter().map(|class| class.rays).sum()
    }

    /// The bytes of the indices on both levels.
    pub(crate) fn index_bytes(&self) -> u64 {
        self.build.objects.bytes + self.build.meshes.bytes
    }

    /// The bytes that a triangle of a mesh takes, with its part of the index over them.
    pub(crate) fn bytes_per_triangle(&self) -> Option<f64> {
        let BuildReport { meshes, triangles, triangle_bytes, .. } = &self.build;
        (*triangles > 0).then(|| (meshes.bytes + triangle_bytes) as f64 / *triangles as f64)
    }
}

/// The classes that occurred; view rays always, so that there is one.
fn classes(stats: &RenderStats, counted: bool) -> Vec<RayClass> {
    let class = |class: render::RayClass| {
        let trace_time = stats.thread_times.of(Stage::Tracing(class));
        let stats = stats.class(class);
        let counts = counted.then_some(stats.tests);
        RayClass { name: class.name(), rays: stats.rays, hits: stats.hits, trace_time, counts }
    };
    let classes = render::RayClass::ALL.into_iter();
    classes.map(class).filter(|class| class.rays > 0 || class.name == "view").collect()
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::accel::{BuildStages, StructureShape};

    /// Figures to show.
    pub(crate) fn example() -> Report {
        let class = |name, rays, milliseconds, boxes, primitives| RayClass {
            name,
            rays,
            hits: rays / 2,
            trace_time: Duration::from_millis(milliseconds),
            counts: Some(Counts { boxes, primitives }),
        };
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
        stages.add("triangles", Duration::from_micros(5_600));
        stages.add("structure", Duration::from_millis(40));
        let mut thread_times = StageTimes::default();
        for (stage, milliseconds) in [
            (Stage::Tracing(render::RayClass::View), 250),
            (Stage::Tracing(render::RayClass::Shadow), 1_250),
            (Stage::MakingRays, 400),
            (Stage::Shading, 500),
            (Stage::Rest, 50),
        ] {
            thread_times.add(stage, Duration::from_millis(milliseconds));
        }
        Report {
            scene: "scenes/hall.sce".to_owned(),
            width: 800,
            height: 600,
            structure: "bvh",
            threads: 2,
            build: BuildReport {
                time: Duration::from_micros(45_600),
                stages,
                objects,
                meshes,
                triangles: 70_000,
                triangle_bytes: 3_360_000,
            },
            render_time: Duration::from_millis(1_250),
            thread_times,
            rays: vec![
                class("view", 1_920_000, 250, 44_928_000, 7_872_000),
                class("shadow", 8_000_000, 1_250, 96_000_000, 4_000_000),
            ],
            ..Report::default()
        }
    }

    #[test]
    fn memory_adds_up() {
        let report = example();
        assert_eq!(report.index_bytes(), 4_480_096);
        assert_eq!(report.bytes_per_triangle(), Some(112.0));
        assert_eq!(Report::default().bytes_per_triangle(), None);
    }
}
