//! A plane mirror shows a ball where its mirror image would be.

use glam::DVec3;
use srt::math::Color;

use super::common::{picture_of, scene};
use super::view::View;

#[test]
fn the_image_in_a_mirror_lies_behind_it() {
    let view = View {
        eye: DVec3::new(0.3, 0.0, 1.0),
        dir: DVec3::new(0.05, 1.0, 0.02),
        up: DVec3::Z,
        fovy_degrees: 50.0,
        width: 240,
        height: 200,
    };
    // The mirror is the plane y = 4; the ball is behind the eye.
    let text = format!(
        "{}max_recursion 1
         {{
         cr 0 0 0
         cp 1 1 1
         triangle -50 4 -50  50 4 -50  50 4 50
         triangle -50 4 -50  50 4 50  -50 4 50
         }}
         ca 1 0.5 0.25
         ball 0.9 1.2 -2 1.7\n",
        view.commands()
    );
    let picture = picture_of(&scene(&text), srt::render::View::Color);
    let to_image = DVec3::new(1.2, 10.0, 1.7) - view.eye;
    let half_angle = (0.9 / to_image.length()).asin();
    let mut seen = 0;
    for (dir, &pixel) in view.directions().into_iter().zip(&picture.pixels) {
        let angle = dir.angle_between(to_image);
        if (angle - half_angle).abs() > 1e-5 {
            let expected =
                if angle < half_angle { Color::new(1.0, 0.5, 0.25) } else { Color::ZERO };
            assert_eq!(pixel, expected, "{angle} from the image, of {half_angle}");
            seen += usize::from(angle < half_angle);
        }
    }
    assert!(seen > 500, "the image is in the picture: {seen}");
}
