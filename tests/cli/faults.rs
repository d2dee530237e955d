//! What goes wrong around the command: it is killed, and nothing is left to write to, to read from or to
//! work with. `docs/faults.md` has the table.

use std::fs::{self, File};
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

use crate::support::{folder, is_ignored, names, refused, rendered, run_in, send};

/// How often a rendering is killed by each signal.
const KILLED: u32 = 100;

/// The command in a folder, as other programs start it.
fn command(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(assert_cmd::cargo::cargo_bin!("srt"));
    command.args(arguments).current_dir(folder).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}

/// Runs it from a shell, after a line as `ulimit -n 9`.
fn limited(folder: &Path, line: &str, arguments: &[&str]) -> Output {
    let script = format!("{line} && exec \"$0\" \"$@\"");
    let mut shell = Command::new("sh");
    shell.args(["-c", &script]).arg(assert_cmd::cargo::cargo_bin!("srt")).args(arguments);
    shell.current_dir(folder).output().unwrap()
}

fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// Kills renderings at times spread over all that they do, and expects the old picture or the new one
/// whole; what else is in the folder is returned.
fn left_by_renderings_killed_by(signal: &str) -> Vec<String> {
    let folder = folder();
    let path = folder.path().join("a.ppm");
    let start = Instant::now();
    let new = rendered(folder.path(), "a.ppm", &[]);
    let all = start.elapsed();
    let (mut old_ones, mut new_ones) = (0, 0);
    for i in 0..KILLED {
        fs::write(&path, "old").unwrap();
        let mut child = command(folder.path(), &["scene.sce", "a.ppm"]).spawn().unwrap();
        std::thread::sleep(all.mul_f64(1.2 * f64::from(i) / f64::from(KILLED)));
        match signal {
            // `kill` takes a while to start.
            "KILL" => child.kill().unwrap(),
            _ => send(child.id(), signal),
        }
        child.wait().unwrap();
        match fs::read(&path).unwrap() {
            bytes if bytes == b"old" => old_ones += 1,
            bytes => {
                assert!(bytes == new, "half a picture after {signal}: {} bytes", bytes.len());
                new_ones += 1;
            }
        }
    }
    assert!(old_ones > 0, "{new_ones} renderings ended before {signal}");
    let mut names = names(folder.path());
    names.retain(|name| name != "a.ppm" && name != "scene.sce");
    names
}

#[test]
fn nothing_is_ever_half_written_and_a_signal_leaves_nothing() {
    if !is_ignored(15) {
        assert!(left_by_renderings_killed_by("TERM").is_empty());
    }
    // What cannot be caught may leave a file, under a name that is no picture's.
    let left = left_by_renderings_killed_by("KILL");
    assert!(
        left.iter().all(|name| name.starts_with(".srt-") && name.ends_with(".tmp")),
        "{left:?}"
    );
}

#[test]
fn a_full_disk_is_an_error() {
    let folder = folder();
    let full = |arguments: &[&str]| {
        let stdout = File::options().write(true).open("/dev/full").unwrap();
        command(folder.path(), arguments).stdout(stdout).output().unwrap()
    };
    if Path::new("/dev/full").exists() {
        for arguments in
            [&["scene.sce", "-"][..], &["scene.sce", "/dev/full"], &["check", "scene.sce"]]
        {
            let output = full(arguments);
            assert_eq!(output.status.code(), Some(2), "{arguments:?}");
            assert!(stderr(&output).contains("cannot write"), "{}", stderr(&output));
        }
    }
    // A limit of the size of files, of one block, ends a file as a full disk does.
    fs::write(folder.path().join("a.ppm"), "old").unwrap();
    let output = limited(folder.path(), "ulimit -f 1", &["scene.sce", "a.ppm"]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    assert!(stderr(&output).contains("cannot write `a.ppm`"), "{}", stderr(&output));
    assert_eq!(fs::read(folder.path().join("a.ppm")).unwrap(), b"old");
    assert_eq!(names(folder.path()), ["a.ppm", "scene.sce"]);
}

#[test]
fn a_folder_that_takes_no_file_is_an_error_before_the_work() {
    use std::os::unix::fs::PermissionsExt;

    let folder = folder();
    let inner = folder.path().join("read-only");
    fs::create_dir(&inner).unwrap();
    fs::set_permissions(&inner, fs::Permissions::from_mode(0o555)).unwrap();
    if File::create(inner.join("root")).is_ok() {
        return; // Root may write anywhere.
    }
    let run = run_in(folder.path(), &["scene.sce", "read-only/a.png"]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("cannot write `read-only/a.png`"), "{}", run.stderr);
}

#[test]
fn a_pipe_that_nobody_reads_ends_the_command_in_silence() {
    let folder = folder();
    // More than a pipe holds.
    let arguments = ["scene.sce", "-", "--size", "400x300", "--quiet"];
    let mut child = command(folder.path(), &arguments).spawn().unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(141));
    assert_eq!(stderr(&output), "");
}

