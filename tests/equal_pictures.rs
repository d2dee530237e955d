//! Every scene in `scenes/` gives the same picture, to the bit, with every structure and with one
//! and two threads.

mod common;

use srt::image_io::{Picture, compare};
use srt::render::{Settings, Sight};
use srt::scene::{STRUCTURES, Scene};

use common::{load, on_threads, rendered, scene_paths, stem};

/// From so many triangles on, `none` is given fewer pixels.
const MANY_TRIANGLES: u64 = 5_000;

fn settings(scene: &Scene) -> Settings {
    let heavy = scene.triangle_count() >= MANY_TRIANGLES;
    let (width, height, aa) = if heavy { (32, 24, 1) } else { (64, 48, 2) };
    Settings { width, height, aa, ..Settings::of_scene(scene) }
}

fn picture(scene: &Scene, structure: &str, threads: usize) -> Picture {
    match on_threads(threads, || rendered(scene, structure, &settings(scene))) {
        Sight::Picture(picture) => picture,
        Sight::Field { .. } => panic!("not a picture"),
    }
}

#[test]
fn structures_and_threads_never_change_a_picture() {
    for path in scene_paths() {
        let scene = load(&path);
        let expected = picture(&scene, "none", 2);
        for structure in STRUCTURES {
            // One thread and two differ in nothing that depends on the number of triangles.
            let slow = structure.name == "none" && scene.triangle_count() >= MANY_TRIANGLES;
            for threads in if slow { 1..2 } else { 1..3 } {
                let got = picture(&scene, structure.name, threads);
                let difference = compare(&expected, &got).expect("sizes are equal");
                assert!(
                    difference.differing == 0,
                    "{} with {} on {threads} threads: {difference:?}",
                    stem(&path),
                    structure.name,
                );
            }
        }
    }
}
