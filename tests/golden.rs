//! Every scene in `scenes/` renders to the picture that is kept of it, to the byte.
//!
//! The pictures are small ones in `tests/golden/`. After a change that is meant to change them:
//!
//! ```text
//! SRT_BLESS=1 cargo test --release --test golden
//! ```
//!
//! writes them anew, and those of new scenes; look at them before they are committed.

mod common;

use std::fs;
use std::path::Path;

use srt::image_io::{Format, Picture, compare, decode, encode};
use srt::render::Settings;

use common::{files_in, in_project, load, picture, scene_paths, stem};

const FOLDER: &str = "tests/golden";
const HINT: &str = "SRT_BLESS=1 cargo test --release --test golden";

fn small_picture(path: &Path) -> Picture {
    let scene = load(path);
    picture(&scene, &Settings { width: 96, height: 64, aa: 2, ..Settings::of_scene(&scene) })
}

/// What is wrong with the golden picture of a scene, if anything is.
fn complaint(path: &Path) -> Option<String> {
    let name = stem(path);
    let file = encode(&small_picture(path), Format::Png).expect("the picture can be written");
    let golden = in_project(FOLDER).join(format!("{name}.png"));
    if std::env::var_os("SRT_BLESS").is_some() {
        fs::write(golden, file).expect("the golden picture can be written");
        return None;
    }
    let Ok(kept) = fs::read(golden) else {
        return Some(format!("{name}: there is no {FOLDER}/{name}.png yet; make it: {HINT}"));
    };
    // Pixels are compared, not files: another release of the PNG encoder may pack them otherwise.
    let [now, kept] = [file, kept].map(|f| decode(&f, Format::Png).expect("it is a PNG file"));
    let difference = compare(&now, &kept).expect("golden pictures are 96 × 64");
    (difference.differing > 0).then(|| format!("{name}: {difference:?}; if this is meant: {HINT}"))
}

#[test]
fn every_scene_looks_as_it_did() {
    let complaints: Vec<_> = scene_paths().iter().filter_map(|path| complaint(path)).collect();
    assert!(complaints.is_empty(), "\n{}", complaints.join("\n"));
}

#[test]
fn every_golden_picture_has_a_scene() {
    let scenes: Vec<_> = scene_paths().iter().map(|path| stem(path)).collect();
    for golden in files_in(FOLDER, "png") {
        assert!(scenes.contains(&stem(&golden)), "{}: its scene is gone", golden.display());
    }
}
