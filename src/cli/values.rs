//! Values of options that are more than a number: sizes and crops.

use std::fmt;
use std::str::FromStr;

/// The most pixels along one side: what a TGA file can state.
const MAX_SIDE: u32 = 65_535;

/// A value that could not be read, and what would be right.
#[derive(Debug, thiserror::Error, PartialEq, Eq)]
pub(crate) enum ValueError {
    /// Not two numbers with an `x` between them.
    #[error("expected WIDTHxHEIGHT in pixels, such as 800x600")]
    SizeForm,
    /// A side of no or of too many pixels.
    #[error("width and height must lie between 1 and {MAX_SIDE}")]
    SizeRange,
    /// Not four numbers with commas between them.
    #[error("expected four pixel coordinates x0,y0,x1,y1, such as 0,0,320,240")]
    CropForm,
    /// A crop without pixels.
    #[error("the crop is empty: x0 must be less than x1, and y0 less than y1")]
    CropEmpty,
}

/// Width and height of a picture in pixels, each from 1 to 65,535.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Size {
    /// Width in pixels.
    pub(crate) width: u32,
    /// Height in pixels.
    pub(crate) height: u32,
}

impl FromStr for Size {
    type Err = ValueError;

    fn from_str(text: &str) -> Result<Self, ValueError> {
        let (width, height) = text.split_once(['x', 'X', '×']).ok_or(ValueError::SizeForm)?;
        let size = Self {
            width: number(width).ok_or(ValueError::SizeForm)?,
            height: number(height).ok_or(ValueError::SizeForm)?,
        };
        let sides = 1..=MAX_SIDE;
        let fits = sides.contains(&size.width) && sides.contains(&size.height);
        if fits { Ok(size) } else { Err(ValueError::SizeRange) }
    }
}

impl fmt::Display for Size {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}x{}", self.width, self.height)
    }
}

/// A part of a picture: columns `x0..x1` and rows `y0..y1`, counted from the top left. Not empty.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Crop {
    /// The first column.
    pub(crate) x0: u32,
    /// The first row, from the top.
    pub(crate) y0: u32,
    /// The column behind the last.
    pub(crate) x1: u32,
    /// The row below the last.
    pub(crate) y1: u32,
}

impl Crop {
    /// Whether the crop lies within a picture.
    pub(crate) fn is_within(self, size: Size) -> bool {
        self.x1 <= size.width && self.y1 <= size.height
    }
}

impl FromStr for Crop {
    type Err = ValueError;

    fn from_str(text: &str) -> Result<Self, ValueError> {
        let values: Option<Vec<u32>> = text.split(',').map(number).collect();
        let Some(&[x0, y0, x1, y1]) = values.as_deref() else {
            return Err(ValueError::CropForm);
        };
        if x0 < x1 && y0 < y1 { Ok(Self { x0, y0, x1, y1 }) } else { Err(ValueError::CropEmpty) }
    }
}

impl fmt::Display for Crop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{},{},{},{}", self.x0, self.y0, self.x1, self.y1)
    }
}

/// A number of digits alone (Rust's own parser would also take `+3`); too large ones saturate, so
/// that they meet the message about ranges.
fn number(text: &str) -> Option<u32> {
    let text = text.trim();
    if text.is_empty() || !text.bytes().all(|b| b.is_ascii_digit()) {
        return None;
    }
    Some(text.parse().unwrap_or(u32::MAX))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes() {
        assert_eq!("800x600".parse(), Ok(Size { width: 800, height: 600 }));
        assert_eq!("1X65535".parse(), Ok(Size { width: 1, height: 65_535 }));
        for bad in ["", "800", "800x", "x600", "-1x5", "+1x5", "8.5x4", "1x2x3", "axb"] {
            assert_eq!(bad.parse::<Size>(), Err(ValueError::SizeForm), "{bad}");
        }
        for bad in ["0x5", "5x0", "65536x1", "99999999999999x1"] {
            assert_eq!(bad.parse::<Size>(), Err(ValueError::SizeRange), "{bad}");
        }
    }

    #[test]
    fn crops() {
        let crop: Crop = "1,2,3,4".parse().unwrap();
        assert_eq!(crop, Crop { x0: 1, y0: 2, x1: 3, y1: 4 });
        assert_eq!("0, 0, 320, 240".parse::<Crop>().unwrap().to_string(), "0,0,320,240");
        for bad in ["", "1,2,3", "1,2,3,4,5", "1,2,3,", "-1,0,3,4", "a,b,c,d"] {
            assert_eq!(bad.parse::<Crop>(), Err(ValueError::CropForm), "{bad}");
        }
        for bad in ["3,0,3,4", "4,0,3,4", "0,4,3,4"] {
            assert_eq!(bad.parse::<Crop>(), Err(ValueError::CropEmpty), "{bad}");
        }
    }

    #[test]
    fn a_crop_may_touch_the_far_edges() {
        let size = Size { width: 3, height: 4 };
        assert!("0,0,3,4".parse::<Crop>().unwrap().is_within(size));
        assert!(!"0,0,4,4".parse::<Crop>().unwrap().is_within(size));
        assert!(!"0,0,3,5".parse::<Crop>().unwrap().is_within(size));
    }
}
