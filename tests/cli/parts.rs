//! `srt part` and `srt assemble`: the picture of a rendering in one go from parts, refusals of what is no whole
//! picture.

use std::fs;
use std::path::Path;

use crate::support::{Run, SCENE, folder, good_run_in, names, refused, rendered, run_in, srt};

/// A mirror, glass and an area light, of few pixels at odd places.
const GLASS: &str = "sce1.0\neyepos 0 -5 1\neyedir 0 1 -0.1\neyeup 0 0 1\nwdist 1\nfovy_deg 50\nnx 37\nny 21\n\
    max_recursion 4\naasample 3\nbackground 0.3 0.2 0.7\ntriangle -9 -9 -1  9 -9 -1  0 9 -1\n{\nalpha 0.2\nri 1.5\n\
    cp 0.4 0.4 0.4\nball 1 0 0 0\n}\n{\ntranslate 1 -2 5\narealight 1 0.9 0.9 0.8\n}\npointlight -3 -3 3 0.2 0.2 0.2\nend\n";

/// The part `number` of `count`, in `part-NUMBER.srtp`.
fn part(folder: &Path, scene: &str, (number, count): (u32, u32), options: &[&str]) -> String {
    let (share, file) = (format!("{number}/{count}"), format!("part-{number:03}.srtp"));
    let arguments = ["part", scene, "--part", &share, "-o", &file, "--quiet"];
    let run = good_run_in(folder, &[&arguments, options].concat());
    assert_eq!((run.stdout.as_str(), run.stderr.as_str()), ("", ""));
    file
}

fn assemble(folder: &Path, parts: &[String], picture: &str) -> Run {
    let mut arguments = vec!["assemble", "-o", picture];
    arguments.extend(parts.iter().map(String::as_str));
    run_in(folder, &arguments)
}

/// The bytes of a picture from all parts of so many.
fn assembled(folder: &Path, scene: &str, count: u32, options: &[&str]) -> Vec<u8> {
    let parts: Vec<_> =
        (1..=count).map(|number| part(folder, scene, (number, count), options)).collect();
    let run = assemble(folder, &parts, "assembled.exr");
    assert_eq!(run.code, 0, "{}", run.stderr);
    fs::read(folder.join("assembled.exr")).unwrap()
}

#[test]
fn parts_are_the_whole_picture_to_the_bit() {
    let folder = folder();
    let at = folder.path();
    fs::write(at.join("glass.sce"), GLASS).unwrap();
    for (scene, options) in [
        ("scene.sce", &[][..]),
        ("glass.sce", &["--seed", "5", "--crop", "3,2,36,21", "--light-samples", "2"]),
        ("glass.sce", &["--sampling", "independent", "--aa", "4"]),
    ] {
        fs::write(at.join("whole.exr"), "").unwrap();
        let whole = rendered_of(at, scene, options);
        for by in ["tiles", "samples"] {
            for count in [1, 7, 100] {
                let options = [options, &["--by", by]].concat();
                let same = assembled(at, scene, count, &options) == whole;
                assert!(same, "{scene} {options:?}: {count} parts");
            }
        }
    }
}

fn rendered_of(folder: &Path, scene: &str, options: &[&str]) -> Vec<u8> {
    good_run_in(folder, &[&[scene, "whole.exr"], options].concat());
    fs::read(folder.join("whole.exr")).unwrap()
}

#[test]
fn what_a_pixel_hits_is_put_together_too() {
    let folder = folder();
    for view in ["depth", "normal", "object", "primitive"] {
        let options = ["--view", view, "--size", "70x50"];
        let whole = rendered(folder.path(), "whole.exr", &options);
        for by in ["tiles", "samples"] {
            let options = [&options[..], &["--by", by]].concat();
            assert!(assembled(folder.path(), "scene.sce", 3, &options) == whole, "{view} {by}");
        }
    }
}

#[test]
fn structures_threads_and_instruction_sets_may_differ_from_part_to_part() {
    let folder = folder();
    let at = folder.path();
    let whole = rendered(at, "whole.exr", &["--aa", "3"]);
    let mut sets = vec!["portable"];
    #[cfg(target_arch = "x86_64")]
    {
        if std::is_x86_feature_detected!("avx2") && std::is_x86_feature_detected!("fma") {
            sets.push("avx2");
        }
        if std::is_x86_feature_detected!("avx512f") && std::is_x86_feature_detected!("avx512dq") {
            sets.push("avx512");
        }
    }
    for by in ["tiles", "samples"] {
        let mut parts = Vec::new();
        for (number, accel) in (1..=5).zip(["bvh8", "none", "cwbvh", "ball", "bvh8:leaf=2"]) {
            let (share, file) = (format!("{number}/5"), format!("{by}-{number}.srtp"));
            let threads = if number % 2 == 0 { "1" } else { "2" };
            let mut command =
                srt(&["part", "scene.sce", "--part", &share, "-o", &file, "--by", by]);
            command.args(["--aa", "3", "--accel", accel, "--threads", threads]);
            command.env("SRT_ISA", sets[number % sets.len()]).current_dir(at);
            command.assert().success();
            parts.push(file);
        }
        parts.reverse();
        let run = assemble(at, &parts, "assembled.exr");
        assert_eq!(run.code, 0, "{}", run.stderr);
        assert!(fs::read(at.join("assembled.exr")).unwrap() == whole, "{by}");
    }
    // The same part has the same bytes.
    let file = |name: &str, accel: &str| {
        let arguments = ["part", "scene.sce", "--part", "1/2", "-o", name, "--accel", accel];
        good_run_in(at, &arguments);
        fs::read(at.join(name)).unwrap()
    };
    assert!(file("a.srtp", "none") == file("b.srtp", "bvh8"));
}

