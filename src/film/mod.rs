//! A picture as it grows. A renderer sends parts: the samples of a tile, or a range of them, or their sums. A [`Film`]
//! puts parts together, and the picture is the same, bit for bit, however it was cut and in whatever order its parts
//! arrive.
//!
//! The sum of a pixel is *defined*: its samples are added in `f32` in the order of their numbers, from 0 on, and
//! divided by their number at the end. A part that begins with sample 0 holds such sums; a part that begins later holds
//! its samples, which the film adds where they are due. A part that arrives too early waits. So the picture is that of
//! a rendering in one go, to the last bit, for samples of any size, infinities and NaNs among them. (Sums that are
//! exact, and so independent of their order, would round otherwise: pictures would change, and a pixel of a part would
//! take ten times the memory of a sum.)
//!
//! ```
//! use srt::film::{Crop, Film, Part, Piece, Values};
//! use srt::math::Color;
//!
//! let area = Crop { x0: 0, y0: 0, x1: 1, y1: 1 }; // a picture of a pixel, with three samples
//! let film = Film::new(area, 3);
//! let samples = [0.25, 1e-9, 3.0].map(Color::splat);
//! let part = |samples, values| Part { piece: Piece { area, samples }, values };
//! film.take(part(1..3, Values::Samples(samples[1..].to_vec())))?; // too early: it waits
//! film.take(part(0..1, Values::Sums(samples[..1].to_vec())))?;
//! assert_eq!(film.means(Color::ZERO), [samples.iter().sum::<Color>() / 3.0]);
//! # Ok::<(), srt::film::FilmError>(())
//! ```
//!
//! Knows neither scenes nor files.

mod crop;
mod division;
mod error;
mod noise;
mod part;
mod passes;
mod tile_sums;
mod tiles;

use std::sync::{Mutex, MutexGuard, PoisonError};

use crate::math::Color;

pub use crop::Crop;
pub use division::{Division, Share};
pub use error::FilmError;
pub use noise::{Moments, seen_luminance};
pub use part::{Part, Piece, Values};
pub use passes::{MOST_SAMPLES_OF_A_PASS, doubling_passes, even_passes};
pub use tiles::{TILE_SIDE, tile_at, tiles_of};

use tile_sums::TileSums;

/// A picture while parts arrive, from any number of threads. Each tile has a lock of its own.
#[derive(Debug)]
pub struct Film {
    region: Crop,
    samples: u32,
    keeps_moments: bool,
    areas: Vec<Crop>,
    tiles: Vec<Mutex<TileSums>>,
}

/// How far a film is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Coverage {
    /// Samples that are added up, over all pixels.
    pub samples: u64,
    /// Samples of the whole picture.
    pub all_samples: u64,
    /// Pixels with at least one sample.
    pub pixels: u64,
    /// Pixels of the picture.
    pub all_pixels: u64,
}

impl Coverage {
    /// Whether nothing is missing.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.samples == self.all_samples
    }

    /// Samples a pixel, on average.
    #[must_use]
    pub fn samples_per_pixel(&self) -> f64 {
        self.samples as f64 / self.all_pixels.max(1) as f64
    }
}

impl Film {
    /// An empty film of a region that is not, with `samples` samples a pixel; at least 1.
    #[must_use]
    pub fn new(region: Crop, samples: u32) -> Self {
        let areas = tiles_of(region);
        let tiles = areas.iter().map(|_| Mutex::default()).collect();
        Self { region, samples: samples.max(1), keeps_moments: false, areas, tiles }
    }

    /// The same, which estimates noise too. It takes samples, or sums with their moments, but no sums alone.
    #[must_use]
    pub fn with_moments(region: Crop, samples: u32) -> Self {
        Self { keeps_moments: true, ..Self::new(region, samples) }
    }

    /// The part of the picture that it shows.
    #[must_use]
    pub fn region(&self) -> Crop {
        self.region
    }

    /// The samples of a pixel when it is complete.
    #[must_use]
    pub fn samples(&self) -> u32 {
        self.samples
    }

    /// Adds a part; one that begins behind what is there waits for what is missing.
    ///
    /// # Errors
    /// If the part does not belong to this film, or a sample of it is there already. Then the film is as before.
    pub fn take(&self, part: Part) -> Result<(), FilmError> {
        let area = part.piece.area;
        let place = tile_at(self.region, area).filter(|&place| self.areas[place] == area);
        let place = place.ok_or(FilmError::NoTile { area })?;
        part.check(self.samples)?;
        self.tile(place).take(part, self.keeps_moments)
    }

    /// What is missing of the first `samples` samples of each pixel, tile by tile.
    #[must_use]
    pub fn missing(&self, samples: u32) -> Vec<Piece> {
        let pieces = self.areas.iter().enumerate().filter_map(|(place, &area)| {
            let done = self.tile(place).done();
            (done < samples).then_some(Piece { area, samples: done..samples })
        });
        pieces.collect()
    }

    /// How much of it there is. What waits does not count.
    #[must_use]
    pub fn coverage(&self) -> Coverage {
        let mut coverage = Coverage {
            all_pixels: self.region.pixels(),
            all_samples: self.region.pixels() * u64::from(self.samples),
            ..Coverage::default()
        };
        for (place, area) in self.areas.iter().enumerate() {
            let done = self.tile(place).done();
            coverage.samples += area.pixels() * u64::from(done);
            coverage.pixels += if done > 0 { area.pixels() } else { 0 };
        }
        coverage
    }

    /// The mean of each pixel's samples so far, row by row from the top left; `missing` where there are none.
    #[must_use]
    pub fn means(&self, missing: Color) -> Vec<Color> {
        let width = self.region.width() as usize;
        let mut pixels = vec![missing; width * self.region.height() as usize];
        for (place, area) in self.areas.iter().enumerate() {
            let tile = self.tile(place);
            if tile.done() == 0 {
                continue;
            }
            let first = (area.y0 - self.region.y0) as usize * width;
            let first = first + (area.x0 - self.region.x0) as usize;
            let columns = area.width() as usize;
            for (y, sums) in tile.sums().chunks(columns).enumerate() {
                let row = &mut pixels[first + y * width..][..columns];
                for (pixel, sum) in row.iter_mut().zip(sums) {
                    *pixel = one_nan(*sum / tile.done() as f32);
                }
            }
        }
        pixels
    }

    /// The noise of the picture so far: the root of the mean over its pixels of the squared standard error of their
    /// [`seen_luminance`], from 0 to 1. `None` as long as a pixel has fewer than two samples, and without moments.
    ///
    /// The error is estimated from the spread of a pixel's samples as if they were independent. They are stratified, so
    /// the true error is smaller, most of all where an edge runs through a pixel.
    #[must_use]
    pub fn noise(&self) -> Option<f64> {
        let mut sum = 0.0;
        for place in 0..self.areas.len() {
            sum += self.tile(place).squared_errors()?;
        }
        Some((sum / self.region.pixels() as f64).sqrt())
    }

    /// What is there, a part for each tile, with its moments if they are kept. Samples that wait are left out.
    #[must_use]
    pub fn parts(&self) -> Vec<Part> {
        let parts =
            self.areas.iter().enumerate().filter_map(|(place, &area)| self.tile(place).part(area));
        parts.collect()
    }

    fn tile(&self, place: usize) -> MutexGuard<'_, TileSums> {
        self.tiles[place].lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// What is no number is always the same one: which of two an addition keeps is not defined.
fn one_nan(color: Color) -> Color {
    if color.is_nan() {
        return color.map(|channel| if channel.is_nan() { f32::NAN } else { channel });
    }
    color
}

#[cfg(test)]
mod tests;
