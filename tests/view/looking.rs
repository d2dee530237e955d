//! The picture: at once, then better, then that of a file; from elsewhere, with other structures, side by side.

use std::fs;

use serde_json::json;

use crate::support::{SCENE, Server, folder, has_picture, rendered};

#[test]
fn the_finished_picture_is_that_of_the_file() {
    let folder = folder();
    let file = rendered(folder.path(), "scene.sce", &[]);
    let server = Server::start(folder.path(), &[]);
    let mut page = server.look();
    let first = page.until("a picture", has_picture);
    assert_eq!((first["width"].as_u64(), first["height"].as_u64()), (Some(40), Some(30)));
    assert!(page.finished() == file);
    for structure in ["none", "cwbvh", "kdtree", "bvh8:leaf=4,builder=sweep"] {
        page.tell(json!({"structures": [structure]}));
        assert!(page.finished() == file, "{structure}");
    }
}

#[test]
fn every_view_and_every_option_is_that_of_the_command_line() {
    let folder = folder();
    let options = ["--size", "70x33", "--aa", "2", "--seed", "5", "--accel", "bvh"];
    let server = Server::start(folder.path(), &[&options[..], &["--view", "depth"]].concat());
    let mut page = server.look();
    for view in ["depth", "normal", "object", "primitive", "heatmap", "color"] {
        if view != "depth" {
            page.tell(json!({"view": view}));
        }
        let picture = page.finished();
        let own = ["--view", view];
        assert!(
            picture == rendered(folder.path(), "scene.sce", &[&options[..], &own].concat()),
            "{view}"
        );
    }
}

#[test]
fn a_moved_camera_shows_another_picture_and_its_lines_are_its_own() {
    let folder = folder();
    let server = Server::start(folder.path(), &[]);
    let mut page = server.look();
    let home = page.finished();
    page.tell(json!({"turn": [0.1, 0.05]}));
    page.tell(json!({"pan": [0.02, -0.1]}));
    page.tell(json!({"zoom": 1.3}));
    let report = page.until("finished", |report| report["complete"] == true);
    let moved = page.pictures[0].clone();
    assert!(moved != home);
    assert_eq!(report["moved"], true);
    // The last line of each kind counts.
    let lines = report["camera"].as_str().unwrap();
    let scene = SCENE.replace("triangle -9", &format!("{lines}\ntriangle -9"));
    fs::write(folder.path().join("moved.sce"), scene).unwrap();
    assert!(moved == rendered(folder.path(), "moved.sce", &[]), "{lines}");
    page.tell(json!("reset"));
    assert!(page.finished() == home);
}

#[test]
fn two_structures_race_to_the_same_picture() {
    let folder = folder();
    let file = rendered(folder.path(), "scene.sce", &[]);
    let server = Server::start(folder.path(), &[]);
    let mut page = server.look();
    page.finished();
    page.tell(json!({"structures": ["bvh8", "none"]}));
    let report = page.until("finished", |report| report["complete"] == true);
    assert!(page.pictures.len() == 2 && page.pictures.iter().all(|own| *own == file));
    let [fast, slow] = [0, 1].map(|i| &report["lanes"][i]);
    assert_eq!(
        (fast["structure"].as_str(), slow["structure"].as_str()),
        (Some("bvh8"), Some("none"))
    );
    assert_eq!(fast["rays"], slow["rays"], "they trace the same rays");
    let classes: Vec<_> =
        fast["classes"].as_array().unwrap().iter().map(|class| class["name"].clone()).collect();
    assert_eq!(classes, ["view", "shadow", "mirror"]);
    let rate = |lane: &serde_json::Value| {
        let (rays, seconds) = (lane["rays"].as_f64().unwrap(), lane["seconds"].as_f64().unwrap());
        (rays / seconds / lane["rays_per_second"].as_f64().unwrap() - 1.0).abs()
    };
    assert!(rate(fast) < 1e-9 && rate(slow) < 1e-9, "{report}");
    page.tell(json!({"structures": ["bvh", "bvh"]}));
    page.until("finished", |report| report["complete"] == true);
    assert!(page.pictures.iter().all(|own| *own == file), "one may race itself");
}

#[test]
fn what_cannot_be_done_is_said_and_all_stays_as_it_was() {
    let folder = folder();
    let server = Server::start(folder.path(), &[]);
    let mut page = server.look();
    let before = page.finished();
    for (structure, reason) in [
        ("bhv", "there is no structure `bhv`"),
        ("bvh8:leaf=99", "`99` is no value of the option `leaf`"),
        ("none:leaf=1", "no option `leaf`"),
    ] {
        page.tell(json!({"structures": [structure]}));
        let report = page.until("refused", |report| !report["refusal"].is_null());
        assert!(report["refusal"].as_str().unwrap().contains(reason), "{report}");
        assert_eq!(report["lanes"][0]["structure"], "bvh8");
        assert!(report["complete"] == true && page.pictures[0] == before);
    }
    // So far away that single precision does not hold it.
    for _ in 0..20 {
        page.tell(json!({"pan": [10.0, 10.0]}));
        page.tell(json!({"zoom": 0.01}));
    }
    page.until("finished", |report| report["complete"] == true);
    page.tell(json!("reset"));
    assert!(page.finished() == before);
}

#[test]
fn several_pages_look_from_where_each_wants() {
    let folder = folder();
    let file = rendered(folder.path(), "scene.sce", &[]);
    let server = Server::start(folder.path(), &["--threads", "2"]);
    let [mut first, mut second, third] = [(); 3].map(|()| server.look());
    first.tell(json!({"turn": [0.2, 0.0]}));
    second.tell(json!({"structures": ["bvh", "cwbvh"]}));
    drop(third);
    let moved = first.finished();
    assert!(moved != file && second.finished() == file);
    drop(first);
    second.tell(json!({"turn": [0.2, 0.0]}));
    assert!(second.finished() == moved);
    // There is an end to it.
    let mut pages: Vec<_> = (0..15).map(|_| server.look()).collect();
    let mut one_more = server.connect(None).unwrap();
    let tungstenite::Message::Close(Some(frame)) = one_more.socket.read().unwrap() else {
        panic!("a page too many");
    };
    assert!(frame.reason.contains("16 pages"), "{}", frame.reason);
    assert!(pages.iter_mut().all(|page| page.finished() == file));
}
