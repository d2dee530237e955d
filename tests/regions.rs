//! The parts of space that structures show hold what they say they hold.

#![allow(clippy::unwrap_used, reason = "a panic is a failed test")]

use std::collections::BTreeSet;

use srt::accel::{BoundingBall, BuildConfig, Region, RegionForm, Regions};
use srt::compare::Family;
use srt::glam::{Vec3, Vec3A};
use srt::math::Aabb;
use srt::scene::{STRUCTURES, Scene, Structure, structure_named};

/// Whether a part of space touches a box; a ball, to within rounding.
fn touches(form: &RegionForm, bounds: &Aabb) -> bool {
    match form {
        RegionForm::Box(own) => !own.intersection(*bounds).is_empty(),
        RegionForm::Polytope(kdop) => !kdop.bounds().intersection(*bounds).is_empty(),
        RegionForm::Ball { center, radius } => {
            let nearest = Vec3A::from(*center).clamp(bounds.min, bounds.max);
            nearest.distance(Vec3A::from(*center)) <= radius * 1.000_001
        }
    }
}

/// Whether one part of space holds all of another, but for a share of its size.
fn holds(outer: &RegionForm, inner: &RegionForm, share: f32) -> bool {
    match (outer, inner) {
        (RegionForm::Box(outer), RegionForm::Box(inner)) => {
            let slack = share * outer.size().max_element();
            (outer.min - slack).cmple(inner.min).all() && inner.max.cmple(outer.max + slack).all()
        }
        // Of the boxes of the same primitives, and of fewer.
        (RegionForm::Polytope(outer), RegionForm::Polytope(inner)) => {
            let (outer, inner) = (outer.sides(), inner.sides());
            outer.iter().zip(inner).all(|(outer, inner)| outer.1 >= inner.1)
        }
        // A ball around balls need not hold them: it holds what is in them.
        _ => true,
    }
}

/// The part of space that each part is a part of.
fn parents(regions: &Regions) -> Vec<Option<&Region>> {
    let mut open: Vec<&Region> = Vec::new();
    let mut parents = Vec::new();
    for region in regions.all() {
        open.truncate(region.level as usize);
        assert_eq!(open.len(), region.level as usize, "parents stand before their children");
        parents.push(open.last().copied());
        open.push(region);
    }
    parents
}

fn check(name: &str, regions: &Regions, boxes: &[Aabb]) {
    for (region, parent) in regions.all().iter().zip(parents(regions)) {
        if let Some(parent) = parent {
            assert!(!parent.is_leaf(), "{name}: within a leaf");
            // Boxes that are stored in steps are rounded outwards, those within more than those around them.
            let share = if name.ends_with("cwbvh") { 0.01 } else { 0.0 };
            assert!(holds(&parent.form, &region.form, share), "{name}: {region:?} in {parent:?}");
        }
        assert_eq!(region.count(), regions.held(region).len());
        for id in regions.held(region).iter().copied() {
            assert!(touches(&region.form, &boxes[id as usize]), "{name}: {region:?} without {id}");
        }
    }
    let held: BTreeSet<u32> =
        regions.all().iter().flat_map(|region| regions.held(region)).copied().collect();
    assert!(held.len() >= boxes.len(), "{name}: {} of {}", held.len(), boxes.len());
}

fn boxes(scene: &Scene) -> Vec<Aabb> {
    scene.objects.iter().map(|object| object.bounds()).collect()
}

#[test]
fn every_structure_over_objects_shows_what_it_holds() {
    for family in [Family::ALL[9], Family::ALL[10], Family::ALL[12]] {
        let scene = family.scene(700, 3).unwrap();
        let boxes = boxes(&scene);
        for structure in STRUCTURES {
            let regions = structure.build(&scene, &BuildConfig::default()).regions();
            // `ball` has one around each mesh alone.
            let is_over_objects = !["none", "ball"].contains(&structure.name);
            let shown = !regions.objects.all().is_empty();
            assert_eq!(shown, is_over_objects, "{}", structure.name);
            if is_over_objects {
                check(&format!("{family} {}", structure.name), &regions.objects, &boxes);
                assert_eq!(regions.meshes.len(), scene.meshes().len());
            }
        }
    }
}

#[test]
fn every_structure_but_none_shows_all_triangles_of_a_mesh() {
    let scene = Family::ALL[5].scene(3_000, 1).unwrap();
    let triangles = scene.meshes()[0].triangles.len();
    for structure in STRUCTURES.iter().filter(|structure| structure.name != "none") {
        let regions = structure.build(&scene, &BuildConfig::default()).regions();
        assert!(regions.objects.all().is_empty(), "the mesh is searched by itself");
        let mesh = &regions.meshes[0];
        let held = mesh.all().iter().map(Region::count).sum::<usize>();
        // Partitions refer to a triangle from several cells.
        assert!(held >= triangles, "{}: {held} of {triangles}", structure.name);
        parents(mesh);
        if structure.name.starts_with("bvh") || ["balls", "kdop"].contains(&structure.name) {
            assert_eq!(held, triangles, "{}", structure.name);
        }
    }
}

#[test]
fn levels_are_those_of_the_structure() {
    let scene = Family::ALL[5].scene(3_000, 1).unwrap();
    let levels = |name: &str| {
        let regions = structure_named(name).unwrap().build(&scene, &BuildConfig::default());
        regions.regions().meshes[0].levels()
    };
    assert_eq!((levels("none"), levels("ball"), levels("grid"), levels("grid2")), (0, 1, 2, 3));
    // Eight children a node make trees a third as deep as two.
    assert!(levels("bvh8") >= 4 && levels("bvh") >= 2 * levels("bvh8"));
    assert!(levels("kdtree") > 8 && levels("octree") > 3);
    assert!(levels("balls") > 8 && levels("kdop") > 8);
}

#[test]
fn a_ball_reaches_to_the_corners_of_boxes() {
    let scene = Family::ALL[9].scene(50, 2).unwrap();
    let one_ball = Structure::new::<BoundingBall, BoundingBall>("one-ball", "one ball");
    let regions = one_ball.build(&scene, &BuildConfig::default()).regions();
    let [region] = regions.objects.all() else { panic!("one ball") };
    let RegionForm::Ball { center, radius } = region.form else { panic!("a ball") };
    let corners = || boxes(&scene).into_iter().flat_map(|bounds| bounds.corners()).map(Vec3::from);
    let farthest = corners().map(|corner| corner.distance(center)).fold(0.0, f32::max);
    assert!((farthest - radius).abs() < 1e-5 * radius, "{farthest} {radius}");
    assert_eq!(region.count(), 50);
}
