//! Bytes → pictures.

use std::io::Cursor;

use exr::meta::MetaData;
use exr::meta::header::Header;
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
    /// No file of so few bytes holds the pixels that this one of OpenEXR announces.
    #[error(
        "not a .exr picture: {bytes} bytes cannot hold the {pixels} pixels of its data windows"
    )]
    Window {
        /// The length of the file.
        bytes: usize,
        /// What its header announces.
        pixels: usize,
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
    if format == Format::Exr {
        check_windows(bytes)?;
    }
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

/// More bytes of pixels than one byte of a file of OpenEXR can stand for. Deflate, the closest of its compressions,
/// makes [1032 bytes of one](https://zlib.net/zlib_tech.html), and PXR24 stores four bytes of a float as three.
const MOST_EXPANSION: usize = 2048;

/// The decoder makes room for a block of pixels as the header announces it, whatever the file holds: some hundred bytes
/// could take gigabytes before they are refused.
fn check_windows(bytes: &[u8]) -> Result<(), DecodeError> {
    // What is no header is the decoder's to name.
    let Ok(meta) = MetaData::read_from_buffered(Cursor::new(bytes), false) else { return Ok(()) };
    let area =
        |header: &Header| header.layer_size.width().saturating_mul(header.layer_size.height());
    let announced = (meta.headers.iter())
        .map(|header| area(header).saturating_mul(header.channels.bytes_per_pixel))
        .fold(0, usize::saturating_add);
    if announced > bytes.len().saturating_mul(MOST_EXPANSION) {
        let pixels = meta.headers.iter().map(area).fold(0, usize::saturating_add);
        return Err(DecodeError::Window { bytes: bytes.len(), pixels });
    }
    Ok(())
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
    fn exr_of_a_window_that_its_bytes_cannot_hold_is_refused() {
        let mut file = encode(&bytes_picture(), Format::Exr).unwrap();
        let key = b"dataWindow\0box2i\0";
        let at = file.windows(key.len()).position(|w| w == key).unwrap() + key.len() + 4;
        // The last column and the last row, after the first ones.
        file[at + 8..at + 12].copy_from_slice(&(1i32 << 23).to_le_bytes());
        let error = decode(&file, Format::Exr).unwrap_err();
        assert!(
            matches!(error, DecodeError::Window { pixels, .. } if pixels == 11 * ((1 << 23) + 1)),
            "{error}"
        );
    }

    #[test]
    fn exr_of_one_colour_is_read_however_it_is_compressed() {
        use exr::prelude::*;
        for compression in [
            Compression::Uncompressed,
            Compression::RLE,
            Compression::ZIP1,
            Compression::ZIP16,
            Compression::PIZ,
            Compression::PXR24,
            Compression::B44A,
        ] {
            let encoding = Encoding { compression, ..Encoding::SMALL_LOSSLESS };
            let channels = SpecificChannels::rgb(|_| (0.0f32, 0.0f32, 0.0f32));
            let layer = Layer::new((1024, 1024), LayerAttributes::named(""), encoding, channels);
            let mut file = Cursor::new(Vec::new());
            Image::from_layer(layer).write().to_buffered(&mut file).unwrap();
            let picture = decode(file.get_ref(), Format::Exr).unwrap();
            assert!(picture.pixels.iter().all(|pixel| *pixel == Color::ZERO), "{compression}");
        }
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
