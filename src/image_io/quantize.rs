//! Linear colours ↔ bytes, as the course's program did it: clamped, floored, without gamma.

use crate::math::Color;

use super::Picture;

/// ⌊255·c⌋ with c clamped to [0, 1]; NaN gives 0.
pub(super) fn byte(c: f32) -> u8 {
    // The conversion cuts the fraction off, and takes NaN to 0.
    (c.clamp(0.0, 1.0) * 255.0) as u8
}

/// The channels of a colour as bytes.
pub(super) fn bytes(color: Color) -> [u8; 3] {
    color.to_array().map(byte)
}

/// The bytes that a picture has in a file of bytes, with those of an opaque alpha: red, green, blue and 255 for each
/// pixel, row by row from the top left, as screens take them.
///
/// ```
/// use srt::image_io::{Picture, rgba_bytes};
/// use srt::math::Color;
///
/// let picture = Picture::from_pixels(1, 1, vec![Color::new(2.0, 0.5, f32::NAN)])?;
/// assert_eq!(rgba_bytes(&picture), [255, 127, 0, 255]);
/// # Ok::<(), srt::image_io::WrongLength>(())
/// ```
#[must_use]
pub fn rgba_bytes(picture: &Picture) -> Vec<u8> {
    let rgba = |&color: &Color| {
        let [r, g, b] = bytes(color);
        [r, g, b, u8::MAX]
    };
    picture.pixels.iter().flat_map(rgba).collect()
}

/// The value that a byte represents: b/255, such that [`byte`] gives the byte back.
pub(super) fn value(b: u8) -> f32 {
    let c = f32::from(b) / 255.0;
    // Where the quotient was rounded down, 255 times it may fall short of b, and the floor would
    // lose a level: the next float above is as near to b/255 and does not.
    if byte(c) == b { c } else { c.next_up() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_byte_comes_back() {
        for b in 0..=255 {
            assert_eq!(byte(value(b)), b);
            assert!((f64::from(value(b)) - f64::from(b) / 255.0).abs() < 1e-7);
        }
    }

    #[test]
    fn values_outside_are_clamped_and_nan_is_black() {
        let cases = [
            (-1.0, 0),
            (-0.0, 0),
            (0.5, 127),
            (0.999_999, 254),
            (1.0, 255),
            (7.0, 255),
            (f32::INFINITY, 255),
            (f32::NEG_INFINITY, 0),
            (f32::NAN, 0),
        ];
        for (c, b) in cases {
            assert_eq!(byte(c), b, "{c}");
        }
    }
}