#[test]
fn a_picture_in_bytes_has_its_tone_and_its_warnings() {
    let folder = folder();
    let options = ["--exposure", "2.5", "--tone-curve", "reinhard"];
    let whole = rendered(folder.path(), "whole.png", &options);
    let parts = [1, 2].map(|number| part(folder.path(), "scene.sce", (number, 2), &[]));
    let arguments = [&["assemble", &parts[1], &parts[0], "-o", "a.png"], &options[..]].concat();
    let run = good_run_in(folder.path(), &arguments);
    assert!(fs::read(folder.path().join("a.png")).unwrap() == whole);
    assert!(
        run.stderr.contains("40 × 30, 4 samples a pixel, of 2 parts by tiles"),
        "{}",
        run.stderr
    );
    let clipped = run_in(
        folder.path(),
        &["assemble", &parts[0], &parts[1], "-o", "b.png", "--exposure", "5"],
    );
    assert!(clipped.stderr.contains("of the picture is clipped"), "{}", clipped.stderr);
}

#[test]
fn what_is_missing_or_there_twice_is_named() {
    let folder = folder();
    let at = folder.path();
    let parts: Vec<_> = (1..=4).map(|number| part(at, "scene.sce", (number, 4), &[])).collect();
    fs::copy(at.join(&parts[1]), at.join("copy.srtp")).unwrap();
    let says = |names: &[&str], texts: &[&str]| {
        let names: Vec<_> = names.iter().map(|&name| name.to_owned()).collect();
        let run = assemble(at, &names, "never.png");
        assert_eq!(run.code, 2, "{names:?}");
        for text in texts {
            assert!(run.stderr.contains(text), "{text}: {}", run.stderr);
        }
        assert!(!at.join("never.png").exists());
    };
    let all = [&*parts[0], &*parts[1], &*parts[2], &*parts[3]];
    says(&[all[3], all[1], all[0]], &["part 3 of 4 is missing"]);
    says(&[all[2]], &["parts 1, 2, 4 of 4 are missing"]);
    says(
        &[all[1], all[0], "copy.srtp"],
        &[
            "part 2/4 is there twice: `part-002.srtp` and `copy.srtp`",
            "parts 3, 4 of 4 are missing",
        ],
    );
    good_run_in(at, &["part", "scene.sce", "--part", "99/100", "-o", "far.srtp"]);
    says(&["far.srtp"], &["parts 1, 2, 3, ", "19, 20 and 79 others of 100 are missing"]);
    says(
        &[all[0], "far.srtp"],
        &["`far.srtp` is part 99/100 by tiles, and `part-001.srtp` is one of 4 by tiles"],
    );
    good_run_in(at, &["part", "scene.sce", "--part", "2/4", "--by", "samples", "-o", "by.srtp"]);
    says(&[all[0], "by.srtp"], &["`by.srtp` is part 2/4 by samples"]);
    says(&["nowhere.srtp"], &["cannot read the part `nowhere.srtp`: No such file"]);
    // A picture does not replace a part.
    let own = run_in(at, &["assemble", all[0], "-o", all[0], "--format", "png"]);
    assert!(own.code == 2 && own.stderr.contains("would replace the part"), "{}", own.stderr);
}

#[test]
fn parts_of_other_pictures_are_refused_with_the_reason() {
    let folder = folder();
    let at = folder.path();
    let own = part(at, "scene.sce", (1, 2), &[]);
    fs::write(at.join("other.sce"), SCENE.replace("ball 0.8", "ball 0.7")).unwrap();
    fs::write(at.join("meshes.sce"), SCENE.replace("knot:1000", "knot:1200")).unwrap();
    let other = |scene: &str, options: &[&str], text: &str| {
        let share = ["part", scene, "--part", "2/2", "-o", "other.srtp"];
        good_run_in(at, &[&share, options].concat());
        let run = assemble(at, &[own.clone(), "other.srtp".to_owned()], "never.png");
        assert_eq!(run.code, 2, "{text}");
        let all = format!("`other.srtp` is a part of another picture than `{own}`: it has {text}");
        assert!(run.stderr.contains(&all), "{all}: {}", run.stderr);
    };
    other("other.sce", &[], "a scene with hash ");
    other("meshes.sce", &[], "a scene with hash ");
    other("scene.sce", &["--seed", "1"], "--seed 1 in place of 0");
    other("scene.sce", &["--aa", "3"], "--aa 3 in place of 2");
    other("scene.sce", &["--size", "41x30"], "a size of 41x30 in place of 40x30");
    other("scene.sce", &["--crop", "0,0,8,8"], "the crop 0,0,8,8 in place of 0,0,40,30");
    other("scene.sce", &["--max-recursion", "1"], "--max-recursion 1 in place of 2");
    other("scene.sce", &["--light-samples", "2"], "--light-samples 2 in place of 1");
    other(
        "scene.sce",
        &["--sampling", "independent"],
        "--sampling independent in place of shuffled",
    );
    other("scene.sce", &["--view", "normal"], "--view normal in place of color");
}

