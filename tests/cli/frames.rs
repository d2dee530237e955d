//! The frames of a scene that moves: `--frames`, `--frame`, and the names of their pictures.

use std::fs;

use crate::support::{SCENE, folder, good_run_in, names, rendered, run_in};

/// The scene of all tests, its ball on its way.
fn moving() -> String {
    SCENE.replace("ball 0.8 -1.5 0 0.8", "at 2 ball 0.8 -1.5 0 0.8\nto 4 ball 0.8 -0.5 0 1.8")
}

#[test]
fn each_frame_becomes_a_picture_of_its_own() {
    let folder = folder();
    fs::write(folder.path().join("scene.sce"), moving()).unwrap();
    let run = good_run_in(folder.path(), &["scene.sce", "out/a-###.exr", "--frames", "1..4"]);
    assert_eq!(names(&folder.path().join("out")), [1, 2, 3, 4].map(|n| format!("a-00{n}.exr")));
    for frame in 1..5 {
        assert!(run.stderr.contains(&format!("frame {frame}: 40 × 30, bvh8: built in ")));
    }
    let of = |frame: &str| fs::read(folder.path().join(format!("out/a-00{frame}.exr"))).unwrap();
    assert!(of("1") == of("2") && of("2") != of("3") && of("3") != of("4"));
    for frame in ["2", "3"] {
        let options = ["--frame", frame, "--accel", "none", "--threads", "1"];
        assert!(rendered(folder.path(), "b.exr", &options) == of(frame), "{frame}");
    }
    assert!(rendered(folder.path(), "b.exr", &[]) == of("1"), "it is frame 0");
    good_run_in(folder.path(), &["scene.sce", "c#.exr", "--frame", "12"]);
    assert!(fs::read(folder.path().join("c12.exr")).unwrap() == of("4"));
}

#[test]
fn a_scene_that_stands_still_has_equal_frames() {
    let folder = folder();
    good_run_in(folder.path(), &["scene.sce", "#.ppm", "--frames", "9..10", "--quiet"]);
    assert_eq!(names(folder.path()), ["10.ppm", "9.ppm", "scene.sce"]);
    let of = |name: &str| fs::read(folder.path().join(name)).unwrap();
    assert!(of("9.ppm") == of("10.ppm"));
}

#[test]
fn standard_output_gets_one_picture_after_the_other() {
    let folder = folder();
    fs::write(folder.path().join("scene.sce"), moving()).unwrap();
    let typed = ["scene.sce", "-", "--format", "ppm", "--frames", "2..4"];
    let output = crate::support::srt(&typed).current_dir(folder.path()).output().unwrap();
    let one = rendered(folder.path(), "a.ppm", &["--frame", "2"]);
    assert_eq!(output.stdout.len(), 3 * one.len());
    assert!(output.stdout.starts_with(&one));
}

#[test]
fn what_is_missing_is_said() {
    let folder = folder();
    let refused = |arguments: &[&str]| {
        let run = run_in(folder.path(), arguments);
        assert_eq!(run.code, 2, "{arguments:?}");
        run.stderr
    };
    let no_place = refused(&["scene.sce", "a.png", "--frames", "0..2"]);
    assert!(
        no_place.contains("the output `a.png` has no place for the number of a frame: put `####`"),
        "{no_place}"
    );
    let no_frames = refused(&["scene.sce", "a-####.png"]);
    assert!(no_frames.contains(
        "`####` in the name of the output stands for the number of a frame: add `--frames"
    ));
    for wrong in ["2..1", "3", "..4", "a..b", "-1..3", "0..100000000"] {
        let text = refused(&["scene.sce", "#.png", "--frames", wrong]);
        assert!(text.contains("expected the first frame and the last"), "{wrong}: {text}");
    }
    for other in
        [&["--frame", "1"][..], &["--progressive"], &["--keep-partial"], &["--checkpoint", "a"]]
    {
        let text = refused(&[&["scene.sce", "#.png", "--frames", "0..1"], other].concat());
        assert!(text.contains("cannot be used with"), "{other:?}: {text}");
    }
    assert_eq!(names(folder.path()), ["scene.sce"]);
}

#[test]
fn an_error_in_a_frame_leaves_those_before_it() {
    let folder = folder();
    let scene = SCENE.replace("translate 1.6 0.4 1", "at 0 scale 1 1 1\nto 4 scale 1 1 -1");
    fs::write(folder.path().join("scene.sce"), scene).unwrap();
    let run = run_in(folder.path(), &["scene.sce", "#.png", "--frames", "0..4", "--quiet"]);
    assert_eq!(run.code, 2);
    assert_eq!(names(folder.path()), ["0.png", "1.png", "scene.sce"]);
    for part in [
        "at frame 2 `z` of `scale` must not be 0",
        "scene.sce:18:16",
        "the 2 before it are written",
    ] {
        assert!(run.stderr.contains(part), "{part}: {}", run.stderr);
    }
}

#[cfg(unix)]
#[test]
fn a_signal_leaves_whole_frames_alone() {
    use std::process::{Command, Stdio};

    use crate::support::{picture, send};

    // On a busy machine rendering may begin late.
    for seconds in [1, 2, 4, 8, 16] {
        let folder = folder();
        let child = Command::new(assert_cmd::cargo::cargo_bin!("srt"))
            .args(["scene.sce", "##.png", "--frames", "0..9999", "--size", "200x150"])
            .current_dir(folder.path())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        std::thread::sleep(std::time::Duration::from_secs(seconds));
        send(child.id(), "TERM");
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(143));
        let left = names(folder.path());
        let frames: Vec<_> = left.iter().filter(|name| *name != "scene.sce").collect();
        for (number, name) in frames.iter().enumerate() {
            assert!(frames.contains(&&format!("{number:02}.png")), "{name}: {frames:?}");
            assert_eq!(picture(&folder.path().join(name)).width, 200);
        }
        if frames.len() > 1 {
            return;
        }
    }
    panic!("rendering never began");
}
