//! Figures → text: the line at the end of a rendering, and the table of `--stats`. Numbers and columns
//! are those of the reports, with spaces that every terminal shows as such.

use std::fmt::Write;

use super::figures::{Figures, Index, RaysOfClass, quotient};
use super::progress::share;
use crate::analysis::statistics::million_per_second;
use crate::render::Stage;
use crate::report::numbers::{self, NOTHING};
use crate::report::terminal_table;
use crate::report::{Cell, Table};

/// Size, structure, build time, render time, rays by class, million rays a second.
pub(crate) fn line(figures: &Figures) -> String {
    let pixels = u64::from(figures.width) * u64::from(figures.height);
    let partial = how_far(figures, pixels);
    let share = quotient(figures.thread_seconds.tracing, figures.thread_seconds.total);
    let tracing = share.map_or(String::new(), |s| format!(" ({:.0} % of it tracing)", 100.0 * s));
    plain(&format!(
        "{} × {}, {}: built in {}, rendered in {}{tracing}{partial}, {}, {}",
        figures.width,
        figures.height,
        figures.structure.name,
        numbers::duration(figures.structure.build_seconds),
        numbers::duration(figures.render_seconds),
        rays(figures),
        ray_rate(figures.rays, figures.render_seconds),
    ))
}

/// ` (interrupted: 37 % rendered)`, ` (stopped by --time: 34 % rendered, 5.4 of 16 samples a pixel, noise 0.0130)`, or
/// nothing of a picture that is whole and of unknown noise.
fn how_far(figures: &Figures, pixels: u64) -> String {
    let noise = figures.noise.map(|noise| format!("noise {}", numbers::figures(noise)));
    let Some(by) = figures.stopped_by else {
        return noise.map_or(String::new(), |noise| format!(" ({noise})"));
    };
    let all = figures.all_samples_per_pixel;
    let samples = (figures.samples_per_pixel * pixels as f64).round() as u64;
    let mut text = match by {
        "signal" => " (interrupted: ".to_owned(),
        by => format!(" (stopped by --{by}: "),
    };
    text += &format!("{} rendered", share(samples, pixels * u64::from(all)));
    if figures.rendered_pixels * u64::from(all) != samples {
        text += &format!(", {:.1} of {all} samples a pixel", figures.samples_per_pixel);
        if figures.rendered_pixels < pixels {
            text +=
                &format!(", none of {} of them", share(pixels - figures.rendered_pixels, pixels));
        }
    }
    if let Some(noise) = noise {
        text = format!("{text}, {noise}");
    }
    text + ")"
}

/// A speed in rays: `12.3 M rays/s`. No time gives no speed.
pub(crate) fn ray_rate(rays: u64, seconds: f64) -> String {
    let rate = million_per_second(rays, 1e9 * seconds).map(numbers::figures);
    format!("{} M rays/s", rate.as_deref().unwrap_or(NOTHING))
}

/// `9.92 M rays (1.92 M view, 8.00 M shadow)`.
fn rays(figures: &Figures) -> String {
    let occurred = figures.classes.iter().filter(|own| own.rays > 0);
    let classes: Vec<String> =
        occurred.map(|own| format!("{} {}", numbers::count(own.rays), own.class.name())).collect();
    let total = numbers::count(figures.rays);
    if classes.is_empty() {
        format!("{total} rays")
    } else {
        format!("{total} rays ({})", classes.join(", "))
    }
}

/// The table of `--stats`: facts about the structure, its indices, the classes of rays, and what the
/// threads spent their time on.
pub(crate) fn table(figures: &Figures) -> String {
    let mut text = String::new();
    for (name, value) in facts(figures) {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{name:<12}{value}");
    }
    for table in [indices(figures), classes(figures), stages(figures)] {
        text.push('\n');
        text.push_str(&terminal_table(&table));
    }
    plain(&text)
}

