//! `srt build`: the same picture from what was built as from the scene itself, and refusals of what is none.

use std::fs;
use std::path::Path;

use srt::math::Random;

use crate::support::{Run, SCENE, folder, good_run_in, names, run_in, srt};

/// The path of a scene of the project.
fn scene(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes").join(name);
    path.display().to_string()
}

fn bytes(folder: &Path, name: &str) -> Vec<u8> {
    fs::read(folder.join(name)).unwrap()
}

#[test]
fn what_was_built_is_rendered_as_its_scene_is_with_every_structure_that_can_be_saved() {
    let folder = folder();
    let at = folder.path();
    good_run_in(at, &["scene.sce", "own.exr", "--quiet"]);
    let own = bytes(at, "own.exr");
    for accel in ["none", "ball", "bvh", "cwbvh", "bvh8", "bvh8:builder=ploc,leaf=4"] {
        let run = good_run_in(at, &["build", "scene.sce", "-o", "a.srtb", "--accel", accel]);
        assert!(
            run.stderr.starts_with(&format!("built the scene with {accel}, ")),
            "{}",
            run.stderr
        );
        // The structure of the file is taken without being named.
        let run = good_run_in(at, &["a.srtb", "built.exr"]);
        assert!(run.stderr.contains(&format!(", {accel}: built in ")), "{}", run.stderr);
        assert!(bytes(at, "built.exr") == own, "{accel}");
        good_run_in(at, &["a.srtb", "named.exr", "--accel", accel, "--threads", "1", "--quiet"]);
        assert!(bytes(at, "named.exr") == own, "{accel}, named");
    }
}

#[test]
fn scenes_of_all_kinds_are_rendered_as_they_are_themselves() {
    let folder = folder();
    let at = folder.path();
    // Cylinders, meshes in files, deep transforms, glass, many objects; a scene that moves.
    for (name, options) in [
        ("temple.sce", &[][..]),
        ("dice.sce", &[]),
        ("robot-arm.sce", &[]),
        ("glass.sce", &[]),
        ("sunflower.sce", &[]),
        ("hall.sce", &[]),
        ("twist.sce", &["--frame", "12"]),
    ] {
        let path = scene(name);
        let sized = |from: &str, to: &str, more: &[&str]| {
            let size = ["--size", "60x40", "--aa", "2", "--quiet"];
            good_run_in(at, &[&[from, to], &size[..], more].concat());
        };
        good_run_in(at, &[&["build", &path, "-o", "a.srtb", "--quiet"], options].concat());
        sized(&path, "own.exr", options);
        sized("a.srtb", "built.exr", &[]);
        assert!(bytes(at, "own.exr") == bytes(at, "built.exr"), "{name}");
        sized("a.srtb", "passes.exr", &["--progressive"]);
        assert!(bytes(at, "own.exr") == bytes(at, "passes.exr"), "{name} in passes");
    }
}

#[test]
fn parts_of_a_scene_of_a_pack_and_of_what_was_built_go_together() {
    let folder = folder();
    let at = folder.path();
    let text = SCENE.replace("generate:torus-knot:1000", "knot.obj");
    fs::write(at.join("scene.sce"), text).unwrap();
    good_run_in(at, &["mesh", "torus-knot", "-n", "1000", "-o", "knot.obj"]);
    good_run_in(at, &["scene.sce", "own.exr", "--quiet"]);
    good_run_in(at, &["pack", "scene.sce", "-o", "scene.srtpack", "--quiet"]);
    good_run_in(at, &["build", "scene.srtpack", "-o", "packed.srtb", "--quiet"]);
    let part = |scene: &str, part: &str, file: &str| {
        good_run_in(at, &["part", scene, "--part", part, "-o", file, "--quiet"]);
    };
    part("scene.sce", "1/3", "1.srtp");
    good_run_in(at, &["build", "scene.sce", "-o", "scene.srtb", "--quiet"]);
    assert!(
        bytes(at, "scene.srtb") == bytes(at, "packed.srtb"),
        "one file, from whatever it was built"
    );
    part("scene.srtpack", "2/3", "2.srtp");
    // All is in the file: neither scene nor mesh is needed.
    fs::remove_file(at.join("knot.obj")).unwrap();
    fs::remove_file(at.join("scene.sce")).unwrap();
    part("scene.srtb", "3/3", "3.srtp");
    let parts = ["1.srtp", "2.srtp", "3.srtp"];
    good_run_in(at, &[&["assemble"], &parts[..], &["-o", "assembled.exr", "--quiet"]].concat());
    assert!(bytes(at, "assembled.exr") == bytes(at, "own.exr"));
    // A checkpoint is gone on with.
    let checkpoint = ["--checkpoint", "a.srtc", "--resume", "--quiet"];
    good_run_in(at, &[&["scene.srtpack", "checked.exr"], &checkpoint[..]].concat());
    good_run_in(at, &[&["scene.srtb", "resumed.exr"], &checkpoint[..]].concat());
    assert!(bytes(at, "resumed.exr") == bytes(at, "own.exr"));
}

