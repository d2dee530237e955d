//! A partition of space keeps the contract of `Accel` by the rules for cells, and what breaks one
//! of these rules is found.

#![allow(clippy::unwrap_used, reason = "a panic is a failed test")]

mod common;
#[path = "../examples/kd_tree/mod.rs"]
mod kd_tree;

use srt::accel::{BuildConfig, StructureShape};
use srt::conformance::check;
use srt::image_io::{Picture, compare};
use srt::render::{Image, Settings, Silent, render};
use srt::scene::{Scene, Structure, structure_named};

use kd_tree::KdTree;

#[test]
fn a_kd_tree_keeps_the_contract() {
    let summary = check::<KdTree>().unwrap_or_else(|difference| panic!("{difference}"));
    assert!(summary.hits > 50_000, "{summary}");
}

#[test]
fn planes_without_the_padding_are_found() {
    let difference = check::<KdTree<false, false>>().unwrap_err();
    assert_eq!(difference.mesh, "nested", "{difference}");
}

#[test]
fn an_end_of_the_search_in_the_first_cell_with_a_hit_is_found() {
    let difference = check::<KdTree<true, true>>().unwrap_err();
    assert_eq!(difference.mesh, "nested", "{difference}");
}

#[test]
fn objects_that_several_leaves_refer_to_give_the_same_picture() {
    let kd_tree = Structure::new::<KdTree, KdTree>("kd-tree", "cells cut in two by planes");
    for name in ["dice", "glass"] {
        let scene = common::load(&common::in_project(&format!("scenes/{name}.sce")));
        let world = kd_tree.build(&scene, &BuildConfig::default()).build_report();
        let references = references(&world.objects);
        assert!(references > scene.objects.len() as u64, "{name}: {references} references");
        let none = structure_named("none").unwrap();
        let difference = compare(&picture(&scene, none), &picture(&scene, &kd_tree)).unwrap();
        assert_eq!(difference.differing, 0, "{name}: {difference:?}");
    }
}

/// How many primitives all leaves hold together.
fn references(shape: &StructureShape) -> u64 {
    (0..).zip(&shape.leaf_sizes).map(|(size, leaves)| size * leaves).sum()
}

fn picture(scene: &Scene, structure: &Structure) -> Picture {
    let world = structure.build(scene, &BuildConfig::default());
    let settings = Settings { width: 48, height: 32, aa: 1, ..Settings::of_scene(scene) };
    match render(scene, world.as_ref(), &settings, &Silent).image {
        Image::Color(picture) => picture,
        Image::Scalar { .. } => panic!("not a picture"),
    }
}
