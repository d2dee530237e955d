//! Scenes → pictures: what changes a picture, and what must not.

use std::fs;

use srt::accel::Quality;
use srt::image_io::Picture;
use srt::render::View;
use srt::scene::STRUCTURES;

use crate::support::{folder, good_run_in, names, picture, rendered, run_in, srt};

#[test]
fn a_scene_becomes_a_picture_and_a_line() {
    let folder = folder();
    let run = good_run_in(folder.path(), &["scene.sce", "a.tga"]);
    assert_eq!(run.stdout, "");
    for part in ["40 × 30, bvh8: built in ", "rendered in ", " rays (4.80 k view, ", " M rays/s\n"]
    {
        assert!(run.stderr.contains(part), "{part}: {}", run.stderr);
    }
    assert_eq!(run.stderr.lines().count(), 1, "{}", run.stderr);
    assert_eq!(names(folder.path()), ["a.tga", "scene.sce"]);
    let picture = picture(&folder.path().join("a.tga"));
    assert_eq!((picture.width, picture.height), (40, 30));
    // The sky above, the floor below, and neither black.
    let (sky, floor) = (picture.get(20, 0).unwrap(), picture.get(20, 28).unwrap());
    assert!((sky.z - 0.9).abs() < 0.005, "{sky}");
    assert!(floor.x > 0.1 && floor.x == floor.z, "{floor}");
}

#[test]
fn neither_structure_nor_build_nor_threads_change_a_byte() {
    let folder = folder();
    let reference = rendered(folder.path(), "a.exr", &["--accel", "none", "--threads", "1"]);
    for structure in STRUCTURES {
        for threads in ["1", "2"] {
            let options = ["--accel", structure.name, "--threads", threads];
            assert!(rendered(folder.path(), "b.exr", &options) == reference, "{options:?}");
        }
    }
    for quality in Quality::ALL.map(Quality::name) {
        assert!(rendered(folder.path(), "b.exr", &["--build", quality]) == reference, "{quality}");
    }
    assert!(rendered(folder.path(), "b.exr", &["--stats"]) == reference, "counting");
    assert!(rendered(folder.path(), "b.exr", &["--seed", "1"]) != reference);
}

#[test]
fn no_instruction_set_changes_a_byte() {
    let folder = folder();
    let options = ["--light-samples", "3"];
    let reference = rendered(folder.path(), "a.exr", &options);
    for isa in ["portable", "avx2", "avx512"] {
        let arguments = [&["scene.sce", "b.exr"], &options[..]].concat();
        let output =
            srt(&arguments).current_dir(folder.path()).env("SRT_ISA", isa).output().unwrap();
        if String::from_utf8_lossy(&output.stderr).contains("lacks the instruction set") {
            continue; // Not this processor's.
        }
        assert!(output.status.success(), "{isa}");
        assert!(fs::read(folder.path().join("b.exr")).unwrap() == reference, "{isa}");
    }
}

#[test]
fn a_crop_is_a_part_of_the_whole() {
    let folder = folder();
    let path = |name: &str| folder.path().join(name);
    rendered(folder.path(), "whole.exr", &[]);
    rendered(folder.path(), "part.exr", &["--crop", "7,3,29,21"]);
    let (whole, part) = (picture(&path("whole.exr")), picture(&path("part.exr")));
    assert_eq!((part.width, part.height), (22, 18));
    let same = |x, y| whole.get(x + 7, y + 3) == part.get(x, y);
    assert!((0..18).all(|y| (0..22).all(|x| same(x, y))));
}

#[test]
fn options_count_more_than_the_scene() {
    let folder = folder();
    rendered(folder.path(), "a.ppm", &["--size", "12x7"]);
    let small = picture(&folder.path().join("a.ppm"));
    assert_eq!((small.width, small.height), (12, 7));
    let as_written = rendered(folder.path(), "a.exr", &[]);
    let same = ["--aa", "2", "--max-recursion", "2", "--light-samples", "1", "--seed", "0"];
    assert!(rendered(folder.path(), "a.exr", &same) == as_written);
    for other in [
        ["--aa", "0"],
        ["--max-recursion", "0"],
        ["--light-samples", "2"],
        ["--sampling", "independent"],
    ] {
        assert!(rendered(folder.path(), "a.exr", &other) != as_written, "{other:?}");
    }
}

