//! Ctrl-C: a clean end, nothing half-written.

use std::path::Path;
use std::process::{Child, Command as Process, Output, Stdio};
use std::time::Duration;

use crate::support::{folder, names, picture};

/// Minutes of work in many small tiles.
const SLOW: [&str; 8] = ["--accel", "none", "--aa", "4", "--size", "1200x900", "--threads", "1"];

fn start(folder: &Path, options: &[&str]) -> Child {
    Process::new(assert_cmd::cargo::cargo_bin!("srt"))
        .args(["scene.sce", "a.png"])
        .args(SLOW)
        .args(options)
        .current_dir(folder)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

/// Lets it run for a while, then sends it what Ctrl-C sends.
fn interrupt(child: Child, after: Duration) -> Output {
    std::thread::sleep(after);
    let id = child.id().to_string();
    assert!(Process::new("kill").args(["-s", "INT", &id]).status().unwrap().success());
    child.wait_with_output().unwrap()
}

#[test]
fn nothing_is_left_behind() {
    let folder = folder();
    let output = interrupt(start(folder.path(), &[]), Duration::from_millis(400));
    assert_eq!(output.status.code(), Some(130));
    assert_eq!(names(folder.path()), ["scene.sce"]);
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert!(stderr.is_empty() || stderr.contains("nothing was written"), "{stderr}");
}

#[test]
fn what_was_rendered_is_kept_where_asked() {
    // On a busy machine rendering may begin late, and before it there is nothing to keep.
    for seconds in [1, 2, 4, 8, 16] {
        let folder = folder();
        let child = start(folder.path(), &["--keep-partial", "--stats=json"]);
        let output = interrupt(child, Duration::from_secs(seconds));
        assert_eq!(output.status.code(), Some(130));
        if names(folder.path()) == ["scene.sce"] {
            continue;
        }
        assert_eq!(names(folder.path()), ["a.png", "scene.sce"]);
        let picture = picture(&folder.path().join("a.png"));
        assert_eq!((picture.width, picture.height), (1200, 900));
        let black = picture.pixels.iter().filter(|p| p.max_element() == 0.0).count();
        assert!(black > 0, "it was stopped");
        assert!(String::from_utf8(output.stderr).unwrap().contains("(stopped early)"));
        let figures: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(figures["partial"], true);
        if black < picture.pixels.len() {
            return;
        }
    }
    panic!("rendering never began");
}
