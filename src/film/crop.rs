//! A part of the picture.

use std::fmt;

/// A part of the picture, in pixels from the top left; the right and bottom ends are excluded.
///
/// Shown as it is written on the command line: `x0,y0,x1,y1`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Crop {
    /// First column.
    pub x0: u32,
    /// First row.
    pub y0: u32,
    /// Behind the last column.
    pub x1: u32,
    /// Behind the last row.
    pub y1: u32,
}

impl Crop {
    /// Width in pixels.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.x1 - self.x0
    }

    /// Height in pixels.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.y1 - self.y0
    }

    /// How many pixels there are; for a crop that is not empty.
    #[must_use]
    pub fn pixels(&self) -> u64 {
        u64::from(self.width()) * u64::from(self.height())
    }

    /// Whether there is a pixel in it.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.x0 >= self.x1 || self.y0 >= self.y1
    }

    /// Whether it lies within a picture of this size.
    #[must_use]
    pub fn is_within(&self, width: u32, height: u32) -> bool {
        self.x1 <= width && self.y1 <= height
    }
}

impl fmt::Display for Crop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{},{},{},{}", self.x0, self.y0, self.x1, self.y1)
    }
}
