//! Signals that ask the command to end: a clean end, nothing half-written.

use std::path::Path;
use std::process::{Child, Command as Process, Output, Stdio};
use std::time::Duration;

use crate::support::{folder, is_ignored, names, picture, send};

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

/// Lets it run for a while, then sends it a signal.
fn interrupt(child: Child, signal: &str, after: Duration) -> Output {
    std::thread::sleep(after);
    send(child.id(), signal);
    child.wait_with_output().unwrap()
}

/// What ends a process, and the code that it ends with. Those that the test was begun without are left
/// out: the command ignores them too.
fn signals() -> impl Iterator<Item = (&'static str, i32)> {
    let all = [("INT", 2), ("TERM", 15), ("HUP", 1), ("QUIT", 3)];
    all.into_iter().filter(|&(_, number)| !is_ignored(number)).map(|(name, n)| (name, 128 + n))
}

#[test]
fn nothing_is_left_behind() {
    for (signal, code) in signals() {
        let folder = folder();
        let child = start(folder.path(), &[]);
        let output = interrupt(child, signal, Duration::from_millis(400));
        assert_eq!(output.status.code(), Some(code), "{signal}");
        assert_eq!(names(folder.path()), ["scene.sce"], "{signal}");
        let stderr = String::from_utf8(output.stderr).unwrap();
        let says_how_far =
            stderr.contains("interrupted: ") && stderr.contains(" % rendered; nothing was written");
        // Before rendering began there is nothing to say.
        assert!(stderr.is_empty() || says_how_far, "{stderr}");
        assert!(!stderr.contains("100 %"), "{stderr}");
    }
}

#[test]
fn what_was_rendered_is_kept_where_asked() {
    signals().for_each(|(signal, code)| is_kept_where_asked(signal, code));
}

fn is_kept_where_asked(signal: &str, code: i32) {
    // On a busy machine rendering may begin late, and before it there is nothing to keep.
    for seconds in [1, 2, 4, 8, 16] {
        let folder = folder();
        let child = start(folder.path(), &["--keep-partial", "--stats=json"]);
        let output = interrupt(child, signal, Duration::from_secs(seconds));
        assert_eq!(output.status.code(), Some(code), "{signal}");
        if names(folder.path()) == ["scene.sce"] {
            continue;
        }
        assert_eq!(names(folder.path()), ["a.png", "scene.sce"]);
        let picture = picture(&folder.path().join("a.png"));
        assert_eq!((picture.width, picture.height), (1200, 900));
        let black = picture.pixels.iter().filter(|p| p.max_element() == 0.0).count();
        assert!(black > 0, "it was stopped");
        let figures: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!(figures["partial"], true);
        let rendered = figures["rendered_pixels"].as_u64().unwrap();
        assert_eq!(rendered as usize, picture.pixels.len() - black);
        let share = format!("(interrupted: {} % rendered)", 100 * rendered / (1200 * 900));
        assert!(String::from_utf8(output.stderr).unwrap().contains(&share));
        if rendered > 0 {
            return;
        }
    }
    panic!("rendering never began");
}

/// `nohup` begins a command without SIGHUP: it is to go on when its terminal closes.
#[test]
fn a_signal_that_was_ignored_stays_ignored() {
    let folder = folder();
    let mut child = Process::new("sh")
        .args(["-c", "trap '' HUP; exec \"$0\" \"$@\""])
        .arg(assert_cmd::cargo::cargo_bin!("srt"))
        .args(["scene.sce", "a.png"])
        .args(SLOW)
        .current_dir(folder.path())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    std::thread::sleep(Duration::from_secs(1));
    send(child.id(), "HUP");
    std::thread::sleep(Duration::from_millis(200));
    assert!(child.try_wait().unwrap().is_none(), "it goes on");
    let output = interrupt(child, "TERM", Duration::ZERO);
    assert_eq!(output.status.code(), Some(143));
}
