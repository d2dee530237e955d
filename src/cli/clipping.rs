//! A warning of a picture of which much is brighter than its format can hold.

use std::fmt;

use crate::image_io::{Clipping, Format, Picture, Tone, exposure_that_holds};

/// A picture of which more than this share is clipped is warned of. Highlights, lamps and skies that
/// are meant to be white take less: of the pictures of this project's scenes, at most a twentieth is
/// clipped. From a quarter on, large surfaces have lost their shading.
const MUCH: f64 = 0.25;

/// With the exposure that is suggested, no more than this share is clipped.
const LITTLE: f64 = 0.01;

/// What there is to say of a picture of which much is clipped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ClippingWarning {
    clipping: Clipping,
    format: Format,
    /// Of how many stops, if there is one.
    remedy: Option<f32>,
}

impl ClippingWarning {
    /// That of a picture that is to be written with a tone, before the tone is applied to it; `None` if
    /// little is clipped, or nothing ever is in this format.
    pub(crate) fn of(picture: &Picture, tone: Tone, format: Format) -> Option<Self> {
        if format.is_linear() {
            return None;
        }
        let clipping = Clipping::of(picture, tone);
        let remedy = || exposure_that_holds(picture, tone, LITTLE);
        (clipping.share() > MUCH).then(|| Self { clipping, format, remedy: remedy() })
    }
}

impl fmt::Display for ClippingWarning {
    /// Two lines, as other warnings: what is wrong, and what would be right.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Clipping { clipped, pixels } = self.clipping;
        let (percent, format) = (100.0 * self.clipping.share(), self.format);
        writeln!(
            f,
            "{percent:.0} % of the picture is clipped: {clipped} of {pixels} pixels have a channel above \
             1, the most that .{format} holds"
        )?;
        f.write_str("  = help: ")?;
        match self.remedy {
            Some(stops) => write!(f, "darken it, for example by `--exposure {stops}`, or")?,
            None => f.write_str("darken it by `--exposure`, or")?,
        }
        f.write_str(" bend it by `--tone-curve reinhard`; .exr and .hdr hold it as it is")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::image_io::ToneCurve;
    use crate::math::Color;

    /// Of ten pixels so many are of some light, and the others grey.
    fn picture(bright: usize, light: f32) -> Picture {
        let mut pixels = vec![Color::splat(0.5); 10];
        pixels[..bright].fill(Color::new(light, 0.2, 0.1));
        Picture { width: 10, height: 1, pixels }
    }

    #[test]
    fn more_than_a_quarter_is_much() {
        let warned =
            |bright| ClippingWarning::of(&picture(bright, 3.0), Tone::default(), Format::Png);
        assert_eq!(warned(2), None);
        assert_eq!(
            warned(3).unwrap().to_string(),
            "30 % of the picture is clipped: 3 of 10 pixels have a channel above 1, the most that .png \
             holds\n  = help: darken it, for example by `--exposure -2`, or bend it by `--tone-curve \
             reinhard`; .exr and .hdr hold it as it is"
        );
        let endless = ClippingWarning::of(&picture(9, f32::INFINITY), Tone::default(), Format::Tga);
        assert!(endless.unwrap().to_string().contains("darken it by `--exposure`, or"));
    }

    #[test]
    fn floats_and_what_is_dark_enough_are_not_warned_of() {
        let warned = |tone, format| ClippingWarning::of(&picture(9, 3.0), tone, format).is_some();
        assert!(warned(Tone::default(), Format::Ppm));
        assert!(!warned(Tone::default(), Format::Exr) && !warned(Tone::default(), Format::Hdr));
        assert!(!warned(Tone { exposure: -2.0, curve: ToneCurve::None }, Format::Ppm));
        assert!(!warned(Tone { exposure: 0.0, curve: ToneCurve::Filmic }, Format::Ppm));
        assert!(warned(Tone { exposure: 3.0, curve: ToneCurve::Filmic }, Format::Ppm));
    }
}
