//! Depths are distances along the view rays: to a plane, a ball, an ellipsoid and a cylinder.

use glam::{DMat3, DVec3};

use super::common::{depths, scene};
use super::view::View;

const VIEW: View = View {
    eye: DVec3::new(-3.0, -7.0, 4.0),
    dir: DVec3::new(3.0, 7.0, -3.5),
    up: DVec3::Z,
    fovy_degrees: 35.0,
    width: 160,
    height: 120,
};

/// Compares the depths of a picture with a closed form. `None` is a miss. Where the closed form
/// gives NaN, close to a silhouette, nothing is compared. `size` is that of the largest triangle, of which
/// depths are known to some roundings.
fn check(objects: &str, size: f64, distance: impl Fn(DVec3) -> Option<f64>) {
    let text = format!("{}{objects}", VIEW.commands());
    let depths = depths(&scene(&text));
    let mut hits = 0;
    for (dir, &depth) in VIEW.directions().into_iter().zip(&depths) {
        match distance(dir) {
            None => assert!(depth.is_nan(), "{dir}: {depth} where nothing is"),
            Some(expected) if expected.is_nan() => {}
            Some(expected) => {
                hits += 1;
                let error = (f64::from(depth) - expected).abs();
                let rounding = 4.0 * size * f64::from(f32::EPSILON);
                assert!(error < 2e-5 + rounding, "{dir}: {depth}, not {expected}");
            }
        }
    }
    assert!(hits > 1000, "only {hits} hits");
}

/// The nearer root of a·t² + 2·b·t + c; NaN close to a double root.
fn near_root(a: f64, b: f64, c: f64) -> Option<f64> {
    let discriminant = b * b - a * c;
    if discriminant.abs() < 1e-3 * b * b {
        return Some(f64::NAN);
    }
    (discriminant > 0.0).then(|| (-b - discriminant.sqrt()) / a)
}

#[test]
fn of_a_plane() {
    check(
        "triangle -999 -999 0  999 -999 0  999 999 0\ntriangle -999 -999 0  999 999 0  -999 999 0",
        2000.0,
        |dir| (dir.z < 0.0).then(|| -VIEW.eye.z / dir.z).filter(|&t| t < 500.0).or(Some(f64::NAN)),
    );
}

#[test]
fn of_a_ball() {
    let center = DVec3::new(0.2, 0.1, 0.6);
    check("ball 1.3 0.2 0.1 0.6", 0.0, |dir| {
        let f = VIEW.eye - center;
        near_root(1.0, f.dot(dir), f.dot(f) - 1.69)
    });
}

#[test]
fn of_an_ellipsoid() {
    // rotate 30 about z, scale (2, 1, 0.5): into the unit ball's space by hand.
    let own = DMat3::from_diagonal(DVec3::new(0.5, 1.0, 2.0))
        * DMat3::from_rotation_z(-30f64.to_radians());
    check("rotate 30 0 0 1\nscale 2 1 0.5\nball 1 0 0 0", 0.0, |dir| {
        let (o, d) = (own * VIEW.eye, own * dir);
        near_root(d.dot(d), o.dot(d), o.dot(o) - 1.0)
    });
}

#[test]
fn of_a_cylinder() {
    // Radius 1.4 about the z axis, from z = −0.5 to z = 1.
    check("translate 0 0 -0.5\nscale 1.4 1.4 1.5\ncylinder", 0.0, |dir| {
        let eye = VIEW.eye;
        let cap = (1.0 - eye.z) / dir.z;
        let on_cap = (eye + cap * dir).truncate().length();
        if (on_cap - 1.4).abs() < 1e-3 {
            return Some(f64::NAN);
        }
        if on_cap < 1.4 {
            return Some(cap);
        }
        let (o, d) = (eye.truncate(), dir.truncate());
        let side = near_root(d.dot(d), o.dot(d), o.dot(o) - 1.96)?;
        let z = eye.z + side * dir.z;
        if (z - 1.0).abs() < 1e-3 || (z + 0.5).abs() < 1e-3 {
            return Some(f64::NAN);
        }
        // NaN, close to the silhouette, stays NaN.
        (side.is_nan() || (-0.5..=1.0).contains(&z)).then_some(side)
    });
}
