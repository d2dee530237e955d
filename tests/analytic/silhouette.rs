//! A ball covers the disc of the directions within asin(r/d) of its centre's.

use glam::DVec3;
use srt::math::Color;

use super::common::{picture_of, scene};
use super::view::View;

fn covered(view: &View, radius: f64, center: DVec3) -> Vec<bool> {
    let text = format!(
        "{}ca 1 1 1\nball {radius} {} {} {}\n",
        view.commands(),
        center.x,
        center.y,
        center.z
    );
    let picture = picture_of(&scene(&text), srt::render::View::Color);
    picture.pixels.iter().map(|&pixel| pixel != Color::ZERO).collect()
}

const VIEW: View = View {
    eye: DVec3::new(0.0, -6.0, 0.0),
    dir: DVec3::Y,
    up: DVec3::Z,
    fovy_degrees: 40.0,
    width: 320,
    height: 240,
};

#[test]
fn a_ball_on_the_axis_covers_a_disc_of_known_radius() {
    let seen = covered(&VIEW, 1.5, DVec3::ZERO);
    let pixels_per_unit = 120.0 / 20f64.to_radians().tan();
    let radius = (1.5f64 / 6.0).asin().tan() * pixels_per_unit;
    let area = std::f64::consts::PI * radius * radius;
    let count = seen.iter().filter(|&&seen| seen).count() as f64;
    // The number of lattice points in a disc differs from its area by about the root of its radius.
    assert!((count - area).abs() < 4.0 * radius.sqrt(), "{count} pixels, not {area}");
    let widest = seen.chunks(320).map(|row| row.iter().filter(|&&seen| seen).count()).max();
    assert!((widest.unwrap() as f64 - 2.0 * radius).abs() <= 1.0);
}

#[test]
fn a_ball_anywhere_covers_the_cone_around_it() {
    for center in [DVec3::ZERO, DVec3::new(1.7, 0.5, -0.9), DVec3::new(-2.0, 3.0, 1.5)] {
        let seen = covered(&VIEW, 1.2, center);
        let to_center = center - VIEW.eye;
        let half_angle = (1.2 / to_center.length()).asin();
        for (i, dir) in VIEW.directions().into_iter().enumerate() {
            let angle = dir.angle_between(to_center);
            if (angle - half_angle).abs() > 1e-6 {
                assert_eq!(seen[i], angle < half_angle, "{center}, pixel {i}");
            }
        }
    }
}
