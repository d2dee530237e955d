//! What a rendering shows, and how it is assembled from tiles.

use crate::image_io::Picture;
use crate::math::Color;

use super::{Crop, View};

/// What a rendering shows, pixel by pixel. The [`View`] decides whether it is colours or scalars.
///
/// Colours are a [`Picture`], which an image file can hold. Scalars become a picture by a colour
/// scale ([`heat_picture`](super::heat_picture)).
#[derive(Clone, Debug, PartialEq)]
pub enum Image {
    /// A colour per pixel.
    Color(Picture),
    /// A number per pixel: a distance in the scene's unit, or a count.
    Scalar {
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
        /// The numbers, row by row from the top left. They are NaN where nothing is seen and where
        /// nothing was rendered, so that such pixels do not stretch the colour scale.
        values: Vec<f32>,
    },
}

/// An image while tiles are put into it.
pub(super) struct ImageBuilder {
    region: Crop,
    is_scalar: bool,
    /// The colours, or the scalars in every component.
    picture: Picture,
}

impl ImageBuilder {
    /// The image of a region without tiles: black, or NaN in scalars.
    pub(super) fn new(region: Crop, view: View) -> Self {
        let is_scalar = matches!(view, View::Depth | View::Heatmap);
        let missing = if is_scalar { Color::NAN } else { Color::ZERO };
        let (width, height) = (region.width(), region.height());
        let pixels = vec![missing; width as usize * height as usize];
        Self { region, is_scalar, picture: Picture { width, height, pixels } }
    }

    /// Puts in the pixels of a tile of the region, row by row.
    pub(super) fn put(&mut self, tile: Crop, pixels: &[Color]) {
        let (x, width) = ((tile.x0 - self.region.x0) as usize, tile.width() as usize);
        let first_row = (tile.y0 - self.region.y0) as usize;
        for (y, row) in (first_row..).zip(pixels.chunks(width)) {
            let first = y * self.region.width() as usize + x;
            self.picture.pixels[first..first + width].copy_from_slice(row);
        }
    }

    pub(super) fn finish(self) -> Image {
        if !self.is_scalar {
            return Image::Color(self.picture);
        }
        let Picture { width, height, pixels } = self.picture;
        Image::Scalar { width, height, values: pixels.iter().map(|pixel| pixel.x).collect() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::{Scale, Spacing};

    /// A tile of 16 × 2 pixels in an image of 20 × 2, of which the rest was not rendered.
    fn half_rendered(view: View) -> Image {
        let tile = Crop { x0: 3, y0: 1, x1: 19, y1: 3 };
        let mut image = ImageBuilder::new(Crop { x1: 23, ..tile }, view);
        let pixels: Vec<_> = (0..32).map(|i| Color::splat(5.0 + i as f32)).collect();
        image.put(tile, &pixels);
        image.finish()
    }

    #[test]
    fn missing_tiles_do_not_stretch_the_scale() {
        for view in [View::Depth, View::Heatmap] {
            let Image::Scalar { values, .. } = half_rendered(view) else { panic!("not scalars") };
            let scale = Scale { low: 5.0, high: 36.0, spacing: Spacing::Linear };
            assert_eq!(Scale::of(&values), Some(scale));
            assert!(values[16..20].iter().all(|value| value.is_nan()));
            assert_eq!(values[20], 21.0);
        }
    }

    #[test]
    fn missing_tiles_of_a_picture_are_black() {
        let Image::Color(picture) = half_rendered(View::Color) else { panic!("not colours") };
        assert_eq!(picture.pixels[15], Color::splat(20.0));
        assert_eq!(picture.pixels[16], Color::ZERO);
    }
}
