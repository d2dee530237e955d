//! Pictures that are brighter than bytes can hold: warnings, `--exposure` and `--tone-curve`.

use std::fs;
use std::path::Path;

use srt::image_io::{Picture, Tone, ToneCurve};
use srt::scene::STRUCTURES;

use crate::support::{folder, good_run_in, picture, refused, rendered, run_in};

/// Balls that are perfect mirrors and white as well, in a box of such mirrors: each bounce adds light.
const MIRRORS: &str = "sce1.0
eyepos 0 -3.5 0.4
eyedir 0 1 -0.1
eyeup 0 0 1
wdist 1
fovy_deg 60
nx 40
ny 30
max_recursion 10
cp 1 1 1
cr 0.8 0.6 0.4
triangle -9 -9 -1  9 -9 -1  0 9 -1
triangle -9 4 -9  9 4 -9  0 4 9
ball 0.8 -0.9 0 0
ball 0.8 0.9 0 0
pointlight 0 -3 3  1 1 1
end
";

fn mirrors(folder: &Path) {
    fs::write(folder.join("mirrors.sce"), MIRRORS).unwrap();
}

#[test]
fn a_picture_that_is_mostly_clipped_is_warned_of_where_bytes_hold_it() {
    let folder = folder();
    mirrors(folder.path());
    let stderr = |output: &str, options: &[&str]| {
        good_run_in(folder.path(), &[&["mirrors.sce", output], options].concat()).stderr
    };
    for format in ["tga", "png", "ppm"] {
        let warned = stderr(&format!("a.{format}"), &[]);
        assert!(warned.starts_with("warning: "), "{warned}");
        for part in [
            " % of the picture is clipped: ",
            " of 1200 pixels have a channel above 1, the most that",
            &format!(".{format} holds\n  = help: darken it, for example by `--exposure -"),
        ] {
            assert!(warned.contains(part), "{part}: {warned}");
        }
        assert_eq!(warned.lines().count(), 3, "{warned}");
    }
    for format in ["exr", "hdr"] {
        assert!(!stderr(&format!("a.{format}"), &[]).contains("warning"), "{format}");
    }
    assert_eq!(stderr("a.png", &["--quiet"]), "");
    assert!(!stderr("a.png", &["--view", "normal"]).contains("warning"));
    let helped = stderr("a.png", &[]);
    let (_, exposure) = helped.split_once("`--exposure ").unwrap();
    let (exposure, _) = exposure.split_once('`').unwrap();
    assert!(!stderr("a.png", &["--exposure", exposure]).contains("warning"), "{helped}");
    assert!(!stderr("a.png", &["--tone-curve", "filmic"]).contains("warning"));
    // An ordinary scene has nothing to be warned of.
    assert!(!good_run_in(folder.path(), &["scene.sce", "a.png"]).stderr.contains("warning"));
}

#[test]
fn reflectances_above_one_are_warned_of_at_their_line() {
    let folder = folder();
    let scene = MIRRORS
        .replace("cp 1 1 1", "cp 1 1.5 1.000001 // too bright")
        .replace("cr 0.8 0.6 0.4", "repeat 3\ncr 2 1 3e3\ncp 7 .5 1\nend_repeat\ncr 1 1 1");
    fs::write(folder.path().join("bright.sce"), scene).unwrap();
    let run = run_in(folder.path(), &["check", "bright.sce"]);
    assert_eq!(run.code, 0);
    insta::assert_snapshot!("reflectances_above_one", run.stderr);
    let rendered = good_run_in(folder.path(), &["bright.sce", "a.exr"]);
    assert!(rendered.stderr.starts_with(&run.stderr), "{}", rendered.stderr);
    assert_eq!(good_run_in(folder.path(), &["bright.sce", "a.exr", "-q"]).stderr, "");
}

#[test]
fn neither_structure_nor_threads_nor_crop_change_a_byte_of_a_toned_picture() {
    let folder = folder();
    mirrors(folder.path());
    let bytes = |name: &str, options: &[&str]| {
        good_run_in(folder.path(), &[&["mirrors.sce", name], options].concat());
        fs::read(folder.path().join(name)).unwrap()
    };
    for curve in ToneCurve::ALL.map(ToneCurve::name) {
        let tone = ["--exposure", "-0.7", "--tone-curve", curve];
        let reference =
            bytes("a.png", &[&tone[..], &["--accel", "none", "--threads", "1"]].concat());
        for structure in STRUCTURES {
            for threads in ["1", "2"] {
                let options = ["--accel", structure.name, "--threads", threads];
                assert!(
                    bytes("b.png", &[&tone[..], &options].concat()) == reference,
                    "{options:?}"
                );
            }
        }
        bytes("crop.png", &[&tone[..], &["--crop", "5,4,31,27"]].concat());
        let part = picture(&folder.path().join("crop.png"));
        let whole = picture(&folder.path().join("a.png"));
        assert!((0..23).all(|y| (0..26).all(|x| whole.get(x + 5, y + 4) == part.get(x, y))));
    }
}

#[test]
fn the_picture_is_that_of_the_light_with_the_tone_applied() {
    let folder = folder();
    mirrors(folder.path());
    let run = |name: &str, options: &[&str]| {
        good_run_in(folder.path(), &[&["mirrors.sce", name], options].concat());
        picture(&folder.path().join(name))
    };
    let light = run("light.exr", &[]);
    let byte = |c: f32| (c.clamp(0.0, 1.0) * 255.0) as u8;
    let bytes = |picture: &Picture| -> Vec<u8> {
        picture.pixels.iter().flat_map(|color| color.to_array().map(byte)).collect()
    };
    for (exposure, curve) in [
        (0.0, ToneCurve::None),
        (-2.5, ToneCurve::None),
        (0.0, ToneCurve::Reinhard),
        (1.25, ToneCurve::Filmic),
    ] {
        let tone = ["--exposure", &exposure.to_string(), "--tone-curve", curve.name()];
        let mut expected = light.clone();
        Tone { exposure, curve }.apply(&mut expected);
        let options = if exposure == 0.0 && curve == ToneCurve::None { &[][..] } else { &tone };
        assert_eq!(bytes(&run("a.ppm", options)), bytes(&expected), "{tone:?}");
    }
    // What is off by default changes nothing when it is asked for.
    let off = ["--exposure", "0", "--tone-curve", "none"];
    assert!(rendered(folder.path(), "a.tga", &off) == rendered(folder.path(), "b.tga", &[]));
}

#[test]
fn wrong_tones_are_refused_with_what_would_be_right() {
    for bad in ["bright", "33", "-32.5", "nan", "inf", "1,5", ""] {
        let expected = "expected a number of stops from -32 to 32, such as -1.5";
        refused(&["scene.sce", "a.png", "--exposure", bad], &[expected]);
    }
    refused(
        &["scene.sce", "a.png", "--tone-curve", "aces"],
        &["invalid value 'aces'", "none, reinhard, filmic"],
    );
    let floats = ".exr holds the light as it is, and what shows it chooses the exposure";
    refused(&["scene.sce", "a.exr", "--exposure", "1"], &[floats]);
    refused(&["scene.sce", "a.hdr", "--tone-curve", "reinhard"], &["are for .tga, .png and .ppm"]);
    refused(
        &["scene.sce", "a.png", "--view", "depth", "--exposure", "1"],
        &["--view depth shows none"],
    );
}
