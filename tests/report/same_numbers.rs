//! Markdown, CSV, HTML and JSON have the same numbers.

use std::collections::{BTreeMap, HashMap};

use serde_json::Value;
use srt::record::Comparison;
use srt::report::Report;

use crate::sample;

pub(crate) fn derived(comparison: &Comparison) -> Value {
    let text = Report::new(comparison).json().unwrap();
    serde_json::from_str::<Value>(&text).unwrap()["derived"].clone()
}

/// The lines of cells of all Markdown tables, headings and rules left out.
pub(crate) fn markdown_rows(text: &str) -> Vec<Vec<String>> {
    let lines: Vec<&str> = text.lines().collect();
    let is_rule = |line: &str| line.starts_with("|--");
    let is_body = |i: &usize| {
        lines[*i].starts_with("| ") && !lines.get(i + 1).is_some_and(|next| is_rule(next))
    };
    let cells = |line: &str| {
        let inner = line.trim_start_matches("| ").trim_end_matches(" |");
        inner.split(" | ").map(str::to_owned).collect()
    };
    (0..lines.len()).filter(is_body).map(|i| cells(lines[i])).collect()
}

/// The lines of cells of all HTML tables, intervals in parentheses as Markdown has them.
fn html_rows(page: &str) -> Vec<Vec<String>> {
    let cell = |cell: &str| {
        let (_, inner) = cell.split_once('>').unwrap();
        let inner = inner.split("</td>").next().unwrap();
        let inner = inner.replace("<span class=\"spread\">", " (").replace("</span>", ")");
        inner.replace('|', "\\|").replace('_', "\\_")
    };
    page.split("<tr")
        .filter(|row| row.contains("<td"))
        .map(|row| row.split("<td").skip(1).map(cell).collect())
        .collect()
}

#[test]
fn html_and_markdown_have_the_same_tables() {
    for comparison in [sample::full(), sample::partial()] {
        let page = Report::new(&comparison).html(&BTreeMap::new());
        let (before, rest) = page.split_once("<details").unwrap();
        let without_raw_rounds: String = rest
            .split("</details>")
            .skip(1)
            .map(|part| part.split("<details").next().unwrap())
            .fold(before.to_owned(), |all, part| all + part);
        let mut from_html = html_rows(&without_raw_rounds);
        let mut from_markdown = markdown_rows(&Report::new(&comparison).markdown());
        // Facts are a list on the page: two cells to a line in Markdown.
        from_markdown.retain(|row| row.len() > 2);
        from_html.sort();
        from_markdown.sort();
        assert!(from_html.len() > 40);
        assert_eq!(from_html, from_markdown);
    }
}

/// A number as it is printed, and half a step of its last figure. Bounds have the decimals of
/// their median.
fn printed(text: &str) -> (f64, f64) {
    let digits: String = text.chars().filter(|c| !matches!(c, '\u{202f}' | '\u{a0}')).collect();
    let decimals = digits.find('.').map_or(0, |point| digits.len() - point - 1);
    let half = 0.5 * 10f64.powi(-i32::try_from(decimals).unwrap());
    (digits.parse().unwrap_or_else(|_| panic!("no number: {text}")), half * (1.0 + 1e-9))
}

pub(crate) fn assert_printed(text: &str, value: &Value) {
    let (number, half) = printed(text);
    let value = value.as_f64().unwrap();
    assert!((number - value).abs() <= half, "{text} is printed for {value}");
}

/// `value (low–high)` against an estimate of the JSON.
pub(crate) fn assert_estimate(text: &str, estimate: &Value) {
    let Some((median, interval)) = text.split_once(" (") else {
        assert!(estimate["interval"].is_null());
        return assert_printed(text, &estimate["value"]);
    };
    assert_printed(median, &estimate["value"]);
    let (low, high) = interval.trim_end_matches(')').split_once('–').unwrap();
    assert_printed(low, &estimate["interval"]["low"]);
    assert_printed(high, &estimate["interval"]["high"]);
}

#[test]
fn markdown_prints_the_figures_of_the_json() {
    let comparison = sample::full();
    let text = Report::new(&comparison).markdown();
    let derived = derived(&comparison);
    let (mut checked, mut sampled) = (0, 0);
    for scene in derived["scenes"].as_array().unwrap() {
        let name = scene["scene"].as_str().unwrap();
        let (_, chapter) = text.split_once(&format!("\n## {name}\n")).unwrap();
        let (_, table) = chapter.split_once("\n### Rays\n").unwrap();
        let rows = markdown_rows(table.split("\n### ").next().unwrap());
        for structure in scene["structures"].as_array().unwrap() {
            for class in structure["classes"].as_array().unwrap() {
                let is_own = |row: &&Vec<String>| {
                    row[0] == class["class"] && row[1] == structure["structure"]
                };
                let row = rows.iter().find(is_own).unwrap();
                assert_estimate(&row[2], &class["speedup"]);
                assert_estimate(&row[3], &class["million_rays_per_second"]);
                assert_estimate(&row[4], &class["ns_per_ray"]);
                let rays = row[5].split_once(" (of ");
                assert_printed(rays.map_or(&row[5], |(rays, _)| rays), &class["rays"]);
                if let Some((_, recorded)) = rays {
                    assert_printed(recorded.trim_end_matches(')'), &class["recorded_rays"]);
                    sampled += 1;
                }
                let of_sample = class["counted_share"].as_f64().unwrap() < 1.0;
                for (cell, figure) in [(7, "boxes_per_ray"), (8, "primitives_per_ray")] {
                    let number = row[cell].strip_prefix("≈ ");
                    assert_eq!(number.is_some(), of_sample, "{row:?}");
                    assert_printed(number.unwrap_or(&row[cell]), &class[figure]);
                }
                assert_printed(&row[9], &class["ns_per_ray"]["rounds"]);
                checked += 1;
            }
        }
    }
    assert_eq!((checked, sampled), (6 * 7, 2));
}