#[test]
fn damaged_parts_are_refused_by_name() {
    let folder = folder();
    let at = folder.path();
    let parts = [1, 2].map(|number| part(at, "scene.sce", (number, 2), &["--by", "samples"]));
    let whole = fs::read(at.join(&parts[1])).unwrap();
    let refuses = |bytes: &[u8], text: &str| {
        fs::write(at.join("bad.srtp"), bytes).unwrap();
        let run = assemble(at, &[parts[0].clone(), "bad.srtp".to_owned()], "never.png");
        assert_eq!(run.code, 2, "{text}");
        let named = run.stderr.contains("cannot read the part `bad.srtp`: ");
        assert!(named && run.stderr.contains(text), "{text}: {}", run.stderr);
        assert!(!at.join("never.png").exists());
    };
    let changed = |at: usize| {
        let mut bytes = whole.clone();
        bytes[at] ^= 0x10;
        bytes
    };
    refuses(b"", "it does not begin with `srt-part`");
    refuses(SCENE.as_bytes(), "it does not begin with `srt-part`");
    refuses(&changed(8), "it has version 17 of the form");
    for at in [20, 100, 140, 150, 170, whole.len() / 2, whole.len() - 40, whole.len() - 1] {
        let counts = at == 170;
        refuses(&changed(at), if counts { "by its own counts" } else { "it was altered" });
    }
    for length in [10, 100, whole.len() / 2, whole.len() - 1] {
        refuses(&whole[..length], "it was cut off or added to");
    }
    refuses(&[&whole[..], b"more"].concat(), "it was cut off or added to");
    good_run_in(at, &["scene.sce", "a.png", "--checkpoint", "a.srtc"]);
    refuses(&fs::read(at.join("a.srtc")).unwrap(), "it is the checkpoint of a rendering");
}

#[test]
fn bad_arguments_of_parts_are_refused() {
    fn part<'a>(options: &[&'a str]) -> Vec<&'a str> {
        [&["part", "scene.sce", "-o", "a.srtp"], options].concat()
    }
    for bad in ["0/3", "4/3", "1", "1/0", "1/2/3", "a/b"] {
        refused(&part(&["--part", bad]), &["expected a part and their number, such as 3/7"]);
    }
    refused(&part(&[]), &["--part <K/N>"]);
    refused(&part(&["--part", "1/2", "--view", "heatmap"]), &["what a structure tested"]);
    refused(&part(&["--part", "1/2", "--by", "rows"]), &["tiles, samples"]);
    refused(&["part", "scene.sce", "--part", "1/2", "-o", "scene.sce"], &["replace the scene"]);
    refused(&["part", "scene.sce", "--part", "1/2", "-o", "no/a.srtp"], &["there is no folder"]);
    refused(&["assemble", "-o", "a.png"], &["<PART>"]);
    let folder = folder();
    let part = part_to_stdout(folder.path());
    assert!(part.starts_with(b"srt-part"));
    assert_eq!(names(folder.path()), ["scene.sce"]);
}

/// A part through a pipe.
fn part_to_stdout(folder: &Path) -> Vec<u8> {
    let arguments = ["part", "scene.sce", "--part", "1/2", "-o", "-"];
    srt(&arguments).current_dir(folder).output().unwrap().stdout
}

/// What docs/many-machines.md does on one machine: all parts by GNU parallel.
#[test]
fn gnu_parallel_renders_all_parts() {
    let version = std::process::Command::new("parallel").arg("--version").output();
    if !version.is_ok_and(|output| output.stdout.starts_with(b"GNU parallel")) {
        eprintln!("SKIPPED: GNU parallel is not installed (Debian's package `parallel`)");
        return;
    }
    let folder = folder();
    let whole = rendered(folder.path(), "whole.exr", &[]);
    let line = "parallel --will-cite -j 2 \"$0\" part scene.sce --part {}/7 -o part-{}.srtp --threads 1 \
        ::: 1 2 3 4 5 6 7 && \"$0\" assemble part-*.srtp -o picture.exr";
    let status = std::process::Command::new("sh")
        .args(["-c", line])
        .arg(assert_cmd::cargo::cargo_bin!("srt"))
        .current_dir(folder.path())
        .status()
        .unwrap();
    assert!(status.success());
    assert!(fs::read(folder.path().join("picture.exr")).unwrap() == whole);
}
