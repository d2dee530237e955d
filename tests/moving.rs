//! Scenes that move: what keys, clocks and deformations make of a scene in each frame, and that its pictures are equal
//! to the bit with every structure and any number of threads in every frame.
#![allow(clippy::unwrap_used, reason = "a panic is a failed test")]

mod common;

use glam::{DAffine3, DVec3};
use srt::accel::{BuildConfig, Update};
use srt::description::{Light, SceneDescription, Shape};
use srt::image_io::{Picture, compare};
use srt::render::{Image, Settings, Silent, render};
use srt::scene::{STRUCTURES, Scene, SceneChange, TracedWorld};
use srt::scene_file::{ParseOptions, parse};
use srt::shapes::Single;

use common::{in_project, load_frame, on_threads, rendered};

const CAMERA: &str =
    "sce1.0\neyepos 0 -5 1\neyedir 0 1 0\neyeup 0 0 1\nwdist 1\nfovy_deg 40\nnx 9\nny 9\n";

/// A scene of the camera and some lines, in a frame.
fn in_frame(lines: &str, frame: u32) -> SceneDescription {
    let text = format!("{CAMERA}{lines}\n");
    let parsed = parse(&text, &ParseOptions { frame, ..ParseOptions::default() });
    parsed.unwrap_or_else(|errors| panic!("frame {frame}: {errors:?}")).description
}

/// Where the balls of radius 1 are.
fn centers(lines: &str, frame: u32) -> Vec<DVec3> {
    let center = |shape: &Shape| match shape {
        Shape::Single(Single::Ball(ball)) => ball.center.as_dvec3(),
        other => panic!("not a ball: {other:?}"),
    };
    in_frame(lines, frame).objects.iter().map(|object| center(&object.shape)).collect()
}

fn xs(lines: &str, frame: u32) -> Vec<f64> {
    centers(lines, frame).iter().map(|center| center.x).collect()
}

#[test]
fn values_go_evenly_from_key_to_key_and_stay_outside() {
    let lines = "at 10 translate 1 0 0\n\n// half of a way\nto 20 translate 3 0 8\nto 40 translate -1 0 0\nball 1 0 0 0";
    let x: Vec<f64> = [0, 10, 15, 20, 25, 30, 40, 99].map(|frame| xs(lines, frame)[0]).to_vec();
    assert_eq!(x, [1.0, 1.0, 2.0, 3.0, 2.0, 1.0, -1.0, -1.0]);
    assert_eq!(centers(lines, 15)[0].z, 4.0);
}

#[test]
fn a_key_alone_is_the_command_itself() {
    let plain = in_frame("translate 1 2 3\nball 1 0 0 0\npointlight 0 0 9 1 1 1", 5);
    let keyed = in_frame("at 3 translate 1 2 3\nball 1 0 0 0\nat 9 pointlight 0 0 9 1 1 1", 5);
    assert_eq!(plain.lights, keyed.lights);
    assert_eq!(plain.objects[0].shape, keyed.objects[0].shape);
}

#[test]
fn a_rotation_turns_by_its_angle_and_keeps_its_axis() {
    let lines = "at 0 rotate 0 0 0 2\nto 90 rotate 90 0 0 2\nscale 1 1 2\ncylinder";
    for frame in [0, 30, 45, 90] {
        let turned = in_frame(lines, frame).objects[0].transform;
        let (sin, cos) = f64::from(frame).to_radians().sin_cos();
        let expected = DVec3::new(cos, sin, 0.0);
        assert!((turned.transform_vector3(DVec3::X) - expected).length() < 1e-15, "{frame}");
    }
}

#[test]
fn two_tracks_of_one_command_are_two_commands() {
    let lines = "at 0 translate 1 0 0\nto 2 translate 2 0 0\nat 0 translate 10 0 0\nto 2 translate 30 0 0\nball 1 0 0 0";
    assert_eq!([0, 1, 2].map(|frame| xs(lines, frame)[0]), [11.0, 21.5, 32.0]);
}

#[test]
fn camera_material_and_lights_have_keys() {
    let lines = "at 0 eyepos 0 -5 1\nto 10 eyepos 10 -5 1\nat 0 cr 0 0 0\nto 10 cr 1 0 0\nball 1 0 0 0\n\
                 at 0 pointlight 0 0 9 1 1 1\nto 10 pointlight 4 0 9 1 1 0\nat 0 ball 1 0 0 0\nto 10 ball 2 0 0 0";
    let scene = in_frame(lines, 5);
    assert_eq!(scene.camera.eye, DVec3::new(5.0, -5.0, 1.0));
    assert_eq!(scene.materials[0].reflectance.x, 0.5);
    assert_eq!((scene.lights.len(), scene.objects.len()), (1, 2));
    let Light::Point { position, color } = &scene.lights[0] else { panic!("a point light") };
    assert_eq!((position.x, color.z), (2.0, 0.5));
    let Shape::Single(Single::Ball(ball)) = scene.objects[1].shape else { panic!("a ball") };
    assert_eq!(ball.radius, 1.5);
}

#[test]
fn delays_add_up_and_periods_come_again() {
    let moving = "at 0 translate 0 0 0\nto 8 translate 8 0 0\nball 1 0 0 0\n";
    let delayed = format!("repeat 3\ndelay 2\n{{\n{moving}}}\nend_repeat");
    assert_eq!(xs(&delayed, 0), [0.0, 0.0, 0.0]);
    assert_eq!(xs(&delayed, 5), [3.0, 1.0, 0.0]);
    let again = format!("repeat 3\ndelay 2\n{{\nevery 8\n{moving}}}\nend_repeat");
    assert_eq!(xs(&again, 0), [6.0, 4.0, 2.0]);
    assert_eq!(xs(&again, 5), [3.0, 1.0, 7.0]);
    assert_eq!(xs(&again, 13), [3.0, 1.0, 7.0]);
    // A `}` takes the clock back, a `pop_matrix` does not.
    let scopes =
        format!("{{\ndelay 2\n}}\n{{\n{moving}}}\npush_matrix\ndelay 1\npop_matrix\n{moving}");
    assert_eq!(xs(&scopes, 5), [5.0, 4.0]);
}

