//! The record of a scene that moves and pictures of its frames → one self-contained HTML file: a flip-book, the table,
//! and plots of the times frame by frame.
//!
//! Without scripts, and on paper, the pictures stand in rows.

use maud::{Markup, html};

use super::MotionReport;
use crate::page::{Page, Parts, picture, slides};
use crate::record::{FramePicture, Motion, Strategy, StrategyRecord};
use crate::report::html::table::bare;
use crate::report::html::{SCRIPT, STYLE, prose};
use crate::report::numbers::TIME;
use crate::report::plot::{self, AxisKind, Ends, Look, Plot, XyPlot, XySeries};

/// For so long a picture is shown when the flip-book is played.
const MILLISECONDS: u32 = 150;

/// So many frames of a line have a marker, about: lines do not differ by colour alone.
const MARKED: usize = 8;

pub(super) fn write(report: &MotionReport<'_>, pictures: &[FramePicture]) -> String {
    let Motion { scene, run, .. } = report.motion;
    let title = format!("srt animates {scene}");
    let script = format!("{SCRIPT}{}", slides::SCRIPT);
    let parts = Parts::Within {
        version: &run.version,
        styles: &[plot::STYLE, STYLE, slides::STYLE, include_str!("page.css")],
        script: &script,
    };
    Page { title: &title, parts }.with(body(report, pictures))
}

fn body(report: &MotionReport<'_>, pictures: &[FramePicture]) -> Markup {
    let Motion { scene, run, .. } = report.motion;
    let figures: Vec<Markup> = pictures.iter().map(|own| figure(scene, own)).collect();
    let lines = report.lines();
    html! {
        header {
            p class="kicker" { "srt animates a scene: what it costs structures to follow it" }
            h1 { (scene) }
            p class="subtitle" { (what_moves(report)) }
            p class="byline" {
                @if run.date.is_empty() { "No date" } @else { time datetime=(run.date) { (run.date) } }
                @if !run.machine.cpu.is_empty() { " · " (run.machine.cpu) }
                @if let Some(commit) = &run.commit { " · commit " code { (commit) } }
            }
            @if run.partial { p class="warning" { strong { "Partial." } " It was stopped before the last frame." } }
            @if !report.holds() { p class="warning" { strong { "Answers differ." } " See the table." } }
        }
        main {
            @if !figures.is_empty() {
                section id="frames" { h2 { "Frames" } (slides::slides("frame", Some(MILLISECONDS), &figures)) }
            }
            section id="costs" {
                h2 { "What it costs" }
                (bare(&report.table()))
                @for line in &lines { p class="note" { (prose(line)) } }
            }
            section id="by-frame" {
                h2 { "Frame by frame" }
                @for plot in plots(report.motion) { (plot) }
            }
            section id="run" {
                h2 { "How it was measured" }
                pre class="command" tabindex="0" { code { (run.command) } }
            }
        }
        footer {
            "Made by srt " (run.version) ". The JSON, CSV and Markdown files beside this page have the same numbers. "
            "All structures give the same picture; these were rendered with the first."
        }
    }
}

/// What moves, without the name of the scene.
fn what_moves(report: &MotionReport<'_>) -> String {
    let line = report.headline();
    let rest = line.strip_prefix(&report.motion.scene).and_then(|rest| rest.strip_prefix(", "));
    let rest = rest.unwrap_or(&line);
    let first = rest.chars().next().map(|first| first.to_uppercase().to_string());
    first.map(|first| first + rest.get(1..).unwrap_or_default()).unwrap_or_default()
}

fn figure(scene: &str, own: &FramePicture) -> Markup {
    html! {
        figure {
            (picture(&own.png, own.size, &format!("{scene}, frame {}", own.frame)))
            figcaption { strong { "Frame " (own.frame) } }
        }
    }
}

/// For each structure the updates of each frame, and its rays.
fn plots(motion: &Motion) -> impl Iterator<Item = Plot> {
    let mut structures: Vec<&str> = Vec::new();
    for own in &motion.strategies {
        if !structures.contains(&own.structure.as_str()) {
            structures.push(&own.structure);
        }
    }
    structures.into_iter().flat_map(|structure| {
        let updates = plot(
            motion,
            structure,
            ["to be ready for each frame", "The time of each update", "update (logarithmic)"],
            &|own| own.updates.iter().map(crate::record::Round::own_ns).collect(),
        );
        let rays = plot(
            motion,
            structure,
            [
                "the recorded rays of each frame",
                "The time of all rays",
                "rays of a frame (logarithmic)",
            ],
            &|own| {
                let sum = |place| own.trace_ns.iter().filter_map(|times| times.get(place)).sum();
                (0..own.updates.len()).map(sum).collect()
            },
        );
        updates.into_iter().chain(rays)
    })
}

