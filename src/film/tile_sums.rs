//! The sums of a tile, and the parts that wait until they are due.

use std::collections::BTreeMap;

use crate::math::Color;

use super::{Crop, FilmError, Moments, Part, Piece, Values};

/// A tile while parts arrive.
#[derive(Debug, Default)]
pub(super) struct TileSums {
    /// The samples of each pixel that are added up: those with the numbers below this.
    done: u32,
    /// Row by row; empty before the first part.
    sums: Vec<Color>,
    /// Empty unless they are kept.
    moments: Vec<Moments>,
    /// Parts that begin behind `done`, by their first sample. None overlaps another.
    waiting: BTreeMap<u32, Part>,
}

impl TileSums {
    /// Samples of each pixel that are added up.
    pub(super) fn done(&self) -> u32 {
        self.done
    }

    /// The sums of the pixels, row by row; empty before the first part.
    pub(super) fn sums(&self) -> &[Color] {
        &self.sums
    }

    /// Takes a part whose numbers were checked.
    pub(super) fn take(&mut self, part: Part, keeps_moments: bool) -> Result<(), FilmError> {
        let Piece { area, samples } = part.piece.clone();
        let (first, end) = (samples.start, samples.end);
        let before = self.waiting.range(..end).next_back();
        let overlaps = before.is_some_and(|(_, other)| other.piece.samples.end > first);
        if first < self.done || overlaps {
            return Err(FilmError::Twice { area, first, end });
        }
        if keeps_moments && matches!(part.values, Values::Sums(_)) {
            return Err(FilmError::NoMoments { area });
        }
        if first > self.done {
            self.waiting.insert(first, part);
            return Ok(());
        }
        self.add(part, keeps_moments);
        while let Some(due) = self.waiting.remove(&self.done) {
            self.add(due, keeps_moments);
        }
        Ok(())
    }

    /// Adds the part that is due.
    fn add(&mut self, part: Part, keeps_moments: bool) {
        let Piece { area, samples } = part.piece;
        self.done = samples.end;
        match part.values {
            Values::Sums(sums) => self.sums = sums,
            Values::SumsAndMoments(sums, moments) => {
                self.sums = sums;
                self.moments = if keeps_moments { moments } else { Vec::new() };
            }
            Values::Samples(values) => {
                let pixels = area.pixels() as usize;
                self.sums.resize(pixels, Color::ZERO);
                let of_pixels = values.chunks((samples.end - samples.start) as usize);
                for (sum, values) in self.sums.iter_mut().zip(of_pixels.clone()) {
                    // As `Sum` of one pixel's samples does.
                    *sum = values.iter().fold(*sum, |sum, &value| sum + value);
                }
                if keeps_moments {
                    self.moments.resize(pixels, Moments::default());
                    for (moments, values) in self.moments.iter_mut().zip(of_pixels) {
                        values.iter().for_each(|&value| moments.add(value));
                    }
                }
            }
        }
    }

    /// The sum over the pixels of the squared standard error; `None` where it is not known.
    pub(super) fn squared_errors(&self) -> Option<f64> {
        if self.moments.is_empty() {
            return None;
        }
        self.moments.iter().map(|moments| moments.squared_error(self.done)).sum()
    }

    /// What is there as a part, if anything is.
    pub(super) fn part(&self, area: Crop) -> Option<Part> {
        if self.done == 0 {
            return None;
        }
        let values = if self.moments.is_empty() {
            Values::Sums(self.sums.clone())
        } else {
            Values::SumsAndMoments(self.sums.clone(), self.moments.clone())
        };
        Some(Part { piece: Piece { area, samples: 0..self.done }, values })
    }
}