#[test]
fn what_lies_between_two_bounds_stays_there() {
    let lines = "at 0 alpha 1\nto 49 alpha 0.1\nball 1 0 0 0";
    for frame in 0..=49 {
        let alpha = in_frame(lines, frame).materials[0].alpha;
        assert!((0.1..=1.0).contains(&alpha), "{frame}: {alpha}");
    }
}

#[test]
fn a_mesh_is_another_one_with_each_deformation_and_the_same_without() {
    let lines = "{\nat 0 twist 0\nto 10 twist 90\nobject_flat a.obj\n}\nobject_flat a.obj\nwave 0 2 1\nobject_flat a.obj";
    assert_eq!(in_frame(lines, 0).meshes.len(), 1);
    let scene = in_frame(lines, 5);
    let twists: Vec<f64> = scene.meshes.iter().map(|mesh| mesh.deformation.twist).collect();
    assert_eq!(twists, [45.0, 0.0]);
    assert!(scene.objects.iter().all(|object| object.transform == DAffine3::IDENTITY));
    let mesh = |object: usize| match scene.objects[object].shape {
        Shape::Mesh { mesh, .. } => mesh,
        Shape::Single(_) => panic!("not a mesh"),
    };
    assert_eq!([0, 1, 2].map(mesh), [0, 1, 1]);
}

#[test]
fn a_scene_without_keys_is_the_same_in_every_frame() {
    let lines = "translate 1 0 0\nball 1 0 0 0\npointlight 0 0 9 1 1 1";
    assert_eq!(in_frame(lines, 0), in_frame(lines, 1234));
    let text = format!("{CAMERA}{lines}\n");
    assert_eq!(parse(&text, &ParseOptions::default()).unwrap().keyed_frames, None);
    let text = format!("{CAMERA}at -3 {lines}\nto 8.5 translate 0 0 0\n")
        .replace("at -3 translate 1 0 0", "");
    assert!(parse(&text, &ParseOptions::default()).is_err(), "`to` goes on with nothing");
}

#[test]
fn the_keyed_frames_are_known() {
    let text = format!(
        "{CAMERA}at 4 translate 1 0 0\nto 8.5 translate 0 0 0\nat -3 ball 1 0 0 0\npointlight 0 0 9 1 1 1\n"
    );
    assert_eq!(parse(&text, &ParseOptions::default()).unwrap().keyed_frames, Some([-3.0, 8.5]));
}

#[test]
fn structures_and_threads_never_change_a_frame() {
    for (name, frames) in
        [("twist", [13, 40]), ("explosion", [9, 47]), ("crowd", [5, 77]), ("robot-arm", [10, 42])]
    {
        let path = in_project(&format!("scenes/{name}.sce"));
        for frame in frames {
            let scene = load_frame(&path, frame);
            let expected = picture(&scene, "none", 2);
            for structure in &STRUCTURES[1..] {
                for threads in 1..3 {
                    let got = picture(&scene, structure.name, threads);
                    let difference = compare(&expected, &got).unwrap();
                    assert_eq!(difference.differing, 0, "{name} {frame}, {}", structure.name);
                }
            }
        }
        let [first, last] = frames.map(|frame| picture(&load_frame(&path, frame), "bvh8", 2));
        assert!(compare(&first, &last).unwrap().differing > 9, "{name} moves");
    }
}

#[test]
fn structures_that_follow_never_change_a_frame() {
    for (name, frames) in [
        ("twist", [0, 13, 40, 59]),
        // Its parts are meshes of their own from the first deformation on.
        ("explosion", [8, 13, 21, 47]),
        ("crowd", [0, 5, 6, 77]),
        ("robot-arm", [0, 10, 11, 42]),
    ] {
        let path = in_project(&format!("scenes/{name}.sce"));
        let scenes = frames.map(|frame| load_frame(&path, frame));
        let expected = scenes.each_ref().map(|scene| picture(scene, "none", 2));
        let ways = STRUCTURES.iter().flat_map(|own| Update::ALL.map(|update| (own, update)));
        for (structure, update) in ways.filter(|(own, update)| own.can_follow(*update)) {
            for threads in 1..3 {
                on_threads(threads, || {
                    let mut world = structure.build(&scenes[0], &BuildConfig::default());
                    for (pair, expected) in scenes.windows(2).zip(&expected[1..]) {
                        let scene = &pair[1];
                        let change = SceneChange::between(&pair[0], scene).unwrap();
                        assert!(world.refit(&change, update));
                        let got = of_world(scene, world.as_ref());
                        let difference = compare(expected, &got).unwrap();
                        assert_eq!(
                            difference.differing, 0,
                            "{name}, {}, {update:?}",
                            structure.name
                        );
                    }
                });
            }
        }
    }
}

fn small(scene: &Scene) -> Settings {
    Settings { width: 24, height: 16, aa: 1, ..Settings::of_scene(scene) }
}

fn of_world(scene: &Scene, world: &dyn TracedWorld) -> Picture {
    color(render(scene, world, &small(scene), &Silent).image)
}

fn picture(scene: &Scene, structure: &str, threads: usize) -> Picture {
    color(on_threads(threads, || rendered(scene, structure, &small(scene))))
}

fn color(image: Image) -> Picture {
    match image {
        Image::Color(picture) => picture,
        Image::Scalar { .. } => panic!("not a picture"),
    }
}