/// Times of each frame with a structure, a line for each strategy; `texts` are the heading, what is shown, and what
/// stands at the axis.
fn plot(
    motion: &Motion,
    structure: &str,
    [heading, shown, label]: [&'static str; 3],
    times: &dyn Fn(&StrategyRecord) -> Vec<u64>,
) -> Option<Plot> {
    let series = motion.strategies.iter().filter(|own| own.structure == structure).map(|own| {
        let numbered = (motion.frames[0] + 1..).zip(times(own));
        let line: Vec<_> = numbered.map(|(frame, ns)| (f64::from(frame), ns as f64)).collect();
        let points = marked(&line);
        // A strategy looks the same in all plots.
        let place = Strategy::ALL.iter().position(|other| *other == own.strategy);
        XySeries {
            look: Look::of_series(place.unwrap_or_default()),
            name: own.strategy.name().to_owned(),
            intervals: vec![None; points.len()],
            points,
            line,
            fit: false,
        }
    });
    let plot = XyPlot {
        title: format!("{structure}: {heading}"),
        meaning: format!("{shown} against the number of the frame, for each strategy."),
        x: Ends { label: "frame", units: &[], kind: AxisKind::Linear },
        y: Ends::logarithmic(label, TIME),
        series: series.collect(),
        path: Vec::new(),
        rings: Vec::new(),
        ring_meaning: "",
    };
    plot.draw()
}

/// Some points of a line, the last among them.
fn marked(line: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let every = line.len().div_ceil(MARKED).max(1);
    let mut points: Vec<_> = line.iter().rev().step_by(every).copied().collect();
    points.reverse();
    points
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::{MotionRays, Moved, RayClass, Round};

    fn motion() -> Motion {
        let record = |strategy, update| StrategyRecord {
            structure: "bvh8".to_owned(),
            strategy,
            updates: (0u64..20)
                .map(|i| Round { wall_ns: update + i, ..Round::default() })
                .collect(),
            trace_ns: vec![vec![5_000; 20]],
            sah_costs: [Some(9.0), None],
            rebuilt: 0,
            compared: 80,
            differing: 0,
        };
        Motion {
            scene: "a<b.sce".to_owned(),
            frames: [5, 25],
            moved: vec![Moved { objects: 1, triangles: 9, is_same_scene: true }; 20],
            rays: vec![MotionRays { class: RayClass::View, rays: vec![100; 20] }],
            strategies: vec![record(Strategy::Rebuild, 90_000), record(Strategy::Partial, 9_000)],
            ..Motion::default()
        }
    }

    #[test]
    fn the_page_has_the_frames_the_table_and_both_plots() {
        let pictures =
            [5, 15, 25].map(|frame| FramePicture { frame, size: [4, 3], png: vec![1, 2] });
        let motion = motion();
        let page = MotionReport::new(&motion).html(&pictures);
        assert!(page.starts_with("<!DOCTYPE html>") && page.ends_with("</html>"));
        for part in [
            r#"<img src="data:image/png;base64,AQI=" width="4" height="3" alt="a&lt;b.sce, frame 15">"#,
            "<strong>Frame 25</strong>",
            r#"data-play="150""#,
            "Frames 6 to 25, built for frame 5",
            "bvh8: to be ready for each frame",
            "bvh8: the recorded rays of each frame",
            "<code>none</code>",
        ] {
            assert!(page.contains(part), "{part}: {page}");
        }
        assert_eq!(page.matches("<svg").count(), 4, "each plot in two forms");
        let names_others =
            ["src=\"http", "href=\"http", "url(http"].iter().any(|mark| page.contains(mark));
        assert!(!page.contains("a<b") && !names_others);
        assert!(!MotionReport::new(&motion).html(&[]).contains("data-play="));
    }

    #[test]
    fn some_points_of_a_line_are_marked_and_the_last_always() {
        let line: Vec<_> = (0..60).map(|i| (f64::from(i), 1.0)).collect();
        let points = marked(&line);
        assert!(points.len() <= MARKED && points.last() == line.last() && points.is_sorted());
        assert_eq!(marked(&line[..3]), line[..3]);
        assert_eq!(marked(&[]), []);
    }
}
