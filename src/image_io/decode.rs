//! Bytes → pictures.

use std::io::Cursor;

use image::{DynamicImage, ImageReader};
use thiserror::Error;

use super::quantize::value;
use super::{Format, Picture};
use crate::math::Color;

/// Why bytes are not a picture of a format.
#[derive(Debug, Error)]
pub enum DecodeError {
    /// They are not a whole file of the format.
    #[error("not a .{format} picture: {source}")]
    Format {
        /// The requested format.
        format: Format,
        /// The decoder's error.
        source: image::ImageError,
    },
    /// The file is whole, and its picture has no pixels.
    #[error("a picture of {width} × {height} has no pixels")]
    Empty {
        /// In pixels.
        width: u32,
        /// In pixels.
        height: u32,
    },
}

/// The picture in the bytes of a file of this format.
///
/// Bytes become b/255, without gamma, chosen such that [`encode`](super::encode) gives the same
/// bytes; 16-bit channels become b/65535. Grey becomes colour; opacity is left out.
///
/// # Errors
/// If the bytes are not a whole file of the format, or the picture has no pixels.
pub fn decode(bytes: &[u8], format: Format) -> Result<Picture, DecodeError> {
    let image = ImageReader::with_format(Cursor::new(bytes), format.of_image_crate())
        .decode()
        .map_err(|source| DecodeError::Format { format, source })?;
    let (width, height) = (image.width(), image.height());
    if width == 0 || height == 0 {
        return Err(DecodeError::Empty { width, height });
    }
    let pixels = match image {
        DynamicImage::ImageLuma8(_)
        | DynamicImage::ImageLumaA8(_)
        | DynamicImage::ImageRgb8(_)
        | DynamicImage::ImageRgba8(_) => {
            image.into_rgb8().pixels().map(|p| Color::from_array(p.0.map(value))).collect()
        }
        // 16 bits and floats: the image crate divides by 65535, or leaves the value alone.
        _ => image.into_rgb32f().pixels().map(|p| Color::from_array(p.0)).collect(),
    };
    Ok(Picture { width, height, pixels })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::image_io::encode;
    use crate::math::Random;

    /// Every byte at least once, in a rectangle that is neither square nor symmetric.
    fn bytes_picture() -> Picture {
        let mut random = Random::new(&[5]);
        let mut channel = |i: u32| value(if i < 256 { i as u8 } else { random.below(256) as u8 });
        let pixels = (0..37 * 11).map(|i| Color::new(channel(i), channel(i * 2), channel(i * 3)));
        Picture::from_pixels(37, 11, pixels.collect()).unwrap()
    }

    #[test]
    fn a_picture_without_pixels_is_refused() {
        let mut file = encode(&bytes_picture(), Format::Tga).unwrap();
        // Width and height, two bytes each, stand at 12 in the header.
        file[12..16].fill(0);
        assert!(decode(&file, Format::Tga).is_err());
        assert!(decode(b"P6\n0 0\n255\n", Format::Ppm).is_err());
    }

    #[test]
    fn eight_bit_formats_round_trip_exactly() {
        let picture = bytes_picture();
        for format in Format::ALL.into_iter().filter(|format| !format.is_linear()) {
            let file = encode(&picture, format).unwrap();
            let back = decode(&file, format).unwrap();
            assert_eq!(back, picture, "{format}");
            assert_eq!(encode(&back, format).unwrap(), file, "{format}");
        }
    }

    #[test]
    fn exr_keeps_every_float_and_hdr_keeps_eight_bits() {
        let mut random = Random::new(&[6]);
        let mut value = || (random.next_f32() - 0.2) * 1000.0;
        let pixels = (0..20 * 9).map(|_| Color::new(value(), value(), value())).collect();
        let picture = Picture::from_pixels(20, 9, pixels).unwrap();
        let through = |format| decode(&encode(&picture, format).unwrap(), format).unwrap();
        assert_eq!(through(Format::Exr), picture);
        for (a, b) in picture.pixels.iter().zip(&through(Format::Hdr).pixels) {
            let clipped = a.max(Color::ZERO);
            let step = clipped.max_element() / 128.0;
            assert!((clipped - *b).abs().max_element() <= step, "{a} {b}");
        }
    }

    #[test]
    fn hdr_takes_what_it_cannot_hold_to_the_nearest_it_can() {
        let pixels = vec![Color::new(f32::NAN, f32::INFINITY, -1.0)];
        let picture = Picture::from_pixels(1, 1, pixels).unwrap();
        let back = decode(&encode(&picture, Format::Hdr).unwrap(), Format::Hdr).unwrap();
        let [r, g, b] = back.pixels[0].to_array();
        assert!(r == 0.0 && b == 0.0 && g > 1e37 && g.is_finite(), "{r} {g} {b}");
    }

    #[test]
    fn sixteen_bit_and_grey_pictures_are_understood() {
        let mut file = Cursor::new(Vec::new());
        let grey = image::ImageBuffer::from_raw(2, 1, vec![65_535u16, 32_768]).unwrap();
        DynamicImage::ImageLuma16(grey).write_to(&mut file, image::ImageFormat::Png).unwrap();
        let picture = decode(file.get_ref(), Format::Png).unwrap();
        assert_eq!(picture.pixels[0], Color::ONE);
        assert!((picture.pixels[1] - Color::splat(32_768.0 / 65_535.0)).length() < 1e-6);
    }

    #[test]
    fn damaged_files_are_errors_that_name_the_format() {
        for format in Format::ALL {
            let file = encode(&bytes_picture(), format).unwrap();
            for cut in [0, 10, file.len() / 2] {
                let error = decode(&file[..cut], format).unwrap_err();
                assert!(error.to_string().starts_with(&format!("not a .{format} picture: ")));
            }
        }
    }
}
