//! `srt pack`: the same picture from a pack as from the scene's own files, and refusals of what is no whole pack.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::support::{folder, good_run_in, names, picture, run_in};

const TETRAHEDRON: &str =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n";

/// A scene in a folder that names meshes beside and above it, one of them by two names.
const SCENE: &str = "sce1.0\neyepos 3 -5 2\neyedir -0.5 1 -0.3\neyeup 0 0 1\nwdist 1\nfovy_deg 40\nnx 40\nny 30\n\
    {\ncp 0.8 0.7 0.3\nobject_flat ../meshes/m.obj\n}\n{\ntranslate 1 0 0\nobject_flat n.obj\n}\n{\ntranslate -1 0 0\nobject_flat ./n.obj\n}\n\
    {\ntranslate 0 0 -1\nobject_flat generate:icosphere:80\n}\npointlight 5 -5 5 1 1 1\nend\n";

/// The scene in `home/scenes` of a folder.
fn write_scene(folder: &Path) {
    fs::create_dir_all(folder.join("home/scenes")).unwrap();
    fs::create_dir_all(folder.join("home/meshes")).unwrap();
    fs::create_dir_all(folder.join("away")).unwrap();
    fs::write(folder.join("home/scenes/a.sce"), SCENE).unwrap();
    fs::write(folder.join("home/meshes/m.obj"), TETRAHEDRON).unwrap();
    fs::write(folder.join("home/scenes/n.obj"), TETRAHEDRON.replace("1 0 0", "2 0 0")).unwrap();
}

#[test]
fn a_pack_is_rendered_as_its_scene_is() {
    let folder = folder();
    let at = folder.path();
    write_scene(at);
    let run = good_run_in(at, &["pack", "home/scenes/a.sce", "-o", "away/a.srtpack"]);
    assert!(run.stderr.starts_with("packed the scene and 3 files, "), "{}", run.stderr);
    let whole = ["home/scenes/a.sce", "whole.exr", "--quiet"];
    good_run_in(at, &whole);
    let whole = fs::read(at.join("whole.exr")).unwrap();
    assert_eq!(picture(&at.join("whole.exr")).width, 40);
    // The scene's own files are gone: all is in the pack.
    let part = |scene: &str, part: &str, file: &str| {
        good_run_in(at, &["part", scene, "--part", part, "-o", file, "--quiet"]);
    };
    part("home/scenes/a.sce", "1/2", "1.srtp");
    fs::rename(at.join("home"), at.join("gone")).unwrap();
    good_run_in(at, &["away/a.srtpack", "packed.exr", "--quiet"]);
    assert!(fs::read(at.join("packed.exr")).unwrap() == whole);
    // Parts from the files and from the pack go together.
    part("away/a.srtpack", "2/2", "2.srtp");
    good_run_in(at, &["assemble", "1.srtp", "2.srtp", "-o", "assembled.exr", "--quiet"]);
    assert!(fs::read(at.join("assembled.exr")).unwrap() == whole);
    // A pack of a pack is the same pack.
    good_run_in(at, &["pack", "away/a.srtpack", "-o", "again.srtpack", "--quiet"]);
    let pack = fs::read(at.join("away/a.srtpack")).unwrap();
    assert!(fs::read(at.join("again.srtpack")).unwrap() == pack);
    assert!(run_in(at, &["check", "away/a.srtpack"]).stdout.contains("a.srtpack: valid"));
}

/// The archive is one for the usual tools, too: what they unpack is the scene.
#[test]
fn a_pack_is_a_tar_archive_with_sums() {
    let folder = folder();
    let at = folder.path();
    write_scene(at);
    good_run_in(at, &["pack", "home/scenes/a.sce", "-o", "away/a.srtpack", "--quiet"]);
    let shell = |command: &str| {
        let out = Command::new("sh").args(["-c", command]).current_dir(at.join("away")).output();
        let out = out.unwrap();
        assert!(out.status.success(), "{}", String::from_utf8_lossy(&out.stderr));
        String::from_utf8(out.stdout).unwrap()
    };
    let listed = shell("tar -tf a.srtpack");
    assert_eq!(listed, "SHA256SUMS\nscenes/a.sce\nmeshes/m.obj\nscenes/n.obj\n");
    shell("tar -xf a.srtpack && sha256sum --check --quiet SHA256SUMS");
    assert_eq!(fs::read_to_string(at.join("away/scenes/a.sce")).unwrap(), SCENE);
    good_run_in(at, &["away/scenes/a.sce", "unpacked.exr", "--quiet"]);
    good_run_in(at, &["away/a.srtpack", "packed.exr", "--quiet"]);
    assert!(fs::read(at.join("unpacked.exr")).unwrap() == fs::read(at.join("packed.exr")).unwrap());
}

#[test]
fn what_is_no_whole_pack_is_refused_by_name() {
    let folder = folder();
    let at = folder.path();
    write_scene(at);
    good_run_in(at, &["pack", "home/scenes/a.sce", "-o", "a.srtpack", "--quiet"]);
    let pack = fs::read(at.join("a.srtpack")).unwrap();
    let refused = |bytes: &[u8], reason: &str| {
        fs::write(at.join("bad.srtpack"), bytes).unwrap();
        let run = run_in(at, &["bad.srtpack", "never.png"]);
        assert_eq!(run.code, 2);
        assert!(run.stderr.contains(reason), "{}", run.stderr);
        assert!(!at.join("never.png").exists());
    };
    let place = |what: &[u8]| pack.windows(what.len()).position(|own| own == what).unwrap();
    let mut altered = pack.clone();
    altered[place(b"v 1 0 0")] = b'#';
    refused(
        &altered,
        "error: cannot read the pack `bad.srtpack`: `meshes/m.obj` in it was altered: its SHA-256 is ",
    );
    refused(
        &pack[..place(b"v 1 0 0")],
        "`meshes/m.obj` is missing in it: it is cut off or altered",
    );
    let mut other = pack.clone();
    other[..10].copy_from_slice(b"SHA255SUMS");
    refused(&other, "error: cannot read the pack `bad.srtpack`: it is cut off or altered: ");
}

#[test]
fn what_cannot_be_packed_is_refused() {
    let folder = folder();
    let at = folder.path();
    write_scene(at);
    let absolute = at.join("home/meshes/m.obj").display().to_string();
    let scene = SCENE.replace("../meshes/m.obj", &absolute);
    fs::write(at.join("home/scenes/absolute.sce"), scene).unwrap();
    fs::write(at.join("home/scenes/bad.sce"), SCENE.replace("n.obj", "none.obj")).unwrap();
    let refused = |scene: &str, output: &str, reason: &str| {
        let run = run_in(at, &["pack", scene, "-o", output]);
        assert_eq!(run.code, 2);
        assert!(run.stderr.contains(reason), "{}", run.stderr);
    };
    let reason = "is an absolute path, which names another file on another machine; name its meshes relative to the scene";
    refused("home/scenes/absolute.sce", "never.srtpack", reason);
    refused("home/scenes/bad.sce", "never.srtpack", "there is no mesh file");
    refused("home/scenes/none.sce", "never.srtpack", "cannot read the scene");
    refused("home/scenes/a.sce", "home/scenes/a.sce", "the pack would replace the scene");
    assert!(!names(at).contains(&"never.srtpack".to_owned()));
}