fn facts(figures: &Figures) -> [(&'static str, String); 5] {
    let structure = &figures.structure;
    let build = numbers::duration(structure.build_seconds);
    [
        ("structure", format!("{}, {} build", structure.name, structure.build)),
        ("built in", format!("{build}{}", build_stages(figures))),
        ("rendered in", numbers::duration(figures.render_seconds)),
        ("threads", figures.threads.to_string()),
        ("memory", memory(figures)),
    ]
}

/// ` (boxes 1.20 ms, clustering 30.1 ms)`, or nothing where the structure does not measure them.
fn build_stages(figures: &Figures) -> String {
    let stages = figures.structure.build_stages.iter();
    let stages: Vec<_> =
        stages.map(|own| format!("{} {}", own.stage, numbers::duration(own.seconds))).collect();
    if stages.is_empty() { String::new() } else { format!(" ({})", stages.join(", ")) }
}

/// `4.27 MiB index, 3.20 MiB for 70.0 k triangles: 112 B a triangle`.
fn memory(figures: &Figures) -> String {
    let structure = &figures.structure;
    let index = numbers::bytes(structure.objects.bytes + structure.meshes.bytes);
    match structure.bytes_per_triangle {
        Some(each) => format!(
            "{index} index, {} for {} triangles: {} B a triangle",
            numbers::bytes(structure.triangle_bytes),
            numbers::count(structure.triangles),
            numbers::figures(each),
        ),
        None => format!("{index} index"),
    }
}

/// The two levels of the structure.
fn indices(figures: &Figures) -> Table {
    let heads = ["index", "#nodes", "#leaves", "#depth", "#bytes", "leaf sizes"];
    let mut table = Table::new("", "", &heads);
    let levels = [("objects", &figures.structure.objects), ("meshes", &figures.structure.meshes)];
    table.rows = levels.map(|(name, index)| index_row(name, index)).into();
    table
}

fn index_row(name: &str, index: &Index) -> Vec<Cell> {
    let cells = [
        name.to_owned(),
        numbers::count(index.nodes),
        numbers::count(index.leaves),
        index.depth.to_string(),
        numbers::bytes(index.bytes),
        leaf_sizes(index),
    ];
    cells.map(Cell::text).into()
}

/// `1 to 5, 1.00 on average`.
fn leaf_sizes(index: &Index) -> String {
    let sizes = &index.leaf_sizes;
    let (Some((least, _)), Some((most, _))) = (sizes.first_key_value(), sizes.last_key_value())
    else {
        return NOTHING.to_owned();
    };
    if least == most {
        return format!("{least}");
    }
    let primitives: u64 = sizes.iter().map(|(&size, leaves)| size as u64 * leaves).sum();
    let mean = quotient(primitives as f64, index.leaves as f64);
    format!("{least} to {most}, {} on average", or_nothing(mean))
}

/// The rays by class, and all together if there are several classes.
fn classes(figures: &Figures) -> Table {
    let heads = ["rays", "#count", "#boxes/ray", "#primitives/ray"];
    let mut table = Table::new("", "", &heads);
    let row = |name: &str, rays: u64, tests: [Option<f64>; 2]| {
        let [boxes, primitives] = tests.map(or_nothing);
        [name.to_owned(), numbers::count(rays), boxes, primitives].map(Cell::text).into()
    };
    let of_class = |own: &RaysOfClass| {
        row(own.class.name(), own.rays, [own.boxes_per_ray, own.primitives_per_ray])
    };
    table.rows = figures.classes.iter().map(of_class).collect();
    if figures.classes.len() > 1 {
        let mean = |tests: fn(&RaysOfClass) -> Option<u64>| {
            let sum: Option<u64> = figures.classes.iter().map(tests).sum();
            quotient(sum? as f64, figures.rays as f64)
        };
        table.rows.push(row(
            "all",
            figures.rays,
            [mean(|own| own.boxes), mean(|own| own.primitives)],
        ));
    }
    table
}

/// What the threads spent their time on: the stages that took any, and all of them but tracing.
fn stages(figures: &Figures) -> Table {
    let mut table = Table::new("", "", &["threads", "#time", "#share"]);
    let seconds = &figures.thread_seconds;
    let row = |name: &str, time: f64| {
        let share = quotient(time, seconds.total).map_or(String::new(), numbers::percent);
        [name.to_owned(), numbers::duration(time), share].map(Cell::text).into()
    };
    let tracing = figures.classes.iter().map(|own| (Stage::Tracing(own.class), own.trace_seconds));
    let others = [
        (Stage::MakingRays, seconds.making_rays),
        (Stage::Shading, seconds.shading),
        (Stage::Rest, seconds.rest),
    ];
    let taken = tracing.chain(others).filter(|&(_, time)| time > 0.0);
    table.rows = taken.map(|(stage, time)| row(stage.name(), time)).collect();
    table.rows.push(row("all outside tracing", seconds.outside_tracing));
    table
}

/// A number with three figures, or a dash.
fn or_nothing(number: Option<f64>) -> String {
    number.map_or_else(|| NOTHING.to_owned(), numbers::figures)
}

/// Reports keep a number and its unit in one line; a terminal breaks no lines, and what is copied
/// from it should hold plain spaces.
fn plain(text: &str) -> String {
    text.replace(['\u{a0}', '\u{202f}'], " ")
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
    fn the_line_of_a_stopped_rendering_shows_that() {
        let mut figures = example();
        (figures.partial, figures.rays, figures.rendered_pixels) = (true, 0, 177_601);
        (figures.stopped_by, figures.all_samples_per_pixel) = (Some("signal"), 4);
        figures.samples_per_pixel = 4.0 * 177_601.0 / 480_000.0;
        figures.classes.clear();
        let part = "rendered in 1.25 s (61 % of it tracing) (interrupted: 37 % rendered), 0 rays, ";
        assert!(line(&figures).contains(part));
    }

    #[test]
    fn the_line_of_a_refined_rendering_shows_its_noise_and_what_stopped_it() {
        let mut figures = example();
        figures.noise = Some(0.0123);
        assert!(line(&figures).contains("(61 % of it tracing) (noise 0.0123), 9.92 M rays"));
        (figures.stopped_by, figures.all_samples_per_pixel) = (Some("time"), 16);
        figures.samples_per_pixel = 5.36;
        let part = "(stopped by --time: 33 % rendered, 5.4 of 16 samples a pixel, noise 0.0123), 9";
        assert!(line(&figures).contains(part), "{}", line(&figures));
        (figures.rendered_pixels, figures.samples_per_pixel) = (240_000, 0.75);
        let part =
            "(stopped by --time: 4 % rendered, 0.8 of 16 samples a pixel, none of 50 % of them, ";
        assert!(line(&figures).contains(part), "{}", line(&figures));
    }

    #[test]
    fn rates() {
        assert_eq!(ray_rate(12_345_678, 1.0), "12.3 M rays/s");
        assert_eq!(ray_rate(12_345, 1.0), "0.0123 M rays/s");
        assert_eq!(ray_rate(5, 0.0), "– M rays/s");
    }

    #[test]
    fn the_table() {
        let expected = "\
structure   bvh, medium build
built in    45.6 ms (mesh 5.60 ms, structure 40.0 ms)
rendered in 1.25 s
threads     2
memory      4.27 MiB index, 3.20 MiB for 70.0 k triangles: 112 B a triangle

index    nodes  leaves  depth     bytes  leaf sizes
objects      3       2      1      96 B  1
meshes   140 k  70.0 k     23  4.27 MiB  1 to 5, 1.00 on average

rays     count  boxes/ray  primitives/ray
view    1.92 M       23.4            4.10
shadow  8.00 M       12.0           0.500
all     9.92 M       14.2            1.20

threads                 time   share
tracing view rays     250 ms  10.2 %
tracing shadow rays   1.25 s  51.0 %
making rays           400 ms  16.3 %
shading               500 ms  20.4 %
the rest             50.0 ms   2.0 %
all outside tracing   950 ms  38.8 %
";
        assert_eq!(table(&example()), expected);
    }
}