#[test]
fn what_does_not_fit_into_memory_is_refused_with_figures() {
    let folder = folder();
    let within_2_gb = |arguments: &[&str]| {
        let output = limited(folder.path(), "ulimit -v 2000000", arguments);
        (output.status.code(), stderr(&output))
    };
    let text = fs::read_to_string(folder.path().join("scene.sce")).unwrap();
    let scene = |name: &str, from: &str, to: &str| {
        fs::write(folder.path().join(name), text.replace(from, to)).unwrap();
    };
    scene("mesh.sce", "torus-knot:1000", "soup:90M");
    scene("build.sce", "torus-knot:1000", "hall:16M");
    let many = "repeat 16000000\nball 0.8 -1.5 0 0.8\nend_repeat";
    scene("many.sce", "ball 0.8 -1.5 0 0.8", many);
    for (arguments, code, part) in [
        (
            &["mesh", "soup", "-n", "90M", "-o", "a.obj"][..],
            2,
            "the mesh `generate:soup:90000000` is too",
        ),
        (
            &["mesh.sce", "a.ppm"],
            2,
            "the mesh `generate:soup:90000000` is too large: it takes about",
        ),
        (&["build.sce", "a.ppm"], 2, "the structure is too large: it takes about"),
        (&["check", "many.sce"], 1, "more than the memory can hold"),
    ] {
        let (got, message) = within_2_gb(arguments);
        assert_eq!(got, Some(code), "{arguments:?}: {message}");
        assert!(
            message.contains(part) && message.contains("available"),
            "{arguments:?}: {message}"
        );
    }
    assert_eq!(names(folder.path()), ["build.sce", "many.sce", "mesh.sce", "scene.sce"]);
}

#[test]
fn with_few_open_files_a_picture_is_whole_or_there_is_an_error() {
    let folder = folder();
    let whole = rendered(folder.path(), "whole.ppm", &[]);
    // With fewer than four the system itself cannot start a program.
    for files in 4..16 {
        let output = limited(
            folder.path(),
            &format!("ulimit -n {files}"),
            &["scene.sce", "a.ppm", "--quiet"],
        );
        let picture = folder.path().join("a.ppm");
        if output.status.success() {
            assert!(fs::read(&picture).unwrap() == whole, "{files}");
            fs::remove_file(picture).unwrap();
        } else {
            assert_eq!(output.status.code(), Some(2), "{files}: {}", stderr(&output));
            assert!(stderr(&output).contains("error:"), "{files}: {}", stderr(&output));
        }
        assert_eq!(names(folder.path()), ["scene.sce", "whole.ppm"], "{files}");
    }
}

#[test]
fn renderings_to_one_file_at_a_time_leave_one_whole_picture() {
    let folder = folder();
    let whole = rendered(folder.path(), "a.ppm", &[]);
    let spawn = |_| command(folder.path(), &["scene.sce", "a.ppm"]).spawn().unwrap();
    let children: Vec<_> = (0..8).map(spawn).collect();
    for child in children {
        assert!(child.wait_with_output().unwrap().status.success());
        assert!(fs::read(folder.path().join("a.ppm")).unwrap() == whole);
    }
    assert_eq!(names(folder.path()), ["a.ppm", "scene.sce"]);
}

#[test]
fn a_device_without_end_is_no_scene() {
    if Path::new("/dev/zero").exists() {
        let parts = ["cannot read the scene `/dev/zero`", "does not end within 1.0 GB"];
        refused(&["/dev/zero", "a.png"], &parts);
    }
}

/// Reading waits for whoever writes to a pipe, as all programs do; a signal ends that, too.
#[test]
fn waiting_for_a_scene_is_ended_by_a_signal() {
    if is_ignored(15) {
        return;
    }
    let folder = folder();
    let mut child = command(folder.path(), &["-", "a.png"]).stdin(Stdio::piped()).spawn().unwrap();
    let open_end = child.stdin.take();
    std::thread::sleep(Duration::from_secs(1));
    send(child.id(), "TERM");
    assert_eq!(child.wait().unwrap().code(), Some(143));
    drop(open_end);
}
