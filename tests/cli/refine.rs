//! `--progressive`, `--time`, `--noise`, `--checkpoint`, `--resume`: the same picture, whole at all times, from
//! wherever it was left.

use std::fs;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use serde_json::Value;

use crate::support::{
    Run, SCENE, folder, good_run_in, is_ignored, names, picture, refused, rendered, run_in, send,
};

/// Passes of some hundred milliseconds each, and minutes in all.
const SLOW: [&str; 8] = ["--accel", "none", "--aa", "16", "--size", "160x120", "--threads", "1"];

fn spawn(folder: &Path, arguments: &[&str]) -> Child {
    Command::new(assert_cmd::cargo::cargo_bin!("srt"))
        .args(arguments)
        .current_dir(folder)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

fn figures(run: &Run) -> Value {
    serde_json::from_str(&run.stdout).unwrap()
}

#[test]
fn passes_add_up_to_the_picture_of_one_go() {
    let folder = folder();
    for options in [
        &[][..],
        &["--aa", "0"],
        &["--aa", "5", "--seed", "3"],
        &["--aa", "17", "--size", "9x7", "--sampling", "independent"],
        &["--view", "depth"],
    ] {
        let whole = rendered(folder.path(), "whole.exr", options);
        let passes = [options, &["--progressive"]].concat();
        assert!(rendered(folder.path(), "passes.exr", &passes) == whole, "{options:?}");
        let saved = [options, &["--checkpoint", "a.srtc"]].concat();
        assert!(rendered(folder.path(), "saved.exr", &saved) == whole, "{options:?}");
        // A checkpoint of all of it is the picture.
        let run = good_run_in(
            folder.path(),
            &[&["scene.sce", "again.exr", "--resume", "--stats=json"], &saved[..]].concat(),
        );
        assert!(run.stderr.contains("going on from `a.srtc`: 100 % is rendered"), "{}", run.stderr);
        assert_eq!(figures(&run)["rays"], 0);
        assert!(fs::read(folder.path().join("again.exr")).unwrap() == whole, "{options:?}");
        fs::remove_file(folder.path().join("a.srtc")).unwrap();
    }
}

#[test]
fn time_stops_it_and_it_goes_on() {
    let folder = folder();
    let slow = [&["scene.sce", "a.exr"], &SLOW[..]].concat();
    let timed = ["--time", "700ms", "--checkpoint", "a.srtc", "--stats=json"];
    let run = good_run_in(folder.path(), &[&slow[..], &timed].concat());
    let stopped = figures(&run);
    assert_eq!((&stopped["stopped_by"], &stopped["partial"]), (&"time".into(), &true.into()));
    let samples = stopped["samples_per_pixel"].as_f64().unwrap();
    assert!(samples < 256.0);
    assert!(run.stderr.contains("(stopped by --time: "), "{}", run.stderr);
    assert!(run.stderr.contains("`a.srtc` has what is rendered: --resume"), "{}", run.stderr);
    assert_eq!(picture(&folder.path().join("a.exr")).width, 160);
    let more = ["--time", "300ms", "--resume", "--checkpoint", "a.srtc", "--stats=json"];
    let more = figures(&good_run_in(folder.path(), &[&slow[..], &more].concat()));
    assert!(more["samples_per_pixel"].as_f64().unwrap() >= samples);
}

#[test]
fn little_noise_stops_it_at_a_pass_that_is_always_the_same() {
    let folder = folder();
    let stopped = |name: &str, noise: &str, threads: &str| {
        let options = ["--aa", "16", "--noise", noise, "--threads", threads, "--stats=json"];
        let run = good_run_in(folder.path(), &[&["scene.sce", name], &options[..]].concat());
        (figures(&run), run.stderr, fs::read(folder.path().join(name)).unwrap())
    };
    let (two, text, picture) = stopped("a.exr", "0.02", "2");
    assert_eq!(two["stopped_by"], "noise");
    assert!(two["noise"].as_f64().unwrap() <= 0.02, "{two}");
    let samples = two["samples_per_pixel"].as_f64().unwrap();
    assert!((4.0..256.0).contains(&samples) && samples.log2().fract() == 0.0, "{samples}");
    assert!(text.contains("(stopped by --noise: ") && text.contains(", noise 0.0"), "{text}");
    let (one, _, same) = stopped("b.exr", "0.02", "1");
    assert_eq!(one["noise"], two["noise"]);
    assert!(picture == same);
    // Less noise takes more samples.
    let (less, ..) = stopped("c.exr", "0.01", "2");
    assert!(less["samples_per_pixel"].as_f64().unwrap() > samples);
    let (all, text, _) = stopped("d.exr", "0.000001", "2");
    assert!(all["stopped_by"].is_null() && all["samples_per_pixel"] == 256.0);
    assert!(text.contains("with all 256 samples a pixel, more than 0.000001"), "{text}");
}

#[test]
fn a_signal_leaves_what_there_is() {
    for (signal, number) in [("INT", 2), ("TERM", 15)] {
        if is_ignored(number) {
            continue;
        }
        let folder = folder();
        let arguments =
            [&["scene.sce", "a.png", "--progressive", "--stats=json"], &SLOW[..]].concat();
        let child = spawn(folder.path(), &arguments);
        // The first picture shows that it renders.
        while !folder.path().join("a.png").exists() {
            std::thread::sleep(Duration::from_millis(20));
        }
        let first = picture(&folder.path().join("a.png"));
        assert!(first.pixels.iter().all(|pixel| pixel.max_element() > 0.0), "it is whole");
        std::thread::sleep(Duration::from_millis(300));
        send(child.id(), signal);
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(128 + number));
        assert_eq!(names(folder.path()), ["a.png", "scene.sce"]);
        let figures: Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(figures["stopped_by"], "signal");
        let samples = figures["samples_per_pixel"].as_f64().unwrap();
        assert!((1.0..256.0).contains(&samples), "{samples}");
        assert!(picture(&folder.path().join("a.png")).pixels.iter().all(|p| p.max_element() > 0.0));
    }
}

