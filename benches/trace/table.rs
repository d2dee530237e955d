//! The table of a run, read back from what criterion stored.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use serde_json::Value;
use srt::compare::machine;

/// One benchmark.
pub(crate) struct Row {
    group: String,
    name: String,
    triangles: Option<u64>,
    elements: u64,
    unit: &'static str,
}

impl Row {
    pub(crate) fn new(
        group: &str,
        name: &str,
        triangles: Option<u64>,
        elements: u64,
        unit: &'static str,
    ) -> Self {
        Self { group: group.into(), name: name.into(), triangles, elements, unit }
    }

    /// Median and the ends of its 95 % interval, in nanoseconds an iteration.
    fn median(&self) -> Option<[f64; 3]> {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("target/criterion");
        let mut file = folder.join(&self.group).join(&self.name);
        if let Some(triangles) = self.triangles {
            file.push(triangles.to_string());
        }
        let file = file.join("new/estimates.json");
        let estimates: Value = serde_json::from_str(&fs::read_to_string(file).ok()?).ok()?;
        let median = &estimates["median"];
        let interval = &median["confidence_interval"];
        Some([
            median["point_estimate"].as_f64()?,
            interval["lower_bound"].as_f64()?,
            interval["upper_bound"].as_f64()?,
        ])
    }
}

/// Writes `results/benchmarks.md`.
pub(crate) fn write(rows: &[Row]) {
    let machine = machine();
    let mut text = format!(
        "# Benchmarks\n\n\
         Written by `cargo bench --bench trace`: medians of criterion's samples on one thread for \
         rays and on all for builds, with the 95 % interval of the median. The mesh of builds and \
         traversals is a generated torus knot. `none` and `ball` trace fewer rays where there are \
         many triangles. Figures of one run on one machine ({}, {} cores; {}): compare rows with \
         each other, not with other machines.\n\n\
         | group | benchmark | triangles | median | 95 % interval | rate |\n\
         |---|---|--:|--:|--:|--:|\n",
        machine.cpu, machine.cores, machine.instruction_set,
    );
    for row in rows {
        let Some([median, low, high]) = row.median() else { continue };
        let triangles = row.triangles.map_or_else(|| "–".to_string(), |n| n.to_string());
        let rate = row.elements as f64 / median * 1e3;
        let _ = writeln!(
            text,
            "| {} | {} | {triangles} | {} | {} – {} | {rate:.3} M {}/s |",
            row.group,
            row.name,
            time(median),
            time(low),
            time(high),
            row.unit,
        );
    }
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("results");
    fs::create_dir_all(&folder).expect("results/ can be made");
    fs::write(folder.join("benchmarks.md"), text).expect("results/benchmarks.md can be written");
}

/// Nanoseconds for people.
fn time(ns: f64) -> String {
    match ns {
        ns if ns < 1e3 => format!("{ns:.3} ns"),
        ns if ns < 1e6 => format!("{:.3} µs", ns / 1e3),
        ns if ns < 1e9 => format!("{:.3} ms", ns / 1e6),
        ns => format!("{:.3} s", ns / 1e9),
    }
}
