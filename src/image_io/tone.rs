//! Exposure and tone curves: how linear light is fitted into the range of bytes. Both are off by default.
//!
//! Only sums, products and quotients of `f32`, and a power of two by `libm`: the same bits everywhere.
//! A pixel depends on itself alone, so that a crop has the pixels of the whole picture.

use crate::math::Color;

use super::Picture;

/// How bright a picture is written, and how it is bent into [0, 1].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Tone {
    /// In stops: the light is multiplied by 2 to this power. At most [`Tone::MAX_STOPS`] either way.
    pub exposure: f32,
    /// What is done to the light then.
    pub curve: ToneCurve,
}

/// How light above 1 is fitted into [0, 1].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ToneCurve {
    /// It is not: what is above 1 is clipped.
    #[default]
    None,
    /// The luminance L becomes L·(1 + L/w²)/(1 + L), so that [`ToneCurve::WHITE`], w, is the least that
    /// becomes 1; hues are kept. Equation 4 of Reinhard, Stark, Shirley and Ferwerda, *Photographic
    /// Tone Reproduction for Digital Images* (SIGGRAPH 2002).
    Reinhard,
    /// Each channel x becomes x·(2.51·x + 0.03)/(x·(2.43·x + 0.59) + 0.14): Narkowicz's fit to the
    /// curve of the Academy Color Encoding System (*ACES Filmic Tone Mapping Curve*, 2016), with a toe
    /// and a shoulder. 1 becomes 0.80, and 7.3 the first to become 1.
    Filmic,
}

impl ToneCurve {
    /// All curves.
    pub const ALL: [Self; 3] = [Self::None, Self::Reinhard, Self::Filmic];

    /// The luminance that becomes white by [`ToneCurve::Reinhard`]: two stops above 1. It is no property
    /// of the picture, since a part of a picture must look as it does in the whole.
    pub const WHITE: f32 = 4.0;

    /// Its name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Reinhard => "reinhard",
            Self::Filmic => "filmic",
        }
    }

    /// A line of help.
    #[must_use]
    pub fn summary(self) -> &'static str {
        match self {
            Self::None => "what is above 1 is clipped",
            Self::Reinhard => "by luminance, hues kept; 4 becomes white (Reinhard et al. 2002)",
            Self::Filmic => "by channel, with a toe and a shoulder (ACES, fit of Narkowicz 2016)",
        }
    }

    /// The colour that it makes of light.
    #[must_use]
    pub fn apply(self, color: Color) -> Color {
        if self == Self::None {
            return color;
        }
        // Far beyond white, and its square is far from overflowing.
        let light = |c: f32| if c.is_nan() { 0.0 } else { c.clamp(0.0, 1e6) };
        let color = Color::from_array(color.to_array().map(light));
        match self {
            Self::None => color,
            Self::Reinhard => {
                let luminance =
                    LUMINANCE[0] * color.x + LUMINANCE[1] * color.y + LUMINANCE[2] * color.z;
                let square = Self::WHITE * Self::WHITE;
                color * ((1.0 + luminance / square) / (1.0 + luminance))
            }
            Self::Filmic => {
                let curve = |x: f32| (x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14);
                Color::from_array(color.to_array().map(curve))
            }
        }
    }
}

/// The shares of red, green and blue in the luminance of linear light, by ITU-R BT.709.
const LUMINANCE: [f32; 3] = [0.2126, 0.7152, 0.0722];

impl Tone {
    /// The most stops of exposure, either way.
    pub const MAX_STOPS: f32 = 32.0;

    /// Whether it changes nothing.
    #[must_use]
    pub fn is_neutral(&self) -> bool {
        *self == Self::default()
    }

    /// Changes the pixels of a picture; not by a bit if it is neutral.
    ///
    /// ```
    /// use srt::image_io::{Picture, Tone, ToneCurve};
    /// use srt::math::Color;
    ///
    /// let mut picture = Picture::from_pixels(1, 1, vec![Color::new(4.0, 2.0, 1.0)])?;
    /// Tone { exposure: -2.0, curve: ToneCurve::None }.apply(&mut picture);
    /// assert_eq!(picture.pixels[0], Color::new(1.0, 0.5, 0.25));
    /// # Ok::<(), srt::image_io::WrongLength>(())
    /// ```
    pub fn apply(&self, picture: &mut Picture) {
        if self.is_neutral() {
            return;
        }
        let color = self.color();
        for pixel in &mut picture.pixels {
            *pixel = color(*pixel);
        }
    }

