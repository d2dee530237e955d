//! Figures → text: the line at the end of a rendering, and the table of `--stats`.

use std::fmt::Write;

use super::figures::{RayClass, Report};
use super::units;
use crate::accel::StructureShape;
use crate::counters::Counts;
use crate::render::Stage;

/// Size, structure, build time, render time, rays by class, million rays a second.
pub(crate) fn line(report: &Report) -> String {
    let partial = if report.partial { " (stopped early)" } else { "" };
    let share = report.thread_times.tracing_share();
    let tracing = share.map_or(String::new(), |s| format!(" ({:.0} % of it tracing)", 100.0 * s));
    format!(
        "{} × {}, {}: built in {}, rendered in {}{tracing}{partial}, {}, {}",
        report.width,
        report.height,
        report.structure,
        units::time(report.build.time),
        units::time(report.render_time),
        rays(report),
        units::rays_per_second(report.total_rays(), report.render_time),
    )
}

/// `9.92 M rays (1.92 M view, 8.00 M shadow)`.
fn rays(report: &Report) -> String {
    let classes: Vec<String> = report
        .rays
        .iter()
        .filter(|class| class.rays > 0)
        .map(|class| format!("{} {}", units::count(class.rays), class.name))
        .collect();
    let total = units::count(report.total_rays());
    if classes.is_empty() {
        format!("{total} rays")
    } else {
        format!("{total} rays ({})", classes.join(", "))
    }
}

/// The table of `--stats`: facts about the structure, then a line for each class of rays.
pub(crate) fn table(report: &Report) -> String {
    let mut text = String::new();
    for (name, value) in facts(report) {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{name:<12}{value}");
    }
    text.push('\n');
    let heading = ["index", "nodes", "leaves", "depth", "bytes", "leaf sizes"].map(str::to_owned);
    let levels = [("objects", &report.build.objects), ("meshes", &report.build.meshes)];
    for [name, nodes, leaves, depth, bytes, sizes] in
        std::iter::once(heading).chain(levels.map(|(name, shape)| level(name, shape)))
    {
        let _ = writeln!(text, "{name:<12}{nodes:>10}{leaves:>10}{depth:>7}{bytes:>12}   {sizes}");
    }
    text.push('\n');
    let heading = ["rays", "count", "boxes/ray", "primitives/ray"].map(str::to_owned);
    let rows = report.rays.iter().map(row).chain(total_row(report));
    for [name, count, boxes, primitives] in std::iter::once(heading).chain(rows) {
        let _ = writeln!(text, "{name:<12}{count:>10}{boxes:>13}{primitives:>18}");
    }
    text.push('\n');
    let heading = ["threads", "time", "share"].map(str::to_owned);
    for [name, time, share] in std::iter::once(heading).chain(stages(report)) {
        let _ = writeln!(text, "{name:<24}{time:>10}{share:>9}");
    }
    text
}

/// What the threads spent their time on: the stages that took any, and all of them but tracing.
fn stages(report: &Report) -> impl Iterator<Item = [String; 3]> {
    let times = &report.thread_times;
    let row = |name: &str, time, share: Option<f64>| {
        let share = share.map_or(String::new(), |share| format!("{:.1} %", 100.0 * share));
        [name.to_owned(), units::time(time), share]
    };
    let taken = Stage::ALL.into_iter().filter(|&stage| !times.of(stage).is_zero());
    let stages = taken.map(move |stage| row(stage.name(), times.of(stage), times.share(stage)));
    let (outside, share) = (times.outside_tracing(), times.outside_tracing_share());
    stages.chain(std::iter::once(row("all outside tracing", outside, share)))
}