#[test]
fn killed_at_any_time_it_goes_on_to_the_same_picture() {
    let folder = folder();
    let at = folder.path();
    let slow = ["scene.sce", "a.exr", "--accel", "none", "--aa", "12", "--size", "48x36"];
    let begun = std::time::Instant::now();
    let whole =
        good_run_in(at, &[&["scene.sce", "whole.exr", "--stats=json"], &slow[2..]].concat());
    let all = begun.elapsed();
    let saved = ["--checkpoint", "a.srtc", "--checkpoint-interval", "20ms", "--resume", "--quiet"];
    // Passes in turns with one go: either goes on with what the other left.
    let mut random = srt::math::Random::new(&[20]);
    for kill in 0..20 {
        let passes: &[&str] = if kill % 2 == 0 { &["--progressive"] } else { &[] };
        let threads: &[&str] =
            if kill % 3 == 0 { &["--threads", "1"] } else { &["--threads", "2"] };
        let mut child = spawn(at, &[&slow, &saved[..], passes, threads].concat());
        // All of them together do not come to the end.
        std::thread::sleep(all.mul_f32(0.1 * random.next_f32()));
        child.kill().unwrap();
        child.wait().unwrap();
        if at.join("a.exr").exists() {
            // A picture of a pass, or the end.
            assert_eq!(picture(&at.join("a.exr")).width, 48);
        }
    }
    // Another structure may end what one began.
    let ended = ["scene.sce", "a.exr", "--aa", "12", "--size", "48x36"];
    let saved = [&saved[..4], &["--resume", "--stats=json"]].concat();
    let run = good_run_in(at, &[&ended[..], &saved].concat());
    let rays = |run: &Run| figures(run)["classes"][0]["rays"].as_u64().unwrap();
    assert!(rays(&run) < rays(&whole), "it goes on with what was saved");
    assert!(run.stderr.contains("going on from `a.srtc`: "), "{}", run.stderr);
    let bytes = |name: &str| fs::read(at.join(name)).unwrap();
    assert!(bytes("a.exr") == bytes("whole.exr"));
}

