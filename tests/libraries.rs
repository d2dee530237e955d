//! The libraries that srt is compared with agree with its structures on nearly all rays, have the ids of the scene, and
//! name what they cannot trace. Where a library only builds the tree, and this project's walk and formula answer, hits
//! are equal to the bit.

#![allow(clippy::unwrap_used, reason = "a panic is a failed test")]

mod common;

use common::peers;
use srt::accel::BuildConfig;
use srt::conformance::Limits;
use srt::math::{Hit, Ray};
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

/// The structures that take a binary tree, with those of the libraries.
fn with_trees_of_libraries(structures: &[&str]) -> Vec<Structure> {
    let with = |name: &&str, builder| {
        let options = format!("builder={builder}");
        structure_named(name).unwrap().with_options(&options).unwrap()
    };
    let both = structures.iter().flat_map(|name| ["parry", "svenstaro"].map(|one| with(name, one)));
    both.collect()
}

/// On meshes and rays that are made to find differences, meshes without an area and of many equal triangles among
/// them.
#[test]
fn trees_of_libraries_give_equal_hits() {
    for structure in with_trees_of_libraries(&["bvh", "bvh8"]) {
        let checked = structure.check(&Limits::NONE).expect("it is no peer");
        let summary = checked.unwrap_or_else(|error| panic!("{}: {error}", structure.name));
        assert!(summary.rays > 50_000, "{}: {} rays", structure.name, summary.rays);
    }
}

#[test]
fn trees_of_libraries_give_equal_hits_in_scenes() {
    let same = |(a, b): (&Hit, &Hit)| a.same_bits(b);
    let scenes = [
        "",
        "triangle 0 0 0  1 0 0  0 1 0",
        "object_flat generate:terrain:2000\n\
         {\ntranslate 0 0 0.2\nrotate 40 1 2 3\nscale 0.5 0.7 0.3\nobject_flat generate:icosphere:1000\n}\n\
         ball 0.3 0 0 0.4\ntriangle -3 -3 -1  3 -3 -1  0 3 -1",
    ];
    for objects in scenes {
        let scene = peers::scene(objects);
        // Of an empty scene there is no box to put rays into.
        let rays = match objects {
            "" => vec![Ray::new(glam::Vec3::ZERO, glam::Vec3::X); 17],
            _ => peers::rays(&scene).into_iter().step_by(7).collect(),
        };
        let of = |structure: &Structure| {
            peers::answers(&*structure.build(&scene, &BuildConfig::default()), &rays)
        };
        let none = of(structure_named("none").unwrap());
        assert!(objects.is_empty() || none.1.contains(&true), "hits that say something");
        for structure in with_trees_of_libraries(&["bvh", "bvh8", "cwbvh", "balls", "kdop"]) {
            let own = of(&structure);
            assert!(none.0.iter().zip(&own.0).all(same), "{}: {objects}", structure.name);
            assert_eq!(none.1, own.1, "{}: {objects}", structure.name);
        }
    }
}

#[test]
fn a_structure_with_a_tree_of_a_library_is_saved_and_read() {
    let scene = peers::scene("object_flat generate:terrain:2000");
    let rays = peers::rays(&scene);
    for structure in with_trees_of_libraries(&["bvh", "bvh8"]) {
        let mut file = Vec::new();
        structure.save(&scene, &BuildConfig::default(), &mut file).unwrap();
        let size = file.len() as u64;
        let read = structure.load(&scene, &mut &file[..], size).unwrap();
        let built = structure.build(&scene, &BuildConfig::default());
        let [read, built] = [read, built].map(|world| peers::answers(&*world, &rays));
        assert!(read.0.iter().zip(&built.0).all(|(a, b)| a.same_bits(b)) && read.1 == built.1);
    }
}
