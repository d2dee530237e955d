//! Where pictures go.

use std::fs;

use srt::image_io::{Format, decode};

use crate::support::{SCENE, folder, good_run_in, names, picture, rendered, run_in, srt};

#[test]
fn every_format_holds_the_same_picture() {
    let folder = folder();
    rendered(folder.path(), "a.png", &[]);
    let reference = picture(&folder.path().join("a.png"));
    for name in ["a.tga", "a.ppm", "A.PPM"] {
        rendered(folder.path(), name, &[]);
        assert!(picture(&folder.path().join(name)) == reference, "{name}");
    }
    for name in ["a.exr", "a.hdr"] {
        rendered(folder.path(), name, &[]);
        let other = picture(&folder.path().join(name));
        let near = |(p, q): (&glam::Vec3, &glam::Vec3)| {
            (p.min(glam::Vec3::ONE) - q).abs().max_element() < 0.02
        };
        assert!(other.pixels.iter().zip(&reference.pixels).all(near), "{name}");
    }
    rendered(folder.path(), "b.dat", &["--format", "png"]);
    let bytes = fs::read(folder.path().join("b.dat")).unwrap();
    assert!(decode(&bytes, Format::Png).unwrap() == reference);
}

#[test]
fn standard_output_gets_the_picture_and_standard_error_the_line() {
    let folder = folder();
    let run = |options: &[&str]| {
        srt(&[&["scene.sce", "-"], options].concat()).current_dir(folder.path()).output().unwrap()
    };
    let reference = rendered(folder.path(), "a.ppm", &[]);
    let output = run(&[]);
    assert!(output.status.success());
    assert!(output.stdout == reference);
    assert!(String::from_utf8(output.stderr).unwrap().starts_with("40 × 30, bvh8: "));
    assert!(run(&["--format", "png"]).stdout.starts_with(b"\x89PNG"));
    assert_eq!(names(folder.path()), ["a.ppm", "scene.sce"]);
}

#[test]
fn a_place_that_cannot_be_written_is_refused_before_rendering() {
    let folder = folder();
    // It would take minutes to render.
    let slow = ["--aa", "256", "--size", "4000x4000", "--accel", "none"];
    let arguments = [&["scene.sce", "no/such/a.png"], &slow[..]].concat();
    assert_eq!(run_in(folder.path(), &arguments).code, 2);
}

#[cfg(unix)]
mod unix {
    use std::io::Read;
    use std::process::{Command as Process, Stdio};

    use super::*;

    #[test]
    fn a_pipe_is_written_to_and_stays_one() {
        use std::os::unix::fs::FileTypeExt;
        let folder = folder();
        let reference = rendered(folder.path(), "a.ppm", &[]);
        let pipe = folder.path().join("pipe");
        assert!(Process::new("mkfifo").arg(&pipe).status().unwrap().success());
        let reader = std::thread::spawn({
            let pipe = pipe.clone();
            move || fs::read(pipe).unwrap()
        });
        let run = run_in(folder.path(), &["scene.sce", "pipe"]);
        assert_eq!(run.code, 0, "{}", run.stderr);
        assert!(reader.join().unwrap() == reference);
        assert!(fs::symlink_metadata(&pipe).unwrap().file_type().is_fifo());
        assert_eq!(names(folder.path()), ["a.ppm", "pipe", "scene.sce"]);
    }

    /// Runs with a standard output whose reader is gone.
    fn unread(arguments: &[&str]) -> (Option<i32>, String) {
        let folder = folder();
        let mut child = Process::new(assert_cmd::cargo::cargo_bin!("srt"))
            .args(arguments)
            .current_dir(folder.path())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        drop(child.stdout.take());
        let mut stderr = String::new();
        child.stderr.take().unwrap().read_to_string(&mut stderr).unwrap();
        (child.wait().unwrap().code(), stderr)
    }

    #[test]
    fn a_reader_that_leaves_is_no_trouble() {
        // It may have written everything before the pipe was closed.
        let (code, stderr) = unread(&["completions", "bash"]);
        assert!(matches!(code, Some(141 | 0)));
        assert_eq!(stderr, "");
        let (code, stderr) = unread(&["scene.sce", "-", "--size", "400x300"]);
        assert_eq!((code, stderr.as_str()), (Some(141), ""));
        let (code, stderr) = unread(&["mesh", "soup", "-n", "100000"]);
        assert_eq!((code, stderr.as_str()), (Some(141), ""));
    }
}

#[test]
fn a_mesh_of_the_scene_is_not_replaced() {
    let folder = folder();
    let at = folder.path();
    let mesh = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    fs::create_dir(at.join("meshes")).unwrap();
    fs::write(at.join("meshes/7.obj"), mesh).unwrap();
    let named = SCENE.replace("generate:torus-knot:1000", "meshes/7.obj");
    fs::write(at.join("named.sce"), named).unwrap();
    let path = "meshes/../meshes/7.obj";
    for typed in [
        &["named.sce", path, "--format", "png"][..],
        &["named.sce", "meshes/#.obj", "--frames", "7..8", "--format", "png"],
        &["named.sce", "a.png", "--checkpoint", path, "--resume"],
        &["pack", "named.sce", "-o", path],
        &["build", "named.sce", "-o", path],
        &["show", "bvh", "named.sce", "-o", path],
        &["part", "named.sce", "--part", "1/2", "-o", path],
    ] {
        let run = run_in(at, typed);
        assert_eq!(run.code, 2, "{typed:?}: {}", run.stderr);
        let reason = "would replace the mesh of the scene `meshes/7.obj`";
        assert!(run.stderr.contains(reason), "{typed:?}: {}", run.stderr);
        assert_eq!(fs::read(at.join("meshes/7.obj")).unwrap(), mesh, "{typed:?}");
    }
    // What nobody names may be replaced.
    fs::write(at.join("meshes/b.obj"), mesh).unwrap();
    good_run_in(at, &["pack", "named.sce", "-o", "meshes/b.obj"]);
    // A pack has its meshes in it.
    good_run_in(at, &["pack", "named.sce", "-o", "a.srtpack"]);
    good_run_in(at, &["a.srtpack", "meshes/7.obj", "--format", "png"]);
}
