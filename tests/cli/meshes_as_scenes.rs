//! A mesh in the place of a scene: an OBJ file or a recipe, for every command.

use std::fs;

use crate::support::{folder, good_run_in, picture, run_in, srt};

/// A tetrahedron, far away and large.
const TETRAHEDRON: &str = "v 1000 0 0\nv 1100 0 0\nv 1000 100 0\nv 1000 0 100\n\
    f 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n";

#[test]
fn a_mesh_is_rendered_packed_built_and_compared() {
    let folder = folder();
    let at = folder.path();
    fs::create_dir(at.join("models")).unwrap();
    fs::write(at.join("models/a solid.OBJ"), TETRAHEDRON).unwrap();
    let mesh = "models/a solid.OBJ";
    good_run_in(at, &[mesh, "a.png", "--size", "90x60", "--quiet"]);
    let seen = picture(&at.join("a.png"));
    let distinct = |at: [u32; 2]| seen.pixels[(at[1] * seen.width + at[0]) as usize];
    assert!(distinct([45, 30]) != distinct([0, 0]), "the mesh is in the middle");
    let checked = good_run_in(at, &["check", mesh]).stdout;
    assert!(checked.contains("valid") && checked.contains("1: 1 mesh"), "{checked}");
    // The same picture from a pack, from a built file, and of every structure.
    good_run_in(at, &["pack", mesh, "-o", "a.srtpack", "--quiet"]);
    good_run_in(at, &["build", mesh, "-o", "a.srtb", "--quiet"]);
    for (number, scene) in ["a.srtpack", "a.srtb", mesh].into_iter().enumerate() {
        let name = format!("{number}.png");
        let accel = ["none", "bvh8", "kdtree"][number];
        let accel: &[&str] = if scene == "a.srtb" { &[] } else { &["--accel", accel] };
        good_run_in(at, &[&[scene, &name, "--size", "90x60", "--quiet"], accel].concat());
        assert!(fs::read(at.join(name)).unwrap() == fs::read(at.join("a.png")).unwrap(), "{scene}");
    }
    let compared = [mesh, "generate:icosphere:80", "--accel", "none,bvh8", "--size", "16x12"];
    let options = ["--budget", "2", "--out", "report", "--quiet"];
    good_run_in(at, &[&["compare"], &compared[..], &options].concat());
    let json = fs::read_to_string(at.join("report/report.json")).unwrap();
    assert!(json.contains("\"a solid\"") && json.contains("generate:icosphere:80"));
}

#[test]
fn what_is_wrong_with_a_mesh_is_said_with_its_line() {
    let folder = folder();
    let at = folder.path();
    fs::write(at.join("bad.obj"), "v 0 0 0\nv 1 0 x\nf 1 2 3\n").unwrap();
    for (mesh, reason) in [
        ("bad.obj", "bad.obj:2:7"),
        ("no.obj", "there is no mesh file"),
        ("generate:icospheres:80", "there is no generator `icospheres`"),
    ] {
        let run = run_in(at, &[mesh, "never.png"]);
        assert_eq!(run.code, 2, "{mesh}");
        assert!(run.stderr.contains(reason), "{}", run.stderr);
        assert!(run.stderr.contains(&format!("the scene around {mesh}:")), "{}", run.stderr);
        assert!(!at.join("never.png").exists());
    }
}

#[test]
fn meshes_of_other_formats_and_without_a_name_are_called_what_they_are() {
    let folder = folder();
    let at = folder.path();
    let stl = [&[0; 80][..], &1u32.to_le_bytes(), &[0; 50]].concat();
    let files: [(&str, &[u8], &str); 4] = [
        ("a.ply", b"ply\nformat ascii 1.0\n", "`a.ply` looks like PLY"),
        ("b.stl", &stl, "`b.stl` looks like STL"),
        ("c.glb", b"glTF\x02\0\0\0", "`c.glb` looks like glTF"),
        ("d.txt", b"# a remark\n\no cube\nv 0 0 0\n", "`d.txt` looks like a mesh"),
    ];
    for (name, bytes, reason) in files {
        fs::write(at.join(name), bytes).unwrap();
        for (typed, code) in [([name, "never.png"], 2), (["check", name], 1)] {
            let run = run_in(at, &typed);
            assert_eq!(run.code, code, "{}", run.stderr);
            assert!(run.stderr.contains(reason), "{}", run.stderr);
            assert_eq!(run.stderr.matches("error: ").count(), 1, "{}", run.stderr);
        }
    }
    let output =
        srt(&["-", "never.png"]).current_dir(at).write_stdin(TETRAHEDRON).output().unwrap();
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{stderr}");
    assert!(stderr.contains("standard input looks like a mesh, a Wavefront OBJ"), "{stderr}");
    assert!(stderr.contains("from a file alone"), "{stderr}");
    assert!(!at.join("never.png").exists());
}

#[test]
fn a_mesh_that_reaches_too_far_is_one_error() {
    let folder = folder();
    let at = folder.path();
    fs::write(at.join("far.obj"), "v 0 0 0\nv 1e20 0 0\nv 0 1e20 0\nf 1 2 3\n").unwrap();
    let run = run_in(at, &["far.obj", "never.png"]);
    assert_eq!(run.code, 2, "{}", run.stderr);
    assert_eq!(run.stderr.matches("error: ").count(), 1, "{}", run.stderr);
    let reason = "the mesh `far.obj` reaches to coordinates of 1e20, and in the place of a scene 1e8 is the most";
    assert!(run.stderr.contains(reason), "{}", run.stderr);
}
