//! Whole pictures: how much faster two threads are than one, and what share of the threads' time
//! goes into all that is not tracing. In interleaved rounds instead of criterion's samples, because
//! the result is a ratio.

#![allow(clippy::print_stdout, reason = "a bench reports to the terminal")]

use glam::DVec3;
use srt::accel::BuildConfig;
use srt::assets::generate::{MeshKind, generate};
use srt::compare::measure::fixed_rounds;
use srt::description::Light;
use srt::image_io::{Picture, compare};
use srt::math::Color;
use srt::render::{Image, RenderStats, Rendering, Settings, Silent, render};
use srt::scene::{Scene, TracedWorld, structure_named};

use crate::knot;

/// Rounds, each of which renders every picture with one thread and with two.
const ROUNDS: usize = 9;

/// Side of the square picture in pixels, and of the one that `none` has to render too.
const SIDE: u32 = 320;
const SMALL_SIDE: u32 = 12;

/// A picture that is rendered over and over.
struct Frame {
    name: &'static str,
    scene: Scene,
    world: Box<dyn TracedWorld>,
}

/// Measures and prints, with the default structure.
pub(crate) fn measure() {
    let pools = [1, 2].map(|threads| {
        rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads start")
    });
    for frame in [frame("matte knot", Color::ZERO), frame("mirroring knot", Color::splat(0.3))] {
        let settings = settings(&frame.scene, SIDE);
        let run = |pool: &rayon::ThreadPool| {
            pool.install(|| render(&frame.scene, &*frame.world, &settings, &Silent))
        };
        frame.check(&pools[0]);
        assert!(same(run(&pools[0]), run(&pools[1])), "threads change the picture");
        let rounds = fixed_rounds(2, ROUNDS, |index| run(&pools[index]).stats);
        let seconds = |stats: &RenderStats| stats.time.as_secs_f64();
        let pairs = rounds[0].iter().zip(&rounds[1]);
        let speedups = pairs.map(|(one, two)| seconds(one) / seconds(two)).collect();
        let outside = |stats: &RenderStats| stats.thread_times.outside_tracing_share();
        let shares = rounds[0].iter().filter_map(outside).collect();
        println!("frames/{}: {SIDE} × {SIDE}, {ROUNDS} rounds, median (least – most)", frame.name);
        println!("    two threads against one   {}", spread(speedups, 1.0, " ×"));
        println!("    outside tracing           {}", spread(shares, 100.0, " %"));
    }
}

/// A knot under an area light; what it mirrors is itself.
fn frame(name: &'static str, specular: Color) -> Frame {
    let mut description = knot::description();
    description.options.max_recursion = 2;
    description.materials[0].specular = specular;
    description.lights.push(Light::Area {
        center: DVec3::new(-3.0, -2.0, 4.0),
        half_u: DVec3::new(1.0, 0.0, 0.0),
        half_v: DVec3::new(0.0, 1.0, 0.0),
        color: Color::ONE,
    });
    let mesh = std::sync::Arc::new(generate(MeshKind::TorusKnot, 70_000, 1));
    let scene = Scene::new(&description, vec![mesh]).expect("the scene can be traced");
    let world = built(&scene, "bvh8");
    Frame { name, scene, world }
}

fn built(scene: &Scene, name: &str) -> Box<dyn TracedWorld> {
    structure_named(name).expect("it is a structure").build(scene, &BuildConfig::default())
}

/// 4 × 4 samples of a pixel, each with 4 × 4 of the light.
fn settings(scene: &Scene, side: u32) -> Settings {
    Settings { width: side, height: side, aa: 4, light_samples: 4, ..Settings::of_scene(scene) }
}

impl Frame {
    /// # Panics
    /// If a small picture differs from that of `none`: what is wrong is not measured.
    fn check(&self, pool: &rayon::ThreadPool) {
        let settings = settings(&self.scene, SMALL_SIDE);
        let none = built(&self.scene, "none");
        let [expected, got] = [&none, &self.world]
            .map(|world| pool.install(|| render(&self.scene, &**world, &settings, &Silent)));
        assert!(same(expected, got), "the picture differs from that of `none`");
    }
}

fn same(a: Rendering, b: Rendering) -> bool {
    let difference = compare(&picture(a), &picture(b)).expect("the pictures are of one size");
    difference.differing == 0
}

fn picture(rendering: Rendering) -> Picture {
    match rendering.image {
        Image::Color(picture) => picture,
        Image::Scalar { .. } => unreachable!("a colour view was chosen"),
    }
}

fn spread(mut values: Vec<f64>, factor: f64, unit: &str) -> String {
    values.sort_by(f64::total_cmp);
    let of = |index: usize| factor * values[index];
    let (least, middle, most) = (of(0), of(values.len() / 2), of(values.len() - 1));
    format!("{middle:.2}{unit} ({least:.2} – {most:.2})")
}