#[test]
fn a_scene_may_come_from_standard_input() {
    let folder = folder();
    let mesh = good_run_in(folder.path(), &["mesh", "torus-knot", "-n", "1000"]).stdout;
    fs::write(folder.path().join("knot.obj"), mesh).unwrap();
    let scene = crate::support::SCENE.replace("generate:torus-knot:1000", "knot.obj");
    fs::write(folder.path().join("knot.sce"), &scene).unwrap();
    good_run_in(folder.path(), &["knot.sce", "a.png"]);
    let piped = |scene: &str, arguments: &[&str]| {
        srt(arguments).current_dir(folder.path()).write_stdin(scene).output().unwrap()
    };
    let run = piped(&scene, &["-", "b.png"]);
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    let read = |name: &str| fs::read(folder.path().join(name)).unwrap();
    assert!(read("a.png") == read("b.png"));
    assert!(piped(&scene, &["check", "-"]).stdout.starts_with(b"standard input: valid\n"));
    let wrong = String::from_utf8(piped("sce1.0\nbal\n", &["-", "b.png"]).stderr).unwrap();
    assert!(wrong.contains("standard input:2:1"), "{wrong}");
    assert!(wrong.contains("error: standard input is not a valid scene"), "{wrong}");
    let refused = String::from_utf8(piped(&scene, &["compare", "-"]).stderr).unwrap();
    assert!(refused.contains("a comparison takes scenes from files"), "{refused}");
}

#[test]
fn every_view_shows_something_of_its_own() {
    let folder = folder();
    let mut seen = Vec::new();
    for view in View::ALL.map(View::name) {
        let run = good_run_in(folder.path(), &["scene.sce", "a.png", "--view", view]);
        let has_scale = matches!(view, "depth" | "heatmap");
        assert_eq!(run.stderr.contains(": black is "), has_scale, "{view}: {}", run.stderr);
        let picture = picture(&folder.path().join("a.png"));
        assert!(different_colors(&picture) > 2, "{view}");
        assert!(!seen.contains(&picture), "{view} is the same as another");
        seen.push(picture);
    }
}

fn different_colors(picture: &Picture) -> usize {
    let mut colors: Vec<_> =
        picture.pixels.iter().map(|p| p.to_array().map(f32::to_bits)).collect();
    colors.sort_unstable();
    colors.dedup();
    colors.len()
}

#[test]
fn formats_of_floats_get_the_numbers_themselves() {
    let folder = folder();
    let run = good_run_in(folder.path(), &["scene.sce", "a.exr", "--view", "depth"]);
    assert!(!run.stderr.contains("black is"), "{}", run.stderr);
    let depths = picture(&folder.path().join("a.exr"));
    assert!(depths.get(20, 0).unwrap().is_nan(), "the sky is nowhere");
    let floor = depths.get(20, 29).unwrap();
    assert!(floor.x > 2.5 && floor.x < 6.0 && floor.x == floor.y, "{floor}");
}

#[test]
fn meshes_are_found_from_anywhere() {
    let folder = folder();
    good_run_in(folder.path(), &["mesh", "icosphere", "-n", "20", "-o", "ball.obj"]);
    let scene = fs::read_to_string(folder.path().join("scene.sce")).unwrap();
    let scene = scene.replace("generate:torus-knot:1000", "ball.obj");
    fs::write(folder.path().join("scene.sce"), scene).unwrap();
    rendered(folder.path(), "a.tga", &[]);
    let elsewhere = tempfile::tempdir().unwrap();
    let scene = folder.path().join("scene.sce");
    let output = folder.path().join("b.tga");
    good_run_in(elsewhere.path(), &[scene.to_str().unwrap(), output.to_str().unwrap()]);
    assert_eq!(
        fs::read(folder.path().join("a.tga")).unwrap(),
        fs::read(output).unwrap(),
        "the working folder does not matter"
    );
}

#[test]
fn the_errors_of_a_scene_are_printed_and_nothing_is_written() {
    let folder = folder();
    fs::write(folder.path().join("old.png"), "old").unwrap();
    fs::write(folder.path().join("bad.sce"), "sce1.0\nbal 1 0 0 0\n").unwrap();
    let run = run_in(folder.path(), &["bad.sce", "old.png", "--quiet"]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("did you mean `ball`?"), "{}", run.stderr);
    assert!(run.stderr.contains(" --> bad.sce:2:1"), "{}", run.stderr);
    let last = run.stderr.lines().last().unwrap();
    assert!(last.starts_with("error: `bad.sce` is not a valid scene: "), "{last}");
    assert_eq!(fs::read(folder.path().join("old.png")).unwrap(), b"old");
    assert_eq!(names(folder.path()), ["bad.sce", "old.png", "scene.sce"]);
}

#[test]
fn warnings_are_printed_unless_quiet() {
    let folder = folder();
    let scene = fs::read_to_string(folder.path().join("scene.sce")).unwrap();
    let scene = scene.replace("end\n", "fog 1 2\n");
    fs::write(folder.path().join("odd.sce"), scene).unwrap();
    let run = |options: &[&str]| run_in(folder.path(), &[&["odd.sce", "a.png"], options].concat());
    assert_eq!(run(&[]).code, 2);
    let lenient = run(&["--lenient"]);
    assert_eq!(lenient.code, 0);
    assert!(lenient.stderr.starts_with("warning: unknown command `fog`"), "{}", lenient.stderr);
    let quiet = run(&["--lenient", "--quiet"]);
    assert_eq!((quiet.code, quiet.stderr.as_str()), (0, ""));
}
