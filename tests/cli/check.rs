//! `srt check`, and its errors about scenes whose meshes are wrong.

use std::fs;
use std::path::Path;

use crate::support::{SCENE, folder, run_in};

#[test]
fn a_valid_scene_is_described() {
    let folder = folder();
    let run = run_in(folder.path(), &["check", "scene.sce"]);
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
    insta::assert_snapshot!("a_valid_scene", run.stdout);
}

#[test]
fn the_worst_scene_decides_and_all_are_checked() {
    let folder = folder();
    fs::write(folder.path().join("bad.sce"), SCENE.replace("wdist 1", "wdist 0")).unwrap();
    let run = run_in(folder.path(), &["check", "bad.sce", "scene.sce"]);
    assert_eq!(run.code, 1);
    assert!(run.stdout.starts_with("scene.sce: valid\n"), "{}", run.stdout);
    assert!(
        run.stderr.contains("error: `bad.sce` is not a valid scene: 1 error"),
        "{}",
        run.stderr
    );
    let run = run_in(folder.path(), &["check", "missing.sce", "bad.sce", "scene.sce"]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("cannot read the scene `missing.sce`"), "{}", run.stderr);
    assert!(run.stderr.contains("`bad.sce` is not a valid scene"), "{}", run.stderr);
}

#[test]
fn an_eye_within_an_opaque_ball_is_warned_of_unless_a_light_is_there_too() {
    let folder = folder();
    let warnings = |more: &str| {
        let scene = SCENE.replace("\nend\n", &format!("\n{more}\nend\n"));
        fs::write(folder.path().join("ball.sce"), scene).unwrap();
        let run = run_in(folder.path(), &["check", "ball.sce"]);
        assert_eq!(run.code, 0, "{}", run.stderr);
        run.stderr
    };
    let dark = warnings("translate 0 -6 2.5\nscale 1 2 1\nball 0.5 0 0 0");
    assert!(dark.contains("warning: the eye is within an opaque ball"), "{dark}");
    assert!(dark.contains("this ball"), "{dark}");
    assert_eq!(warnings("alpha 0.5\nball 0.5 0 -6 2.5"), "");
    assert_eq!(warnings("ball 50 0 0 0"), "", "the light is in it too");
    assert_eq!(warnings("ball 0.5 0 -7 2.5"), "");
}

