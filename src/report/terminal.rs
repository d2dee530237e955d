//! Record → text for a terminal: an aligned table for each scene and sweep, and the verdict.
//!
//! A record may come from anybody: control characters, which could control the terminal, are shown as replacement
//! characters.

use std::fmt::Write;

use super::Report;
use super::limits::weaknesses;
use super::numbers::{self, NOTHING};
use super::sampling_verdict::sampling_verdict;
use super::tables::{self, Cell, Column, Table};
use super::verdict::verdict;
use crate::analysis::baseline::{improvements, regressions};
use crate::analysis::{SceneFigures, StructureFigures};
use crate::record::{Baseline, Estimate, RayClass, SceneRecord, Status};

/// Million rays per second by class, build, memory and time to the picture of each structure; growth with the number of
/// triangles; conformance; then the verdicts.
pub(super) fn write(report: &Report<'_>) -> String {
    let Report { comparison, analysis, .. } = report;
    let mut text = String::new();
    for (scene, figures) in comparison.scenes.iter().zip(&analysis.scenes) {
        let (name, triangles) = (printable(&scene.name), numbers::count(scene.triangles));
        let _ = writeln!(text, "{name} ({triangles} triangles), million rays per second");
        if let Some(rays) = &scene.rays {
            let _ = writeln!(
                text,
                "  {} SHA-256 {}",
                tables::rays_in_words(rays),
                printable(&rays.hash)
            );
        }
        for line in table_lines(&scene_table(scene, figures)).lines() {
            let _ = writeln!(text, "  {line}");
        }
        text.push('\n');
    }
    for table in analysis.sweeps.iter().flat_map(tables::size_tables) {
        let _ = writeln!(text, "{}", printable(&table.title));
        for line in table_lines(&table).lines() {
            let _ = writeln!(text, "  {line}");
        }
        text.push('\n');
    }
    let conformance = tables::conformance_table(comparison);
    if !conformance.rows.is_empty() {
        let _ = writeln!(text, "conformance of structures that are not srt's own");
        for line in table_lines(&conformance).lines() {
            let _ = writeln!(text, "  {line}");
        }
        text.push('\n');
    }
    let sentences = [Some(verdict(report)), weaknesses(report), sampling_verdict(report)];
    for sentence in sentences.into_iter().flatten() {
        text += &printable(&sentence);
        text.push('\n');
    }
    text
}

/// On one line, without control characters and those that change the direction of text.
fn printable(text: &str) -> String {
    let changes =
        |c: char| c.is_control() || matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    text.replace(changes, "\u{fffd}")
}

/// What changed against a baseline: warnings, each change with its interval, then the doubts.
pub(super) fn write_changes(baseline: &Baseline) -> String {
    let Baseline { threshold, outcome: changes } = baseline;
    let warnings: String =
        changes.warnings.iter().map(|w| format!("WARNING: {}\n", printable(w))).collect();
    let mut text = String::new();
    for (word, list) in [
        ("slower", regressions(baseline).collect::<Vec<_>>()),
        ("faster", improvements(baseline).collect()),
    ] {
        for change in list {
            let (times, spread) =
                (numbers::value(change.slowdown), numbers::spread(change.slowdown));
            let _ = writeln!(
                text,
                "{word}: {} rays of {} with {} take {times} × the baseline's time (95 % {})",
                change.class.name(),
                printable(&change.scene),
                printable(&change.structure),
                spread.unwrap_or_default(),
            );
        }
    }
    if text.is_empty() {
        let percent = numbers::percent(*threshold);
        let n = changes.changes.len();
        let _ = writeln!(
            text,
            "none of {n} measurements changed by more than {percent} at 95 % confidence"
        );
    }
    for doubt in &changes.doubts {
        let _ = writeln!(text, "note: {}", printable(doubt));
    }
    warnings + &text
}

