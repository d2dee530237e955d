//! A small frame of balls in soft light, with either method.

use std::time::Duration;

use criterion::BenchmarkGroup;
use criterion::measurement::WallTime;
use srt::accel::BuildConfig;
use srt::image_io::{Picture, compare};
use srt::render::{Image, Sampling, Settings, Silent, render};
use srt::scene::{Scene, TracedWorld, structure_named};
use srt::scene_file::{ParseOptions, parse};

const SCENE: &str = "sce1.0
eyepos 0 -6 2.5
eyedir 0 1 -0.35
eyeup 0 0 1
wdist 1
fovy_deg 45
nx 96
ny 72
max_recursion 1
aasample 4
triangle -9 -9 0  9 -9 0  0 9 0
cp 0.2 0.2 0.2
ball 0.8 -1.5 0 0.8
ball 0.5 1.5 0 0.5
translate 0 -2 4
arealight 0.7 0.8 0.8 0.8
end
";

pub(crate) fn measure(group: &mut BenchmarkGroup<'_, WallTime>) {
    let parsed = parse(SCENE, &ParseOptions::default()).expect("the scene is valid");
    let scene = Scene::new(&parsed.description, vec![]).expect("the scene can be traced");
    let built = |name| {
        let structure = structure_named(name).expect("it is a structure");
        structure.build(&scene, &BuildConfig::default())
    };
    let (none, bvh) = (built("none"), built("bvh"));
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread starts");
    group.sample_size(20).measurement_time(Duration::from_secs(3));
    for sampling in Sampling::ALL {
        let settings = Settings { sampling, ..Settings::of_scene(&scene) };
        let difference =
            compare(&picture(&scene, &*none, &settings), &picture(&scene, &*bvh, &settings));
        let differing = difference.expect("the pictures are of one size").differing;
        assert_eq!(differing, 0, "{sampling:?}: the picture differs from that of `none`");
        group.bench_function(format!("frame-{}", sampling.name()), |b| {
            pool.install(|| b.iter(|| picture(&scene, &*bvh, &settings)));
        });
    }
}

fn picture(scene: &Scene, tracer: &dyn TracedWorld, settings: &Settings) -> Picture {
    match render(scene, tracer, settings, &Silent).image {
        Image::Color(picture) => picture,
        Image::Scalar { .. } => unreachable!("a colour view was chosen"),
    }
}
