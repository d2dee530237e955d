//! Record → CSV: a line for each scene, structure and class of rays, with numbers in full precision.
//!
//! The form is that of RFC 4180 with a heading line. A structure that traced nothing has one line with an empty class,
//! so that it is not missing.

mod sampling;

pub(super) use sampling::write_sampling;

use super::Report;
use super::numbers::exact;
use crate::analysis::{ClassFigures, SceneFigures, StructureFigures};
use crate::record::{
    Conformance, ConformanceOutcome, Estimate, Memory, SceneRecord, Status, StructureRecord,
};

const HEADS: [&str; 40] = [
    "scene",
    "triangles",
    "structure",
    "status",
    "class",
    "rays",
    "recorded_rays",
    "hit_share",
    "boxes_per_ray",
    "primitives_per_ray",
    "rounds",
    "ns_per_ray",
    "ns_per_ray_low",
    "ns_per_ray_high",
    "cpu_ns_per_ray",
    "disturbance",
    "instructions_per_cycle",
    "branch_misses_per_ray",
    "cache_misses_per_ray",
    "million_rays_per_second",
    "million_rays_per_second_low",
    "million_rays_per_second_high",
    "base",
    "speedup",
    "speedup_low",
    "speedup_high",
    "build_one_thread_ns",
    "build_all_threads_ns",
    "index_bytes",
    "bytes_per_triangle",
    "primitive_bytes",
    "total_bytes_per_triangle",
    "sah_cost",
    "epo",
    "epo_standard_error",
    "picture_ns",
    "picture_ns_low",
    "picture_ns_high",
    "picture_rounds",
    "conformance",
];

/// Writes the table. Its numbers read back equal to those in the JSON's `derived`.
pub(super) fn write(report: &Report<'_>) -> String {
    let mut text = line(HEADS.map(str::to_owned));
    for (scene, figures) in report.comparison.scenes.iter().zip(&report.analysis.scenes) {
        for (structure, own) in scene.structures.iter().zip(&figures.structures) {
            let checked = report.comparison.conformance_of(&structure.name);
            if own.classes.is_empty() {
                text += &line(row(scene, figures, structure, own, checked, None));
            }
            for class in &own.classes {
                text += &line(row(scene, figures, structure, own, checked, Some(class)));
            }
        }
    }
    text
}

fn row(
    scene: &SceneRecord,
    figures: &SceneFigures,
    record: &StructureRecord,
    own: &StructureFigures,
    conformance: Option<&Conformance>,
    class: Option<&ClassFigures>,
) -> [String; 40] {
    let ns = class.and_then(|class| class.ns_per_ray);
    let rate = parts(class.and_then(|class| class.million_rays_per_second));
    let speedup = parts(class.and_then(|class| class.speedup));
    let shape = record.shape.as_ref();
    let [ns_value, ns_low, ns_high] = parts(ns);
    let [rate, rate_low, rate_high] = rate;
    let [speedup, speedup_low, speedup_high] = speedup;
    let [picture, picture_low, picture_high] = parts(own.picture_ns);
    [
        text(&scene.name),
        scene.triangles.to_string(),
        text(&record.name),
        status(&record.status).to_owned(),
        class.map_or_else(String::new, |class| class.class.name().to_owned()),
        whole(class.map(|class| class.rays)),
        whole(class.map(|class| class.recorded_rays)),
        number(class.and_then(|class| class.hit_share)),
        number(class.and_then(|class| class.boxes_per_ray)),
        number(class.and_then(|class| class.primitives_per_ray)),
        whole(ns.map(|estimate| estimate.rounds as u64)),
        ns_value,
        ns_low,
        ns_high,
        value(class.and_then(|class| class.cpu_ns_per_ray)),
        number(class.and_then(|class| class.disturbance)),
        value(class.and_then(|class| class.instructions_per_cycle)),
        value(class.and_then(|class| class.branch_misses_per_ray)),
        value(class.and_then(|class| class.cache_misses_per_ray)),
        rate,
        rate_low,
        rate_high,
        text(figures.base.as_deref().unwrap_or_default()),
        speedup,
        speedup_low,
        speedup_high,
        value(own.build_one_thread_ns),
        value(own.build_all_threads_ns),
        whole(record.memory.as_ref().map(|memory: &Memory| memory.index_bytes)),
        number(own.bytes_per_triangle),
        whole(record.memory.as_ref().map(|memory: &Memory| memory.primitive_bytes)),
        number(own.total_bytes_per_triangle),
        number(shape.and_then(|shape| shape.sah_cost)),
        number(shape.and_then(|shape| shape.epo)),
        number(shape.and_then(|shape| shape.epo_standard_error)),
        picture,
        picture_low,
        picture_high,
        whole(own.picture_ns.map(|estimate| estimate.rounds as u64)),
        conformance.map_or("", state).to_owned(),
    ]
}

/// A status as in the JSON.
fn status(status: &Status) -> &'static str {
    match status {
        Status::Ok => "ok",
        Status::Failed { .. } => "failed",
        Status::TooSlow { .. } => "too_slow",
        Status::Stopped => "stopped",
    }
}

/// What a check of conformance showed, as in the JSON, or that it had no time for all of it.
fn state(own: &Conformance) -> &'static str {
    match own.outcome {
        ConformanceOutcome::Equal if own.is_whole() => "equal",
        ConformanceOutcome::Equal => "equal_so_far",
        ConformanceOutcome::Differs(_) => "differs",
        ConformanceOutcome::Failed { .. } => "failed",
    }
}

/// Value, low and high.
fn parts(estimate: Option<Estimate>) -> [String; 3] {
    let interval = estimate.and_then(|estimate| estimate.interval);
    [
        value(estimate),
        number(interval.map(|interval| interval.low)),
        number(interval.map(|interval| interval.high)),
    ]
}

fn value(estimate: Option<Estimate>) -> String {
    number(estimate.map(|estimate| estimate.value))
}

fn number(value: Option<f64>) -> String {
    value.map_or_else(String::new, exact)
}

fn whole(value: Option<u64>) -> String {
    value.map_or_else(String::new, |n| n.to_string())
}

/// A name from the record, which may come from anybody. One that begins as a spreadsheet's formula does
/// gets a single quote before it, as spreadsheets mark text.
fn text(name: &str) -> String {
    let is_formula = name.starts_with(['=', '+', '-', '@', '\t', '\r', '\n']);
    if is_formula { format!("'{name}") } else { name.to_owned() }
}

/// Fields in a line; those with a comma, a quote or a line end are quoted.
fn line<const N: usize>(fields: [String; N]) -> String {
    let quoted = |field: String| {
        if field.contains([',', '"', '\n', '\r']) {
            format!("\"{}\"", field.replace('"', "\"\""))
        } else {
            field
        }
    };
    fields.map(quoted).join(",") + "\r\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_that_need_quotes_get_them() {
        let fields = ["a", "b,c", "d \"e\"", ""].map(str::to_owned);
        assert_eq!(line(fields), "a,\"b,c\",\"d \"\"e\"\"\",\r\n");
    }

    #[test]
    fn names_are_no_formulas() {
        for formula in ["=1+1", "+1", "-1", "@SUM(1)", "\t=1", "\r=1", "\n=1"] {
            assert_eq!(text(formula), format!("'{formula}"));
        }
        assert_eq!(text("hall-1 = 2"), "hall-1 = 2");
        assert_eq!(text(""), "");
    }
}
