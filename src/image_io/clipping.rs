//! How much of a picture is brighter than bytes can hold, and what exposure would hold it.

use crate::math::Color;

use super::{Picture, Tone};

/// The pixels of a picture that bytes cannot hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Clipping {
    /// How many have a channel above 1 by a level of 255 or more. What is less could not be seen, and
    /// may be a sum of ones that was rounded up.
    pub clipped: usize,
    /// How many there are.
    pub pixels: usize,
}

impl Clipping {
    /// That of a picture that is written with a tone.
    #[must_use]
    pub fn of(picture: &Picture, tone: Tone) -> Self {
        let color = tone.color();
        let clipped = picture.pixels.iter().filter(|&&pixel| is_clipped(color(pixel))).count();
        Self { clipped, pixels: picture.pixels.len() }
    }

    /// The share of clipped pixels, from 0 to 1; 0 of a picture without pixels.
    #[must_use]
    pub fn share(&self) -> f64 {
        self.clipped as f64 / self.pixels.max(1) as f64
    }
}

fn is_clipped(color: Color) -> bool {
    color.max_element() >= 256.0 / 255.0
}

/// The exposure of the fewest whole stops below that of `tone` with which at most `share` of a picture
/// is clipped, if there is one.
#[must_use]
pub fn exposure_that_holds(picture: &Picture, tone: Tone, share: f64) -> Option<f32> {
    let exposures = (1..).map(|stops: u8| tone.exposure - f32::from(stops));
    exposures
        .take_while(|&exposure| exposure >= -Tone::MAX_STOPS)
        .find(|&exposure| Clipping::of(picture, Tone { exposure, ..tone }).share() <= share)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::image_io::ToneCurve;

    fn picture() -> Picture {
        let pixels = [0.5, 1.0, 1.0 + 1e-6, 1.2, 3.0, 9.0, f32::NAN, -1.0];
        let pixels = pixels.map(|x| Color::new(0.2, x, 0.1)).to_vec();
        Picture { width: 8, height: 1, pixels }
    }

    #[test]
    fn pixels_above_one_are_counted() {
        let clipping = Clipping::of(&picture(), Tone::default());
        assert_eq!(clipping, Clipping { clipped: 3, pixels: 8 });
        assert_eq!(clipping.share(), 0.375);
        let brighter = Tone { exposure: 1.0, curve: ToneCurve::None };
        assert_eq!(Clipping::of(&picture(), brighter).clipped, 5);
        let nothing = Picture { width: 0, height: 0, pixels: vec![] };
        assert_eq!(Clipping::of(&nothing, brighter).share(), 0.0);
    }

    #[test]
    fn an_exposure_holds_what_is_asked_for() {
        let tone = Tone::default();
        assert_eq!(exposure_that_holds(&picture(), tone, 0.0), Some(-4.0));
        assert_eq!(exposure_that_holds(&picture(), tone, 0.2), Some(-2.0));
        let endless = Picture { width: 1, height: 1, pixels: vec![Color::INFINITY] };
        assert_eq!(exposure_that_holds(&endless, tone, 0.0), None);
    }
}
