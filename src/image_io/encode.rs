//! Pictures → bytes.

use std::io::Cursor;

use image::codecs::pnm::{PnmEncoder, PnmSubtype, SampleEncoding};
use image::codecs::tga::TgaEncoder;
use image::{DynamicImage, ExtendedColorType, ImageBuffer, ImageEncoder, ImageResult};
use thiserror::Error;

use super::quantize::bytes;
use super::{Format, Picture, WrongLength};

/// Why a picture cannot be written.
#[derive(Debug, Error)]
pub enum EncodeError {
    /// The picture's pixels do not fill its rectangle.
    #[error(transparent)]
    Length(#[from] WrongLength),
    /// There is nothing to write.
    #[error("a picture of {width} × {height} pixels has nothing to write")]
    Empty {
        /// Its width in pixels.
        width: u32,
        /// Its height in pixels.
        height: u32,
    },
    /// The format has no room for so many pixels in a row or column.
    #[error(
        "a picture of {width} × {height} pixels is too large for .{format}: at most {limit} either way"
    )]
    TooLarge {
        /// Its width in pixels.
        width: u32,
        /// Its height in pixels.
        height: u32,
        /// The requested format.
        format: Format,
        /// The largest width and height of the format.
        limit: u32,
    },
    /// The encoder failed.
    #[error("cannot write the picture as .{format}: {source}")]
    Encoder {
        /// The requested format.
        format: Format,
        /// The encoder's error.
        source: image::ImageError,
    },
}

/// The bytes of a file of this format.
///
/// `.tga`, `.png`, `.ppm`: each channel clamped to [0, 1] and written as ⌊255·c⌋ without gamma, NaN
/// as 0. `.exr`: the floats as they are. `.hdr`: 8 bits of mantissa under a shared exponent, what
/// is negative or NaN as 0.
///
/// ```
/// use srt::image_io::{Format, Picture, encode};
///
/// let file = encode(&Picture::new(2, 1), Format::Ppm)?;
/// assert_eq!(file, b"P6\n2 1 255\n\0\0\0\0\0\0");
/// # Ok::<(), srt::image_io::EncodeError>(())
/// ```
///
/// # Errors
/// If the picture is empty, larger than the format allows, or not filled.
pub fn encode(picture: &Picture, format: Format) -> Result<Vec<u8>, EncodeError> {
    check(picture, format)?;
    let (width, height) = (picture.width, picture.height);
    let done = match format {
        Format::Tga => encode_tga(picture),
        Format::Ppm => encode_ppm(picture),
        Format::Png => ImageBuffer::from_raw(width, height, rgb8(picture.rows()))
            .map_or_else(too_short, |buffer| write(&DynamicImage::ImageRgb8(buffer), format)),
        Format::Exr => encode_floats(picture, format, |c| c),
        // 2¹²⁶ is well inside the range of the shared exponent; `max` takes NaN to 0.
        Format::Hdr => encode_floats(picture, format, |c| c.max(0.0).min(2f32.powi(126))),
    };
    done.map_err(|source| EncodeError::Encoder { format, source })
}

fn check(picture: &Picture, format: Format) -> Result<(), EncodeError> {
    let (width, height) = (picture.width, picture.height);
    let length = picture.pixels.len();
    if length as u64 != u64::from(width) * u64::from(height) {
        return Err(WrongLength { width, height, length }.into());
    }
    if length == 0 {
        return Err(EncodeError::Empty { width, height });
    }
    let limit = match format {
        Format::Tga => u32::from(u16::MAX),
        _ => i32::MAX as u32,
    };
    if width.max(height) > limit {
        return Err(EncodeError::TooLarge { width, height, format, limit });
    }
    Ok(())
}

