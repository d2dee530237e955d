//! The command end to end, as a shell sees it.

#![allow(clippy::unwrap_used, reason = "a panic is a failed test")]

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use tempfile::TempDir;

/// A scene that is valid wherever it is read.
const SCENE: &str = "sce1.0\neyepos 0 -5 0\neyedir 0 1 0\neyeup 0 0 1\nwdist 1\nfovy_deg 40\n\
    nx 16\nny 12\naasample 0\nball 1 0 0 0\npointlight 0 -5 5 1 1 1\nend\n";

fn srt(arguments: &[&str]) -> Command {
    let mut command = Command::cargo_bin("srt").unwrap();
    command.args(arguments).env_remove("NO_COLOR");
    command
}

/// Runs in a folder and returns exit code, standard output and standard error.
fn run_in(folder: &Path, arguments: &[&str]) -> (i32, String, String) {
    let output = srt(arguments).current_dir(folder).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), text(output.stdout), text(output.stderr))
}

/// A folder with a valid scene in it.
fn folder() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("scene.sce"), SCENE).unwrap();
    folder
}

/// Expects a refusal with a message, and no new file.
fn refused(arguments: &[&str], parts: &[&str]) {
    let folder = folder();
    let (code, stdout, stderr) = run_in(folder.path(), arguments);
    assert_eq!(code, 2, "{arguments:?}: {stderr}");
    assert!(stdout.is_empty(), "{stdout}");
    for part in parts {
        assert!(stderr.contains(part), "{arguments:?} should say {part}:\n{stderr}");
    }
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "{arguments:?} left a file");
}

#[test]
fn help_names_every_option_and_exit_code() {
    let (code, help, _) = run_in(Path::new("."), &["--help"]);
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
        "check",
        "diff",
        "mesh",
        "completions",
        "man",
        "none",
        "ball",
        "bvh",
        "cwbvh",
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
    for subcommand in ["check", "diff", "mesh", "completions", "man"] {
        let (code, help, _) = run_in(Path::new("."), &[subcommand, "--help"]);
        assert_eq!(code, 0);
        assert!(help.contains("Example"), "{subcommand}:\n{help}");
    }
}

#[test]
fn the_version_is_the_packages() {
    let (code, stdout, _) = run_in(Path::new("."), &["--version"]);
    assert_eq!((code, stdout), (0, format!("srt {}\n", env!("CARGO_PKG_VERSION"))));
}

#[test]
fn without_arguments_the_usage_is_shown() {
    refused(&[], &["Usage:"]);
    refused(&["scene.sce"], &["OUTPUT"]);
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
    with("--accel", "bhv", &["none", "ball", "bvh", "cwbvh"]);
    with("--build", "slower", &["fastest", "slowest"]);
    with("--threads", "0", &["--threads"]);
    with("--aa", "-1", &["--aa"]);
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
    refused(&["diff", "scene.sce", "b.png"], &["cannot read `scene.sce`"]);
}

#[test]
fn the_scene_is_not_replaced_by_its_picture() {
    refused(&["scene.sce", "scene.sce", "--format", "png"], &["replace the scene"]);
}

#[test]
fn completions_exist_for_every_shell() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let (code, script, _) = run_in(Path::new("."), &["completions", shell]);
        assert_eq!(code, 0);
        assert!(script.contains("light-samples"), "{shell}");
    }
    refused(&["completions", "cmd"], &["bash"]);
}

#[test]
fn man_pages_are_printed_or_written() {
    let folder = tempfile::tempdir().unwrap();
    let (code, page, _) = run_in(folder.path(), &["man"]);
    assert_eq!(code, 0);
    for part in [".TH srt 1", "light\\-samples", "Exit codes", "130"] {
        assert!(page.contains(part), "{part}:\n{page}");
    }
    assert_eq!(run_in(folder.path(), &["man", "."]).0, 0);
    assert_eq!(fs::read_to_string(folder.path().join("srt.1")).unwrap(), page);
    assert!(folder.path().join("srt-diff.1").exists());
    assert_eq!(run_in(folder.path(), &["man", "no/such"]).0, 2);
}

#[cfg(unix)]
mod unix {
    use std::io::Read;
    use std::process::{Command as Process, Stdio};

    use super::*;

    /// The system's root may write everywhere, and such tests say nothing about it.
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
                let (code, _, stderr) = run_in(folder.path(), &["missing.sce", name]);
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
    }

    #[test]
    fn bash_takes_the_completions() {
        let folder = tempfile::tempdir().unwrap();
        let script = folder.path().join("srt.bash");
        let (_, text, _) = run_in(folder.path(), &["completions", "bash"]);
        fs::write(&script, text).unwrap();
        match Process::new("bash").arg("-n").arg(&script).status() {
            Ok(status) => assert!(status.success()),
            Err(error) => eprintln!("bash was not tried: {error}"),
        }
    }

    #[test]
    fn a_reader_that_leaves_is_no_trouble() {
        let mut command = Process::new(assert_cmd::cargo::cargo_bin!("srt"));
        let mut child = command
            .args(["completions", "bash"])
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        drop(child.stdout.take());
        let mut stderr = String::new();
        child.stderr.take().unwrap().read_to_string(&mut stderr).unwrap();
        // It may have written everything before the pipe was closed.
        assert!(matches!(child.wait().unwrap().code(), Some(141 | 0)));
        assert_eq!(stderr, "");
    }
}
