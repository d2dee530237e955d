//! The pictures of a comparison as files: their names, and the hashes of their pixels.

use sha2::{Digest, Sha256};

use crate::image_io::Picture;
use crate::record::PictureFile;

use crate::sealed::hexadecimal;

/// The file of a scene's picture.
pub(crate) fn picture_name(scene: &str) -> String {
    format!("{scene}.png")
}

/// The file of a structure's heatmap of a scene. The marks between a structure's options mean
/// something else in addresses of pages; dots are in no name of a structure.
pub(crate) fn heatmap_name(scene: &str, structure: &str) -> String {
    format!("{scene}-heatmap-{}.png", structure.replace([':', ',', '='], "."))
}

/// A picture in a file, as the record names it.
pub(super) fn picture_file(file: String, picture: &Picture) -> PictureFile {
    let hash = picture_hash(picture);
    PictureFile { file, width: picture.width, height: picture.height, hash }
}

/// SHA-256 of the pixels, row by row from the top left: red, green and blue as little-endian
/// 32-bit floats; hexadecimal.
pub(super) fn picture_hash(picture: &Picture) -> String {
    let mut hash = Sha256::new();
    for pixel in &picture.pixels {
        for channel in pixel.to_array() {
            hash.update(channel.to_le_bytes());
        }
    }
    hexadecimal(&hash.finalize())
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
