//! A picture divided among machines.

use std::fmt;

use super::{Crop, Piece, tiles_of};

/// How a picture is divided.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Division {
    /// Each part has all samples of some tiles.
    #[default]
    Tiles,
    /// Each part has some samples of all tiles, or nearly so.
    Samples,
}

impl Division {
    /// All ways.
    pub const ALL: [Self; 2] = [Self::Tiles, Self::Samples];

    /// The name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Tiles => "tiles",
            Self::Samples => "samples",
        }
    }

    /// A line of help.
    #[must_use]
    pub fn summary(self) -> &'static str {
        match self {
            Self::Tiles => {
                "every n-th tile with all samples: the least work and the smallest files"
            }
            Self::Samples => {
                "some samples of all tiles: each part shows the whole picture, with more noise"
            }
        }
    }
}

/// Part `number` of `count`, from 1. Shown as it is typed: `3/7`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Share {
    /// From 1 to `count`.
    pub number: u32,
    /// How many parts there are; at most [`Share::MOST`].
    pub count: u32,
}

impl Share {
    /// The most parts of a picture.
    pub const MOST: u32 = 1_000_000;

    /// The pieces of the part, in a picture of `samples` samples a pixel. Those of all parts are the whole picture,
    /// each piece once. Where there are more parts than tiles, or samples, some are empty.
    #[must_use]
    pub fn pieces(self, division: Division, region: Crop, samples: u32) -> Vec<Piece> {
        let tiles = tiles_of(region);
        match division {
            Division::Tiles => {
                let (first, step) = (self.number as usize - 1, self.count as usize);
                let own = tiles.into_iter().skip(first).step_by(step);
                own.map(|area| Piece { area, samples: 0..samples }).collect()
            }
            Division::Samples => self.samples_of(&tiles, samples),
        }
    }

    /// All samples in one row, sample by sample and within a sample tile by tile, are cut into `count` pieces of equal
    /// length. So parts are equally long for any number of them, and of each tile a part has samples that follow each
    /// other.
    fn samples_of(self, tiles: &[Crop], samples: u32) -> Vec<Piece> {
        let row = tiles.len() as u64;
        let all = row * u64::from(samples);
        let cut =
            |number: u32| (u128::from(all) * u128::from(number) / u128::from(self.count)) as u64;
        let (first, end) = (cut(self.number - 1), cut(self.number));
        // The first sample of tile `tile` that is not before `place`.
        let sample = |place: u64, tile: u64| place.saturating_sub(tile).div_ceil(row) as u32;
        let pieces = tiles
            .iter()
            .zip(0u64..)
            .map(|(&area, tile)| Piece { area, samples: sample(first, tile)..sample(end, tile) });
        pieces.filter(|piece| !piece.samples.is_empty()).collect()
    }
}

impl fmt::Display for Share {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.number, self.count)
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn the_parts_are_the_whole_each_sample_once() {
        let region = Crop { x0: 3, y0: 0, x1: 70, y1: 33 };
        for division in Division::ALL {
            for (samples, count) in [(1, 1), (1, 4), (9, 2), (9, 7), (4, 100), (16, 16)] {
                let mut seen = BTreeSet::new();
                let mut lengths = Vec::new();
                for number in 1..=count {
                    let pieces = Share { number, count }.pieces(division, region, samples);
                    let before = seen.len();
                    for Piece { area, samples } in pieces {
                        for sample in samples {
                            assert!(seen.insert((area.x0, area.y0, sample)), "{division:?}");
                        }
                    }
                    lengths.push(seen.len() - before);
                }
                assert_eq!(seen.len(), tiles_of(region).len() * samples as usize);
                let (least, most) = (lengths.iter().min().unwrap(), lengths.iter().max().unwrap());
                let step = if division == Division::Tiles { samples as usize } else { 1 };
                assert!(most - least <= step, "{division:?} {count}: {lengths:?}");
            }
        }
    }

    #[test]
    fn as_many_parts_as_samples_have_a_sample_each() {
        let region = Crop { x0: 0, y0: 0, x1: 40, y1: 40 };
        let pieces = Share { number: 3, count: 4 }.pieces(Division::Samples, region, 4);
        assert_eq!(pieces.len(), 9);
        assert!(pieces.iter().all(|piece| piece.samples == (2..3)));
    }
}
