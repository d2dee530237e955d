//! Prose wraps at 120 columns: every Markdown file and every comment of the project.
//!
//! Exempt is what cannot wrap: rows of tables, code, headings, and lines whose words are one long link
//! or path. What a run of the program has written, in `results/`, is its own.

#![allow(clippy::unwrap_used, reason = "a panic is a failed test")]

use std::fs;
use std::path::{Path, PathBuf};

const COLUMNS: usize = 120;

/// Folders whose files were written by a program, or are not the project's.
const SKIPPED: [&str; 4] = ["target", "results", ".git", "snapshots"];

/// All files below a folder.
fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let kept = |path: &PathBuf| !SKIPPED.iter().any(|name| path.ends_with(name));
    let below = |path: PathBuf| if path.is_dir() { files(&path) } else { vec![path] };
    entries.filter(kept).flat_map(below).collect()
}

fn with_extension(extension: &str) -> Vec<PathBuf> {
    let all = files(Path::new(env!("CARGO_MANIFEST_DIR")));
    all.into_iter().filter(|path| path.extension().is_some_and(|e| e == extension)).collect()
}

/// The numbers of the lines of Markdown that are too long and could be wrapped.
fn long_lines_of_markdown(text: &str) -> Vec<usize> {
    let mut is_code = false;
    let mut long = Vec::new();
    for (number, line) in (1..).zip(text.lines()) {
        let start = line.trim_start();
        is_code ^= start.starts_with("```");
        let cannot_wrap = is_code || start.starts_with(['|', '#', '<']) || start.starts_with("[!");
        if !cannot_wrap && is_long(line) {
            long.push(number);
        }
    }
    long
}

/// The numbers of the lines of Rust whose comment is too long.
fn long_comments(text: &str) -> Vec<usize> {
    let is_comment = |line: &str| line.trim_start().starts_with("//");
    let lines = (1..).zip(text.lines());
    lines.filter(|(_, line)| is_comment(line) && is_long(line)).map(|(number, _)| number).collect()
}

/// Whether a line is too long and has a space at which it could end earlier.
fn is_long(line: &str) -> bool {
    let indent = line.chars().take_while(|c| !c.is_alphanumeric()).count();
    let has_break = line.chars().skip(indent).take(COLUMNS - indent.min(COLUMNS)).any(|c| c == ' ');
    line.chars().count() > COLUMNS && has_break
}

#[test]
fn markdown_wraps() {
    let pages = with_extension("md");
    assert!(pages.len() > 5, "{pages:?}");
    check(&pages, long_lines_of_markdown);
}

#[test]
fn comments_wrap() {
    let sources = with_extension("rs");
    assert!(sources.len() > 100, "{}", sources.len());
    check(&sources, long_comments);
}

fn check(paths: &[PathBuf], long: fn(&str) -> Vec<usize>) {
    let found: Vec<String> = paths
        .iter()
        .flat_map(|path| {
            let lines = long(&fs::read_to_string(path).unwrap());
            lines.into_iter().map(move |line| format!("{}:{line}", path.display()))
        })
        .collect();
    assert!(found.is_empty(), "beyond {COLUMNS} columns:\n{}", found.join("\n"));
}

#[test]
fn what_is_too_long_is_found() {
    let word = "word ".repeat(30);
    assert_eq!(long_lines_of_markdown(&format!("short\n\n- {word}\n")), [3]);
    assert_eq!(long_lines_of_markdown(&format!("| {word} |\n```\n{word}\n```\n")), [0usize; 0]);
    assert_eq!(long_lines_of_markdown(&format!("- [{}](x)", "a".repeat(130))), [0usize; 0]);
    assert_eq!(long_comments(&format!("let x = 1;\n    // {word}\n")), [2]);
    assert_eq!(long_comments(&format!("let x = \"{word}\";\n")), [0usize; 0]);
}
