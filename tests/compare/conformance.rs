//! Structures from outside are checked for conformance before they are measured.

use std::time::{Duration, Instant};

use srt::accel::Exhaustive;
use srt::compare::{Plan, Silent, run};
use srt::record::{ConformanceOutcome, RayClass, Status};
use srt::report::Report;
use srt::scene::Structure;

use crate::kd_tree::KdTree;
use crate::slow::Slow;
use crate::{named, plan};

/// A plan with time for whole checks of two structures; its rounds end long before that.
fn long_plan() -> Plan {
    Plan { budget: Some(Duration::from_secs(1_200)), classes: vec![RayClass::View], ..plan() }
}

#[test]
fn one_that_agrees_in_scenes_and_does_not_conform_is_caught_and_not_timed() {
    // Over the objects nothing, so that only triangles are checked.
    let honest = Structure::new::<Exhaustive, KdTree>("kd-tree", "cells cut in two by planes");
    type Unpadded = KdTree<false, false>;
    let unpadded = Structure::new::<Unpadded, Unpadded>("unpadded", "planes as in textbooks");
    let result = run(&long_plan(), &[unpadded, named("bvh"), honest], &Silent).unwrap();
    assert!(!result.holds());
    let comparison = &result.comparison;
    let [wrong, right] = &comparison.conformance[..] else {
        panic!("{:?}", comparison.conformance)
    };
    assert_eq!((wrong.structure.as_str(), right.structure.as_str()), ("unpadded", "kd-tree"));
    let ConformanceOutcome::Differs(first) = &wrong.outcome else { panic!("{wrong:?}") };
    assert_eq!((first.mesh.as_str(), wrong.rays), ("nested", 0));
    let fault = wrong.fault().unwrap();
    for part in ["mesh `nested` times ", "Ray { origin: ", "expected Hit { t: ", "; got "] {
        assert!(fault.contains(part), "{fault}");
    }
    assert!(right.is_whole() && right.rays > 100_000 && right.hits > 50_000, "{right:?}");

    let scene = &comparison.scenes[0];
    let proof = scene.proof.as_ref().unwrap();
    assert_eq!(proof.reference, "bvh", "never one that does not conform");
    let entry = proof.structure("unpadded").unwrap();
    assert!(entry.holds() && entry.rays_checked > 100, "the scene does not show it: {entry:?}");
    let row = scene.structure("unpadded").unwrap();
    assert!(
        matches!(&row.status, Status::Failed { message } if message.contains("conformance, at mesh `")),
        "{:?}",
        row.status
    );
    assert!(row.classes.is_empty() && row.picture_rounds.is_empty());
    assert_eq!(scene.structure("kd-tree").unwrap().status, Status::Ok);
    assert!(!scene.structure("kd-tree").unwrap().classes.is_empty());

    let verdict = Report::new(comparison).verdict();
    assert!(verdict.starts_with("unpadded DOES NOT CONFORM and is not timed: "), "{verdict}");
    assert!(!verdict.contains("FAILED"), "{verdict}");
}

#[test]
fn the_check_of_one_that_is_slow_keeps_to_its_share() {
    let slow = Structure::new::<Slow<2_000>, Exhaustive>("slow", "two milliseconds a ray");
    let plan = Plan { budget: Some(Duration::from_secs(30)), ..long_plan() };
    let start = Instant::now();
    let result = run(&plan, &[named("bvh"), slow], &Silent).unwrap();
    // All of its rays would take half an hour.
    assert!(start.elapsed() < Duration::from_secs(240), "{:?}", start.elapsed());
    let [checked] = &result.comparison.conformance[..] else { panic!("{result:?}") };
    assert!(result.holds() && checked.holds() && !checked.is_whole(), "{checked:?}");
    assert!(checked.rays > 0 && checked.meshes_checked < checked.meshes, "{checked:?}");
    // The program's own structures are not checked.
    let own = run(&plan, &[named("bvh")], &Silent).unwrap();
    assert!(own.comparison.conformance.is_empty());
}
