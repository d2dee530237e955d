//! `srt show` and `--view cells`: pages and pictures of structures, and refusals where there is nothing to show.

use std::fs;

use crate::support::{SCENE, folder, good_run_in, refused, rendered, run_in};

/// How often a text holds another one.
fn count(text: &str, part: &str) -> usize {
    text.matches(part).count()
}

#[test]
fn a_page_has_a_picture_for_each_level_and_loads_nothing() {
    let folder = folder();
    let at = folder.path();
    let run = good_run_in(at, &["show", "bvh", "scene.sce", "-o", "a.html", "--size", "48x36"]);
    assert!(run.stdout.is_empty());
    let page = fs::read_to_string(at.join("a.html")).unwrap();
    assert!(
        page.starts_with("<!DOCTYPE html>") && page.contains("<h1><code>bvh</code> over scene")
    );
    let levels = count(&page, "<figcaption><strong><span class=\"chip\"");
    assert!(run.stderr.starts_with(&format!("{levels} levels of bvh, ")), "{}", run.stderr);
    // The scene before and all leaves behind; the levels of the objects first, then of the meshes.
    assert_eq!(count(&page, "<figure>"), levels + 2);
    assert_eq!(count(&page, "src=\"data:image/png;base64,"), levels + 2);
    let places =
        ["The scene", "Level 0 over the objects", "Level 0 over the triangles", "All leaves"]
            .map(|title| page.find(&format!("{title}</strong>")).unwrap());
    assert!(places.is_sorted(), "{places:?}");
    assert!(page.contains("default-src 'none'") && count(&page, "<script>") == 1);
    for foreign in ["http:", "https:", "<link rel=\"stylesheet\"", " src=\"/"] {
        assert!(!page.contains(foreign), "{foreign}");
    }
    // As often as one likes, with as many threads.
    good_run_in(
        at,
        &["show", "bvh", "scene.sce", "-o", "b.html", "--size", "48x36", "--threads", "2", "-q"],
    );
    assert!(fs::read_to_string(at.join("b.html")).unwrap() == page);
}

#[test]
fn levels_and_sizes_are_as_asked_for() {
    let folder = folder();
    let at = folder.path();
    for structure in ["ball", "bvh8", "cwbvh", "kdtree", "grid", "grid2", "octree:leaf=8", "balls"]
    {
        let arguments =
            ["show", structure, "scene.sce", "-o", "a.html", "--levels", "2", "--size", "20x10"];
        let run = good_run_in(at, &arguments);
        let page = fs::read_to_string(at.join("a.html")).unwrap();
        // `ball` has one level over the meshes, and none over the objects that is another.
        let least = if structure == "ball" { 1 } else { 3 };
        let figures = count(&page, "width=\"20\" height=\"10\"");
        assert!((least + 2..=6).contains(&figures), "{structure}: {figures}, {}", run.stderr);
    }
    let run = good_run_in(at, &["show", "grid", "scene.sce", "-o", "-", "--aa", "0", "--quiet"]);
    // 720 wide, in the form of the scene's 40 × 30.
    assert!(run.stdout.contains("width=\"720\" height=\"540\"") && run.stderr.is_empty());
}

#[test]
fn the_leaves_are_a_view_of_the_structure_alone() {
    let folder = folder();
    let at = folder.path();
    let of = |structure: &str, more: &[&str]| {
        let options = ["--view", "cells", "--accel", structure];
        rendered(at, "cells.png", &[&options, more].concat())
    };
    let bvh = of("bvh", &["--threads", "1"]);
    assert!(of("bvh", &["--threads", "2"]) == bvh);
    assert!(of("bvh", &["--progressive"]) == bvh);
    for other in
        ["ball", "bvh8", "cwbvh", "kdtree", "grid", "grid2", "octree", "balls", "bvh:leaf=1"]
    {
        assert!(of(other, &[]) != bvh, "{other}");
    }
}

#[test]
fn what_has_no_cells_or_is_of_no_structure_is_refused() {
    refused(
        &["show", "none", "scene.sce", "-o", "a.html"],
        &["`none` has no cells over this scene"],
    );
    refused(
        &["scene.sce", "a.png", "--view", "cells", "--accel", "none"],
        &["`none` has no cells over this scene"],
    );
    let folder = folder();
    let empty =
        SCENE.split("triangle").next().unwrap().to_owned() + "pointlight 0 0 9 1 1 1\nend\n";
    fs::write(folder.path().join("empty.sce"), empty).unwrap();
    let run = run_in(folder.path(), &["show", "bvh8", "empty.sce", "-o", "a.html"]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("over this scene: the scene has no primitives"), "{}", run.stderr);
    assert!(!run.stderr.contains("another structure"), "{}", run.stderr);
    refused(&["show", "bvhh", "scene.sce", "-o", "a.html"], &["bvhh", "bvh"]);
    refused(&["show", "bvh", "scene.sce", "-o", "scene.sce"], &["would replace the scene"]);
    refused(&["show", "bvh", "scene.sce", "-o", "a.html", "--levels", "0"], &["--levels"]);
    refused(&["show", "bvh", "missing.sce", "-o", "a.html"], &["missing.sce"]);
    refused(&["show", "bvh", "scene.sce", "-o", "no/such/a.html"], &["no/such"]);
    let part = ["part", "scene.sce", "--part", "1/2", "-o", "a.srtp", "--view", "cells"];
    refused(&part, &["--view cells shows the structure"]);
    refused(
        &["scene.sce", "a.png", "--view", "cells", "--checkpoint", "a.srtc"],
        &["--view cells shows the structure"],
    );
}
