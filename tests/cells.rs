//! What `--view cells` shows, against closed forms.

#![allow(clippy::unwrap_used, reason = "a panic is a failed test")]

use srt::accel::{BoundingBall, BuildConfig};
use srt::math::Color;
use srt::render::{Image, Settings, Silent, View, render};
use srt::scene::{STRUCTURES, Scene, Structure, structure_named};
use srt::scene_file::{ParseOptions, parse};

/// A pixel is 1/20 of a unit in the plane y = 0, the middle of the picture is the origin.
const SIDE: u32 = 161;
const PIXEL: f64 = 0.05;

/// One ball around all objects; in the table `ball` has one around each mesh alone.
const ONE_BALL: Structure = Structure::new::<BoundingBall, BoundingBall>("one-ball", "one ball");

fn scene(objects: &str) -> Scene {
    // From so far that rays are nearly parallel.
    let (distance, half) = (1000.0, 0.5 * PIXEL * f64::from(SIDE));
    let angle = 2.0 * (half / distance).atan().to_degrees();
    let text = format!(
        "sce1.0\neyepos 0 -{distance} 0\neyedir 0 1 0\neyeup 0 0 1\nwdist 1\nfovy_deg {angle}\n\
         nx {SIDE}\nny {SIDE}\n{objects}\npointlight 0 -9 9 1 1 1\nend\n"
    );
    let parsed = parse(&text, &ParseOptions::default()).unwrap();
    Scene::new(&parsed.description, vec![]).unwrap()
}

/// What is seen at points of the plane y = 0.
fn seen(scene: &Scene, structure: &Structure) -> impl Fn(f64, f64) -> Color + use<> {
    let world = structure.build(scene, &BuildConfig::default());
    let settings = Settings { view: View::Cells, ..Settings::of_scene(scene) };
    let Image::Color(picture) = render(scene, &*world, &settings, &Silent).image else {
        panic!("not colours")
    };
    move |x, z| {
        let place = |along: f64| (0.5 * f64::from(SIDE - 1) + along / PIXEL).round() as usize;
        picture.pixels[(SIDE as usize - 1 - place(z)) * SIDE as usize + place(x)]
    }
}

fn tree() -> &'static Structure {
    structure_named("bvh").unwrap()
}

fn is_grey(color: Color) -> bool {
    (color.x - color.y).abs() < 1e-6 && (color.y - color.z).abs() < 1e-6
}

#[test]
fn leaves_of_a_tree_are_boxes() {
    let seen = seen(&scene("ball 1 -2 0 0\nball 1 2 0 0"), tree());
    // The corners of the boxes, where the balls are not, and the way between them.
    for x in [-2.9, -1.1, 1.1, 2.9] {
        for z in [-0.9, 0.9] {
            assert!(!is_grey(seen(x, z)), "{x} {z}");
        }
        assert_eq!(seen(x, 1.1), Color::ZERO);
    }
    assert_eq!(seen(0.0, 0.0), Color::ZERO);
    // Each has a colour of its own, and a rim.
    assert_eq!(seen(-2.5, 0.5), seen(-1.5, -0.5));
    assert_ne!(seen(-2.0, 0.0), seen(2.0, 0.0));
    let along: Vec<f32> = (0..24).map(|i| seen(-2.0 + PIXEL * f64::from(i), 0.0).x).collect();
    let rims = along.iter().filter(|&&light| light > 0.0 && light < 0.9 * along[0]).count();
    assert_eq!(rims, 1, "{along:?}");
}

#[test]
fn a_ball_is_round_and_brightest_in_its_middle() {
    let seen = seen(&scene("ball 1 -2 0 0\nball 1 2 0 0"), &ONE_BALL);
    // Its centre is the mean of the boxes, and its radius reaches to their corners.
    let radius = f64::from(9.0f32 + 1.0 + 1.0).sqrt();
    let middle = seen(0.0, 0.0);
    assert!(!is_grey(middle));
    for (x, z) in [(1.0, 0.0), (0.0, 1.0), (-0.6, -0.8), (0.8, -0.6)] {
        let at = |distance: f64| seen(distance * x, distance * z);
        assert_eq!(at(radius + 2.0 * PIXEL), Color::ZERO);
        assert!(!is_grey(at(radius - 2.0 * PIXEL)));
        assert!(at(radius - 4.0 * PIXEL).x < 0.75 * middle.x);
    }
}

#[test]
fn a_leaf_in_which_the_eye_is_is_not_entered() {
    // The large ball is hit from within, beside the small one's box.
    let seen = seen(&scene("ball 2000 0 0 0\nball 1 0 0 0"), tree());
    assert!(!is_grey(seen(0.9, 0.9)));
    let beside = seen(2.0, 0.0);
    assert!(is_grey(beside) && beside.x > 0.2);
}

#[test]
fn every_structure_over_objects_shows_its_cells() {
    let scene = scene("scatter mixed:200:1");
    for structure in STRUCTURES {
        let seen = seen(&scene, structure);
        let has_cells = !["none", "ball"].contains(&structure.name);
        let colored = (-16..16).any(|i| !is_grey(seen(f64::from(i) * PIXEL, 0.05)));
        assert_eq!(colored, has_cells, "{}", structure.name);
    }
}
