//! Record → text for a terminal: an aligned table for each scene, and the verdict.

use std::fmt::Write;

use super::Report;
use super::numbers::{self, NOTHING};
use super::sampling_verdict::sampling_verdict;
use super::tables;
use super::verdict::verdict;
use crate::analysis::baseline::{improvements, regressions};
use crate::analysis::{SceneFigures, StructureFigures};
use crate::record::{Baseline, Estimate, RayClass, SceneRecord, Status};

/// Million rays per second by class, build, memory and time to the picture of each structure; then the verdicts.
pub(super) fn write(report: &Report<'_>) -> String {
    let Report { comparison, analysis, .. } = report;
    let mut text = String::new();
    for (scene, figures) in comparison.scenes.iter().zip(&analysis.scenes) {
        let triangles = numbers::count(scene.triangles);
        let _ = writeln!(text, "{} ({triangles} triangles), million rays per second", scene.name);
        text += &aligned(&scene_rows(scene, figures));
        text.push('\n');
    }
    text += &verdict(report);
    text.push('\n');
    if let Some(verdict) = sampling_verdict(report) {
        text += &verdict;
        text.push('\n');
    }
    text
}

/// What changed against a baseline: warnings, each change with its interval, then the doubts.
pub(super) fn write_changes(baseline: &Baseline) -> String {
    let Baseline { threshold, outcome: changes } = baseline;
    let warnings: String =
        changes.warnings.iter().map(|warning| format!("WARNING: {warning}\n")).collect();
    let mut text = String::new();
    for (word, list) in [
        ("slower", regressions(baseline).collect::<Vec<_>>()),
        ("faster", improvements(baseline).collect()),
    ] {
        for change in list {
            let (times, spread) =
                (numbers::median(change.slowdown), numbers::spread(change.slowdown));
            let _ = writeln!(
                text,
                "{word}: {} rays of {} with {} take {times} × the baseline's time (95 % {})",
                change.class.name(),
                change.scene,
                change.structure,
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
        let _ = writeln!(text, "note: {doubt}");
    }
    warnings + &text
}

fn scene_rows(scene: &SceneRecord, figures: &SceneFigures) -> Vec<Vec<String>> {
    let classes = figures.classes();
    let mut head = vec!["structure".to_owned()];
    head.extend(classes.iter().map(|class| class.name().to_owned()));
    head.extend(["× base", "build", "memory", "picture", "proof"].map(str::to_owned));
    let rows = scene.structures.iter().zip(&figures.structures).map(|(record, own)| {
        let memory = record.memory.as_ref().map(|memory| numbers::bytes(memory.index_bytes));
        let time = |ns: Option<Estimate>| or_dash(ns.map(|ns| numbers::time(ns.median)));
        let mut row = vec![record.name.clone()];
        row.extend(classes.iter().map(|&class| rate(own, class)));
        row.push(or_dash(classes.first().and_then(|&class| speedup(own, class))));
        row.push(time(own.build_all_threads_ns));
        row.push(or_dash(memory));
        row.push(time(own.picture_ns));
        row.push(remark(scene, &record.name, &record.status));
        row
    });
    std::iter::once(head).chain(rows).collect()
}

fn rate(own: &StructureFigures, class: RayClass) -> String {
    let rate = own.class(class).and_then(|class| class.million_rays_per_second);
    or_dash(rate.map(numbers::median))
}

fn speedup(own: &StructureFigures, class: RayClass) -> Option<String> {
    own.class(class)?.speedup.map(numbers::median)
}

/// Whether the results are equal, or what went wrong.
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
        (Status::Ok, Some(entry)) if entry.picture_equal == Some(true) => "equal".to_owned(),
        (Status::Ok, Some(entry)) if entry.rays_checked > 0 => "hits equal".to_owned(),
        (Status::Ok, _) => peer.map_or_else(|| NOTHING.to_owned(), tables::agreement),
    }
}

fn or_dash(text: Option<String>) -> String {
    text.unwrap_or_else(|| NOTHING.to_owned())
}

/// Columns as wide as their widest cell. The first and the last are aligned left, the others right.
fn aligned(rows: &[Vec<String>]) -> String {
    let columns = rows.first().map_or(0, Vec::len);
    let width = |column: usize| {
        rows.iter().map(|row| row[column].chars().count()).max().unwrap_or_default()
    };
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let mut text = String::new();
    for row in rows {
        let mut line = String::from(" ");
        for (column, (cell, &width)) in row.iter().zip(&widths).enumerate() {
            let _ = match column {
                0 => write!(line, " {cell:<width$}"),
                _ if column + 1 == columns => write!(line, "  {cell}"),
                _ => write!(line, "  {cell:>width$}"),
            };
        }
        text += line.trim_end();
        text.push('\n');
    }
    text
}
