//! `srt animate`: a scene that moves, and what structures take to follow it.

use std::fs;

use serde_json::Value;

use crate::support::{SCENE, folder, good_run_in, names, run_in};

/// Two moving parts: a knot that is wrung, and a ball on its way.
fn moving() -> String {
    SCENE
        .replace("ball 0.8 -1.5 0 0.8", "at 0 ball 0.8 -1.5 0 0.8\nto 4 ball 0.8 -0.5 0 1.8")
        .replace("translate 1.6 0.4 1", "at 0 twist 0\nto 9 twist 90\ntranslate 1.6 0.4 1")
}

#[test]
fn all_strategies_give_equal_answers_and_their_costs() {
    let folder = folder();
    fs::write(folder.path().join("scene.sce"), moving()).unwrap();
    let typed = ["animate", "scene.sce", "--frames", "2..6", "--size", "40x30", "--out", "out"];
    let run = good_run_in(folder.path(), &typed);
    for part in [
        "scene.sce, frames 3 to 6, built for frame 2: 3 objects and 997 triangles; in a frame 1 object",
        "structure  strategy",
        "no difference from bvh with rebuild in ",
        "over 4 frames; no difference from `none` in ",
        "threads, rays on one",
    ] {
        assert!(run.stdout.contains(part), "{part}:\n{}", run.stdout);
    }
    assert_eq!(run.stdout.lines().filter(|line| line.ends_with("equal")).count(), 10);
    let out = folder.path().join("out");
    assert_eq!(names(&out), ["motion.csv", "motion.html", "motion.json", "motion.md"]);
    let json: Value = serde_json::from_slice(&fs::read(out.join("motion.json")).unwrap()).unwrap();
    assert_eq!((&json["motion_version"], &json["frames"]), (&1.into(), &vec![2, 6].into()));
    let moved = &json["moved"][0];
    assert_eq!((&moved["objects"], &moved["is_same_scene"]), (&2.into(), &true.into()));
    assert!(
        moved["triangles"].as_u64().unwrap() > 900
            && json["compared_with_none"].as_u64() > Some(999)
    );
    let strategies = json["strategies"].as_array().unwrap();
    let names: Vec<_> = strategies
        .iter()
        .map(|own| (own["structure"].as_str().unwrap(), own["strategy"].as_str().unwrap()))
        .collect();
    let strategies_of_all = ["rebuild", "quick_rebuild", "refit", "rotate", "partial"];
    let expected = ["bvh", "bvh8"].map(|name| strategies_of_all.map(|strategy| (name, strategy)));
    assert_eq!(names, expected.as_flattened());
    for (own, derived) in strategies.iter().zip(json["derived"].as_array().unwrap()) {
        assert_eq!((&own["differing"], &own["rebuilt"]), (&0.into(), &0.into()));
        assert!(own["compared"].as_u64().unwrap() > 5_000);
        assert_eq!(own["updates"].as_array().unwrap().len(), 4);
        assert!(derived["update_ns"].as_f64().unwrap() > 0.0);
        assert!(derived["sah_share"].as_f64().unwrap() > 0.5);
    }
    let csv = fs::read_to_string(out.join("motion.csv")).unwrap();
    assert_eq!(csv.lines().count(), 1 + 10 * 4);
    let page = fs::read_to_string(out.join("motion.html")).unwrap();
    for frame in 2..=6 {
        assert!(page.contains(&format!("alt=\"scene.sce, frame {frame}\"")), "{frame}");
    }
    assert_eq!(page.matches("data:image/png;base64,").count(), 5);
    assert!(page.contains("default-src 'none'") && !page.contains("src=\"http"));
    assert!(csv.starts_with("structure,strategy,frame,update_ns,view_rays,view_trace_ns,shadow"));
}

#[test]
fn structures_that_cannot_follow_are_built_anew() {
    let folder = folder();
    let scene = SCENE.replace("cp 0.3 0.3 0.3", "cp 0.3 0.3 0.3\nat 0 alpha 1\nto 3 alpha 0.5");
    fs::write(folder.path().join("scene.sce"), scene).unwrap();
    let typed = [
        "animate",
        "scene.sce",
        "--frames",
        "0..3",
        "--size",
        "16x12",
        "--accel",
        "none,bvh8,kdtree",
    ];
    let run = good_run_in(
        folder.path(),
        &[&typed[..], &["--strategies", "refit,rebuild", "--threads", "1"]].concat(),
    );
    // A kd-tree cannot follow; nothing has moved, so the others have nothing to do.
    assert_eq!(
        run.stdout.lines().filter(|line| line.ends_with("equal")).count(),
        5,
        "{}",
        run.stdout
    );
    assert!(run.stdout.contains("in a frame 0 objects and 0 triangles move"), "{}", run.stdout);
    assert!(!run.stderr.contains("note: "), "{}", run.stderr);
    // Whoever offers nothing is named, and the others are measured.
    let refits = [&typed[..], &["--strategies", "refit", "--threads", "1"]].concat();
    let run = good_run_in(folder.path(), &refits);
    let note = "note: kdtree offers none of: refit; it is left out\n";
    assert!(run.stderr.contains(note), "{}", run.stderr);
    let quiet = good_run_in(folder.path(), &[&refits[..], &["--quiet"]].concat());
    assert!(quiet.stderr.is_empty(), "{}", quiet.stderr);
}

#[test]
fn what_cannot_be_measured_is_refused() {
    let folder = folder();
    let refused = |typed: &[&str]| {
        let run = run_in(folder.path(), &[&["animate", "scene.sce"], typed].concat());
        assert_eq!(run.code, 2, "{typed:?}");
        run.stderr
    };
    assert!(refused(&[]).contains("--frames"));
    assert!(refused(&["--frames", "3..3"]).contains("name a later one as the last, as in 3..12"));
    let none = refused(&["--frames", "0..3", "--accel", "kdtree", "--strategies", "refit"]);
    assert!(none.contains("none of these structures can follow in these ways"), "{none}");
    fs::write(
        folder.path().join("scene.sce"),
        SCENE.replace("translate 1.6 0.4 1", "at 0 scale 1 1 1\nto 4 scale 1 1 -1"),
    )
    .unwrap();
    let wrong = refused(&["--frames", "0..4", "--size", "16x12"]);
    assert!(wrong.contains("at frame 2 `z` of `scale`") && wrong.contains("in frame 2"), "{wrong}");
    assert_eq!(names(folder.path()), ["scene.sce"]);
}
