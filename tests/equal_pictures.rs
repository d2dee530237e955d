//! Every scene in `scenes/` gives the same picture, to the bit, with every structure and with one
//! and two threads.

mod common;

use std::fs;

use srt::image_io::{Picture, compare};
use srt::render::{Image, Settings};
use srt::scene::{STRUCTURES, Scene, Structure};

use common::{compiled, in_project, load, on_threads, rendered, scene_paths, stem};

/// From so many objects and triangles on, a scene is given fewer pixels, for the sake of those that test all of them.
const MANY: u64 = 500;

/// The structure whose pictures all others are compared with: a quick one.
const REFERENCE: &str = "bvh";

/// From so many on, `none` and `ball`, which find no object by its box, would take hours.
const TOO_MANY_TRIANGLES: u64 = 10_000_000;

fn has_many(scene: &Scene) -> bool {
    scene.objects.len() as u64 + scene.triangle_count() >= MANY
}

fn settings(scene: &Scene) -> Settings {
    let (width, height, aa) = if has_many(scene) { (32, 24, 1) } else { (64, 48, 2) };
    Settings { width, height, aa, ..Settings::of_scene(scene) }
}

fn picture(scene: &Scene, structure: &str, threads: usize) -> Picture {
    match on_threads(threads, || rendered(scene, structure, &settings(scene))) {
        Image::Color(picture) => picture,
        Image::Scalar { .. } => panic!("not a picture"),
    }
}

#[test]
fn structures_and_threads_never_change_a_picture() {
    for path in scene_paths() {
        let scene = load(&path);
        let without = if scene.triangle_count() < TOO_MANY_TRIANGLES { 0 } else { 2 };
        assert_equal(&stem(&path), &scene, &STRUCTURES[without..]);
    }
}

#[test]
fn of_the_million_objects_a_thousand_are_equal_with_all_structures() {
    let path = in_project("scenes/million.sce");
    let text = fs::read_to_string(&path).expect("the scene can be read");
    // As large a cone of fewer and larger knots.
    let few = text
        .replace("repeat 200000", "repeat 200")
        .replace("1.0000036 1.0000036 1.0000036", "1.0036 1.0036 1.0036")
        .replace("scale .0023 .0023 .0023", "scale .06 .06 .06");
    let scene = compiled(&few, "million.sce", path.parent().expect("a file is in a folder"));
    assert_eq!(scene.objects.len(), 1001);
    assert_equal("a thousand", &scene, STRUCTURES);
}

/// Compares all structures, with one and two threads, with one of them.
fn assert_equal(name: &str, scene: &Scene, structures: &[Structure]) {
    let expected = picture(scene, REFERENCE, 2);
    for structure in structures {
        // One thread and two differ in nothing that depends on the number of triangles.
        let slow = structure.name == "none" && has_many(scene);
        for threads in if slow { 2..3 } else { 1..3 } {
            let got = picture(scene, structure.name, threads);
            let difference = compare(&expected, &got).expect("sizes are equal");
            assert!(
                difference.differing == 0,
                "{name} with {} on {threads} threads: {difference:?}",
                structure.name,
            );
        }
    }
}
