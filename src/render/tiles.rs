//! The order of the pixels of a tile, and so of a picture.

use crate::film::{Crop, TILE_SIDE, tiles_of};

use super::view_rays::Pixel;

/// The columns and rows of a picture's pixels, in the order in which a single thread renders them.
pub fn pixel_order(width: u32, height: u32) -> impl Iterator<Item = [u32; 2]> {
    let tiles = tiles_of(Crop { x0: 0, y0: 0, x1: width, y1: height });
    tiles.into_iter().flat_map(pixels_of).map(|pixel| [pixel.x, pixel.y])
}

/// The pixels of a tile along Morton's curve. Pixels that follow each other lie in a small square,
/// so the rays through them are coherent.
pub(super) fn pixels_of(tile: Crop) -> Vec<Pixel> {
    let even_bits = |code: u32| (0..16).fold(0, |bits, i| bits | (code >> (2 * i) & 1) << i);
    (0..TILE_SIDE * TILE_SIDE)
        .map(|code| Pixel { x: tile.x0 + even_bits(code), y: tile.y0 + even_bits(code >> 1) })
        .filter(|pixel| pixel.x < tile.x1 && pixel.y < tile.y1)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_cover_a_region_once() {
        let region = Crop { x0: 5, y0: 2, x1: 40, y1: 19 };
        let tiles = tiles_of(region);
        assert_eq!(tiles.len(), 3 * 2);
        assert_eq!(tiles[0], Crop { x0: 5, y0: 2, x1: 21, y1: 18 });
        assert_eq!(tiles[5], Crop { x0: 37, y0: 18, x1: 40, y1: 19 });
        assert_eq!(tiles.iter().map(Crop::pixels).sum::<u64>(), region.pixels());
    }

    #[test]
    fn a_tile_is_walked_in_squares_and_every_pixel_is_reached() {
        let tile = Crop { x0: 32, y0: 16, x1: 48, y1: 32 };
        let pixels = pixels_of(tile);
        for square in pixels.chunks(16) {
            let side = |of: fn(&Pixel) -> u32| {
                let values = || square.iter().map(of);
                values().max().unwrap_or(0) - values().min().unwrap_or(0)
            };
            assert_eq!((side(|p| p.x), side(|p| p.y)), (3, 3));
        }
        let cut = Crop { x1: 37, y1: 19, ..tile };
        let mut places: Vec<_> = pixels_of(cut).iter().map(|p| (p.y, p.x)).collect();
        places.sort_unstable();
        let expected: Vec<_> = (16..19).flat_map(|y| (32..37).map(move |x| (y, x))).collect();
        assert_eq!(places, expected);
    }
}
