//! `srt compare` and `srt report`: files, exit codes, refusals.

use std::fs;
use std::path::Path;
use std::process::Command;
use std::thread::sleep;
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::support::{Run, SCENE, folder, good_run_in, names, picture, refused, run_in, send};

const QUICK: [&str; 8] =
    ["--budget", "8", "--rounds", "6", "--threads", "2", "--accel", "none,bvh"];

fn compare(folder: &Path, options: &[&str]) -> Run {
    run_in(folder, &[&["compare", "scene.sce"], &QUICK[..], options].concat())
}

fn json(path: &Path) -> Value {
    serde_json::from_slice(&fs::read(path).unwrap()).unwrap()
}

#[test]
fn a_report_is_written_in_all_its_forms_and_again() {
    let folder = folder();
    let run = compare(folder.path(), &["--out", "new/out"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(
        run.stdout.contains("bvh") && run.stdout.contains("no difference in"),
        "{}",
        run.stdout
    );
    let out = folder.path().join("new/out");
    let files = [
        "report.csv",
        "report.html",
        "report.json",
        "report.md",
        "scene-heatmap-bvh.png",
        "scene-heatmap-none.png",
        "scene.png",
    ];
    assert_eq!(names(&out), files);
    let record = json(&out.join("report.json"));
    assert_eq!(record["run"]["partial"], false);
    assert!(record["run"]["command"].as_str().unwrap().starts_with("srt compare scene.sce"));
    let scene = &record["scenes"][0];
    assert_eq!((scene["name"].as_str(), scene["objects"].as_u64()), (Some("scene"), Some(3)));
    assert_eq!(scene["hash"].as_str().unwrap().len(), 64);
    for entry in scene["proof"]["structures"].as_array().unwrap() {
        assert_eq!(entry["picture_equal"], true);
        assert_eq!(entry["differing_hits"], 0);
    }
    let size = picture(&out.join("scene.png"));
    assert_eq!((size.width, size.height), (40, 30));

    let again = good_run_in(folder.path(), &["report", "new/out/report.json", "--out", "again"]);
    assert_eq!(again.stdout, run.stdout);
    for file in ["report.json", "report.md", "report.csv", "report.html"] {
        let read = |out: &Path| fs::read_to_string(out.join(file)).unwrap();
        assert!(read(&out) == read(&folder.path().join("again")), "{file} differs");
    }
    let based =
        ["report", "new/out/report.json", "--out", "based", "--base", "bvh", "--plots", "svg"];
    good_run_in(folder.path(), &based);
    assert_eq!(json(&folder.path().join("based/report.json"))["base"], "bvh");
    let plot = fs::read_to_string(folder.path().join("svg/scene-rates.svg")).unwrap();
    assert!(plot.starts_with("<svg"));
    let run = run_in(folder.path(), &["report", "new/out/report.json", "--base", "bvh9"]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("no `bvh9` to take ratios to: it has bvh, none"), "{}", run.stderr);
}

#[test]
fn ratios_are_taken_to_the_structure_that_is_named() {
    let folder = folder();
    let quick = ["compare", "scene.sce", "--budget", "2", "--accel", "none,bvh", "--out", "out"];
    good_run_in(folder.path(), &[&quick[..], &["--base", "bvh"]].concat());
    assert_eq!(json(&folder.path().join("out/report.json"))["base"], "bvh");
    let run = run_in(folder.path(), &[&quick[..], &["--base", "ball"]].concat());
    assert_eq!(run.code, 2);
    let reason = "ratios cannot be taken to `ball`, which is not compared: there are none, bvh";
    assert!(run.stderr.contains(reason), "{}", run.stderr);
}

#[test]
fn a_structure_takes_part_once_for_each_choice_of_options() {
    let folder = folder();
    let names_of = |accel| ["--accel", accel, "--out", "out"];
    let quick = ["compare", "scene.sce", "--budget", "6", "--rounds", "2", "--threads", "2"];
    let list = names_of("bvh,bvh:leaf=4,builder=sah,bvh:builder=sah,none");
    let run = good_run_in(folder.path(), &[&quick[..], &list].concat());
    let expected = ["bvh", "bvh:builder=sah,leaf=4", "bvh:builder=sah", "none"];
    let record = json(&folder.path().join("out/report.json"));
    let names = record["scenes"][0]["structures"].as_array().unwrap().iter();
    assert!(names.map(|own| own["name"].as_str().unwrap()).eq(expected));
    assert!(run.stdout.contains("bvh:builder=sah,leaf=4"), "{}", run.stdout);
    assert!(folder.path().join("out/scene-heatmap-bvh.builder.sah.leaf.4.png").exists());
    let twice = names_of("bvh:builder=sah,leaf=4,bvh:leaf=4,builder=sah");
    let run = run_in(folder.path(), &[&quick[..], &twice].concat());
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("bvh:builder=sah,leaf=4"), "{}", run.stderr);
}

#[test]
fn a_regression_is_named_and_fails() {
    let folder = folder();
    assert_eq!(compare(folder.path(), &["--out", "a"]).code, 0);
    let path = folder.path().join("a/report.json");
    let mut old = json(&path);
    // As if the old rounds had taken a thousandth of their time.
    for structure in old["scenes"][0]["structures"].as_array_mut().unwrap() {
        for class in structure["classes"].as_array_mut().unwrap() {
            for round in class["rounds"].as_array_mut().unwrap() {
                let time = round["wall_ns"].as_u64().unwrap();
                round["wall_ns"] = (time / 1_000 + 1).into();
            }
        }
    }
    fs::write(folder.path().join("old.json"), old.to_string()).unwrap();
    let run = compare(folder.path(), &["--out", "b", "--baseline", "old.json"]);
    assert_eq!(run.code, 1, "{}", run.stderr);
    assert!(run.stdout.contains("slower: view rays of scene with bvh"), "{}", run.stdout);
    let run = compare(
        folder.path(),
        &["--out", "c", "--baseline", "old.json", "--fail-above", "10000000%", "--quiet"],
    );
    assert_eq!((run.code, run.stdout.as_str()), (0, ""), "{}", run.stderr);
}

#[test]
fn a_sweep_traces_growing_meshes() {
    let folder = folder();
    let sweep = ["compare", "--sweep", "100..1k", "--mesh", "icosphere", "--out", "out"];
    let run = run_in(folder.path(), &[&sweep, &QUICK[..]].concat());
    assert_eq!(run.code, 0, "{}", run.stderr);
    let record = json(&folder.path().join("out/report.json"));
    let points = record["sweeps"][0]["points"].as_array().unwrap();
    for structure in ["none", "bvh"] {
        let own = points.iter().filter(|point| point["structure"] == structure);
        let views = own.filter(|point| point["class"] == "view");
        let sizes: Vec<_> = views.map(|point| point["triangles"].as_u64().unwrap()).collect();
        assert_eq!(sizes, [80, 320, 980], "{structure}");
    }
}

#[test]
fn a_study_of_sampling_is_a_chapter_in_all_forms() {
    let folder = folder();
    let unlit = SCENE.replace("arealight 0.7", "pointlight 0 0 0");
    fs::write(folder.path().join("unlit.sce"), unlit).unwrap();
    let study = ["compare", "scene.sce", "unlit.sce", "--sampling-study", "--out", "out"];
    let run = run_in(folder.path(), &[&study, &QUICK[..]].concat());
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(run.stdout.contains("Sampling: shuffled leaves "), "{}", run.stdout);
    let read = |file: &str| fs::read_to_string(folder.path().join("out").join(file)).unwrap();
    let record = json(&folder.path().join("out/report.json"));
    let noise = record["derived"]["noise"].as_array().unwrap();
    assert!(noise.len() >= 12 && noise.iter().all(|own| own["scene"] == "scene"), "{noise:?}");
    assert!(read("sampling.csv").contains("\r\nnoise,scene,shuffled,"));
    let note = "unlit was left out of the study of sampling";
    for (file, title) in [("report.md", "### Noise that"), ("report.html", "noise against time")] {
        assert!(read(file).contains(title) && read(file).contains(note), "{file}");
    }
}

#[test]
fn what_cannot_be_done_is_refused_before_the_work() {
    refused(&["compare"], &["SCENE"]);
    refused(&["compare", "scene.sce", "--accel", "bhv"], &["none", "cwbvh"]);
    refused(&["compare", "--sweep", "1k..10k"], &["--family"]);
    refused(&["compare", "--sweep", "10k..1k", "--mesh", "hall"], &["the smaller first"]);
    refused(&["compare", "--sweep", "1k..2k", "--mesh", "hall", "--sampling-study"], &["<SCENE>"]);
    let sweep = ["compare", "--sweep", "1k..2k", "--mesh", "hall"];
    refused(&[&sweep[..], &["--baseline", "old.json"]].concat(), &["<SCENE>"]);
    refused(&["compare", "scene.sce", "--budget", "0"], &["seconds"]);
    refused(&["compare", "scene.sce", "--fail-above", "9%"], &["--baseline"]);
    refused(&["compare", "missing.sce", "--out", "."], &["missing.sce"]);
    refused(&["compare", "scene.sce", "--baseline", "old.json"], &["old.json"]);
    refused(&["compare", "scene.sce", "--out", "scene.sce"], &["scene.sce", "is a file"]);
    refused(&["report", "scene.sce"], &["not", "scene.sce"]);
}

#[test]
fn a_baseline_without_anything_in_common_is_trouble() {
    let folder = folder();
    let run = compare(folder.path(), &["--out", "a"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let path = folder.path().join("a/report.json");
    let mut old = json(&path);
    old["run"]["machine"]["cpu"] = "another".into();
    old["scenes"][0]["name"] = "other".into();
    fs::write(folder.path().join("old.json"), old.to_string()).unwrap();
    let run = compare(folder.path(), &["--out", "b", "--baseline", "old.json"]);
    assert_eq!(run.code, 2, "{}", run.stderr);
    assert!(run.stderr.contains("has nothing in common"), "{}", run.stderr);
    assert!(run.stdout.contains("WARNING: The processor was another"), "{}", run.stdout);
    let record = json(&folder.path().join("b/report.json"));
    assert_eq!(record["baseline"]["outcome"]["changes"].as_array().map(Vec::len), Some(0));
}

#[test]
fn pictures_of_an_older_report_do_not_stay_in_its_folder() {
    let folder = folder();
    assert_eq!(compare(folder.path(), &["--out", "out"]).code, 0);
    let out = folder.path().join("out");
    fs::write(out.join("mine.png"), "not of the report").unwrap();
    let run = run_in(
        folder.path(),
        &["compare", "scene.sce", "--accel", "bvh", "--budget", "2", "--out", "out"],
    );
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(run.stderr.contains("too little for intervals; --budget 5"), "{}", run.stderr);
    assert!(run.stdout.contains("reference"), "{}", run.stdout);
    let pictures: Vec<_> = names(&out).into_iter().filter(|name| name.ends_with(".png")).collect();
    assert_eq!(pictures, ["mine.png", "scene-heatmap-bvh.png", "scene.png"]);
}

#[cfg(unix)]
#[test]
fn a_folder_that_takes_no_files_is_found_before_the_work() {
    // /proc takes no folders, not even from root.
    let run = run_in(folder().path(), &["compare", "scene.sce", "--out", "/proc/srt"]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("/proc/srt"), "{}", run.stderr);
}

#[test]
fn comparisons_at_the_same_time_have_a_folder_each() {
    let folder = folder();
    let start = || {
        std::process::Command::new(assert_cmd::cargo::cargo_bin!("srt"))
            .args(["compare", "scene.sce", "--quiet"])
            .args(QUICK)
            .current_dir(folder.path())
            .spawn()
            .unwrap()
    };
    let runs: Vec<_> = (0..6).map(|_| start()).collect();
    for mut run in runs {
        assert_eq!(run.wait().unwrap().code(), Some(0));
    }
    let results = folder.path().join("results");
    let reports = names(&results);
    assert_eq!(reports.len(), 6, "{reports:?}");
    for report in reports {
        assert_eq!(json(&results.join(&report).join("report.json"))["run"]["partial"], false);
    }
}

#[cfg(unix)]
#[test]
fn an_interrupted_comparison_is_written_and_marked() {
    use std::process::{Command, Stdio};
    use std::time::Duration;

    // On a busy machine the work may begin late, and before it a signal ends the process at once.
    for seconds in [1, 2, 4, 8, 16] {
        let folder = folder();
        let child = Command::new(assert_cmd::cargo::cargo_bin!("srt"))
            .args(["compare", "scene.sce", "--budget", "600", "--rounds", "400", "--out", "out"])
            .current_dir(folder.path())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        std::thread::sleep(Duration::from_secs(seconds));
        send(child.id(), "TERM");
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(143));
        let record = folder.path().join("out/report.json");
        if record.exists() {
            assert_eq!(json(&record)["run"]["partial"], true);
            assert!(folder.path().join("out/report.html").exists());
            return;
        }
    }
    panic!("the comparison never began");
}

/// Unix file names are bytes. Reports show them as far as they are text.
#[cfg(target_os = "linux")]
#[test]
fn a_scene_whose_name_is_no_text_is_compared() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;

    let folder = folder();
    let name = OsStr::from_bytes(b"caf\xe9.sce");
    std::fs::rename(folder.path().join("scene.sce"), folder.path().join(name)).unwrap();
    let arguments = ["compare", "--accel", "bvh,bvh8", "--budget", "1", "--out", "out"];
    let output = crate::support::srt(&arguments).arg(name).current_dir(folder.path()).output();
    let output = output.unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let record = json(&folder.path().join("out/report.json"));
    assert_eq!(record["scenes"][0]["name"], "caf\u{fffd}");
    assert!(folder.path().join("out/report.html").exists());
}

/// What was measured before SIGKILL stays as it was, to the digit; the rest is measured.
#[test]
fn a_comparison_that_was_killed_is_gone_on_with() {
    let folder = folder();
    let at = folder.path();
    let more = SCENE.replace("end\n", "ball 0.5 3 3 3\nend\n");
    assert_ne!(more, SCENE);
    fs::write(at.join("other.sce"), &more).unwrap();
    let line = |scenes: &[&'static str]| {
        let options = [
            "--budget",
            "6",
            "--rounds",
            "2",
            "--threads",
            "2",
            "--accel",
            "none,bvh",
            "--out",
            "out",
        ];
        [&["compare"], scenes, &options[..], &["--resume", "--quiet"]].concat()
    };
    let both = line(&["scene.sce", "other.sce"]);
    let report = at.join("out/report.json");
    let mut command = Command::new(assert_cmd::cargo::cargo_bin!("srt"));
    let mut process = command.args(&both).current_dir(at).spawn().unwrap();
    let deadline = Instant::now() + Duration::from_secs(60);
    while !report.exists() {
        assert!(Instant::now() < deadline && process.try_wait().unwrap().is_none());
        sleep(Duration::from_millis(5));
    }
    process.kill().unwrap();
    process.wait().unwrap();
    let before = json(&report);
    assert_eq!(
        (&before["run"]["partial"], &before["run"]["done"][0]),
        (&true.into(), &"scene".into())
    );
    assert_eq!(before["scenes"].as_array().unwrap().len(), 1);

    good_run_in(at, &both);
    let after = json(&report);
    assert_eq!(after["run"]["partial"], false);
    let names: Vec<_> = (0..2).map(|i| after["scenes"][i]["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["scene", "other"]);
    assert_eq!(after["scenes"][0], before["scenes"][0]);
    assert_eq!(after["run"]["date"], before["run"]["date"]);
    let seconds = |record: &Value| record["run"]["elapsed_seconds"].as_f64().unwrap();
    assert!(seconds(&after) > seconds(&before));
    assert!(
        after["notes"].to_string().contains("The comparison was stopped, and gone on with at ")
    );
    // The page has the pictures of both.
    let page = fs::read_to_string(at.join("out/report.html")).unwrap();
    assert!(!page.contains("is missing") && at.join("out/scene.png").exists());

    // A scene that changed meanwhile is measured anew; the other stays.
    fs::write(at.join("other.sce"), more.replace("ball 0.5", "ball 0.6")).unwrap();
    good_run_in(at, &both);
    let changed = json(&report);
    assert_eq!(changed["scenes"][0], before["scenes"][0]);
    assert_ne!(changed["scenes"][1]["hash"], after["scenes"][1]["hash"]);

    let run = run_in(at, &line(&["scene.sce"]));
    assert_eq!(run.code, 2);
    let reason = "it was begun with another command: `srt compare scene.sce other.sce --budget 6 ";
    assert!(run.stderr.contains(reason), "{}", run.stderr);
    assert!(run.stderr.contains("; leave --resume out to begin anew"), "{}", run.stderr);
    assert_eq!(json(&report), changed, "nothing is lost");
}

/// What `out` holds, by the names of its files.
#[cfg(unix)]
fn contents(out: &Path) -> Vec<(String, Vec<u8>)> {
    names(out).into_iter().map(|name| (name.clone(), fs::read(out.join(name)).unwrap())).collect()
}

#[cfg(unix)]
#[test]
fn an_interrupted_comparison_leaves_an_older_report_as_it_is() {
    let folder = folder();
    let at = folder.path();
    assert_eq!(compare(at, &["--out", "out", "--quiet"]).code, 0);
    let older = contents(&at.join("out"));
    // Pictures are rendered and builds timed first, so that there are no times of rays yet.
    for milliseconds in [300, 1_000] {
        let child = Command::new(assert_cmd::cargo::cargo_bin!("srt"))
            .args(["compare", "scene.sce", "--accel", "none,bvh", "--rounds", "400"])
            .args(["--budget", "60", "--out", "out"])
            .current_dir(at)
            .stdout(std::process::Stdio::null())
            .stderr(std::process::Stdio::piped())
            .spawn()
            .unwrap();
        sleep(Duration::from_millis(milliseconds));
        send(child.id(), "TERM");
        let output = child.wait_with_output().unwrap();
        let stderr = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(143), "{stderr}");
        assert!(contents(&at.join("out")) == older, "after {milliseconds} ms: {stderr}");
    }
}

#[test]
fn a_report_does_not_replace_its_baseline() {
    let folder = folder();
    let at = folder.path();
    fs::create_dir(at.join("base")).unwrap();
    fs::write(at.join("base/report.json"), "an older record").unwrap();
    for baseline in ["base/report.json", "./base/../base/report.json"] {
        let run = compare(at, &["--out", "base", "--baseline", baseline]);
        assert_eq!(run.code, 2, "{}", run.stderr);
        let reason = format!("the report would replace the baseline `{baseline}`");
        assert!(run.stderr.contains(&reason), "{}", run.stderr);
    }
    assert_eq!(names(&at.join("base")), ["report.json"]);
    assert_eq!(fs::read(at.join("base/report.json")).unwrap(), b"an older record");
}

#[test]
fn a_plan_that_is_refused_leaves_no_folder() {
    let twice = ["compare", "scene.sce", "--accel", "bvh8,bvh8", "--out", "out"];
    refused(&twice, &["`bvh8` was named twice"]);
    refused(
        &["compare", "scene.sce", "--accel", "bvh8", "--base", "bvh", "--out", "out"],
        &["ratios cannot be taken to `bvh`"],
    );
}
