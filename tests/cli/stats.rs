//! The figures of `--stats`.

use serde_json::Value;

use crate::support::{folder, good_run_in, names};

/// The figures of the scene, rendered with some options.
fn figures(options: &[&str]) -> Value {
    let folder = folder();
    let arguments = [&["scene.sce", "a.png", "--stats=json"], options].concat();
    let run = good_run_in(folder.path(), &arguments);
    serde_json::from_str(&run.stdout).unwrap()
}

fn sum(values: &Value, field: &str) -> u64 {
    values.as_array().unwrap().iter().map(|value| value[field].as_u64().unwrap()).sum()
}

#[test]
fn figures_add_up() {
    let figures = figures(&["--threads", "2"]);
    assert_eq!(figures["version"], 1);
    assert_eq!((&figures["width"], &figures["height"]), (&40.into(), &30.into()));
    assert_eq!(figures["threads"], 2);
    assert_eq!(figures["partial"], false);
    let classes = &figures["classes"];
    assert_eq!(figures["rays"], sum(classes, "rays"));
    assert_eq!(classes[0]["class"], "view");
    assert_eq!(classes[0]["rays"], 40 * 30 * 4);
    for class in classes.as_array().unwrap() {
        assert!(class["hits"].as_u64() <= class["rays"].as_u64());
        let mean = class["boxes"].as_f64().unwrap() / class["rays"].as_f64().unwrap();
        assert_eq!(class["boxes_per_ray"], mean);
    }
    let speed = figures["rays"].as_f64().unwrap() / figures["render_seconds"].as_f64().unwrap();
    assert_eq!(figures["rays_per_second"], speed);
}

#[test]
fn options_are_named_as_they_were_applied() {
    let name = |accel: &str| figures(&["--accel", accel])["structure"]["name"].clone();
    assert_eq!(name("bvh8:leaf=2,builder=ploc"), "bvh8:builder=ploc,leaf=2");
    assert_eq!(name("cwbvh:leaf=1"), "cwbvh:leaf=1");
}

#[test]
fn the_structure_adds_up() {
    let structure = &figures(&["--build", "fast"])["structure"];
    assert_eq!(structure["name"], "bvh8");
    assert_eq!(structure["build"], "fast");
    for level in ["objects", "meshes"] {
        let shape = &structure[level];
        let sizes = shape["leaf_sizes"].as_object().unwrap();
        let leaves: u64 = sizes.values().map(|n| n.as_u64().unwrap()).sum();
        assert_eq!(shape["leaves"], leaves);
        let primitives: u64 =
            sizes.iter().map(|(k, n)| k.parse::<u64>().unwrap() * n.as_u64().unwrap()).sum();
        let expected =
            if level == "objects" { 3 } else { structure["triangles"].as_u64().unwrap() };
        assert_eq!(primitives, expected, "{level}");
    }
    let stages = structure["build_stages"].as_array().unwrap();
    let seconds: f64 = stages.iter().map(|stage| stage["seconds"].as_f64().unwrap()).sum();
    assert!(0.0 < seconds && seconds <= structure["build_seconds"].as_f64().unwrap());
    let bytes = structure["meshes"]["bytes"].as_f64().unwrap()
        + structure["triangle_bytes"].as_f64().unwrap();
    assert_eq!(structure["bytes_per_triangle"], bytes / structure["triangles"].as_f64().unwrap());
}

#[test]
fn exhaustive_search_tests_no_box_and_every_primitive() {
    let figures = figures(&["--accel", "none", "--aa", "0"]);
    let triangles = figures["structure"]["triangles"].as_u64().unwrap();
    let view = &figures["classes"][0];
    assert_eq!(view["boxes"], 0);
    // The triangles of the mesh, the floor and the ball.
    assert_eq!(view["primitives"], view["rays"].as_u64().unwrap() * (triangles + 2));
}

#[test]
fn scales_of_views_are_figures_too() {
    assert!(figures(&[])["scale"].is_null());
    let scale = &figures(&["--view", "heatmap"])["scale"];
    assert!(scale["low"].as_f64().unwrap() < scale["high"].as_f64().unwrap());
}

#[test]
fn the_table_goes_to_standard_error() {
    let folder = folder();
    let run = good_run_in(folder.path(), &["scene.sce", "a.png", "--stats", "--quiet"]);
    assert_eq!(run.stdout, "");
    for part in [
        "structure   bvh8, medium build\n",
        "B a triangle\n",
        "boxes/ray",
        "shadow  ",
        "all outside tracing ",
    ] {
        assert!(run.stderr.contains(part), "{part}: {}", run.stderr);
    }
    assert!(!run.stderr.contains("M rays/s"), "{}", run.stderr);
}

#[test]
fn where_the_picture_takes_standard_output_figures_leave_it() {
    let folder = folder();
    let output = crate::support::srt(&["scene.sce", "-", "--stats=json", "--quiet"])
        .current_dir(folder.path())
        .output()
        .unwrap();
    let picture = srt::image_io::decode(&output.stdout, srt::image_io::Format::Ppm).unwrap();
    assert_eq!((picture.width, picture.height), (40, 30));
    let figures: Value = serde_json::from_slice(&output.stderr).unwrap();
    assert_eq!(figures["version"], 1);
    assert_eq!(names(folder.path()), ["scene.sce"]);
}