    /// What becomes of a colour.
    pub(super) fn color(self) -> impl Fn(Color) -> Color {
        let factor = libm::exp2f(self.exposure);
        move |color| self.curve.apply(color * factor)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn one(color: Color, tone: Tone) -> Color {
        let mut picture = Picture { width: 1, height: 1, pixels: vec![color] };
        tone.apply(&mut picture);
        picture.pixels[0]
    }

    fn curved(curve: ToneCurve, x: f32) -> f32 {
        let color = one(Color::splat(x), Tone { exposure: 0.0, curve });
        assert!((color - color.x).abs().max_element() < 1e-6, "grey stays grey");
        color.x
    }

    #[test]
    fn the_neutral_tone_changes_no_bit() {
        for odd in [f32::NAN, f32::INFINITY, -0.0, -3.0, 1e-40] {
            let color = one(Color::splat(odd), Tone::default());
            assert_eq!(color.to_array().map(f32::to_bits), [odd.to_bits(); 3]);
        }
    }

    #[test]
    fn whole_stops_are_exact() {
        for stops in -32..=32_i16 {
            let tone = Tone { exposure: f32::from(stops), curve: ToneCurve::None };
            let expected = 0.75 * 2f32.powi(stops.into());
            assert_eq!(one(Color::splat(0.75), tone), Color::splat(expected), "{stops}");
        }
        let half = one(Color::ONE, Tone { exposure: 0.5, curve: ToneCurve::None });
        assert_eq!(half.x.to_bits(), std::f32::consts::SQRT_2.to_bits());
    }

    /// These bits follow from the formulas, each operation rounded to the nearest `f32`.
    #[test]
    fn the_same_bits_everywhere() {
        let color = Color::new(3.1, 0.7, 0.05);
        let bits =
            |exposure, curve| one(color, Tone { exposure, curve }).to_array().map(f32::to_bits);
        assert_eq!(bits(-0.3, ToneCurve::None), [0x4021_26a0, 0x3f11_8e3e, 0x3d26_596b]);
        assert_eq!(bits(-0.3, ToneCurve::Reinhard), [0x3faf_80ba, 0x3e9e_84c9, 0x3cb5_2a0a]);
        assert_eq!(bits(-0.3, ToneCurve::Filmic), [0x3f70_5364, 0x3f28_30c3, 0x3d02_aa41]);
    }

    #[test]
    fn curves_rise_from_black_to_white() {
        for curve in [ToneCurve::Reinhard, ToneCurve::Filmic] {
            let steps: Vec<f32> = (0..1000).map(|i| curved(curve, 0.01 * i as f32)).collect();
            assert_eq!(steps[0], 0.0);
            assert!(steps.is_sorted());
            let white = if curve == ToneCurve::Reinhard { ToneCurve::WHITE } else { 7.25 };
            assert!((curved(curve, white) - 1.0).abs() < 1e-3, "{}", curve.name());
            assert!(curved(curve, 0.95 * white) < 1.0);
        }
        assert!((curved(ToneCurve::Filmic, 1.0) - 0.8038).abs() < 1e-4);
        assert!((curved(ToneCurve::Reinhard, 1.0) - 0.53125).abs() < 1e-6);
    }

    #[test]
    fn reinhards_curve_keeps_hues() {
        let color = Color::new(3.0, 1.5, 0.75);
        let toned = one(color, Tone { exposure: 1.0, curve: ToneCurve::Reinhard });
        assert!((toned.x / toned.y - 2.0).abs() < 1e-5 && (toned.y / toned.z - 2.0).abs() < 1e-5);
    }

    #[test]
    fn odd_light_is_black_or_white_by_every_curve() {
        for curve in [ToneCurve::Reinhard, ToneCurve::Filmic] {
            assert_eq!(curved(curve, f32::NEG_INFINITY), 0.0);
            assert_eq!(curved(curve, -1.0), 0.0);
            assert_eq!(one(Color::NAN, Tone { exposure: 0.0, curve }), Color::ZERO);
            assert!(curved(curve, f32::INFINITY) >= 1.0);
            assert!(curved(curve, f32::MAX) >= 1.0);
        }
    }
}
