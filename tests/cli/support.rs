//! A folder with a scene, and the command run in it.

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use srt::image_io::{Format, Picture, decode};
use tempfile::TempDir;

/// A scene of every shape but the cylinder, with soft shadows and a mirror; small and quick.
pub(crate) const SCENE: &str = "sce1.0
eyepos 0 -6 2.5
eyedir 0 1 -0.35
eyeup 0 0 1
wdist 1
fovy_deg 45
nx 40
ny 30
max_recursion 2
aasample 2
background 0.4 0.6 0.9
triangle -9 -9 0  9 -9 0  0 9 0
{
cp 0.3 0.3 0.3
ball 0.8 -1.5 0 0.8
}
{
translate 1.6 0.4 1
object_phong generate:torus-knot:1000
}
{
translate 0 -2 4
arealight 0.7 0.8 0.8 0.8
}
end
";

/// The exit code and the output of a run of the command.
pub(crate) struct Run {
    pub(crate) code: i32,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

/// The command with arguments.
pub(crate) fn srt(arguments: &[&str]) -> Command {
    let mut command = Command::cargo_bin("srt").unwrap();
    command.args(arguments).env_remove("NO_COLOR");
    command
}

/// Runs in a folder.
pub(crate) fn run_in(folder: &Path, arguments: &[&str]) -> Run {
    let output = srt(arguments).current_dir(folder).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    let code = output.status.code().unwrap();
    Run { code, stdout: text(output.stdout), stderr: text(output.stderr) }
}

/// Runs in a folder, and expects it to go well.
pub(crate) fn good_run_in(folder: &Path, arguments: &[&str]) -> Run {
    let run = run_in(folder, arguments);
    assert_eq!(run.code, 0, "{arguments:?}: {}", run.stderr);
    run
}

/// A folder with `scene.sce` in it.
pub(crate) fn folder() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("scene.sce"), SCENE).unwrap();
    folder
}

/// Renders `scene.sce` with some options, and returns the bytes of the picture.
pub(crate) fn rendered(folder: &Path, name: &str, options: &[&str]) -> Vec<u8> {
    good_run_in(folder, &[&["scene.sce", name], options].concat());
    fs::read(folder.join(name)).unwrap()
}

/// Reads a picture by its extension.
pub(crate) fn picture(path: &Path) -> Picture {
    decode(&fs::read(path).unwrap(), Format::from_path(path).unwrap()).unwrap()
}

/// The names in a folder, sorted.
pub(crate) fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<_> =
        entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// Sends a signal to a process.
pub(crate) fn send(process: u32, signal: &str) {
    let kill =
        std::process::Command::new("kill").args(["-s", signal, &process.to_string()]).status();
    assert!(kill.unwrap().success());
}

/// Whether this process was begun without a signal, and so its children are: as a background job of a
/// shell is begun without SIGINT.
pub(crate) fn is_ignored(signal: i32) -> bool {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    mask.is_some_and(|mask| mask >> (signal - 1) & 1 == 1)
}

/// Expects a refusal with a message, and no new file.
pub(crate) fn refused(arguments: &[&str], parts: &[&str]) {
    let folder = folder();
    let Run { code, stdout, stderr } = run_in(folder.path(), arguments);
    assert_eq!(code, 2, "{arguments:?}: {stderr}");
    assert!(stdout.is_empty(), "{stdout}");
    for part in parts {
        assert!(stderr.contains(part), "{arguments:?} should print {part}:\n{stderr}");
    }
    assert_eq!(names(folder.path()), ["scene.sce"], "{arguments:?} left a file");
}
