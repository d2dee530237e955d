//! Every kind against what it promises: its number, its space, its clusters.

use super::*;

const COUNTS: [u32; 5] = [1, 2, 63, 1000, 20_000];

fn of(kind: ScatterKind, count: u32, seed: u64) -> Vec<Scattered> {
    scatter(ScatterRecipe { kind, count, seed }).collect()
}

/// The corners of a box around an object; the meshes lie in the cube [−1, 1]³.
fn corners(scattered: &Scattered) -> Vec<DVec3> {
    let Placed { shape, transform } = scattered.under(&DAffine3::IDENTITY);
    let (low, high) = match shape {
        Some(Single::Triangle(triangle)) => return triangle.corners.map(Vec3::as_dvec3).into(),
        Some(Single::Ball(ball)) => {
            let (center, radius) = (ball.center.as_dvec3(), f64::from(ball.radius));
            (center - radius, center + radius)
        }
        Some(Single::Cylinder(_)) => (DVec3::new(-1.0, -1.0, 0.0), DVec3::ONE),
        None => (DVec3::NEG_ONE, DVec3::ONE),
    };
    let pick = |low: f64, high: f64, bit: usize| if bit == 0 { low } else { high };
    let corner = |i: usize| {
        DVec3::new(
            pick(low.x, high.x, i & 1),
            pick(low.y, high.y, i & 2),
            pick(low.z, high.z, i & 4),
        )
    };
    (0..8).map(|i| transform.transform_point3(corner(i))).collect()
}

fn middle(object: &Scattered) -> DVec3 {
    let corners = corners(object);
    corners.iter().sum::<DVec3>() / corners.len() as f64
}

#[test]
fn there_are_as_many_as_asked_for_and_within_the_cube() {
    for kind in ScatterKind::ALL {
        for count in COUNTS {
            let objects = of(kind, count, 3);
            assert_eq!(objects.len(), count as usize, "{kind}");
            for object in &objects {
                // The box around a turned shape reaches further than the shape, by at most √3.
                let reach =
                    corners(object).iter().map(|c| c.abs().max_element()).fold(0.0, f64::max);
                assert!(reach <= 1.8, "{kind} {count}: {reach} {object:?}");
                assert!(middle(object).abs().max_element() <= 1.0, "{kind} {count}: {object:?}");
                assert!(object.tint.min_element() >= 0.0 && object.tint.max_element() <= 1.0);
            }
        }
    }
}

#[test]
fn an_object_depends_on_the_seed_and_its_index() {
    for kind in ScatterKind::ALL {
        assert_eq!(of(kind, 500, 7), of(kind, 500, 7));
        assert_ne!(of(kind, 500, 7), of(kind, 500, 8), "{kind}");
        let objects = of(kind, 500, 7);
        assert!((1..500).all(|i| objects[i] != objects[i - 1]), "{kind}");
    }
}

#[test]
fn mixed_objects_are_of_all_shapes_and_the_others_of_one() {
    let shapes = |kind| {
        let mut counts = [0; 4];
        for object in of(kind, 400, 1) {
            counts[match object.under(&DAffine3::IDENTITY).shape {
                Some(Single::Ball(_)) => 0,
                Some(Single::Cylinder(_)) => 1,
                Some(Single::Triangle(_)) => 2,
                None => 3,
            }] += 1;
        }
        counts
    };
    assert_eq!(shapes(ScatterKind::Mixed), [200, 100, 100, 0]);
    assert_eq!(shapes(ScatterKind::Balls), [400, 0, 0, 0]);
    assert_eq!(shapes(ScatterKind::Knots), [0, 0, 0, 400]);
    assert_eq!(shapes(ScatterKind::City), [0, 0, 0, 400]);
}

#[test]
fn radii_of_balls_follow_a_power_law() {
    let radii: Vec<f64> = of(ScatterKind::Balls, 100_000, 1)
        .iter()
        .map(|object| match object.form {
            Form::Ball { radius, .. } => radius,
            _ => panic!("not a ball"),
        })
        .collect();
    let smallest = radii.iter().copied().fold(f64::INFINITY, f64::min);
    let above = |factor: f64| radii.iter().filter(|&&r| r > factor * smallest).count() as f64;
    // Twice as large, an eighth as many.
    for factor in [1.0, 2.0] {
        let ratio = above(factor) / above(2.0 * factor);
        assert!((ratio / 8.0 - 1.0).abs() < 0.1, "{factor}: {ratio}");
    }
}

#[test]
fn a_town_has_streets_and_no_tower_in_another() {
    // The feet of towers, from above: no two of them meet, and all stand on the ground.
    let town = of(ScatterKind::City, 4 * 400, 1);
    let foot = |foot: &Scattered| {
        let corners = corners(foot);
        (corners[0], corners[7])
    };
    let feet: Vec<(DVec3, DVec3)> = town.iter().step_by(4).map(foot).collect();
    for (i, (low, high)) in feet.iter().enumerate() {
        assert!(low.z.abs() < 1e-12 && high.z > 0.0);
        for (other_low, other_high) in &feet[..i] {
            let apart = other_high.x < low.x || high.x < other_low.x;
            assert!(apart || other_high.y < low.y || high.y < other_low.y);
        }
    }
    // Plots of a block are nearer to each other than those at a street, and those nearer than at an avenue.
    let distance = |a: usize, b: usize| middle(&town[4 * b]).x - middle(&town[4 * a]).x;
    assert!(distance(3, 4) > 1.5 * distance(0, 1) && distance(15, 16) > 1.5 * distance(3, 4));
}

#[test]
fn a_transform_acts_on_every_form() {
    let outer = DAffine3::from_translation(DVec3::new(5.0, -2.0, 1.0))
        * DAffine3::from_scale(DVec3::new(2.0, 3.0, 0.5));
    let middle = |placed: &Placed| match placed.shape {
        Some(Single::Triangle(t)) => t.corners.map(Vec3::as_dvec3).iter().sum::<DVec3>() / 3.0,
        Some(Single::Ball(ball)) => placed.transform.transform_point3(ball.center.as_dvec3()),
        Some(Single::Cylinder(_)) => placed.transform.transform_point3(0.5 * DVec3::Z),
        None => placed.transform.transform_point3(DVec3::ZERO),
    };
    for kind in ScatterKind::ALL {
        for object in of(kind, 40, 5) {
            let (before, after) = (object.under(&DAffine3::IDENTITY), object.under(&outer));
            let expected = outer.transform_point3(middle(&before));
            assert!(expected.distance(middle(&after)) < 1e-5, "{kind}: {object:?}");
        }
    }
}
