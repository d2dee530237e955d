//! Nobody looks, nobody works; and the end.

use std::process::Command;
use std::thread::sleep;
use std::time::Duration;

use serde_json::json;

use crate::support::{Server, folder, has_picture};

/// Hours of work.
const SLOW: [&str; 8] = ["--size", "1200x900", "--aa", "16", "--accel", "none", "--threads", "1"];

/// Waits until a second passes in which the process hardly works.
fn wait_until_idle(server: &Server) {
    for _ in 0..60 {
        let before = server.processor_seconds();
        sleep(Duration::from_secs(1));
        if server.processor_seconds() - before < 0.05 {
            return;
        }
    }
    panic!("it goes on working");
}

#[test]
#[cfg(target_os = "linux")]
fn a_finished_picture_takes_no_time() {
    let folder = folder();
    let server = Server::start(folder.path(), &[]);
    let mut page = server.look();
    page.finished();
    wait_until_idle(&server);
    // It is still looked at.
    page.tell(json!({"turn": [0.1, 0.0]}));
    page.finished();
}

#[test]
#[cfg(target_os = "linux")]
fn nothing_is_rendered_that_nobody_looks_at() {
    let folder = folder();
    let server = Server::start(folder.path(), &SLOW);
    wait_until_idle(&server);
    let [mut first, mut second] = [(); 2].map(|()| server.look());
    first.next();
    second.next();
    drop(first);
    second.next();
    let before = server.processor_seconds();
    sleep(Duration::from_secs(1));
    assert!(server.processor_seconds() - before > 0.1, "it works for the one who looks");
    drop(second);
    wait_until_idle(&server);
}

#[test]
fn a_movement_stops_the_pass_under_way() {
    let folder = folder();
    let server = Server::start(folder.path(), &SLOW);
    let mut page = server.look();
    page.until("a first look", has_picture);
    let mut before = page.pictures[0].clone();
    // A pass takes minutes; each of these is answered by a coarse picture.
    for _ in 0..3 {
        page.tell(json!({"turn": [0.1, 0.05]}));
        let report = page.until("moved", has_picture);
        assert_eq!(
            (&report["complete"], &report["lanes"][0]["samples"]),
            (&json!(false), &json!(0.0))
        );
        assert!(report["lanes"][0]["picture_width"].as_u64() < Some(1200), "{report}");
        assert!(page.pictures[0] != before);
        before = page.pictures[0].clone();
    }
}

#[test]
#[cfg(unix)]
fn a_signal_ends_it_at_once_while_it_works() {
    for (signal, number) in [("INT", 2), ("TERM", 15)] {
        let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
        let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
        let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
        if mask.is_some_and(|mask| mask >> (number - 1) & 1 == 1) {
            continue; // what the test was begun without, it begins without
        }
        let folder = folder();
        let mut server = Server::start(folder.path(), &SLOW);
        let mut page = server.look();
        page.next();
        let process = server.child.id().to_string();
        assert!(Command::new("kill").args(["-s", signal, &process]).status().unwrap().success());
        let code = server.child.wait().unwrap().code();
        assert_eq!(code, Some(128 + number), "{signal}");
        let end = loop {
            match page.socket.read() {
                Ok(_) => {}
                Err(error) => break error,
            }
        };
        assert!(!end.to_string().is_empty(), "the page is told by its socket");
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1, "nothing is left behind");
    }
}