#[test]
fn what_was_built_is_read_wherever_a_scene_is() {
    let folder = folder();
    let at = folder.path();
    good_run_in(at, &["scene.sce", "own.exr", "--quiet"]);
    good_run_in(at, &["build", "scene.sce", "-o", "a.srtb", "--quiet"]);
    assert!(run_in(at, &["check", "a.srtb"]).stdout.starts_with("a.srtb: valid\n"));
    // Through pipes.
    let piped =
        srt(&["build", "scene.sce", "-o", "-", "--quiet"]).current_dir(at).output().unwrap();
    assert!(piped.stdout == bytes(at, "a.srtb"));
    let read = srt(&["-", "piped.exr"]).current_dir(at).write_stdin(piped.stdout).output().unwrap();
    assert!(read.status.success(), "{}", String::from_utf8_lossy(&read.stderr));
    assert!(bytes(at, "piped.exr") == bytes(at, "own.exr"));
    // With another structure, what was built is built again.
    good_run_in(at, &["build", "a.srtb", "-o", "b.srtb", "--accel", "cwbvh", "--quiet"]);
    good_run_in(at, &["b.srtb", "again.exr", "--quiet"]);
    assert!(bytes(at, "again.exr") == bytes(at, "own.exr"));
    // Frames of a scene that does not move are all the same; rays are those of the scene.
    good_run_in(at, &["a.srtb", "frame-#.exr", "--frames", "3..4", "--quiet"]);
    assert!(bytes(at, "frame-4.exr") == bytes(at, "own.exr"));
    let reports = ["--budget", "1", "--size", "8x6", "--accel", "bvh", "--quiet"];
    let compared = |scene: &str, out: &str| {
        good_run_in(at, &[&["compare", scene, "--out", out], &reports[..]].concat());
        let report = fs::read_to_string(at.join(out).join("report.json")).unwrap();
        let hashes = report.lines().filter(|line| line.contains("\"hash\""));
        hashes.map(str::to_owned).collect::<Vec<_>>()
    };
    let own = compared("scene.sce", "own");
    assert!(own.len() > 1, "of the program and of the scene");
    assert_eq!(own, compared("a.srtb", "built"));
}

#[test]
fn what_was_not_built_so_is_refused_by_name() {
    let folder = folder();
    let at = folder.path();
    fs::copy(scene("twist.sce"), at.join("twist.sce")).unwrap();
    good_run_in(at, &["build", "scene.sce", "-o", "a.srtb", "--build", "fast", "--quiet"]);
    good_run_in(at, &["build", "twist.sce", "-o", "twist.srtb", "--frame", "7", "--quiet"]);
    let refused = |arguments: &[&str], reason: &str| {
        let Run { code, stderr, .. } = run_in(at, arguments);
        assert_eq!(code, 2, "{arguments:?}: {stderr}");
        assert!(stderr.contains(reason), "{arguments:?}: {stderr}");
    };
    refused(
        &["a.srtb", "never.png", "--accel", "bvh8:leaf=4"],
        "error: `a.srtb` was built with `bvh8`, not with `bvh8:leaf=4`: leave --accel out, or build it again with it",
    );
    refused(
        &["part", "a.srtb", "--part", "1/2", "-o", "never.srtp", "--build", "medium"],
        "error: `a.srtb` was built with --build fast, not with medium: leave --build out",
    );
    refused(
        &["twist.srtb", "never.png", "--frame", "8"],
        "error: `twist.srtb` was built for frame 7, not for frame 8: build it for that frame too",
    );
    refused(
        &["build", "scene.sce", "-o", "never.srtb", "--accel", "kdtree"],
        "error: `kdtree` cannot be saved: choose another --accel",
    );
    refused(
        &["pack", "a.srtb", "-o", "never.srtpack"],
        "error: `a.srtb` is a built scene, and has no mesh files: pack the scene that it was built from",
    );
    refused(&["build", "none.sce", "-o", "never.srtb"], "error: cannot read the scene");
    refused(
        &["build", "a.srtb", "-o", "a.srtb"],
        "error: the file would replace the scene `a.srtb`",
    );
    fs::write(at.join("bad.sce"), SCENE.replace("ball", "bal")).unwrap();
    refused(&["build", "bad.sce", "-o", "never.srtb"], "did you mean `ball`?");
    assert!(names(at).iter().all(|name| !name.starts_with("never")), "{:?}", names(at));
}

