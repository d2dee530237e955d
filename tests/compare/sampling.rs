//! The study of sampling, on a small scene.

use std::time::Duration;

use srt::accel::BuildConfig;
use srt::analysis::{Analysis, Pairing};
use srt::compare::{Plan, Silent, run};
use srt::image_io::Picture;
use srt::math::Color;
use srt::record::{RoundRule, SamplingChapter};
use srt::render::{self, Image, Sampling, Settings, render};
use srt::scene::Scene;
use srt::scene_file::{ParseOptions, parse};

use crate::{SCENE, StopAt, named, plan};

/// A plan of nothing but the study: a structure takes part, but no class of rays is timed.
fn study_plan() -> Plan {
    Plan {
        sampling_study: true,
        classes: vec![],
        budget: Some(Duration::from_secs(6)),
        rounds: RoundRule { warmup: 1, at_least: 6, relative_interval: 1e9 },
        ..plan()
    }
}

fn scene(text: &str) -> Scene {
    Scene::new(&parse(text, &ParseOptions::default()).unwrap().description, vec![]).unwrap()
}

fn chapter(plan: &Plan) -> (SamplingChapter, Analysis, Vec<String>) {
    let comparison = run(plan, &[named("bvh")], &Silent).unwrap().comparison;
    let analysis = Analysis::of(&comparison);
    (comparison.sampling.unwrap(), analysis, comparison.notes)
}

#[test]
fn a_study_gives_figures_and_noise_that_falls() {
    let (chapter, analysis, _) = chapter(&study_plan());
    assert_eq!(chapter.default, Sampling::default().name());
    assert_eq!(analysis.operations.len(), 6);
    for own in &analysis.operations {
        let ns = own.ns.unwrap().value;
        assert!(ns > 0.0 && ns.is_finite(), "{}: {ns}", own.operation);
    }
    assert_eq!(analysis.shares.len(), 4 + 2);
    for own in &analysis.shares {
        let share = own.share.unwrap();
        assert!(share > 0.0 && share < 1.0, "{}: {share}", own.operation);
    }
    let converged = &chapter.converged[0];
    assert!(converged.passes >= 4 && converged.rmse > 0.0);
    for sampling in Sampling::ALL {
        let is_own = |own: &&srt::analysis::NoiseFigures| {
            own.sampling == sampling.name() && own.pairing == Pairing::EqualSamples
        };
        let noise: Vec<f64> =
            analysis.noise.iter().filter(is_own).map(|own| own.rmse.value).collect();
        assert_eq!(noise.len(), 6);
        assert!(noise.windows(2).all(|pair| pair[1] < pair[0]), "{sampling:?}: {noise:?}");
        assert!(noise[5] > converged.rmse, "{noise:?} against {}", converged.rmse);
    }
    let pairs = analysis.noise.iter().filter(|own| own.pairing == Pairing::EqualTime);
    assert!(pairs.count() >= 4, "{:?}", analysis.noise);
}

#[test]
fn shares_are_counts_times_costs() {
    let (chapter, _, _) = chapter(&study_plan());
    let size = &chapter.converged[0];
    let pixels = u64::from(size.width * size.height);
    let count = |sampling: &str, operation: &str| {
        let is_own = |part: &&srt::record::FramePart| {
            part.sampling == sampling && part.operation.contains(operation)
        };
        chapter.parts.iter().find(is_own).map(|part| part.count)
    };
    assert_eq!(count("shuffled", "placing"), Some(16 * pixels));
    assert_eq!(count("shuffled", "shuffling"), Some(pixels), "there is one area light");
    assert_eq!(count("shuffled", "the tables"), Some(1));
    assert_eq!(count("independent", "shuffling"), None);
    let taken = count("shuffled", "taking").unwrap();
    assert!(taken > 4 * pixels && taken < 32 * pixels, "{taken} of {pixels} pixels");
    // The same view rays hit the same surfaces in the last round of both.
    assert!(taken.abs_diff(count("independent", "on the fly").unwrap()) * 20 < taken);
}

#[test]
fn scenes_without_area_lights_are_left_out_and_named() {
    let mut plan = study_plan();
    plan.budget = Some(Duration::from_secs(2));
    plan.scenes[0].scene = scene(&SCENE.replace("arealight 0.7", "pointlight 0 0 0"));
    let (chapter, analysis, notes) = chapter(&plan);
    assert!(analysis.noise.is_empty() && chapter.parts.is_empty());
    assert_eq!(chapter.costs.len(), 6);
    let expected = "balls was left out of the study of sampling: it has no area light.";
    assert!(notes.iter().any(|note| note == expected), "{notes:?}");
}

#[test]
fn a_study_that_is_stopped_is_kept_as_far_as_it_is() {
    let stop = StopAt("balls: sampling", std::sync::atomic::AtomicU64::new(0));
    let comparison = run(&study_plan(), &[named("bvh")], &stop).unwrap().comparison;
    assert!(comparison.run.partial);
    let chapter = comparison.sampling.unwrap();
    assert_eq!((chapter.costs.len(), chapter.noise.len()), (6, 0));
}

/// The mean picture over many seeds, and the standard error of the mean of all of it.
fn mean_of(sampling: Sampling) -> (Color, f32) {
    const SEEDS: u16 = 64;
    let scene = scene(SCENE);
    let world = named("bvh").build(&scene, &BuildConfig::default());
    let means: Vec<Color> = (0..u64::from(SEEDS))
        .map(|seed| {
            let settings = Settings { aa: 2, sampling, seed, ..Settings::of_scene(&scene) };
            let image = render(&scene, &*world, &settings, &render::Silent).image;
            let Image::Color(Picture { pixels, .. }) = image else { panic!("not a picture") };
            pixels.iter().sum::<Color>() / pixels.len() as f32
        })
        .collect();
    let mean = means.iter().sum::<Color>() / f32::from(SEEDS);
    let squares: f32 = means.iter().map(|own| (*own - mean).length_squared()).sum();
    (mean, (squares / f32::from(SEEDS - 1) / f32::from(SEEDS)).sqrt())
}

#[test]
fn both_methods_converge_to_the_same_mean() {
    let (shuffled, error_of_shuffled) = mean_of(Sampling::Shuffled);
    let (independent, error_of_independent) = mean_of(Sampling::Independent);
    let error = error_of_shuffled.hypot(error_of_independent);
    assert!(error < 0.002, "{error}");
    let difference = (shuffled - independent).length();
    assert!(difference < 4.0 * error, "{shuffled} and {independent} differ by {difference}");
}
