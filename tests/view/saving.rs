//! The scene and its meshes are saved while someone looks.

use std::fs;
use std::path::Path;

use serde_json::{Value, json};

use crate::support::{Page, SCENE, Server, folder, rendered};

fn save(folder: &Path, scene: &str) {
    fs::write(folder.join("scene.sce"), scene).unwrap();
}

/// Waits for an error of the scene.
fn error(page: &mut Page) -> String {
    let report = page.until("an error", |report| !report["error"].is_null());
    report["error"].as_str().unwrap().to_owned()
}

fn is_mended(report: &Value) -> bool {
    report["error"].is_null() && report["complete"] == true
}

#[test]
fn a_bad_edit_is_explained_in_place_and_a_mended_one_is_shown() {
    let folder = folder();
    let server = Server::start(folder.path(), &[]);
    let mut page = server.look();
    let before = page.finished();
    save(folder.path(), &SCENE.replace("ball 0.8", "balll 0.8"));
    let text = error(&mut page);
    for part in [
        "error: unknown command `balll`, did you mean `ball`?",
        "--> scene.sce:15:1",
        "^^^^^ no command has this name",
        "`scene.sce` is not a valid scene: 1 error",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
    assert!(page.pictures[0] == before, "the last good picture stays");
    // It can still be looked at.
    page.tell(json!({"turn": [0.1, 0.0]}));
    assert!(page.finished() != before);
    page.tell(json!("reset"));
    assert!(page.finished() == before);
    save(folder.path(), &SCENE.replace("ball 0.8", "ball 1.1"));
    page.until("mended", is_mended);
    assert!(page.pictures[0] == rendered(folder.path(), "scene.sce", &[]));
    assert!(page.pictures[0] != before);
    // Another size, put in the place of the file as editors do.
    fs::write(folder.path().join("new"), SCENE.replace("nx 40", "nx 52")).unwrap();
    fs::rename(folder.path().join("new"), folder.path().join("scene.sce")).unwrap();
    page.until("replaced", |report| report["width"] == 52 && report["complete"] == true);
    assert!(page.pictures[0] == rendered(folder.path(), "scene.sce", &[]));
    fs::remove_file(folder.path().join("scene.sce")).unwrap();
    assert!(error(&mut page).contains("cannot read the scene `scene.sce`"));
    save(folder.path(), SCENE);
    page.until("there again", is_mended);
    assert!(page.pictures[0] == before);
}

#[test]
fn meshes_are_followed_even_those_that_are_missing() {
    let folder = folder();
    let mesh = "v -1 0 0\nv 1 0 0\nv 0 0 1.5\nf 1 2 3\n";
    fs::write(folder.path().join("sail.obj"), mesh).unwrap();
    let scene = SCENE.replace("generate:torus-knot:1000", "sail.obj");
    save(folder.path(), &scene);
    let server = Server::start(folder.path(), &[]);
    let mut page = server.look();
    let before = page.finished();
    fs::write(folder.path().join("sail.obj"), mesh.replace("1.5", "2.5")).unwrap();
    page.until("another picture", |report| report["complete"] == true);
    while page.pictures[0] == before {
        page.until("another picture", |report| report["complete"] == true);
    }
    assert!(page.pictures[0] == rendered(folder.path(), "scene.sce", &[]));
    fs::write(folder.path().join("sail.obj"), mesh.replace("f 1 2 3", "f 1 2 9")).unwrap();
    let text = error(&mut page);
    assert!(text.contains("sail.obj:4:7") && text.contains("scene.sce:19:14"), "{text}");
    // A mesh that is not there yet is waited for.
    save(folder.path(), &scene.replace("sail.obj", "kite.obj"));
    page.until("missing", |report| {
        report["error"]
            .as_str()
            .is_some_and(|text| text.contains("there is no mesh file `kite.obj`"))
    });
    fs::write(folder.path().join("kite.obj"), mesh).unwrap();
    page.until("found", is_mended);
    assert!(page.pictures[0] == rendered(folder.path(), "scene.sce", &[]));
}

#[test]
fn the_place_is_kept_unless_the_scene_has_another_camera() {
    let folder = folder();
    let server = Server::start(folder.path(), &[]);
    let mut page = server.look();
    page.tell(json!({"turn": [0.2, 0.1]}));
    let report = page.until("finished", |report| report["complete"] == true);
    let place = report["camera"].clone();
    save(folder.path(), &SCENE.replace("background 0.4", "background 0.9"));
    let kept = page.until("saved", |report| report["complete"] == true && report["moved"] == true);
    assert_eq!(kept["camera"], place);
    save(folder.path(), &SCENE.replace("fovy_deg 45", "fovy_deg 30"));
    let report = page.until("another camera", |report| report["moved"] == false);
    assert!(report["camera"].as_str().unwrap().contains("fovy_deg 30"), "{report}");
    assert!(page.finished() == rendered(folder.path(), "scene.sce", &[]));
}