fn facts(report: &Report) -> [(&'static str, String); 5] {
    [
        ("structure", format!("{}, {} build", report.structure, report.quality.name())),
        ("built in", format!("{}{}", units::time(report.build.time), build_stages(report))),
        ("rendered in", units::time(report.render_time)),
        ("threads", report.threads.to_string()),
        ("memory", memory(report)),
    ]
}

/// ` (boxes 1.20 ms, clustering 30.1 ms)`, or nothing where the structure does not tell.
fn build_stages(report: &Report) -> String {
    let stages = report.build.stages.iter();
    let stages: Vec<_> =
        stages.map(|(stage, time)| format!("{stage} {}", units::time(time))).collect();
    if stages.is_empty() { String::new() } else { format!(" ({})", stages.join(", ")) }
}

/// `4.27 MiB index, 3.20 MiB for 70.0 k triangles: 112.0 B a triangle`.
fn memory(report: &Report) -> String {
    let index = format!("{} index", units::bytes(report.index_bytes()));
    match report.bytes_per_triangle() {
        Some(each) => format!(
            "{index}, {} for {} triangles: {each:.1} B a triangle",
            units::bytes(report.build.triangle_bytes),
            units::count(report.build.triangles),
        ),
        None => index,
    }
}

/// One of the two levels of a structure.
fn level(name: &str, shape: &StructureShape) -> [String; 6] {
    [
        name.to_owned(),
        units::count(shape.nodes),
        units::count(shape.leaves),
        shape.depth.to_string(),
        units::bytes(shape.bytes),
        leaf_sizes(shape),
    ]
}

/// `1 to 5 primitives, 1.00 on average`.
fn leaf_sizes(shape: &StructureShape) -> String {
    let sizes = || shape.leaf_sizes.iter().enumerate().filter(|(_, leaves)| **leaves > 0);
    let primitives: u64 = sizes().map(|(size, leaves)| size as u64 * leaves).sum();
    let (Some((least, _)), Some((most, _))) = (sizes().next(), sizes().next_back()) else {
        return "–".to_owned();
    };
    if least == most {
        return format!("{least}");
    }
    format!("{least} to {most}, {} on average", units::per_ray(primitives, shape.leaves))
}

fn row(class: &RayClass) -> [String; 4] {
    let per_ray = |n: fn(Counts) -> u64| {
        class.counts.map_or("–".to_owned(), |counts| units::per_ray(n(counts), class.rays))
    };
    [
        class.name.to_owned(),
        units::count(class.rays),
        per_ray(|counts| counts.boxes),
        per_ray(|counts| counts.primitives),
    ]
}

/// All classes together, if there are several.
fn total_row(report: &Report) -> Option<[String; 4]> {
    let mut counts = Counts::default();
    for class in &report.rays {
        counts += class.counts?;
    }
    let hits = report.rays.iter().map(|class| class.hits).sum();
    let total = RayClass {
        name: "all",
        rays: report.total_rays(),
        hits,
        trace_time: report.thread_times.tracing(),
        counts: Some(counts),
    };
    (report.rays.len() > 1).then(|| row(&total))
}

#[cfg(test)]
mod tests {
    use super::super::figures::tests::example;
    use super::*;

    #[test]
    fn the_line() {
        assert_eq!(
            line(&example()),
            "800 × 600, bvh: built in 45.6 ms, rendered in 1.25 s (61 % of it tracing), \
             9.92 M rays (1.92 M view, 8.00 M shadow), 7.94 M rays/s"
        );
    }

    #[test]
    fn the_line_of_a_stopped_rendering_says_so() {
        let report = Report { partial: true, rays: Vec::new(), ..example() };
        assert!(
            line(&report)
                .contains("rendered in 1.25 s (61 % of it tracing) (stopped early), 0 rays, ")
        );
    }

    #[test]
    fn the_table() {
        let expected = "\
structure   bvh, medium build
built in    45.6 ms (triangles 5.60 ms, structure 40.0 ms)
rendered in 1.25 s
threads     2
memory      4.27 MiB index, 3.20 MiB for 70.0 k triangles: 112.0 B a triangle

index            nodes    leaves  depth       bytes   leaf sizes
objects              3         2      1        96 B   1
meshes           140 k    70.0 k     23    4.27 MiB   1 to 5, 1.00 on average

rays             count    boxes/ray    primitives/ray
view            1.92 M        23.40              4.10
shadow          8.00 M        12.00              0.50
all             9.92 M        14.21              1.20

threads                       time    share
tracing view rays           250 ms   10.2 %
tracing shadow rays         1.25 s   51.0 %
making rays                 400 ms   16.3 %
shading                     500 ms   20.4 %
the rest                   50.0 ms    2.0 %
all outside tracing         950 ms   38.8 %
";
        assert_eq!(table(&example()), expected);
    }
}