/// Where each part of the file begins is found by what it begins with.
#[test]
fn what_was_altered_is_refused_by_the_name_of_the_part() {
    let folder = folder();
    let at = folder.path();
    good_run_in(at, &["build", "scene.sce", "-o", "a.srtb", "--quiet"]);
    let built = bytes(at, "a.srtb");
    let refused = |bytes: &[u8], reason: &str| {
        fs::write(at.join("bad.srtb"), bytes).unwrap();
        let run = run_in(at, &["bad.srtb", "never.png"]);
        let expected = format!("error: cannot read the built scene `bad.srtb`: {reason}");
        assert_eq!(run.code, 2);
        assert!(run.stderr.starts_with(&expected), "{}", run.stderr);
        assert!(!at.join("never.png").exists());
    };
    let altered = |place: usize| {
        let mut bytes = built.clone();
        bytes[place] ^= 0x20;
        bytes
    };
    let place = |what: &[u8]| built.windows(what.len()).position(|own| own == what).unwrap();
    refused(&altered(8), "it has version 33 of the form, and only 1 can be read: build it again");
    refused(
        &altered(place(b"bvh8")),
        "the head in it was altered: the checksum of numbers is wrong",
    );
    let text = place(b"eyepos");
    refused(&altered(text), "the scene's text in it was altered: the checksum of letters is wrong");
    refused(&built[..text], "it is cut off in the scene's text");
    // The mesh follows the text, then come the scene as it was compiled, and the structures.
    let mesh = place(b"end\n") + 100;
    refused(&altered(mesh), "mesh 1 in it was altered: the checksum of vertices is wrong");
    refused(&built[..mesh], "it is cut off in mesh 1");
    let end = built.len();
    refused(
        &altered(end - 20),
        "the structure over the objects in it was altered: the checksum of nodes is wrong",
    );
    refused(&built[..end - 1], "it is cut off in the structure over the objects");
    refused(&[&built[..], b"\n"].concat(), "it is longer than it should be");
    // Another program's sources, with the right checksum, are those of another version.
    let mut other = built.clone();
    let sources = 13 + usize::from(other[12]);
    other[sources] ^= 1;
    // The head ends with the checksum of all before it.
    let is_end = |&end: &usize| fnv(&built[..end]).to_le_bytes() == built[end..end + 8];
    let head = (sources..text).find(is_end).unwrap();
    let sum = fnv(&other[..head]).to_le_bytes();
    other[head..head + 8].copy_from_slice(&sum);
    refused(&other, "it was built by another version of srt, ");
}

fn fnv(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xCBF2_9CE4_8422_2325, |sum, &byte| {
        (sum ^ u64::from(byte)).wrapping_mul(0x100_0000_01B3)
    })
}

/// Bytes at random places, and ends at random places: always an error in words, never a picture.
#[test]
fn no_damage_is_rendered() {
    let folder = folder();
    let at = folder.path();
    let text = SCENE.replace("torus-knot:1000", "torus-knot:100");
    fs::write(at.join("scene.sce"), text).unwrap();
    let mut random = Random::new(&[6]);
    for accel in ["bvh", "cwbvh", "bvh8"] {
        good_run_in(at, &["build", "scene.sce", "-o", "a.srtb", "--accel", accel, "--quiet"]);
        let built = bytes(at, "a.srtb");
        for turn in 0..24 {
            let place = random.below(built.len() as u32) as usize;
            let damaged = if turn % 3 == 0 {
                built[..place].to_vec()
            } else {
                let mut bytes = built.clone();
                bytes[place] ^= 1 << random.below(8);
                bytes
            };
            fs::write(at.join("bad.srtb"), damaged).unwrap();
            let run = run_in(at, &["bad.srtb", "never.png", "--size", "8x6", "--quiet"]);
            assert_eq!(run.code, 2, "{accel}, byte {place}: {}", run.stderr);
            assert!(run.stderr.starts_with("error: "), "{}", run.stderr);
            assert!(!at.join("never.png").exists());
        }
    }
}