#[test]
fn the_stages_of_builds_are_those_of_the_record() {
    let comparison = sample::full();
    let text = Report::new(&comparison).markdown();
    for scene in &comparison.scenes {
        let (_, chapter) = text.split_once(&format!("\n## {}\n", scene.name)).unwrap();
        let (_, table) = chapter.split_once("\n### Stages of the builds\n").unwrap();
        let table = table.split("\n### ").next().unwrap();
        assert!(table.contains("one build on 2 threads"), "{table}");
        let mut rows = markdown_rows(table).into_iter();
        for structure in &scene.structures {
            let mut shares = 0.0;
            for stage in &structure.build.stages {
                let row = rows.next().unwrap();
                assert_eq!(row[..2], [structure.name.clone(), stage.name.clone()]);
                assert!(row[2].ends_with('s'), "{row:?}");
                let (share, _) = printed(row[3].strip_suffix("\u{a0}%").unwrap());
                shares += share;
            }
            let has_stages = !structure.build.stages.is_empty();
            assert!(
                !has_stages || (shares - 100.0_f64).abs() < 0.3,
                "{shares} % of {}",
                structure.name
            );
        }
        assert_eq!(rows.next(), None);
    }
}

#[test]
fn builds_of_a_single_stage_have_no_table_of_them() {
    let mut comparison = sample::full();
    for scene in &mut comparison.scenes {
        scene.structures.iter_mut().for_each(|structure| structure.build.stages.truncate(1));
    }
    assert!(!Report::new(&comparison).markdown().contains("Stages of the builds"));
    assert!(!Report::new(&comparison).html(&BTreeMap::new()).contains("Stages of the builds"));
}

#[test]
fn csv_has_every_figure_of_the_json() {
    for comparison in [sample::full(), sample::partial()] {
        let text = Report::new(&comparison).csv();
        let mut lines = text.lines();
        let heads: Vec<&str> = lines.next().unwrap().split(',').collect();
        let rows: Vec<HashMap<&str, &str>> =
            lines.map(|line| heads.iter().copied().zip(line.split(',')).collect()).collect();
        let mut rows = rows.iter();
        for scene in derived(&comparison)["scenes"].as_array().unwrap() {
            for structure in scene["structures"].as_array().unwrap() {
                let classes = structure["classes"].as_array().unwrap();
                let of_scene = comparison.scenes.iter().find(|own| scene["scene"] == own.name);
                let record = of_scene.unwrap().structure(structure["structure"].as_str().unwrap());
                let memory = record.unwrap().memory.as_ref();
                let primitive_bytes = memory.map(|memory| memory.primitive_bytes.to_string());
                if classes.is_empty() {
                    let row = rows.next().unwrap();
                    assert!(row["class"].is_empty() && row["ns_per_ray"].is_empty());
                    assert!(matches!(row["status"], "too_slow" | "failed"));
                }
                for class in classes {
                    let row = rows.next().unwrap();
                    assert_eq!(row["scene"], scene["scene"]);
                    assert_eq!(row["structure"], structure["structure"]);
                    assert_eq!(row["class"], class["class"]);
                    csv_estimate(row, "ns_per_ray", &class["ns_per_ray"]);
                    csv_estimate(row, "million_rays_per_second", &class["million_rays_per_second"]);
                    csv_estimate(row, "speedup", &class["speedup"]);
                    csv_estimate(row, "picture_ns", &structure["picture_ns"]);
                    same(row["boxes_per_ray"], &class["boxes_per_ray"]);
                    assert_eq!(row["primitive_bytes"], primitive_bytes.as_deref().unwrap_or(""));
                    same(row["rounds"], &class["ns_per_ray"]["rounds"]);
                    for name in ["bytes_per_triangle", "total_bytes_per_triangle"] {
                        same(row[name], &structure[name]);
                    }
                    for name in
                        ["instructions_per_cycle", "branch_misses_per_ray", "cache_misses_per_ray"]
                    {
                        same(row[name], &class[name]["value"]);
                    }
                    same(row["build_all_threads_ns"], &structure["build_all_threads_ns"]["value"]);
                }
            }
        }
        assert!(rows.next().is_none());
    }
}

pub(crate) fn csv_estimate(row: &HashMap<&str, &str>, name: &str, estimate: &Value) {
    same(row[name], &estimate["value"]);
    same(row[format!("{name}_low").as_str()], &estimate["interval"]["low"]);
    same(row[format!("{name}_high").as_str()], &estimate["interval"]["high"]);
}

/// The same number to the last bit; empty where the JSON has none.
pub(crate) fn same(text: &str, value: &Value) {
    assert_eq!(text.parse::<f64>().ok(), value.as_f64(), "{text} for {value}");
}
