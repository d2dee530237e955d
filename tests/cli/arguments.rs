//! What is typed: help, values that are checked, refusals before any work.

use std::fs;
use std::path::Path;

use srt::scene::STRUCTURES;

use crate::support::{Run, folder, refused, run_in};

#[test]
fn an_unknown_instruction_set_is_refused() {
    let run = assert_cmd::cargo::cargo_bin_cmd!("srt")
        .args(["check", "a.sce"])
        .env("SRT_ISA", "sse9")
        .output()
        .unwrap();
    let stderr = String::from_utf8(run.stderr).unwrap();
    assert_eq!(run.status.code(), Some(2), "{stderr}");
    assert!(stderr.contains("`sse9`") && stderr.contains("avx512"), "{stderr}");
}

#[test]
fn a_word_that_is_neither_a_scene_nor_a_subcommand_is_called_so() {
    let folder = folder();
    let run = run_in(folder.path(), &["rendr", "my.sce"]);
    assert_eq!(run.code, 2);
    let words = "there is no scene and no subcommand `rendr`; `srt SCENE OUTPUT` renders";
    assert!(run.stderr.contains(words), "{}", run.stderr);
    let run = run_in(folder.path(), &["chek", "scene.sce"]);
    let words = "there is no scene and no subcommand `chek`; did you mean `check`?";
    assert!(run.stderr.contains(words), "{}", run.stderr);
}

#[test]
fn help_names_every_option_and_exit_code() {
    let Run { code, stdout: help, .. } = run_in(Path::new("."), &["--help"]);
    assert_eq!(code, 0);
    for word in [
        "--accel",
        "--build",
        "--threads",
        "--seed",
        "--size",
        "--aa",
        "--sampling",
        "--light-samples",
        "--max-recursion",
        "--crop",
        "--view",
        "--format",
        "--lenient",
        "--keep-partial",
        "--stats",
        "--quiet",
        "--version",
        "compare",
        "conformance",
        "report",
        "rays",
        "check",
        "diff",
        "mesh",
        "completions",
        "man",
        "bvh8:builder=sah|ploc",
        "cwbvh:leaf=1..3",
        "fastest",
        "slowest",
        "shuffled",
        "independent",
        "heatmap",
        "Examples:",
        "Exit codes:",
        "130",
        "./check",
        "top left",
    ] {
        assert!(help.contains(word), "the help does not mention {word}:\n{help}");
    }
    for structure in STRUCTURES {
        for word in [structure.name, structure.summary] {
            assert!(help.contains(word), "the help does not mention {word}:\n{help}");
        }
    }
    for subcommand in [
        "compare",
        "conformance",
        "report",
        "rays",
        "check",
        "diff",
        "mesh",
        "view",
        "completions",
        "man",
    ] {
        let Run { code, stdout: help, .. } = run_in(Path::new("."), &[subcommand, "--help"]);
        assert_eq!(code, 0);
        assert!(help.contains("Example"), "{subcommand}:\n{help}");
    }
}

#[test]
fn the_version_is_the_packages() {
    let Run { code, stdout, .. } = run_in(Path::new("."), &["--version"]);
    assert_eq!((code, stdout), (0, format!("srt {}\n", env!("CARGO_PKG_VERSION"))));
}

#[test]
fn without_arguments_the_usage_is_shown() {
    refused(&[], &["Usage:"]);
    refused(&["scene.sce"], &["OUTPUT"]);
    refused(&["scene.sce", "a.png", "extra"], &["unexpected argument `extra`", "Usage:"]);
}

