//! Numbers as colours: depths and counts on a perceptually even scale.

use colorous::INFERNO;

use crate::image_io::Picture;
use crate::math::Color;

/// What the ends of a colour scale stand for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// The darkest colour.
    pub low: f32,
    /// The brightest colour.
    pub high: f32,
}

impl Scale {
    /// The scale from the smallest to the largest of some numbers, NaNs left out; `None` if there
    /// are no others.
    #[must_use]
    pub fn of(values: &[f32]) -> Option<Self> {
        let numbers = || values.iter().copied().filter(|v| !v.is_nan());
        let low = numbers().reduce(f32::min)?;
        let high = numbers().reduce(f32::max)?;
        Some(Self { low, high })
    }

    /// Where a number lies on the scale, from 0 to 1.
    #[must_use]
    pub fn position(&self, value: f32) -> f32 {
        let span = self.high - self.low;
        if span > 0.0 { ((value - self.low) / span).clamp(0.0, 1.0) } else { 0.0 }
    }
}

/// A picture of numbers on matplotlib's *inferno* scale; NaNs are mid grey, which is not on it.
#[must_use]
pub fn heat_picture(width: u32, height: u32, values: &[f32], scale: Scale) -> Picture {
    let color = |&value: &f32| {
        if value.is_nan() {
            return Color::splat(0.5);
        }
        let c = INFERNO.eval_continuous(f64::from(scale.position(value)));
        // The least value that is written as this byte: ⌊255·c⌋.
        Color::new(f32::from(c.r), f32::from(c.g), f32::from(c.b)) / 255.0 + 1e-4
    };
    Picture { width, height, pixels: values.iter().map(color).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_scale_spans_the_numbers_and_brightness_grows_along_it() {
        let values = [3.0, f32::NAN, 1.0, 2.0];
        let scale = Scale::of(&values).unwrap();
        assert_eq!(scale, Scale { low: 1.0, high: 3.0 });
        let picture = heat_picture(4, 1, &values, scale);
        let brightness = |i: usize| picture.pixels[i].element_sum();
        assert!(brightness(2) < brightness(3) && brightness(3) < brightness(0));
        assert_eq!(picture.pixels[1], Color::splat(0.5));
        assert_eq!(Scale::of(&[f32::NAN]), None);
        assert_eq!(Scale { low: 1.0, high: 1.0 }.position(1.0), 0.0);
    }
}
