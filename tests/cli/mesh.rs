//! `srt mesh`: meshes by rule, as files.

use std::fs;

use srt::assets::generate::MeshKind;

use crate::support::{folder, good_run_in, names, run_in};

#[test]
fn every_kind_makes_a_mesh_that_a_scene_can_use() {
    let folder = folder();
    for kind in MeshKind::ALL.map(MeshKind::name) {
        good_run_in(folder.path(), &["mesh", kind, "--triangles", "2000", "-o", "m.obj"]);
        let text = fs::read_to_string(folder.path().join("m.obj")).unwrap();
        let faces = text.lines().filter(|line| line.starts_with("f ")).count();
        assert!((1700..2300).contains(&faces), "{kind}: {faces}");
        let scene = crate::support::SCENE.replace("generate:torus-knot:1000", "m.obj");
        fs::write(folder.path().join("m.sce"), scene).unwrap();
        let check = good_run_in(folder.path(), &["check", "m.sce"]);
        assert!(check.stdout.contains(&format!("m.obj: {faces} triangles")), "{}", check.stdout);
    }
    assert_eq!(names(folder.path()), ["m.obj", "m.sce", "scene.sce"]);
}

#[test]
fn a_number_that_the_shape_does_not_allow_is_noted() {
    let folder = folder();
    let run = good_run_in(folder.path(), &["mesh", "icosphere", "-n", "100"]);
    assert!(run.stdout.starts_with("v "), "{}", run.stdout);
    let other = "but the shape does not allow every number\n";
    assert_eq!(run.stderr, format!("the icosphere has 80 triangles: 100 were requested, {other}"));
    let least = good_run_in(folder.path(), &["mesh", "hall", "-n", "1"]);
    assert_eq!(least.stderr, "the hall has 168 triangles: 1 were requested, the least is 168\n");
    let more = good_run_in(folder.path(), &["mesh", "icosphere", "-n", "30"]);
    assert!(more.stderr.ends_with(&format!("30 were requested, {other}")), "{}", more.stderr);
    let exact = good_run_in(folder.path(), &["mesh", "soup", "-n", "7"]);
    assert_eq!(exact.stderr, "");
}

#[test]
fn the_seed_decides() {
    let folder = folder();
    let soup =
        |seed| good_run_in(folder.path(), &["mesh", "soup", "-n", "9", "--seed", seed]).stdout;
    assert_eq!(soup("1"), soup("1"));
    assert_ne!(soup("1"), soup("2"));
}

#[test]
fn wrong_kinds_and_numbers_are_refused() {
    let folder = folder();
    for arguments in [
        ["mesh", "teapot", "-n", "10"],
        ["mesh", "soup", "-n", "0"],
        ["mesh", "soup", "-n", "100000001"],
    ] {
        assert_eq!(run_in(folder.path(), &arguments).code, 2, "{arguments:?}");
    }
}
