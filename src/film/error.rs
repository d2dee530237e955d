//! Why a part does not belong to a film.

use thiserror::Error;

use super::Crop;

/// Why a film does not take a part.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum FilmError {
    /// Its area is no tile of the picture.
    #[error("its area {area} is no tile of the picture")]
    NoTile {
        /// The area.
        area: Crop,
    },
    /// Its samples are none that such a part can have.
    #[error(
        "its samples {first} to {end} (excluded) of the tile {area} cannot be: pixels have {all_samples}, \
         and sums begin with sample 0"
    )]
    Range {
        /// The tile.
        area: Crop,
        /// The first sample.
        first: u32,
        /// Behind the last sample.
        end: u32,
        /// How many there are.
        all_samples: u32,
    },
    /// It has not as many values as its piece has.
    #[error("its tile {area} has {found} values in place of {expected}")]
    Length {
        /// The tile.
        area: Crop,
        /// How many there should be.
        expected: u64,
        /// How many there are.
        found: usize,
    },
    /// Some of its samples are there already.
    #[error(
        "samples {first} to {end} (excluded) of the tile {area} are there already, at least in part"
    )]
    Twice {
        /// The tile.
        area: Crop,
        /// The first sample.
        first: u32,
        /// Behind the last sample.
        end: u32,
    },
    /// The film estimates noise, which sums alone do not tell.
    #[error("its tile {area} has sums without the moments that noise is estimated from")]
    NoMoments {
        /// The tile.
        area: Crop,
    },
}
