//! Scalars as colours: depths and counts on a perceptually uniform scale.

use colorous::INFERNO;

use crate::image_io::Picture;
use crate::math::Color;
use crate::record::Spacing;

/// The numbers at the ends of a colour scale, and their spacing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// The number with the darkest colour.
    pub low: f32,
    /// The number with the brightest colour.
    pub high: f32,
    /// The spacing of the numbers between them.
    pub spacing: Spacing,
}

impl Scale {
    /// The linear scale from the smallest to the largest of some numbers, NaNs left out; `None` if
    /// there are no others.
    #[must_use]
    pub fn of(values: &[f32]) -> Option<Self> {
        let numbers = || values.iter().copied().filter(|v| !v.is_nan());
        let low = numbers().reduce(f32::min)?;
        let high = numbers().reduce(f32::max)?;
        Some(Self { low, high, spacing: Spacing::Linear })
    }

    /// The same ends with equal factors between them, if the lower one allows that.
    #[must_use]
    pub fn logarithmic(self) -> Self {
        let spacing = if self.low > 0.0 { Spacing::Logarithmic } else { self.spacing };
        Self { spacing, ..self }
    }

    /// Where a number lies on the scale, from 0 to 1.
    #[must_use]
    pub fn position(&self, value: f32) -> f32 {
        let place = |value: f32| match self.spacing {
            Spacing::Linear => value,
            Spacing::Logarithmic => libm::logf(value.max(self.low)),
        };
        let (low, span) = (place(self.low), place(self.high) - place(self.low));
        if span > 0.0 { ((place(value) - low) / span).clamp(0.0, 1.0) } else { 0.0 }
    }

    /// The number whose colour is halfway.
    #[must_use]
    pub fn middle(&self) -> f32 {
        match self.spacing {
            Spacing::Linear => 0.5 * self.low + 0.5 * self.high,
            Spacing::Logarithmic => self.low.sqrt() * self.high.sqrt(),
        }
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
        assert_eq!(scale, Scale { low: 1.0, high: 3.0, spacing: Spacing::Linear });
        let picture = heat_picture(4, 1, &values, scale);
        let brightness = |i: usize| picture.pixels[i].element_sum();
        assert!(brightness(2) < brightness(3) && brightness(3) < brightness(0));
        assert_eq!(picture.pixels[1], Color::splat(0.5));
        assert_eq!(Scale::of(&[f32::NAN]), None);
        let point = Scale { low: 1.0, high: 1.0, spacing: Spacing::Linear };
        assert_eq!((point.position(1.0), point.logarithmic().position(1.0)), (0.0, 0.0));
    }

    #[test]
    fn equal_factors_are_equal_steps_of_a_logarithmic_scale() {
        let linear = Scale::of(&[1.0, 100.0]).unwrap();
        let scale = linear.logarithmic();
        assert!((scale.position(10.0) - 0.5).abs() < 1e-6);
        assert_eq!([0.1, 1.0, 100.0, 1e9].map(|x| scale.position(x)), [0.0, 0.0, 1.0, 1.0]);
        assert!((scale.middle() - 10.0).abs() < 1e-5 && linear.middle() == 50.5);
        // There are no factors from 0 on.
        assert_eq!(Scale::of(&[0.0, 1.0]).unwrap().logarithmic().spacing, Spacing::Linear);
    }
}