fn scene_table(scene: &SceneRecord, figures: &SceneFigures) -> Table {
    let classes = figures.classes();
    let mut heads = vec!["structure".to_owned()];
    heads.extend(classes.iter().map(|class| format!("#{}", class.name())));
    // One class's ratio is enough for a line; the report has those of all.
    let of_class = classes.first().map_or_else(String::new, |class| format!(", {}", class.name()));
    heads.push(format!("#× base{of_class}"));
    heads.extend(["#build", "#memory", "#picture", "proof"].map(str::to_owned));
    let heads: Vec<&str> = heads.iter().map(String::as_str).collect();
    let mut table = Table::new("", "", &heads);
    let rows = scene.structures.iter().zip(&figures.structures).map(|(record, own)| {
        let memory = record.memory.as_ref().map(|memory| numbers::bytes(memory.total_bytes()));
        let time = |ns: Option<Estimate>| or_dash(ns.map(|ns| numbers::time(ns.value)));
        let mut row = vec![record.name.clone()];
        row.extend(classes.iter().map(|&class| rate(own, class)));
        row.push(or_dash(classes.first().and_then(|&class| speedup(own, class))));
        row.push(time(own.build_all_threads_ns));
        row.push(or_dash(memory));
        row.push(time(own.picture_ns));
        row.push(remark(scene, &record.name, &record.status));
        row.into_iter().map(Cell::text).collect()
    });
    table.rows = rows.collect();
    table
}

fn rate(own: &StructureFigures, class: RayClass) -> String {
    let rate = own.class(class).and_then(|class| class.million_rays_per_second);
    Cell::compared(rate).text
}

fn speedup(own: &StructureFigures, class: RayClass) -> Option<String> {
    Some(Cell::compared(Some(own.class(class)?.speedup?)).text)
}

/// In how much the results were compared, or what went wrong.
fn remark(scene: &SceneRecord, structure: &str, status: &Status) -> String {
    let proof = scene.proof.as_ref();
    let peer = proof.and_then(|proof| proof.peer(structure));
    let is_only = proof.is_some_and(|proof| proof.structures.len() + proof.peers.len() == 1);
    let proof = proof.and_then(|proof| proof.structure(structure));
    match (status, proof) {
        (Status::Failed { message }, _) => format!("failed: {message}"),
        (Status::TooSlow { .. }, _) => "too slow".to_owned(),
        (_, Some(entry)) if !entry.holds() => "DIFFERS".to_owned(),
        (Status::Stopped, _) => "stopped".to_owned(),
        (Status::Ok, Some(_)) if is_only => "reference".to_owned(),
        (Status::Ok, entry) => match entry.and_then(tables::compared_without_difference) {
            Some(compared) => format!("no difference in {compared}"),
            None => peer.map_or_else(|| NOTHING.to_owned(), tables::agreement),
        },
    }
}

fn or_dash(text: Option<String>) -> String {
    text.unwrap_or_else(|| NOTHING.to_owned())
}

/// The heading line and the lines of a table, in columns as wide as their widest cell: numbers are
/// aligned to the right, texts to the left. Spreads are left out.
pub(crate) fn table_lines(table: &Table) -> String {
    let heads = table.columns.iter().map(|column| printable(&column.head)).collect();
    let cells = |row: &Vec<Cell>| row.iter().map(|cell| printable(&cell.text)).collect();
    let rows: Vec<Vec<String>> =
        std::iter::once(heads).chain(table.rows.iter().map(cells)).collect();
    let width = |index: usize| rows.iter().map(|row| row[index].chars().count()).max();
    let widths: Vec<usize> =
        (0..table.columns.len()).map(|index| width(index).unwrap_or_default()).collect();
    let mut text = String::new();
    for row in &rows {
        let cells = row.iter().zip(&widths).zip(&table.columns);
        let cell = |((text, &width), column): ((&String, &usize), &Column)| match column.numeric {
            true => format!("{text:>width$}"),
            false => format!("{text:<width$}"),
        };
        text += cells.map(cell).collect::<Vec<_>>().join("  ").trim_end();
        text.push('\n');
    }
    text
}