/// Scenes of one mesh each, and the files that it may be.
fn meshes(folder: &Path) {
    fs::create_dir(folder.join("meshes")).unwrap();
    let write =
        |name: &str, text: &[u8]| fs::write(folder.join("meshes").join(name), text).unwrap();
    write("empty.obj", b"");
    write("points.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    write("malformed.obj", b"# a mesh\nv 0 0 0\n  v 1 zero 0\nv 0 1 0\nf 1 2 3\n");
    write("out_of_range.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n");
    write("bytes.obj", b"v 0 0 0\nv 1 \xff 0\n");
    write("flat.obj", b"v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
    write("partly_flat.obj", b"v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 4\nf 1 1 4\n");
}

/// What `check` prints about the scene with its mesh called `name`.
fn check_mesh(name: &str) -> (i32, String) {
    let folder = folder();
    meshes(folder.path());
    let scene = SCENE.replace("generate:torus-knot:1000", name);
    fs::write(folder.path().join("mesh.sce"), scene).unwrap();
    let run = run_in(folder.path(), &["check", "mesh.sce"]);
    (run.code, run.stderr)
}

#[test]
fn meshes_that_cannot_be_loaded() {
    let names = [
        "meshes/malformd.obj",
        "nowhere/a.obj",
        "meshes",
        "meshes/empty.obj",
        "meshes/points.obj",
        "meshes/malformed.obj",
        "meshes/out_of_range.obj",
        "meshes/bytes.obj",
        "meshes/flat.obj",
        "generate:torus-knott:1000",
        "generate:soup:many",
    ];
    let mut all = String::new();
    for name in names {
        let (code, stderr) = check_mesh(name);
        assert_eq!(code, 1, "{name}: {stderr}");
        all += &stderr;
        all += "\n";
    }
    insta::assert_snapshot!("meshes", all);
}

#[test]
fn degenerate_triangles_are_one_warning() {
    let (code, stderr) = check_mesh("meshes/partly_flat.obj");
    assert_eq!(code, 0);
    insta::assert_snapshot!("degenerate_triangles_of_a_mesh", stderr);
}

#[test]
fn objects_that_cannot_be_traced() {
    let folder = folder();
    let scene = SCENE
        .replace("translate 1.6 0.4 1", "translate 3e38 0 0\nscale 2e38 1 1")
        .replace("eyepos 0 -6 2.5", "eyepos 0 -6e12 2.5")
        .replace("ball 0.8 -1.5 0 0.8", "ball 1e-10 -1.5 0 0.8")
        .replace("translate 0 -2 4", "translate 0 -2 4e20");
    fs::write(folder.path().join("far.sce"), scene).unwrap();
    let run = run_in(folder.path(), &["check", "far.sce"]);
    assert_eq!(run.code, 1);
    insta::assert_snapshot!("objects_that_cannot_be_traced", run.stderr);
}

/// What the check of `many.sce` says to a gigabyte of memory.
#[cfg(target_os = "linux")] // Elsewhere the shell may not be able to limit it.
fn errors_in_little_memory(folder: &std::path::Path) -> String {
    let output = std::process::Command::new("sh")
        .args(["-c", "ulimit -v 1000000 && exec \"$0\" check many.sce"])
        .arg(assert_cmd::cargo::cargo_bin!("srt"))
        .current_dir(folder)
        .output()
        .unwrap();
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{stderr}");
    stderr
}

#[cfg(target_os = "linux")]
#[test]
fn objects_that_memory_cannot_hold() {
    let folder = folder();
    let many = "repeat 4000\n  repeat 4000\n    ball 1 0 0 0\n  end_repeat\nend_repeat\nend\n";
    fs::write(folder.path().join("many.sce"), SCENE.replace("end\n", many)).unwrap();
    let stderr = errors_in_little_memory(folder.path());
    for part in [
        "error: this makes 16000000 objects and lights, more than the memory can hold",
        "--> many.sce:25:1",
        "make fewer, or let the program use more memory",
        "`many.sce` is not a valid scene: 1 error",
    ] {
        assert!(stderr.contains(part), "{part}:\n{stderr}");
    }
}

#[test]
fn all_errors_of_a_scene_are_printed_at_once() {
    let folder = folder();
    let scene = SCENE.replace("end\n", "object_flat b.obj\nobject_flat a.obj\nend\n");
    fs::write(folder.path().join("two.sce"), scene).unwrap();
    let run = run_in(folder.path(), &["two.sce", "a.png"]);
    assert_eq!(run.code, 2, "to render it is trouble");
    assert!(run.stderr.contains("there is no mesh file `b.obj`"), "{}", run.stderr);
    assert!(run.stderr.contains("there is no mesh file `a.obj`"), "{}", run.stderr);
    assert!(run.stderr.contains("is not a valid scene: 2 errors"), "{}", run.stderr);
}

/// A scene in which text, meshes and generators are wrong.
fn all_wrong(folder: &Path) {
    meshes(folder);
    let wrong = "\
ball 1 0 x 0
object_flat meshes/malformed.obj
object_flt meshes/none.obj
object_phong ./meshes/malformed.obj
repeat 2
object_flat generate:soup:many
object_flat meshes/out_of_range.obj
object_flat generate:torus-knott:1000
object_phong meshes/malformed.obj
object_flat meshes/bytes.obj
object_flat generate:torus-knot:100000000
object_flat meshes/partly_flat.obj
";
    fs::write(folder.join("wrong.sce"), SCENE.replace("\nend\n", &format!("\n{wrong}end\n")))
        .unwrap();
}

#[test]
fn errors_of_meshes_and_generators_stand_among_those_of_the_text() {
    let folder = folder();
    all_wrong(folder.path());
    let checked = run_in(folder.path(), &["check", "wrong.sce"]);
    assert_eq!(checked.code, 1);
    insta::assert_snapshot!("errors_of_text_and_meshes", checked.stderr);
    let rendered = run_in(folder.path(), &["wrong.sce", "a.png"]);
    assert_eq!((rendered.code, rendered.stderr), (2, checked.stderr));
    assert!(!folder.path().join("a.png").exists());
}

#[test]
fn what_can_be_checked_beside_a_mesh_that_cannot_be_loaded_is() {
    let folder = folder();
    meshes(folder.path());
    let wrong = "object_flat meshes/partly_flat.obj\nball 1e-12 0 0 0\nobject_flat meshes/none.obj\n\
        translate 3e20 0 0\nobject_flat meshes/points.obj\nobject_flat generate:soup:5\n";
    fs::write(
        folder.path().join("wrong.sce"),
        SCENE.replace("\nend\n", &format!("\n{wrong}end\n")),
    )
    .unwrap();
    let run = run_in(folder.path(), &["check", "wrong.sce"]);
    assert_eq!(run.code, 1);
    insta::assert_snapshot!("errors_beside_a_missing_mesh", run.stderr);
}

#[cfg(target_os = "linux")]
#[test]
fn meshes_beyond_memory_are_told_with_the_errors_of_the_text() {
    let folder = folder();
    let wrong = "ball 1\nobject_flat generate:soup:99M\nobject_flat generate:hall:1k\nend\n";
    fs::write(folder.path().join("many.sce"), SCENE.replace("end\n", wrong)).unwrap();
    let stderr = errors_in_little_memory(folder.path());
    for part in [
        "error: `ball` takes 4 values (radius x y z), found 1",
        "error: the mesh `generate:soup:99000000` is too large: it takes about 7.1 GB of memory",
        "--> many.sce:26:13",
        "use a mesh of fewer triangles, or let the program use more memory",
        "`many.sce` is not a valid scene: 3 errors",
    ] {
        assert!(stderr.contains(part), "{part}:\n{stderr}");
    }
}

#[test]
fn standard_input_is_read_only_once() {
    crate::support::refused(&["check", "-", "-"], &["`-` is named twice"]);
}

#[test]
fn every_frame_of_a_scene_that_moves_is_looked_at() {
    let folder = folder();
    let scaled = |last: &str| {
        let keys = format!("at 0 scale 1 1 1\nto 10 scale {last}\ntranslate 1.6 0.4 1");
        fs::write(folder.path().join("moving.sce"), SCENE.replace("translate 1.6 0.4 1", &keys))
            .unwrap();
        run_in(folder.path(), &["check", "moving.sce"])
    };
    let good = scaled("2 1 1");
    assert_eq!((good.code, good.stderr.as_str()), (0, ""));
    assert!(good.stdout.contains("keys from frame 0 to 10"), "{}", good.stdout);
    let wrong = scaled("-1 1 1");
    assert_eq!((wrong.code, wrong.stdout.as_str()), (1, ""), "{}", wrong.stderr);
    for part in ["at frame 5 `x` of `scale` must not be 0", "in frame 5\n"] {
        assert!(wrong.stderr.contains(part), "{}", wrong.stderr);
    }
}
