//! What pictures are told apart by.

use std::fmt::Write;

use sha2::{Digest, Sha256};

use crate::image_io::Picture;

/// SHA-256 of the pixels, row by row from the top left: red, green and blue as little-endian
/// 32-bit floats; hexadecimal.
pub(super) fn picture_hash(picture: &Picture) -> String {
    let mut hash = Sha256::new();
    for pixel in &picture.pixels {
        for channel in pixel.to_array() {
            hash.update(channel.to_le_bytes());
        }
    }
    hash.finalize().iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}"); // writing to a string cannot fail
        text
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_pixels_have_the_hash_of_nothing() {
        let hash = picture_hash(&Picture::new(0, 0));
        assert!(hash.starts_with("e3b0c44298fc1c149afbf4c8996fb924"), "{hash}");
        assert_ne!(picture_hash(&Picture::new(1, 1)), hash);
    }
}
