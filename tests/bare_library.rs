//! The library by itself, built with `default-features = false`: few dependencies, and layers that
//! need no other. Reads `Cargo.toml` and `src/lib.rs`; builds nothing.

#![allow(clippy::unwrap_used, reason = "a panic is a failed test")]

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// The most direct dependencies that the library by itself may have.
const MOST: usize = 8;

/// The layers that it consists of.
const LAYERS: [&str; 7] =
    ["accel", "conformance", "counters", "math", "parallel", "shapes", "simd"];

fn text(path: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(path)).unwrap()
}

#[test]
fn it_has_few_direct_dependencies() {
    let needed = needed_dependencies(&text("Cargo.toml"));
    assert!(needed.contains("glam"), "glam is in every interface: {needed:?}");
    assert!(needed.len() <= MOST, "more than {MOST}: {needed:?}");
}

#[test]
fn it_has_no_build_dependencies() {
    let manifest = text("Cargo.toml");
    let needed = entries_of(&manifest, |section| section.ends_with("build-dependencies"));
    let needed: Vec<_> = needed.into_iter().filter(|(_, value)| !is_optional(value)).collect();
    assert!(needed.is_empty(), "{needed:?}");
}

#[test]
fn it_consists_of_its_layers() {
    assert_eq!(unconditional_modules(&text("src/lib.rs")), BTreeSet::from(LAYERS));
}

/// Rows of the table of layers; `tests/layers.rs` holds the code to them.
#[test]
fn its_layers_need_no_other() {
    let table = text("ARCHITECTURE.md");
    for layer in LAYERS {
        let row = table.lines().find_map(|line| line.strip_prefix(&format!("| `{layer}` | ")));
        let imports = row.unwrap().split('|').next().unwrap();
        for import in imports.split(',').map(str::trim).filter(|import| *import != "nothing") {
            assert!(LAYERS.contains(&import), "`{layer}` may import `{import}`");
        }
    }
}

/// The dependencies of any platform that are not optional.
fn needed_dependencies(manifest: &str) -> BTreeSet<String> {
    let is_normal =
        |section: &str| section == "dependencies" || section.ends_with("'.dependencies");
    let entries = entries_of(manifest, is_normal);
    entries.into_iter().filter(|(_, value)| !is_optional(value)).map(|(name, _)| name).collect()
}

fn is_optional(value: &str) -> bool {
    value.contains("optional = true")
}

/// Names and values in some sections of a manifest, each in a line.
fn entries_of(manifest: &str, is_wanted: impl Fn(&str) -> bool) -> Vec<(String, String)> {
    let (mut entries, mut wanted) = (Vec::new(), false);
    for line in manifest.lines().map(str::trim) {
        if let Some(section) = line.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
            wanted = is_wanted(section);
            // Another form of the same: `[dependencies.glam]`.
            assert!(!section.contains("dependencies."), "an entry in a section of its own: {line}");
        } else if wanted && !line.is_empty() && !line.starts_with('#') {
            let (name, value) = line.split_once(" = ").expect("an entry in each line");
            let whole = value.matches('{').count() == value.matches('}').count();
            assert!(whole, "an entry of several lines: {line}");
            entries.push((name.to_owned(), value.to_owned()));
        }
    }
    entries
}

/// The modules of a root file whose declarations no `cfg` stands before.
fn unconditional_modules(root: &str) -> BTreeSet<&str> {
    let lines: Vec<_> = root.lines().collect();
    let pairs = lines.windows(2).filter(|pair| !pair[0].starts_with("#[cfg("));
    let modules = pairs.map(|pair| pair[1].trim_start_matches("pub "));
    modules.filter_map(|module| module.strip_prefix("mod ")?.strip_suffix(';')).collect()
}

#[test]
fn manifests_are_read_as_they_are_written() {
    let manifest = "\
[features]
default = [
    \"dep:clap\",
]

[dependencies]
# A remark.
glam = \"0.34\"
obvhs = { version = \"0.4\", features = [\"parallel\"] }
clap = { version = \"4\", optional = true }

[target.'cfg(unix)'.dependencies]
rustix = { version = \"1\", default-features = false }

[dev-dependencies]
insta = \"1\"

[build-dependencies]
sha2 = \"0.10\"
";
    let names = ["glam", "obvhs", "rustix"].map(str::to_owned);
    assert_eq!(needed_dependencies(manifest), BTreeSet::from(names));
    let root = "pub mod a;\n#[cfg(feature = \"x\")]\npub mod b;\npub use c;\npub mod d;\n";
    assert_eq!(unconditional_modules(&format!("\n{root}")), BTreeSet::from(["a", "d"]));
}
