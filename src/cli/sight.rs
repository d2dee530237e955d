//! What was rendered → the picture that is written: numbers become colours where the format holds
//! bytes, and stay numbers where it holds floats.

use super::units;
use crate::image_io::{Format, Picture};
use crate::math::Color;
use crate::render::{Scale, Sight, View, heat_picture};

/// The picture for a format, and the scale of its colours if it shows numbers.
pub(crate) fn picture(sight: Sight, format: Format) -> (Picture, Option<Scale>) {
    match sight {
        Sight::Picture(picture) => (picture, None),
        Sight::Field { width, height, values } if format.is_linear() => (
            Picture { width, height, pixels: values.into_iter().map(Color::splat).collect() },
            None,
        ),
        Sight::Field { width, height, values } => {
            let scale = Scale::of(&values).unwrap_or(Scale { low: 0.0, high: 0.0 });
            (heat_picture(width, height, &values, scale), Some(scale))
        }
    }
}

/// What the colours of a scale mean.
pub(crate) fn legend(view: View, scale: Scale) -> String {
    let Scale { low, high } = scale;
    match view {
        View::Depth => format!(
            "depth: black is {} and pale yellow {} of the scene's units away; \
             grey is where nothing is seen",
            units::figures(low),
            units::figures(high),
        ),
        _ => format!(
            "{}: black is {low} and pale yellow {high} tests of boxes and primitives a pixel",
            view.name(),
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn depths() -> Sight {
        Sight::Field { width: 2, height: 1, values: vec![3.5, f32::NAN] }
    }

    #[test]
    fn floats_keep_the_numbers() {
        let (picture, scale) = picture(depths(), Format::Exr);
        assert_eq!(picture.pixels[0], Color::splat(3.5));
        assert!(picture.pixels[1].is_nan());
        assert_eq!(scale, None);
    }

    #[test]
    fn bytes_get_colours_and_a_legend() {
        let (picture, scale) = picture(depths(), Format::Png);
        assert_eq!(picture.pixels[1], Color::splat(0.5));
        let legend = legend(View::Depth, scale.unwrap());
        assert!(legend.starts_with("depth: black is 3.500 and pale yellow 3.500 "), "{legend}");
    }

    #[test]
    fn nothing_seen_at_all_is_grey() {
        let nothing = Sight::Field { width: 1, height: 1, values: vec![f32::NAN] };
        let (picture, scale) = picture(nothing, Format::Tga);
        assert_eq!(picture.pixels, [Color::splat(0.5)]);
        assert_eq!(scale, Some(Scale { low: 0.0, high: 0.0 }));
    }
}
