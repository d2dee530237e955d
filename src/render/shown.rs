//! What was rendered → the picture that is written: numbers become colours where the format holds
//! bytes, and stay numbers where it holds floats.

use crate::image_io::{Format, Picture};
use crate::math::Color;

use super::{Image, Scale, Spacing, View, heat_picture};

/// The scale of a picture in which nothing is seen.
const NOTHING: Scale = Scale { low: 0.0, high: 0.0, spacing: Spacing::Linear };

/// The picture for a format, and the scale of its colours if it shows numbers.
#[must_use]
pub fn picture_for(image: Image, view: View, format: Format) -> (Picture, Option<Scale>) {
    match image {
        Image::Color(picture) => (picture, None),
        Image::Scalar { width, height, values } if format.is_linear() => (
            Picture { width, height, pixels: values.into_iter().map(Color::splat).collect() },
            None,
        ),
        Image::Scalar { width, height, values } => {
            let scale = Scale::of(&values).unwrap_or(NOTHING);
            // What is near takes up more of a picture than of the depths.
            let scale = if view == View::Depth { scale.logarithmic() } else { scale };
            (heat_picture(width, height, &values, scale), Some(scale))
        }
    }
}

/// What the colours of a scale mean.
#[must_use]
pub fn legend(view: View, scale: Scale) -> String {
    let Scale { low, high, .. } = scale;
    match view {
        View::Depth => format!(
            "depth: black is {} of the scene's units away, the middle of the scale {} and pale \
             yellow {}, in steps of equal factors; grey is where nothing is seen",
            four_figures(low),
            four_figures(scale.middle()),
            four_figures(high),
        ),
        _ => format!(
            "{}: black is {low} and pale yellow {high} tests of boxes and primitives a pixel{}",
            view.name(),
            if scale.spacing == Spacing::Logarithmic { ", in steps of equal factors" } else { "" },
        ),
    }
}

/// A number of any size with four figures: `3.756`, `1723`, `1.500e-5`.
fn four_figures(value: f32) -> String {
    match value.abs() {
        v if v != 0.0 && !(1e-3..1e6).contains(&v) => format!("{value:.3e}"),
        v if v < 10.0 => format!("{value:.3}"),
        v if v < 1e3 => format!("{value:.1}"),
        _ => format!("{value:.0}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_figures_of_any_size() {
        assert_eq!(four_figures(0.0), "0.000");
        assert_eq!(four_figures(3.756_4), "3.756");
        assert_eq!(four_figures(172.39), "172.4");
        assert_eq!(four_figures(1_723.9), "1724");
        assert_eq!(four_figures(1.5e-5), "1.500e-5");
        assert_eq!(four_figures(2.5e7), "2.500e7");
    }

    fn depths() -> Image {
        Image::Scalar { width: 2, height: 1, values: vec![3.5, f32::NAN] }
    }

    #[test]
    fn floats_keep_the_numbers() {
        let (picture, scale) = picture_for(depths(), View::Depth, Format::Exr);
        assert_eq!(picture.pixels[0], Color::splat(3.5));
        assert!(picture.pixels[1].is_nan());
        assert_eq!(scale, None);
    }

    #[test]
    fn bytes_get_colours_and_a_legend() {
        let (picture, scale) = picture_for(depths(), View::Depth, Format::Png);
        assert_eq!(picture.pixels[1], Color::splat(0.5));
        let scale = scale.unwrap();
        assert_eq!(scale.spacing, Spacing::Logarithmic);
        let legend = legend(View::Depth, Scale { high: 14.0, ..scale });
        let start =
            "depth: black is 3.500 of the scene's units away, the middle of the scale 7.000";
        assert!(legend.starts_with(start), "{legend}");
    }

    #[test]
    fn a_legend_says_how_a_heatmap_is_spaced() {
        let scale = Scale { low: 4.0, high: 900.0, spacing: Spacing::Linear };
        let linear =
            "heatmap: black is 4 and pale yellow 900 tests of boxes and primitives a pixel";
        assert_eq!(legend(View::Heatmap, scale), linear);
        let logarithmic = legend(View::Heatmap, scale.logarithmic());
        assert_eq!(logarithmic, format!("{linear}, in steps of equal factors"));
    }

    #[test]
    fn nothing_seen_at_all_is_grey() {
        let nothing = Image::Scalar { width: 1, height: 1, values: vec![f32::NAN] };
        let (picture, scale) = picture_for(nothing, View::Depth, Format::Tga);
        assert_eq!(picture.pixels, [Color::splat(0.5)]);
        assert_eq!(scale, Some(NOTHING));
    }
}
