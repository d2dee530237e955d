//! The bytes of a picture file → a picture, in the format that they begin as.
#![no_main]

use libfuzzer_sys::fuzz_target;
use srt::image_io::{Difference, Format, Picture, compare, decode, difference_picture, encode};
use srt_fuzz::{CountingAllocator, peak};

#[global_allocator]
static ALLOCATOR: CountingAllocator = CountingAllocator;

/// What decoders may take whatever the picture. The image crate's limit is 512 MiB; its decoder of OpenEXR takes that
/// several times.
const ALWAYS: usize = 2 << 30;

/// The same for each pixel: it may be four floats in the decoder, four floats in another order, and three floats.
const FOR_EACH_PIXEL: usize = 64;

/// Larger pictures are not written again. A file of OpenEXR without pixels may have a window of many millions.
const MOST_WRITTEN: usize = 1 << 16;

fuzz_target!(|data: &[u8]| {
    let format = format(data);
    let (decoded, bytes) = peak(|| decode(data, format));
    let pixels = decoded.as_ref().map_or(0, |picture| picture.pixels.len());
    assert!(bytes <= ALWAYS + FOR_EACH_PIXEL * pixels, "{bytes} bytes for {pixels} pixels");
    match &decoded {
        Ok(picture) => check_picture(picture, format),
        Err(error) => assert!(!error.to_string().is_empty()),
    }
    srt_fuzz::count(decoded.is_ok());
});

/// The format whose first bytes these are; TGA has none of its own.
fn format(data: &[u8]) -> Format {
    match data {
        [0x89, b'P', b'N', b'G', ..] => Format::Png,
        [0x76, 0x2f, 0x31, 0x01, ..] => Format::Exr,
        [b'P', b'1'..=b'7', ..] => Format::Ppm,
        [b'#', b'?', ..] => Format::Hdr,
        _ => Format::Tga,
    }
}

/// It is a rectangle, equal to itself, and written in any format it is read again as one of that size: in those of
/// bytes and in floats as the same one.
fn check_picture(picture: &Picture, format: Format) {
    let (width, height) = (picture.width, picture.height);
    assert!(width > 0 && height > 0);
    assert_eq!(picture.pixels.len() as u64, u64::from(width) * u64::from(height));
    if picture.pixels.len() > MOST_WRITTEN {
        return;
    }
    assert_eq!(compare(picture, picture), Ok(Difference::default()));
    let black = difference_picture(picture, picture).expect("of one size");
    assert!(black.pixels.iter().all(|pixel| *pixel == srt::math::Color::ZERO));
    let other = Format::ALL[(width as usize + height as usize) % Format::ALL.len()];
    for format in [format, other] {
        // What TGA cannot hold is refused.
        let Ok(file) = encode(picture, format) else { continue };
        let again = decode(&file, format).expect("what was written can be read");
        assert_eq!((again.width, again.height), (width, height));
        if format == Format::Exr {
            assert_eq!(compare(picture, &again).map(|d| d.differing), Ok(0));
        }
        if format != Format::Hdr {
            let file_again = encode(&again, format).expect("it was written before");
            assert!(file_again == file, "{format} is written otherwise the second time");
        }
    }
}