/// Truevision TGA: 18 bytes of header, then blue, green and red, rows from the bottom.
fn encode_tga(picture: &Picture) -> ImageResult<Vec<u8>> {
    /// Bit 5 of this byte means that rows start at the top; the low bits count alpha bits.
    const IMAGE_DESCRIPTOR: usize = 17;
    let mut file = Vec::new();
    // The image crate writes rows as they come and always calls them rows from the top. The
    // course's files start at the bottom: the rows go in turned over, and the bit is cleared.
    TgaEncoder::new(&mut file).disable_rle().write_image(
        &rgb8(picture.rows().rev()),
        picture.width,
        picture.height,
        ExtendedColorType::Rgb8,
    )?;
    file[IMAGE_DESCRIPTOR] = 0;
    Ok(file)
}

fn encode_ppm(picture: &Picture) -> ImageResult<Vec<u8>> {
    let mut file = Vec::new();
    PnmEncoder::new(&mut file)
        .with_subtype(PnmSubtype::Pixmap(SampleEncoding::Binary))
        .write_image(
            &rgb8(picture.rows()),
            picture.width,
            picture.height,
            ExtendedColorType::Rgb8,
        )?;
    Ok(file)
}

fn encode_floats(
    picture: &Picture,
    format: Format,
    channel: impl Fn(f32) -> f32,
) -> ImageResult<Vec<u8>> {
    let values = picture.pixels.iter().flat_map(|c| c.to_array()).map(channel).collect();
    ImageBuffer::from_raw(picture.width, picture.height, values)
        .map_or_else(too_short, |buffer| write(&DynamicImage::ImageRgb32F(buffer), format))
}

fn rgb8<'a>(rows: impl Iterator<Item = &'a [crate::math::Color]>) -> Vec<u8> {
    rows.flatten().flat_map(|&color| bytes(color)).collect()
}

fn write(image: &DynamicImage, format: Format) -> ImageResult<Vec<u8>> {
    let mut file = Cursor::new(Vec::new());
    image.write_to(&mut file, format.of_image_crate())?;
    Ok(file.into_inner())
}

/// The error where the image crate finds fewer values than pixels, which `check` has excluded.
fn too_short<T>() -> ImageResult<T> {
    use image::error::{ImageError, ParameterError, ParameterErrorKind};
    Err(ImageError::Parameter(ParameterError::from_kind(ParameterErrorKind::DimensionMismatch)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Color;

    /// Red and green above, blue and grey below.
    fn four_pixels() -> Picture {
        let pixels = vec![Color::X, Color::Y, Color::Z, Color::splat(0.5)];
        Picture::from_pixels(2, 2, pixels).unwrap()
    }

    #[test]
    fn a_tga_file_is_the_courses_to_the_byte() {
        let file = encode(&four_pixels(), Format::Tga).unwrap();
        let header = [0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 2, 0, 24, 0];
        let bottom_row = [255, 0, 0, 127, 127, 127];
        let top_row = [0, 0, 255, 0, 255, 0];
        assert_eq!(file, [&header[..], &bottom_row, &top_row].concat());
    }

    #[test]
    fn a_ppm_file_is_header_and_bytes_from_the_top() {
        let file = encode(&four_pixels(), Format::Ppm).unwrap();
        let pixels = [255, 0, 0, 0, 255, 0, 0, 0, 255, 127, 127, 127];
        assert_eq!(file, [&b"P6\n2 2 255\n"[..], &pixels].concat());
    }

    #[test]
    fn what_has_no_place_in_a_format_is_refused() {
        let wide = Picture::new(65_536, 1);
        assert!(matches!(encode(&wide, Format::Tga), Err(EncodeError::TooLarge { .. })));
        assert!(encode(&wide, Format::Png).is_ok());
        for format in Format::ALL {
            let empty = Picture::new(0, 3);
            assert!(matches!(encode(&empty, format), Err(EncodeError::Empty { .. })));
            let short = Picture { width: 2, height: 2, pixels: vec![Color::ZERO; 3] };
            assert!(matches!(encode(&short, format), Err(EncodeError::Length(_))));
        }
    }
}
