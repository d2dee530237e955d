//! What a rendering shows.

use crate::film::Film;
use crate::image_io::Picture;
use crate::math::Color;

use super::View;

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

impl Image {
    /// What a film shows. Where it has nothing, colours are black, and scalars NaN.
    #[must_use]
    pub fn of(film: &Film, view: View) -> Self {
        let (width, height) = (film.region().width(), film.region().height());
        if matches!(view, View::Depth | View::Heatmap) {
            let values = film.means(Color::NAN).iter().map(|pixel| pixel.x).collect();
            return Self::Scalar { width, height, values };
        }
        Self::Color(Picture { width, height, pixels: film.means(Color::ZERO) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::film::{Crop, Part, Piece, Values};
    use crate::render::{Scale, Spacing};

    /// A tile of 16 × 2 pixels in an image of 20 × 2, of which the rest was not rendered.
    fn half_rendered(view: View) -> Image {
        let tile = Crop { x0: 3, y0: 1, x1: 19, y1: 3 };
        let film = Film::new(Crop { x1: 23, ..tile }, 1);
        let pixels: Vec<_> = (0..32).map(|i| Color::splat(5.0 + i as f32)).collect();
        let piece = Piece { area: tile, samples: 0..1 };
        film.take(Part { piece, values: Values::Sums(pixels) }).unwrap();
        Image::of(&film, view)
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