#[test]
fn values_are_checked() {
    let with = |option: &str, value: &str, parts: &[&str]| {
        refused(&["scene.sce", "a.png", option, value], parts);
    };
    with("--size", "80by60", &["WIDTHxHEIGHT"]);
    with("--size", "0x60", &["between 1 and"]);
    with("--crop", "1,2,3", &["x0,y0,x1,y1"]);
    with("--crop", "5,0,5,9", &["empty"]);
    with("--accel", "bhv", &STRUCTURES.iter().map(|one| one.name).collect::<Vec<_>>());
    with("--accel", "bvh8:builder=plco", &["--accel", "`sah`, `ploc`", "did you mean `ploc`?"]);
    with("--accel", "bvh8:leaf=9", &["a whole number from 1 to 8"]);
    with("--accel", "none:leaf=1", &["no option `leaf`"]);
    with("--accel", "none,bvh", &["'none,bvh'"]);
    with("--build", "slower", &["fastest", "slowest"]);
    with("--threads", "0", &["--threads", "from 1 to 1024"]);
    with("--threads", "x", &["--threads", "expected a whole number from 1 to 1024"]);
    with("--aa", "1.5", &["--aa", "expected a whole number from 0 to 256"]);
    with("--seed", "-1", &["--seed", "expected a whole number from 0 to"]);
    with("--size", "-1x5", &["WIDTHxHEIGHT"]);
    with("--crop", "-1,0,3,4", &["x0,y0,x1,y1"]);
    with("--threads", "1024", &["1024 threads are too many", "available"]);
    with("--size", "65535x65535", &["65535x65535 pixels are too many", "--crop"]);
    with("--aa", "-1", &["--aa"]);
    with("--aa", "257", &["256"]);
    with("--max-recursion", "1001", &["1000"]);
    with("--size", "65536x1", &["65535"]);
    with("--crop", "0,0,41,30", &["0,0,41,30", "40x30"]);
    refused(&["scene.sce", "a.png", "--aa", "64", "--light-samples", "17"], &["64 × 64", "1024"]);
    with("--light-samples", "0", &["--light-samples"]);
    with("--view", "colour", &["heatmap"]);
    with("--format", "jpg", &["tga", "exr"]);
    refused(&["scene.sce", "a.png", "--stats=xml"], &["json"]);
    refused(&["scene.sce", "a.png", "--size", "9x9", "--crop", "0,0,10,9"], &["0,0,10,9", "9x9"]);
}

#[test]
fn subcommands_take_no_options_of_rendering() {
    refused(&["check", "scene.sce", "--size", "9x9"], &["--size"]);
    // Behind an option of rendering, a name is that of a scene.
    refused(&["--size", "9x9", "check", "a.png"], &["cannot read the scene `check`"]);
}

#[test]
fn an_unknown_format_is_refused_with_the_list() {
    let list = [".tga", ".png", ".ppm", ".exr", ".hdr"];
    refused(&["scene.sce", "a.jpg"], &[&list[..], &["`.jpg`"]].concat());
    refused(&["scene.sce", "a"], &[&list[..], &["no extension"]].concat());
    refused(&["scene.sce", ".png"], &["no extension"]);
}

#[test]
fn a_place_that_cannot_be_written_is_refused_before_the_scene_is_read() {
    refused(&["missing.sce", "no/such/a.png"], &["there is no folder `no/such`"]);
    refused(&["missing.sce", ".", "--format", "png"], &["it is a folder"]);
    refused(&["missing.sce", "new/", "--format", "png"], &["it is a folder"]);
    refused(&["missing.sce", "scene.sce/a.png"], &["scene.sce/a.png"]);
}

#[test]
fn a_scene_that_cannot_be_read_is_trouble() {
    refused(&["missing.sce", "a.png"], &["cannot read the scene `missing.sce`"]);
    refused(&["check", "missing.sce"], &["cannot read the scene `missing.sce`"]);
    refused(&["diff", "missing.png", "b.png"], &["cannot read `missing.png`"]);
    refused(&["diff", "missing", "b.png"], &["cannot read `missing`: there is no such file"]);
    refused(&["diff", "scene.sce", "b.png"], &["cannot read `scene.sce`"]);
}

#[test]
fn the_scene_is_not_replaced_by_its_picture() {
    refused(&["scene.sce", "scene.sce", "--format", "png"], &["replace the scene"]);
}

#[test]
fn completions_exist_for_every_shell() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let Run { code, stdout: script, .. } = run_in(Path::new("."), &["completions", shell]);
        assert_eq!(code, 0);
        assert!(script.contains("light-samples"), "{shell}");
    }
    refused(&["completions", "cmd"], &["bash"]);
}

