//! Record → Markdown: verdict, proof and tables, for places that do not show HTML.

use std::fmt::Write;

use super::Report;
use super::limits::{limits, weaknesses};
use super::numbers;
use super::sampling_verdict::sampling_verdict;
use super::tables::{self, Cell, Table};
use super::verdict::verdict;
use crate::analysis::SceneFigures;
use crate::record::{Comparison, SceneRecord};

/// Writes the report. Pictures are linked as the files that the record names.
pub(super) fn write(report: &Report<'_>) -> String {
    let Report { comparison, analysis, .. } = report;
    let mut text = format!("# srt compares\n\n{}\n", escaped(&verdict(report)));
    if let Some(weaknesses) = weaknesses(report) {
        let _ = write!(text, "\n{}\n", escaped(&weaknesses));
    }
    if comparison.run.partial {
        text += "\n**Partial: the comparison was stopped before its plan was done.**\n";
    }
    add_conformance(comparison, &mut text);
    add_table(&tables::overall_table(report), &mut text);
    add_baseline(comparison, &mut text);
    add_table(&tables::proof_matrix(comparison), &mut text);
    for (scene, figures) in comparison.scenes.iter().zip(&analysis.scenes) {
        add_scene(scene, figures, comparison.run.options.threads, &mut text);
    }
    for (sweep, figures) in comparison.sweeps.iter().zip(&analysis.sweeps) {
        let _ = write!(text, "\n## Growth: {}\n", escaped(&sweep.mesh));
        tables::growth_tables(sweep, figures).iter().for_each(|table| add_table(table, &mut text));
    }
    if let Some(chapter) = &comparison.sampling {
        let default = escaped(&chapter.default);
        let _ = write!(text, "\n## Sampling\n\n");
        if let Some(verdict) = sampling_verdict(report) {
            let _ = write!(text, "{} ", escaped(&verdict));
        }
        let _ = writeln!(text, "The default is {default}.");
        tables::sampling_tables(chapter, analysis)
            .iter()
            .for_each(|table| add_table(table, &mut text));
    }
    add_run(comparison, &mut text);
    text += "\n## Limits and bias\n\n";
    for limit in limits(report) {
        let _ = writeln!(text, "* {}", escaped(&limit));
    }
    text
}

fn add_conformance(comparison: &Comparison, text: &mut String) {
    add_table(&tables::conformance_table(comparison), text);
    for own in &comparison.conformance {
        if let Some(fault) = own.fault() {
            let (structure, fault) = (escaped(&own.structure), escaped(&fault));
            let _ = write!(text, "\n{structure} does not conform: {fault}\n");
        }
    }
}

fn add_baseline(comparison: &Comparison, text: &mut String) {
    let Some(baseline) = &comparison.baseline else { return };
    let table = tables::baseline_table(baseline);
    for warning in &baseline.outcome.warnings {
        let _ = write!(text, "\n**Warning: {}**\n", escaped(warning));
    }
    if table.rows.is_empty() {
        let _ = write!(text, "\n### {}\n\n{}\n", escaped(&table.title), escaped(&table.note));
    }
    add_table(&table, text);
}

fn add_scene(scene: &SceneRecord, figures: &SceneFigures, threads: u32, text: &mut String) {
    let name = escaped(&scene.name);
    let _ = write!(
        text,
        "\n## {name}\n\n{}, {}, {}; {}, SHA-256 {}\n",
        numbers::things(scene.objects, "object"),
        numbers::things(scene.triangles, "triangle"),
        numbers::things(scene.lights, "light"),
        code(&scene.path),
        code(&scene.hash)
    );
    if let Some(rays) = &scene.rays {
        let (words, hash, geometry) =
            (tables::rays_in_words(rays), code(&rays.hash), code(&rays.geometry));
        let _ = write!(text, "\n{words} SHA-256 {hash}, for geometry with SHA-256 {geometry}\n");
    }
    if let Some(picture) = &scene.picture {
        let _ = write!(text, "\n![{name}]({})\n", address(&picture.file));
        let _ = write!(text, "\nPixels: SHA-256 {}\n", code(&picture.hash));
    }
    if let Some(proof) = &scene.proof {
        add_table(&tables::proof_table(proof), text);
        for entry in &proof.structures {
            if let Some(difference) = &entry.first_difference {
                let (structure, difference) = (escaped(&entry.structure), escaped(difference));
                let _ = write!(text, "\nFirst difference of {structure}: {difference}\n");
            }
        }
    }
    add_table(&tables::ray_table(scene, figures), text);
    add_table(&tables::hardware_table(scene, figures), text);
    add_table(&tables::structure_table(scene, figures), text);
    add_table(&tables::stage_table(scene, threads), text);
    add_table(&tables::picture_table(scene, figures), text);
}

