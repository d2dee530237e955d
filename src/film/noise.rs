//! How noisy a pixel is, from the spread of its samples.

use crate::math::Color;

/// What is kept of a pixel's samples to estimate its noise.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Moments {
    /// The sum of the samples' [`seen_luminance`].
    pub sum: f64,
    /// The sum of its squares.
    pub squares: f64,
}

impl Moments {
    /// Adds a sample.
    pub fn add(&mut self, sample: Color) {
        let luminance = seen_luminance(sample);
        self.sum += luminance;
        self.squares += luminance * luminance;
    }

    /// The square of the standard error of the mean of `samples` samples: their variance, as a larger number of them
    /// would have it, over their number. `None` of fewer than two.
    #[must_use]
    pub fn squared_error(&self, samples: u32) -> Option<f64> {
        if samples < 2 {
            return None;
        }
        let n = f64::from(samples);
        // Rounding may bring the difference a hair below zero.
        let variance = ((self.squares - self.sum * self.sum / n) / (n - 1.0)).max(0.0);
        Some(variance / n)
    }
}

/// The luminance of a linear colour (ITU-R BT.709) as a screen shows it: light of a channel above 1 counts as 1, so
/// that highlights which are white in any case are not what is waited for. What is no number counts as 0.
#[must_use]
pub fn seen_luminance(color: Color) -> f64 {
    let seen = |light: f32| if light > 0.0 { f64::from(light.min(1.0)) } else { 0.0 };
    0.2126 * seen(color.x) + 0.7152 * seen(color.y) + 0.0722 * seen(color.z)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_error_is_that_of_the_formula() {
        let mut moments = Moments::default();
        for light in [0.25, 0.75, 0.5, 0.5] {
            moments.add(Color::splat(light));
        }
        // Variance (1/16 + 1/16)/3, over four samples.
        assert!((moments.squared_error(4).unwrap() - 1.0 / 96.0).abs() < 1e-12);
        assert_eq!(moments.squared_error(1), None);
    }

    #[test]
    fn what_a_screen_does_not_show_does_not_count() {
        assert!((seen_luminance(Color::splat(1e9)) - 1.0).abs() < 1e-12);
        assert_eq!(seen_luminance(Color::splat(-3.0)), 0.0);
        assert_eq!(seen_luminance(Color::NAN), 0.0);
        assert!((seen_luminance(Color::INFINITY) - 1.0).abs() < 1e-12);
    }
}
