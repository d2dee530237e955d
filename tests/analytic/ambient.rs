//! Without lights a colour is ca·cr, exactly, and a byte of a picture is ⌊255·c⌋.

use glam::DVec3;
use srt::image_io::{Format, encode};
use srt::math::Color;

use super::common::{picture_of, scene};
use super::view::View;

const VIEW: View = View {
    eye: DVec3::ZERO,
    dir: DVec3::Y,
    up: DVec3::Z,
    fovy_degrees: 60.0,
    width: 24,
    height: 16,
};

/// The eye is inside of each shape: all that it sees is the shape.
fn inside_of(shape: &str, ca: Color, cr: Color) -> Vec<Color> {
    let text = format!(
        "{}ca {} {} {}\ncr {} {} {}\n{shape}\n",
        VIEW.commands(),
        ca.x,
        ca.y,
        ca.z,
        cr.x,
        cr.y,
        cr.z
    );
    picture_of(&scene(&text), srt::render::View::Color).pixels
}

#[test]
fn the_inside_of_everything_is_ca_times_cr() {
    let (ca, cr) = (Color::new(0.3, 0.7, 1.0), Color::new(0.9, 0.1, 0.6));
    for shape in [
        "ball 5 0 0 0",
        "translate 0 0 -4\nscale 3 4 9\ncylinder",
        "scale 5 5 5\nobject_flat generate:icosphere:320",
        "scale 5 -6 5\nobject_phong generate:icosphere:320",
    ] {
        for pixel in inside_of(shape, ca, cr) {
            assert_eq!(pixel, ca * cr, "{shape}");
        }
    }
}

#[test]
fn bytes_are_floors() {
    for (c, byte) in [
        (0.0, 0),
        (0.003, 0),
        (0.004, 1),
        (0.5, 127),
        (0.75, 191),
        (0.999, 254),
        (1.0, 255),
        (1.5, 255),
    ] {
        let text = format!("{}ca {c} {c} {c}\nball 5 0 0 0\n", VIEW.commands());
        let picture = picture_of(&scene(&text), srt::render::View::Color);
        let file = encode(&picture, Format::Ppm).unwrap();
        let pixels = &file[file.len() - 24 * 16 * 3..];
        assert!(pixels.iter().all(|&b| b == byte), "{c}: {}, not {byte}", pixels[0]);
    }
}