fn add_run(comparison: &Comparison, text: &mut String) {
    let command = &comparison.run.command;
    let fence = "`".repeat(longest_backticks(command).max(2) + 1);
    let _ = write!(text, "\n## How it was measured\n\n{fence}sh\n{command}\n{fence}\n\n");
    text.push_str("| | |\n|---|---|\n");
    for (name, value) in tables::facts(comparison) {
        let _ = writeln!(text, "| {name} | {} |", escaped(&value));
    }
}

/// A table under its title; nothing without rows.
fn add_table(table: &Table, text: &mut String) {
    if table.rows.is_empty() {
        return;
    }
    let _ = write!(text, "\n### {}\n\n", escaped(&table.title));
    if !table.note.is_empty() {
        let _ = write!(text, "{}\n\n", escaped(&table.note));
    }
    text.push_str(&table_lines(table));
}

/// The heading line and the lines of a table, without its title and its note.
#[must_use]
pub fn table_lines(table: &Table) -> String {
    let mut text = String::new();
    let heads: Vec<String> = table.columns.iter().map(|column| escaped(&column.head)).collect();
    let rules: Vec<&str> =
        table.columns.iter().map(|column| if column.numeric { "--:" } else { "---" }).collect();
    let _ = writeln!(text, "| {} |\n|{}|", heads.join(" | "), rules.join("|"));
    for row in &table.rows {
        let cells: Vec<String> = row.iter().map(cell).collect();
        let _ = writeln!(text, "| {} |", cells.join(" | "));
    }
    text
}

fn cell(cell: &Cell) -> String {
    let text = escaped(&cell.text);
    match &cell.spread {
        Some(spread) => format!("{text} ({spread})"),
        None => text,
    }
}

/// Text without Markdown or HTML markup: a record may come from anybody.
fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '\\' | '`' | '*' | '_' | '[' | ']' | '|' | '#' | '~' => escaped.extend(['\\', c]),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '&' => escaped.push_str("&amp;"),
            '\n' | '\r' => escaped.push(' '),
            _ => escaped.push(c),
        }
    }
    escaped
}

/// Text between backticks: more of them than it has in a row, on one line. Nothing in it is markup.
fn code(text: &str) -> String {
    let fence = "`".repeat(longest_backticks(text) + 1);
    let text = text.replace(char::is_control, " ");
    // A backtick at an end would belong to the fence, and nothing between fences would be text.
    let space =
        if text.is_empty() || text.starts_with('`') || text.ends_with('`') { " " } else { "" };
    format!("{fence}{space}{text}{space}{fence}")
}

/// The most backticks that follow each other.
fn longest_backticks(text: &str) -> usize {
    text.split(|c| c != '`').map(str::len).max().unwrap_or(0)
}

/// A file's name as the address of a link: all that could end it, or name a protocol, is percent-encoded.
fn address(file: &str) -> String {
    let mut address = String::with_capacity(file.len());
    for byte in file.bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'_' | b'.' | b'~' | b'/' => {
                address.push(char::from(byte));
            }
            // Writing to a string cannot fail.
            _ => drop(write!(address, "%{byte:02X}")),
        }
    }
    address
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markup_becomes_text() {
        assert_eq!(escaped("<b>&|`~[a](b)\n# c"), "&lt;b&gt;&amp;\\|\\`\\~\\[a\\](b) \\# c");
    }

    #[test]
    fn code_does_not_end_before_its_end() {
        assert_eq!(code("a.sce"), "`a.sce`");
        assert_eq!(code("a`<b>``\n\nc"), "```a`<b>``  c```");
        assert_eq!(code("`"), "`` ` ``");
        assert_eq!(code(""), "`  `");
    }

    #[test]
    fn an_address_names_a_file_alone() {
        assert_eq!(address("heat/hall-2.png"), "heat/hall-2.png");
        assert_eq!(address("javascript:a) <b>é"), "javascript%3Aa%29%20%3Cb%3E%C3%A9");
    }
}
