//! A picture in memory.

use thiserror::Error;

use crate::math::Color;

/// Linear, unclamped pixels, row by row from the top left.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// `width · height` colours.
    pub pixels: Vec<Color>,
}

/// The pixels do not fill the rectangle, or do not fit in it.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[error("{width} × {height} pixels are not {length}")]
pub struct WrongLength {
    /// The requested width.
    pub width: u32,
    /// The requested height.
    pub height: u32,
    /// How many pixels there were.
    pub length: usize,
}

impl Picture {
    /// A black picture.
    #[must_use]
    pub fn new(width: u32, height: u32) -> Self {
        Self { width, height, pixels: vec![Color::ZERO; area(width, height)] }
    }

    /// A picture of given pixels, row by row from the top left.
    ///
    /// # Errors
    /// If there are not exactly `width · height` of them.
    pub fn from_pixels(width: u32, height: u32, pixels: Vec<Color>) -> Result<Self, WrongLength> {
        if pixels.len() == area(width, height) {
            Ok(Self { width, height, pixels })
        } else {
            Err(WrongLength { width, height, length: pixels.len() })
        }
    }

    /// The colour at column `x` from the left and row `y` from the top; `None` outside.
    #[must_use]
    pub fn get(&self, x: u32, y: u32) -> Option<Color> {
        let inside = x < self.width && y < self.height;
        inside.then(|| self.pixels.get(area(self.width, y) + x as usize).copied()).flatten()
    }

    /// The rows from the top, each of `width` colours.
    pub fn rows(&self) -> impl DoubleEndedIterator<Item = &[Color]> {
        // A picture without columns has no rows to give; chunks of 0 are not allowed.
        self.pixels.chunks_exact(self.width.max(1) as usize)
    }
}

/// The number of pixels of a rectangle.
fn area(width: u32, height: u32) -> usize {
    width as usize * height as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_are_counted_from_the_top_left() {
        let pixels = (0..6).map(|i| Color::splat(i as f32)).collect();
        let picture = Picture::from_pixels(3, 2, pixels).unwrap();
        assert_eq!(picture.get(0, 0), Some(Color::ZERO));
        assert_eq!(picture.get(2, 1), Some(Color::splat(5.0)));
        assert_eq!(picture.get(3, 0), None);
        assert_eq!(picture.get(0, 2), None);
        assert_eq!(picture.rows().next_back().map(|row| row[0]), Some(Color::splat(3.0)));
    }

    #[test]
    fn too_few_pixels_are_refused() {
        let error = Picture::from_pixels(3, 2, vec![Color::ZERO; 5]).unwrap_err();
        assert_eq!(error.to_string(), "3 × 2 pixels are not 5");
        assert_eq!(Picture::new(0, 7).rows().count(), 0);
    }
}
