//! `srt compare --save-rays`, `--rays`, and `srt rays`: the same rays again, other programs' rays, refusals.

use std::fs;
use std::path::Path;

use serde_json::Value;
use srt::math::Hit;
use srt::ray_file::{RayAnswers, RayFile};

use crate::support::{Run, SCENE, folder, good_run_in, refused, run_in};

const QUICK: [&str; 8] =
    ["--budget", "8", "--rounds", "3", "--threads", "2", "--accel", "none,bvh"];

fn compare(folder: &Path, options: &[&str]) -> Run {
    run_in(folder, &[&["compare", "scene.sce"], &QUICK[..], options].concat())
}

/// Two balls over a ground and what is mirrored in one, with `rays/scene.srtrays`; and the record.
fn saved() -> (tempfile::TempDir, Value) {
    let folder = folder();
    let run = compare(folder.path(), &["--save-rays", "rays", "--out", "first"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let record = record(folder.path(), "first");
    (folder, record)
}

fn record(folder: &Path, out: &str) -> Value {
    serde_json::from_slice(&fs::read(folder.join(out).join("report.json")).unwrap()).unwrap()
}

fn file(folder: &Path) -> Vec<u8> {
    fs::read(folder.join("rays/scene.srtrays")).unwrap()
}

fn hexadecimal(hash: &[u8]) -> String {
    hash.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// The classes of a structure, with their recorded rays, and how many of them hit something if all were counted.
fn classes(record: &Value, structure: usize) -> Vec<(String, u64, Option<u64>)> {
    let classes = record["scenes"][0]["structures"][structure]["classes"].as_array().unwrap();
    let class = |own: &Value| {
        let number = |name: &str| own[name].as_u64().unwrap();
        let rays = own["sample"]["of_rays"].as_u64().unwrap_or_else(|| number("rays"));
        let hits = (number("counted_rays") == rays).then(|| number("hits"));
        (own["class"].as_str().unwrap().to_owned(), rays, hits)
    };
    classes.iter().map(class).collect()
}

#[test]
fn saved_rays_are_measured_again_with_the_same_hits_and_the_same_hash() {
    let (folder, first) = saved();
    let bytes = file(folder.path());
    let rays = RayFile::decode(&bytes).unwrap();
    assert_eq!(rays.encode(), bytes);
    let hash = hexadecimal(&rays.hash());
    let saved = &first["scenes"][0]["rays"];
    assert_eq!((saved["hash"].as_str(), saved["replayed"].as_bool()), (Some(&*hash), Some(false)));

    let again = compare(folder.path(), &["--rays", "rays/scene.srtrays", "--out", "second"]);
    assert_eq!(again.code, 0, "{}", again.stderr);
    let second = record(folder.path(), "second");
    let replayed = &second["scenes"][0]["rays"];
    assert_eq!(replayed["hash"].as_str(), Some(&*hash));
    assert_eq!(replayed["geometry"].as_str(), Some(&*hexadecimal(&rays.geometry)));
    assert_eq!(replayed["replayed"].as_bool(), Some(true));
    for record in [&first, &second] {
        let of_bvh = classes(record, 1);
        assert_eq!(of_bvh.len(), rays.classes.len());
        for (class, count, hits) in of_bvh {
            let own = rays.classes.iter().find(|own| own.class.name() == class).unwrap();
            assert_eq!(own.rays.len() as u64, count, "{class}");
            assert!(hits.is_none_or(|hits| own.answers.hit_count() as u64 == hits), "{class}");
        }
    }
    for form in ["report.md", "report.html"] {
        let text = fs::read_to_string(folder.path().join("second").join(form)).unwrap();
        assert!(text.contains(&hash) && text.contains("Rays read from a file: "), "{form}");
    }
    assert!(again.stdout.contains(&format!("Rays read from a file: SHA-256 {hash}")));

    let info = good_run_in(folder.path(), &["rays", "info", "rays/scene.srtrays"]).stdout;
    assert!(info.contains(&hash) && info.contains(&hexadecimal(&rays.geometry)), "{info}");
    for class in &rays.classes {
        assert!(
            info.contains(class.class.name()) && info.contains(class.answers.query()),
            "{info}"
        );
    }
}

#[test]
fn a_replay_refuses_what_are_not_the_scenes_rays() {
    let (folder, _) = saved();
    let at = folder.path();
    let bytes = file(at);
    let refuses = |bytes: &[u8], parts: &[&str]| {
        fs::write(at.join("bad.srtrays"), bytes).unwrap();
        let Run { code, stderr, .. } = compare(at, &["--rays", "bad.srtrays", "--out", "never"]);
        assert_eq!(code, 2, "{stderr}");
        for part in parts.iter().chain(&["`bad.srtrays`"]) {
            assert!(stderr.contains(part), "{part}: {stderr}");
        }
        assert!(!at.join("never").exists());
    };
    let mut altered = bytes.clone();
    altered[300] ^= 1;
    refuses(&altered, &["its contents have SHA-256 ", "it was altered"]);
    refuses(&bytes[..bytes.len() - 1], &["by its own counts", "cut off"]);
    refuses(&[&bytes[..], b"more"].concat(), &["by its own counts", "added to"]);
    refuses(b"", &["it does not begin with `srt-rays`"]);
    refuses(SCENE.as_bytes(), &["it does not begin with `srt-rays`"]);

    // A file with a hash that is right, of answers that are not.
    let mut forged = RayFile::decode(&bytes).unwrap();
    let RayAnswers::ClosestHit(hits) = &mut forged.classes[0].answers else { panic!("view rays") };
    let place = hits.iter().position(Hit::is_hit).unwrap();
    hits[place].u = 0.75;
    refuses(&forged.encode(), &["1 of its ", " answers are not those of this program: view ray: "]);

    // Another colour is the same geometry, another radius is not.
    let scene = |text: String| fs::write(at.join("scene.sce"), text).unwrap();
    scene(SCENE.replace("ball 0.8 ", "ball 0.7 "));
    refuses(&bytes, &["not for the geometry of `scene.sce`", "SHA-256"]);
    scene(SCENE.replace("translate 1.6 ", "translate 1.7 "));
    refuses(&bytes, &["not for the geometry of `scene.sce`"]);
    scene(SCENE.replace("cp 0.3 0.3 0.3", "cp 0.4 0.3 0.3"));
    let run = compare(at, &["--rays", "rays/scene.srtrays", "--classes", "view", "--out", "other"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert_eq!(classes(&record(at, "other"), 1).len(), 1);

    let two = ["--rays", "bad.srtrays", "--rays", "bad.srtrays"];
    let run = compare(at, &two);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("there are 2 and 1 scenes"), "{}", run.stderr);
    let run = compare(at, &["--save-rays", "scene.sce"]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("--save-rays takes a folder"), "{}", run.stderr);
    refused(&["compare", "a.sce", "--rays", "b", "--save-rays", "c"], &["cannot be used with"]);
}

#[test]
fn other_programs_rays_go_out_and_come_back() {
    let (folder, _) = saved();
    let at = folder.path();
    let rays = RayFile::decode(&file(at)).unwrap();
    let view = rays.classes.iter().find(|own| own.class.name() == "view").unwrap();
    for (format, size) in [("rodent", 24), ("tinybvh", 64)] {
        let export = |from: &str, to: &str| {
            good_run_in(at, &["rays", "export", from, to, "--format", format, "--class", "view"])
        };
        export("rays/scene.srtrays", "out.rays");
        let out = fs::read(at.join("out.rays")).unwrap();
        assert_eq!(out.len(), view.rays.len() * size);
        let import = ["rays", "import", "out.rays", "back.srtrays", "--format", format];
        let run = good_run_in(at, &[&import[..], &["--scene", "scene.sce"]].concat());
        let back = RayFile::decode(&fs::read(at.join("back.srtrays")).unwrap()).unwrap();
        assert_eq!((back.geometry, &back.classes[..]), (rays.geometry, &[view.clone()][..]));
        assert!(run.stderr.contains(&hexadecimal(&back.hash())), "{}", run.stderr);
        export("back.srtrays", "again.rays");
        assert!(fs::read(at.join("again.rays")).unwrap() == out);
    }
    // As any other rays, those are measured.
    let run = compare(at, &["--rays", "back.srtrays", "--out", "imported"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert_eq!(classes(&record(at, "imported"), 1).len(), 1);

    let failed = |typed: &[&str], parts: &[&str]| {
        let Run { code, stderr, .. } = run_in(at, &[&["rays"], typed].concat());
        assert_eq!(code, 2, "{stderr}");
        assert!(parts.iter().all(|part| stderr.contains(part)), "{stderr}");
    };
    let export = ["export", "rays/scene.srtrays", "no.rays", "--format", "rodent"];
    failed(&export, &["rays of several classes", "give --class", "view, shadow"]);
    failed(&[&export[..], &["--class", "probe"]].concat(), &["has no probe rays; it has: view"]);
    fs::write(at.join("odd"), [0; 25]).unwrap();
    let import = ["import", "odd", "no.srtrays", "--scene", "scene.sce", "--format"];
    failed(
        &[&import[..], &["rodent"]].concat(),
        &["`odd` as rodent's", "25 bytes", "multiple of 24"],
    );
    failed(&[&import[..], &["tinybvh"]].concat(), &["`odd` as tinybvh's", "25 bytes"]);
    failed(&[&import[..], &["obj"]].concat(), &["'obj'", "rodent", "tinybvh"]);
    failed(&["info", "missing"], &["cannot read the rays `missing`"]);
    fs::write(at.join("none"), []).unwrap();
    let import = ["import", "none", "no.srtrays", "--scene", "scene.sce", "--format"];
    for format in ["rodent", "tinybvh"] {
        failed(&[&import[..], &[format]].concat(), &["`none` has no rays: there is nothing to"]);
    }
    assert!(!at.join("no.rays").exists() && !at.join("no.srtrays").exists());
    let negative = ["import", "odd", "no", "--format", "rodent", "--scene", "s", "--t-min", "-1"];
    failed(&negative, &["expected a number from 0"]);
}

#[test]
fn neither_rays_nor_scene_are_replaced() {
    let folder = folder();
    let at = folder.path();
    fs::write(at.join("mesh.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").unwrap();
    fs::write(at.join("in.rays"), [0, 0, 0, 0, 0, 0x3f80_0000u32].map(u32::to_le_bytes).concat())
        .unwrap();
    fs::write(at.join("a.srtrays"), "any").unwrap();
    let refused = |typed: &[&str], kept: &str, reason: &str| {
        let before = fs::read(at.join(kept)).unwrap();
        let run = run_in(at, &[&["rays"], typed, &["--format", "rodent"]].concat());
        assert_eq!(run.code, 2, "{typed:?}");
        assert!(run.stderr.contains(reason), "{}", run.stderr);
        assert_eq!(fs::read(at.join(kept)).unwrap(), before, "{typed:?}");
    };
    refused(&["export", "a.srtrays", "./a.srtrays"], "a.srtrays", "replace the rays `a.srtrays`");
    let import =
        |to: &'static str, scene: &'static str| ["import", "in.rays", to, "--scene", scene];
    refused(&import("in.rays", "scene.sce"), "in.rays", "would replace the rays `in.rays`");
    refused(&import("scene.sce", "scene.sce"), "scene.sce", "would replace the scene `scene.sce`");
    fs::write(at.join("named.sce"), SCENE.replace("generate:torus-knot:1000", "mesh.obj")).unwrap();
    let reason = "would replace the mesh of the scene `mesh.obj`";
    refused(&import("mesh.obj", "named.sce"), "mesh.obj", reason);
}

#[test]
fn a_file_without_rays_of_the_classes_that_are_wanted_is_refused() {
    let (folder, _) = saved();
    let at = folder.path();
    let all = RayFile::decode(&file(at)).unwrap();
    let only = |count: usize| {
        let mut rays = all.clone();
        rays.classes.truncate(1);
        rays.classes[0].rays.truncate(count);
        let RayAnswers::ClosestHit(hits) = &mut rays.classes[0].answers else { panic!("view") };
        hits.truncate(count);
        fs::write(at.join("few.srtrays"), rays.encode()).unwrap();
    };
    let refuses = |options: &[&str], reason: &str| {
        let typed = [&["--rays", "few.srtrays", "--out", "never"], options].concat();
        let run = compare(at, &typed);
        assert_eq!(run.code, 2, "{}", run.stderr);
        assert!(run.stderr.contains(reason), "{}", run.stderr);
        assert!(!at.join("never").exists());
    };
    only(100);
    let reason = "the rays `few.srtrays`: it has no mirror or diffuse rays; it has: view";
    refuses(&["--classes", "mirror,diffuse"], reason);
    only(0);
    refuses(&[], "the rays `few.srtrays`: it has none to measure");
    refuses(&["--classes", "view"], "the rays `few.srtrays`: it has none to measure");
}
