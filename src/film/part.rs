//! What a renderer sends: the samples of a tile's pixels, or a range of them, in one of three forms.

use std::ops::Range;

use crate::math::Color;

use super::{Crop, FilmError, Moments};

/// Work that is sent back as one part.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Piece {
    /// A tile of the picture.
    pub area: Crop,
    /// The samples of each of its pixels, by their numbers; not empty.
    pub samples: Range<u32>,
}

/// A piece, rendered.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// What it is of.
    pub piece: Piece,
    /// What was found.
    pub values: Values,
}

/// What a part holds of its pixels, row by row from the top left.
#[derive(Clone, Debug, PartialEq)]
pub enum Values {
    /// The sum of each pixel's samples, which begin with sample 0: added in their order, from zero.
    Sums(Vec<Color>),
    /// Each pixel's samples in their order, pixel by pixel.
    Samples(Vec<Color>),
    /// Sums as above, and the moments that noise is estimated from.
    SumsAndMoments(Vec<Color>, Vec<Moments>),
}

impl Part {
    /// Whether its numbers agree with each other, in a film of so many samples a pixel.
    pub(super) fn check(&self, all_samples: u32) -> Result<(), FilmError> {
        let Piece { area, samples } = &self.piece;
        let beyond = samples.is_empty() || samples.end > all_samples;
        let begins_late = samples.start > 0 && !matches!(self.values, Values::Samples(_));
        if beyond || begins_late {
            let (first, end) = (samples.start, samples.end);
            return Err(FilmError::Range { area: *area, first, end, all_samples });
        }
        let expected = match self.values {
            Values::Samples(_) => area.pixels() * u64::from(samples.end - samples.start),
            Values::Sums(_) | Values::SumsAndMoments(..) => area.pixels(),
        };
        let (found, fits) = match &self.values {
            Values::Sums(values) | Values::Samples(values) => (values.len(), true),
            Values::SumsAndMoments(sums, moments) => (sums.len(), sums.len() == moments.len()),
        };
        if found as u64 != expected || !fits {
            return Err(FilmError::Length { area: *area, expected, found });
        }
        Ok(())
    }
}