#[test]
fn checkpoints_of_other_pictures_and_damaged_ones_are_refused() {
    let folder = folder();
    let at = folder.path();
    good_run_in(at, &["scene.sce", "a.png", "--checkpoint", "a.srtc"]);
    let bytes = fs::read(at.join("a.srtc")).unwrap();
    let resume = |options: &[&str]| {
        let arguments = ["scene.sce", "b.png", "--checkpoint", "a.srtc"];
        let Run { code, stderr, .. } = run_in(at, &[&arguments, options].concat());
        assert_eq!(code, 2, "{stderr}");
        assert!(!at.join("b.png").exists() && fs::read(at.join("a.srtc")).unwrap() == bytes);
        stderr
    };
    let text = resume(&[]);
    assert!(text.contains("it is there already: go on with it by --resume"), "{text}");
    let text = resume(&["--resume", "--seed", "2"]);
    let expected =
        "cannot resume from `a.srtc`: it is of another picture: it has --seed 0 in place of 2";
    assert!(text.contains(expected), "{text}");
    let text = resume(&["--resume", "--aa", "4"]);
    assert!(text.contains("it has --aa 2 in place of 4"), "{text}");
    fs::write(at.join("scene.sce"), SCENE.replace("0.4 0.6 0.9", "0.4 0.6 0.8")).unwrap();
    let text = resume(&["--resume"]);
    assert!(text.contains("it has a scene with hash "), "{text}");
    fs::write(at.join("scene.sce"), SCENE).unwrap();

    // Of another version, with the right hash.
    let mut older = srt::part_file::PartFile::decode(&bytes).unwrap();
    older.origin.version = "0.0.9".to_owned();
    let refuses = |bytes: &[u8], text: &str| {
        fs::write(at.join("bad.srtc"), bytes).unwrap();
        let arguments = ["scene.sce", "b.png", "--checkpoint", "bad.srtc", "--resume"];
        let Run { code, stderr, .. } = run_in(at, &arguments);
        assert_eq!(code, 2, "{stderr}");
        let named = stderr.contains("cannot resume from `bad.srtc`: ");
        assert!(named && stderr.contains(text), "{text}: {stderr}");
    };
    let mut written = Vec::new();
    older.write(&mut written).unwrap();
    refuses(&written, "it has a renderer of version 0.0.9 in place of ");
    older.origin.version = env!("CARGO_PKG_VERSION").to_owned();
    older.origin.sources[0] ^= 1;
    written.clear();
    older.write(&mut written).unwrap();
    refuses(&written, "it has a renderer of sources ");
    let mut altered = bytes.clone();
    altered[400] ^= 1;
    refuses(&altered, "it was altered");
    refuses(&bytes[..bytes.len() / 2], "it was cut off");
    refuses(b"", "it does not begin with `srt-part`");
    good_run_in(at, &["part", "scene.sce", "--part", "1/1", "-o", "part.srtp"]);
    refuses(&fs::read(at.join("part.srtp")).unwrap(), "it is part 1/1 of a picture");
}

#[test]
fn bad_options_of_refining_are_refused() {
    fn with<'a>(options: &[&'a str]) -> Vec<&'a str> {
        [&["scene.sce", "a.png"], options].concat()
    }
    refused(&with(&["--time", "soon"]), &["expected a time above 0 with its unit"]);
    refused(&with(&["--noise", "2"]), &["expected an error above 0 and below 1"]);
    refused(&with(&["--resume"]), &["--checkpoint <FILE>"]);
    refused(&with(&["--checkpoint-interval", "1s"]), &["--checkpoint <FILE>"]);
    refused(&with(&["--checkpoint", "scene.sce"]), &["replace the scene"]);
    refused(&with(&["--checkpoint", "a.png"]), &["it is the file of the picture"]);
    refused(&with(&["--checkpoint", "no/a.srtc"]), &["there is no folder"]);
    refused(&with(&["--checkpoint", "-"]), &["it is no file"]);
    let heat = with(&["--checkpoint", "a", "--view", "heatmap"]);
    refused(&heat, &["--checkpoint is for what is the same whatever the structure"]);
    refused(&with(&["--progressive", "--view", "heatmap"]), &["cannot be refined in passes"]);
    refused(&with(&["--noise", "0.1", "--view", "heatmap"]), &["cannot be refined in passes"]);
    for view in ["normal", "depth", "object", "primitive", "cells"] {
        let parts = [&*format!("--view {view} has none"), "leave --noise out"];
        refused(&with(&["--aa", "4", "--noise", "0.1", "--view", view]), &parts);
    }
}
