//! Layers import downwards only: every `crate::` path in `src/` is held to the table of
//! `ARCHITECTURE.md`, which has a row for each layer and for nothing else.

#![allow(clippy::unwrap_used, reason = "a panic is a failed test")]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// The files of the crate's roots, which are no layers.
const ROOTS: [&str; 2] = ["lib", "main"];

/// How the table begins.
const HEAD: &str = "| layer | may import |";

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// What each layer may import, as `ARCHITECTURE.md` has it.
fn allowed() -> BTreeMap<String, BTreeSet<String>> {
    let document = fs::read_to_string(root().join("ARCHITECTURE.md")).unwrap();
    table(&document).unwrap_or_else(|error| panic!("ARCHITECTURE.md: {error}"))
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
            let is_root = ROOTS.contains(&layer.as_str());
            if !is_root && !allowed.get(&layer).is_some_and(|names| names.contains(&import)) {
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

#[test]
fn every_layer_has_its_row_and_every_row_its_layer() {
    let entries = fs::read_dir(root().join("src")).unwrap().map(|entry| entry.unwrap().path());
    let layers: BTreeSet<_> = entries.map(|path| layer_of(&path)).collect();
    let layers: BTreeSet<_> =
        layers.into_iter().filter(|layer| !ROOTS.contains(&layer.as_str())).collect();
    assert_eq!(allowed().into_keys().collect::<BTreeSet<_>>(), layers);
}

/// The table of layers: its head, a line of dashes, and rows up to the first line that is none.
fn table(document: &str) -> Result<BTreeMap<String, BTreeSet<String>>, String> {
    let mut lines = document.lines().skip_while(|line| !line.starts_with(HEAD)).skip(1);
    if !lines.next().is_some_and(|line| line.starts_with("|---|")) {
        return Err(format!("no table that begins with `{HEAD}`"));
    }
    let mut rows = BTreeMap::new();
    for line in lines.take_while(|line| line.starts_with('|')) {
        let (layer, imports) = row(line).ok_or_else(|| format!("not a row: {line}"))?;
        if rows.insert(layer, imports).is_some() {
            return Err(format!("a second row for the same layer: {line}"));
        }
    }
    let all: BTreeSet<String> = rows.keys().cloned().collect();
    for (layer, imports) in &mut rows {
        if imports.remove("everything") {
            imports.extend(all.iter().filter(|other| *other != layer).cloned());
        }
        if let Some(unknown) = imports.iter().find(|import| !all.contains(*import)) {
            return Err(format!("`{layer}` may import `{unknown}`, which has no row"));
        }
    }
    Ok(rows)
}

/// A row: ``| `layer` | what it may import, with commas | what it is |``. `nothing` stands alone, and
/// so does `everything`, for all other layers.
fn row(line: &str) -> Option<(String, BTreeSet<String>)> {
    let cells: Vec<_> = line.strip_prefix('|')?.strip_suffix('|')?.split('|').collect();
    let [layer, imports, _] = cells[..] else { return None };
    let layer = layer.trim().strip_prefix('`')?.strip_suffix('`')?;
    let names: Vec<_> = imports.split(',').map(str::trim).collect();
    let is_name =
        |name: &str| !name.is_empty() && name.chars().all(|c| c.is_ascii_lowercase() || c == '_');
    let stands_alone = |name: &&str| matches!(*name, "nothing" | "everything");
    let fine = is_name(layer)
        && names.iter().all(|name| is_name(name))
        && (names.len() == 1 || !names.iter().any(stands_alone));
    let imports = names.into_iter().filter(|name| *name != "nothing").map(str::to_owned);
    fine.then(|| (layer.to_owned(), imports.collect()))
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
}

#[test]
fn a_table_is_read_as_it_is_written_or_not_at_all() {
    let table =
        |rows: &str| table(&format!("# A\n| x |\n\n{HEAD} what |\n|---|---|---|\n{rows}\n\nB"));
    let set = |names: &[&str]| names.iter().map(|&name| name.to_owned()).collect::<BTreeSet<_>>();
    let lowest = "| `math` | nothing | lowest |";
    let parsed = table(&format!("| `cli` | everything | x |\n| `simd` | math | y |\n{lowest}"));
    let parsed = parsed.unwrap();
    assert_eq!(parsed["cli"], set(&["math", "simd"]));
    assert_eq!(parsed["simd"], set(&["math"]));
    assert_eq!(parsed["math"], set(&[]));
    for bad in [
        "| math | nothing | no backticks |",
        "| `math/` | nothing | a slash |",
        "| `math` | nothing |",
        "| `math` | | empty |",
        "| `math` | simd | no row |",
        "| `math` | nothing, everything | both |",
        "| `math` | nothing | a | b |",
        "| `math` | nothing | twice |\n| `math` | nothing | twice |",
    ] {
        assert!(table(bad).is_err(), "{bad}");
    }
    assert!(self::table("no table").is_err());
}
