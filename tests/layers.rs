//! Layers import downwards only: every `crate::` path in `src/` is held to the table below, and the
//! table of `ARCHITECTURE.md` to the same.

#![allow(clippy::unwrap_used, reason = "a panic is a failed test")]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// What each layer may import. Everything is allowed to `cli` alone.
const LAYERS: &[(&str, &[&str])] = &[
    ("accel", &["counters", "math"]),
    ("assets", &["description", "math"]),
    (
        "cli",
        &[
            "accel",
            "assets",
            "compare",
            "counters",
            "description",
            "image_io",
            "math",
            "record",
            "render",
            "report",
            "scene",
            "scene_file",
        ],
    ),
    (
        "compare",
        &[
            "accel",
            "assets",
            "counters",
            "description",
            "image_io",
            "math",
            "record",
            "render",
            "scene",
        ],
    ),
    ("counters", &[]),
    ("description", &["math"]),
    ("image_io", &["math"]),
    ("math", &[]),
    ("record", &["math"]),
    ("report", &["record"]),
    ("render", &["accel", "counters", "description", "image_io", "math", "scene"]),
    ("scene", &["accel", "assets", "counters", "description", "math", "shapes"]),
    ("scene_file", &["description", "math"]),
    ("shapes", &["accel", "counters", "math", "simd"]),
    ("simd", &["math"]),
];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn allowed() -> BTreeMap<String, BTreeSet<String>> {
    let set = |names: &[&str]| names.iter().map(|&name| name.to_owned()).collect();
    LAYERS.iter().map(|&(layer, imports)| (layer.to_owned(), set(imports))).collect()
}

#[test]
fn every_path_keeps_to_the_table() {
    let allowed = allowed();
    let mut wrong = Vec::new();
    for file in sources(&root().join("src")) {
        let layer = layer_of(&file);
        let text = without_comments(&fs::read_to_string(&file).unwrap());
        for import in imports(&text).into_iter().filter(|import| *import != layer) {
            // The crate's root declares the layers and belongs to none.
            let fine = matches!(layer.as_str(), "lib" | "main")
                || allowed
                    .get(&layer)
                    .unwrap_or_else(|| panic!("`{layer}` is not in the table"))
                    .contains(&import);
            if !fine {
                wrong.push(format!("{}: `{layer}` may not import `{import}`", file.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_table_has_no_ring() {
    // Taking away what imports nothing that is left must leave nothing.
    let mut left = allowed();
    while let Some(lowest) = left
        .iter()
        .find(|(_, needs)| needs.iter().all(|n| !left.contains_key(n)))
        .map(|(l, _)| l.clone())
    {
        left.remove(&lowest);
    }
    assert!(left.is_empty(), "these import each other: {:?}", left.keys());
}

/// A row is ``| `layer/` | what it may import, with commas |`` and any further cells; `nothing` and
/// `everything` are understood.
#[test]
fn the_document_has_the_same_table() {
    let Ok(document) = fs::read_to_string(root().join("ARCHITECTURE.md")) else {
        return;
    };
    let allowed = allowed();
    let documented: BTreeMap<_, _> = document
        .lines()
        .filter_map(row)
        .flatten()
        .filter(|(l, _)| allowed.contains_key(l))
        .collect();
    for (layer, imports) in &allowed {
        let found = documented.get(layer).unwrap_or_else(|| panic!("no row for `{layer}`"));
        let everything = found.contains("everything") && layer == "cli";
        assert!(everything || found == imports, "`{layer}`: {found:?}, not {imports:?}");
    }
}

/// The layers of a row of a table, each with the names in the second cell.
fn row(line: &str) -> Option<Vec<(String, BTreeSet<String>)>> {
    let mut cells = line.strip_prefix('|')?.split('|').map(str::trim);
    let (layers, imports) = (cells.next()?, cells.next()?);
    let name = |text: &str| {
        let text = text.trim().trim_matches('`');
        text.trim_end_matches('/').trim_end_matches(".rs").to_owned()
    };
    let imports: BTreeSet<String> =
        imports.split(',').map(name).filter(|n| !n.is_empty() && n != "nothing").collect();
    Some(layers.split(',').map(|layer| (name(layer), imports.clone())).collect())
}

fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(sources(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files
}

/// `src/render/tiles.rs` and `src/render.rs` are of the layer `render`.
fn layer_of(file: &Path) -> String {
    let inside = file.strip_prefix(root().join("src")).unwrap();
    let first = Path::new(inside.iter().next().unwrap());
    first.file_stem().unwrap().to_str().unwrap().to_owned()
}

/// Links in documentation may lead anywhere.
fn without_comments(text: &str) -> String {
    let code = |line: &str| line.split("//").next().unwrap_or_default().to_owned();
    text.lines().map(code).collect::<Vec<_>>().join("\n")
}

/// The modules that `crate::name` and `crate::{one, two::{…}}` name.
fn imports(code: &str) -> Vec<String> {
    let is_name = |c: char| c.is_alphanumeric() || c == '_';
    let first_name = |text: &str| text.trim().split(|c| !is_name(c)).next().unwrap().to_owned();
    let mut found = Vec::new();
    for rest in code.split("crate::").skip(1) {
        match rest.strip_prefix('{') {
            None => found.push(first_name(rest)),
            Some(list) => found.extend(entries(list).iter().map(|entry| first_name(entry))),
        }
    }
    found
}

/// The entries of a list in braces, whose opening one is gone: split at the commas of its level.
fn entries(list: &str) -> Vec<String> {
    let (mut depth, mut entries) = (0, vec![String::new()]);
    for c in list.chars() {
        match c {
            '}' if depth == 0 => break,
            ',' if depth == 0 => entries.push(String::new()),
            _ => {
                depth += i32::from(c == '{') - i32::from(c == '}');
                entries.last_mut().unwrap().push(c);
            }
        }
    }
    entries.retain(|entry| !entry.trim().is_empty());
    entries
}

#[test]
fn paths_are_found_in_all_their_forms() {
    let code = "use crate::math::Ray;\nuse crate::{\n    accel::{A, B},\n    shapes,\n};\nlet x = crate::simd::x();";
    assert_eq!(imports(code), ["math", "accel", "shapes", "simd"]);
    assert_eq!(imports(&without_comments("/// [`x`](crate::cli::x)\nlet a; // crate::b")), [""; 0]);
    let parsed = row("| `counters.rs`, `math/` | nothing | lowest |").unwrap();
    assert_eq!(parsed[1], ("math".to_owned(), BTreeSet::new()));
    assert_eq!(parsed[0].0, "counters");
}