#[test]
fn man_pages_are_printed_or_written() {
    let folder = tempfile::tempdir().unwrap();
    let Run { code, stdout: page, .. } = run_in(folder.path(), &["man"]);
    assert_eq!(code, 0);
    for part in [".TH srt 1", "light\\-samples", "Exit codes", "130"] {
        assert!(page.contains(part), "{part}:\n{page}");
    }
    assert_eq!(run_in(folder.path(), &["man", "."]).code, 0);
    assert_eq!(fs::read_to_string(folder.path().join("srt.1")).unwrap(), page);
    assert!(folder.path().join("srt-diff.1").exists());
    assert_eq!(run_in(folder.path(), &["man", "new/man1"]).code, 0);
    assert_eq!(fs::read_to_string(folder.path().join("new/man1/srt.1")).unwrap(), page);
    let Run { code, stderr, .. } = run_in(folder.path(), &["man", "srt.1/below"]);
    assert_eq!(code, 2);
    assert!(stderr.contains("cannot make the folder `srt.1/below`"), "{stderr}");
}

#[cfg(unix)]
mod unix {
    use std::process::Command as Process;

    use super::*;

    /// The system's root may write everywhere, and cannot be tested so.
    fn may_write_anywhere(folder: &Path) -> bool {
        fs::write(folder.join("probe"), "").is_ok()
    }

    fn set_mode(path: &Path, mode: u32) {
        use std::os::unix::fs::PermissionsExt;
        fs::set_permissions(path, fs::Permissions::from_mode(mode)).unwrap();
    }

    #[test]
    fn a_read_only_place_is_refused_before_the_scene_is_read() {
        let folder = folder();
        let locked = folder.path().join("locked");
        fs::create_dir(&locked).unwrap();
        fs::write(locked.join("old.png"), "old").unwrap();
        set_mode(&locked.join("old.png"), 0o444);
        set_mode(&locked, 0o555);
        if !may_write_anywhere(&locked) {
            for name in ["locked/new.png", "locked/old.png"] {
                let Run { code, stderr, .. } = run_in(folder.path(), &["missing.sce", name]);
                assert_eq!(code, 2);
                assert!(stderr.contains(&format!("cannot write `{name}`")), "{stderr}");
            }
        }
        set_mode(&locked, 0o755);
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn a_place_that_takes_no_files_is_refused_even_to_root() {
        refused(&["missing.sce", "/proc/a.png"], &["cannot write `/proc/a.png`"]);
        let run = run_in(Path::new("."), &["missing.sce", "/proc/a.png"]);
        assert!(!run.stderr.contains(".tmp"), "{}", run.stderr);
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn a_full_standard_output_is_called_that() {
        for arguments in [&["mesh", "soup", "-n", "100"][..], &["--help"], &["-h"], &["--version"]]
        {
            let full = fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
            let run = Process::new(assert_cmd::cargo::cargo_bin!("srt"))
                .args(arguments)
                .stdout(full)
                .output()
                .unwrap();
            assert_eq!(run.status.code(), Some(2), "{arguments:?}");
            let stderr = String::from_utf8(run.stderr).unwrap();
            assert!(stderr.contains("cannot write standard output: "), "{arguments:?}: {stderr}");
        }
    }

    #[test]
    fn bash_takes_the_completions() {
        let folder = tempfile::tempdir().unwrap();
        let script = folder.path().join("srt.bash");
        let Run { stdout: text, .. } = run_in(folder.path(), &["completions", "bash"]);
        fs::write(&script, text).unwrap();
        match Process::new("bash").arg("-n").arg(&script).status() {
            Ok(status) => assert!(status.success()),
            Err(error) => eprintln!("bash was not tried: {error}"),
        }
    }
}

#[test]
fn a_slip_in_the_name_of_a_subcommand_is_found() {
    for (typed, parts) in [
        (&["help", "comprae"][..], &["no subcommand `comprae`", "did you mean `compare`?"][..]),
        (&["help", "rays", "exprot"], &["no subcommand `exprot`", "did you mean `export`?"]),
        (&["rays", "exprot"], &["no subcommand `exprot`", "did you mean `export`?"]),
        (&["rays", "rays"], &["no subcommand `rays`"]),
        (&["help", "xyzzy"], &["no subcommand `xyzzy`"]),
        (&["a.sce", "b.png", "compare"], &["unexpected argument `compare`"]),
        (&["a.sce", "b.png", "foo"], &["unexpected argument `foo`: a rendering takes a scene"]),
    ] {
        let Run { code, stderr, .. } = run_in(Path::new("."), typed);
        assert_eq!(code, 2, "{typed:?}: {stderr}");
        assert!(parts.iter().all(|part| stderr.contains(part)), "{typed:?}: {stderr}");
        assert!(typed[0] != "help" || !stderr.contains("a rendering takes"), "{stderr}");
    }
}
