//! `srt conformance`: a line a structure, exit codes, refusals.

use std::path::Path;

use crate::support::{Run, refused, run_in};

#[test]
fn a_structure_that_gives_equal_hits_has_a_line_that_says_so() {
    let typed = ["conformance", "--accel", "ball,bvh:builder=sah,leaf=20"];
    let Run { code, stdout, stderr } = run_in(Path::new("."), &typed);
    assert_eq!((code, stderr.as_str()), (0, ""), "{stdout}");
    let lines: Vec<&str> = stdout.lines().collect();
    assert!(lines[0].starts_with("ball: ") && lines[1].starts_with("bvh:builder=sah,leaf=20: "));
    for line in &lines {
        assert!(line.contains(" rays at ") && line.ends_with("all results are equal"));
    }
    assert_eq!(lines.len(), 2, "{stdout}");
}

#[test]
fn a_budget_ends_the_check_with_what_is_known() {
    let typed = ["conformance", "--accel", "bvh", "--budget", "0.001"];
    let Run { code, stdout, stderr } = run_in(Path::new("."), &typed);
    assert_eq!((code, stderr.as_str()), (0, ""), "{stdout}");
    assert!(stdout.contains(": no difference so far; ended with "), "{stdout}");
    assert!(stdout.ends_with(" of 58 meshes compared in full\n"), "{stdout}");
    refused(&["conformance", "--budget", "0"], &["--budget"]);
}

#[test]
fn what_is_no_structure_is_refused() {
    refused(&["conformance", "--accel", "bhv"], &["'bhv'", "cwbvh"]);
    refused(&["conformance", "scene.sce"], &["unexpected argument 'scene.sce'"]);
    #[cfg(feature = "embree")]
    refused(&["conformance", "--accel", "embree"], &["`embree` is another program's"]);
}

#[test]
fn the_structures_are_listed_with_their_options() {
    let Run { code, stdout, stderr } = run_in(Path::new("."), &["accels"]);
    assert_eq!((code, stderr.as_str()), (0, ""));
    for name in [
        "none", "ball", "bvh", "cwbvh", "bvh8", "kdtree", "grid", "grid2", "octree", "balls",
        "kdop",
    ] {
        assert!(
            stdout.lines().any(|line| line.split(' ').next() == Some(name)),
            "{name}: {stdout}"
        );
    }
    assert!(stdout.contains("density=1..64: "), "{stdout}");
    refused(&["accels", "bvh"], &["unexpected argument 'bvh'"]);
}
