//! The libraries that srt is compared with agree with its structures on nearly all rays, have the ids of the scene, and
//! name what they cannot trace.

#![allow(clippy::unwrap_used, reason = "a panic is a failed test")]

mod common;

use common::peers;
use srt::scene::{Structure, structure_named};

fn libraries() -> [Structure; 4] {
    ["obvhs2", "obvhs8", "parry", "svenstaro"].map(|name| *structure_named(name).unwrap())
}

#[test]
fn hits_agree_on_generated_meshes() {
    peers::assert_hits_agree_on_meshes(&libraries(), &["icosphere:20000", "terrain:20000"]);
}

#[test]
fn hits_agree_on_transformed_meshes_and_single_triangles() {
    peers::assert_hits_agree_on_transformed_meshes_and_single_triangles(&libraries());
}

#[test]
fn an_empty_scene_and_a_single_triangle_are_scenes() {
    peers::assert_an_empty_scene_and_a_single_triangle_are_scenes(&libraries());
}

#[test]
fn memory_grows_with_the_scene() {
    for library in libraries() {
        let [small, large] = peers::bytes(&library);
        assert!((0..2).all(|part| large[part] > 5 * small[part]), "{}", library.name);
    }
}

#[test]
fn they_are_compared_as_peers() {
    peers::assert_compared_as_peers(&libraries());
}
