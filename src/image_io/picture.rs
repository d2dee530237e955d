//! A picture in memory.

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
