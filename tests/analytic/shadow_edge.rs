//! The shadow of a cylinder on the floor: the hull of its foot and of its head's projection.

use glam::{DVec2, DVec3};
use srt::math::Color;

use super::common::{picture_of, scene};
use super::view::View;

const RADIUS: f64 = 0.8;
const HEIGHT: f64 = 1.5;
const LIGHT: DVec3 = DVec3::new(-3.0, 1.0, 4.0);

/// How deep a point of the floor is in the shadow: negative inside.
///
/// From the light, the cylinder's slice at height z falls on the floor as a disc whose centre and
/// radius grow linearly with s = z/(z_light − z), scaled to [0, 1]; the shadow is their union.
/// |p − c(s)|² − r(s)² is a quadratic polynomial of s.
fn depth_in_shadow(p: DVec2) -> f64 {
    let growth = HEIGHT / (LIGHT.z - HEIGHT);
    let (c1, r0, r1) = (-growth * LIGHT.truncate(), RADIUS, RADIUS * growth);
    let a = c1.dot(c1) - r1 * r1;
    let b = -p.dot(c1) - r0 * r1;
    let c = p.dot(p) - r0 * r0;
    let at = |s: f64| a * s * s + 2.0 * b * s + c;
    let inner = if a > 0.0 { (-b / a).clamp(0.0, 1.0) } else { 0.0 };
    at(inner).min(at(0.0)).min(at(1.0))
}

#[test]
fn the_shadow_of_a_cylinder_ends_where_it_should() {
    let view = View {
        eye: DVec3::new(1.0, 0.0, 9.0),
        dir: DVec3::NEG_Z,
        up: DVec3::Y,
        fovy_degrees: 50.0,
        width: 240,
        height: 200,
    };
    let text = format!(
        "{}ca 0.25 0.25 0.25
         triangle -12 -12 0  12 -12 0  12 12 0
         triangle -12 -12 0  12 12 0  -12 12 0
         pointlight {} {} {} 1 1 1
         cr 0 0 0
         scale {RADIUS} {RADIUS} {HEIGHT}
         cylinder\n",
        view.commands(),
        LIGHT.x,
        LIGHT.y,
        LIGHT.z,
    );
    let picture = picture_of(&scene(&text), srt::render::View::Color);
    let (mut dark, mut lit) = (0, 0);
    for (dir, &pixel) in view.directions().into_iter().zip(&picture.pixels) {
        let p = (view.eye - view.eye.z / dir.z * dir).truncate();
        let depth = depth_in_shadow(p);
        if pixel == Color::ZERO || depth.abs() < 1e-4 {
            continue; // the cylinder itself, or the edge
        }
        if depth < 0.0 {
            dark += 1;
            assert_eq!(pixel, Color::splat(0.25), "{p} is in the shadow");
        } else {
            lit += 1;
            let to_light = LIGHT - p.extend(0.0);
            let expected = 0.25 + to_light.z / to_light.length();
            assert!((f64::from(pixel.x) - expected).abs() < 1e-5, "{p}: {pixel}, not {expected}");
        }
    }
    assert!(dark > 1000 && lit > 10_000, "{dark} dark, {lit} lit");
}
