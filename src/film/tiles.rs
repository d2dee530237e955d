//! The tiles of a region: the areas that parts have.

use super::Crop;

/// Side of a tile in pixels.
pub const TILE_SIDE: u32 = 16;

/// The tiles of a region, row by row. Those at its right and bottom ends may be smaller.
#[must_use]
pub fn tiles_of(region: Crop) -> Vec<Crop> {
    let columns = || (region.x0..region.x1).step_by(TILE_SIDE as usize);
    let rows = (region.y0..region.y1).step_by(TILE_SIDE as usize);
    rows.flat_map(|y0| {
        columns().map(move |x0| Crop {
            x0,
            y0,
            x1: x0.saturating_add(TILE_SIDE).min(region.x1),
            y1: y0.saturating_add(TILE_SIDE).min(region.y1),
        })
    })
    .collect()
}

/// The place in [`tiles_of`] of a tile; `None` if the region, which is not empty, has no such tile.
#[must_use]
pub fn tile_at(region: Crop, tile: Crop) -> Option<usize> {
    let step = |from: u32, to: u32| {
        let distance = to.checked_sub(from)?;
        distance.is_multiple_of(TILE_SIDE).then_some(distance / TILE_SIDE)
    };
    let (column, row) = (step(region.x0, tile.x0)?, step(region.y0, tile.y0)?);
    let expected = Crop {
        x1: tile.x0.saturating_add(TILE_SIDE).min(region.x1),
        y1: tile.y0.saturating_add(TILE_SIDE).min(region.y1),
        ..tile
    };
    let is_one = tile == expected && !tile.is_empty();
    let columns = region.width().div_ceil(TILE_SIDE) as usize;
    is_one.then_some(row as usize * columns + column as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_know_their_places() {
        let region = Crop { x0: 5, y0: 7, x1: 55, y1: 40 };
        let tiles = tiles_of(region);
        assert_eq!(tiles.len(), 4 * 3);
        assert_eq!(tiles.iter().map(Crop::pixels).sum::<u64>(), region.pixels());
        for (place, &tile) in tiles.iter().enumerate() {
            assert_eq!(tile_at(region, tile), Some(place));
        }
        for wrong in [
            Crop { x0: 6, ..tiles[0] },
            Crop { x1: 20, ..tiles[0] },
            Crop { x0: 0, x1: 5, ..tiles[0] },
            Crop { x0: 69, x1: 85, ..tiles[0] },
            Crop { y0: 55, y1: 71, ..tiles[0] },
            Crop { x0: u32::MAX, x1: u32::MAX, ..tiles[0] },
        ] {
            assert_eq!(tile_at(region, wrong), None, "{wrong}");
        }
    }
}
