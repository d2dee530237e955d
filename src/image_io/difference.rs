//! How far two pictures are from each other, pixel by pixel.

use thiserror::Error;

use super::Picture;
use crate::math::Color;

/// How two pictures of the same size differ.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Difference {
    /// How many pixels have other bits in any channel (−0 and 0 are other bits).
    pub differing: u64,
    /// The largest absolute difference of any channel; infinite where a NaN meets a number.
    pub largest: f32,
    /// The mean absolute difference over all channels.
    pub mean: f64,
    /// The root of the mean squared difference over all channels.
    pub rmse: f64,
    /// Column and row, from the top left, of the first pixel that differs.
    pub first: Option<(u32, u32)>,
}

/// Pictures of different sizes have no difference.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[error("the pictures differ in size: {} × {} and {} × {} pixels", a.0, a.1, b.0, b.1)]
pub struct SizeMismatch {
    /// Width and height of the first.
    pub a: (u32, u32),
    /// Width and height of the second.
    pub b: (u32, u32),
}

/// Compares two pictures; whether pixels are equal is decided by their bits.
///
/// # Errors
/// If they are not of the same size.
pub fn compare(a: &Picture, b: &Picture) -> Result<Difference, SizeMismatch> {
    check_sizes(a, b)?;
    let mut difference = Difference::default();
    let (mut sum, mut squares) = (0.0, 0.0);
    for (i, (p, q)) in a.pixels.iter().zip(&b.pixels).enumerate() {
        if p.to_array().map(f32::to_bits) == q.to_array().map(f32::to_bits) {
            continue;
        }
        difference.differing += 1;
        difference.first.get_or_insert_with(|| place(i, a.width));
        for d in distance(*p, *q).to_array() {
            difference.largest = difference.largest.max(d);
            sum += f64::from(d);
            squares += f64::from(d) * f64::from(d);
        }
    }
    let channels = (3 * a.pixels.len()).max(1) as f64;
    difference.mean = sum / channels;
    difference.rmse = (squares / channels).sqrt();
    Ok(difference)
}

/// The absolute difference of every channel, scaled so that the largest finite one becomes 1.
///
/// Equal pictures give black; where a number meets a NaN or an infinity, the channel is 1.
///
/// # Errors
/// If they are not of the same size.
pub fn difference_picture(a: &Picture, b: &Picture) -> Result<Picture, SizeMismatch> {
    check_sizes(a, b)?;
    let distances = || a.pixels.iter().zip(&b.pixels).map(|(p, q)| distance(*p, *q));
    let finite = distances().flat_map(|d| d.to_array()).filter(|d| d.is_finite());
    let largest = finite.fold(0.0, f32::max);
    // Divided, not multiplied by 1/largest: that overflows for the smallest differences.
    let scale = |d: f32| if d == 0.0 { 0.0 } else { (d / largest).min(1.0) };
    let pixels = distances().map(|d| Color::from_array(d.to_array().map(scale))).collect();
    Ok(Picture { width: a.width, height: a.height, pixels })
}

fn check_sizes(a: &Picture, b: &Picture) -> Result<(), SizeMismatch> {
    let (size_a, size_b) = ((a.width, a.height), (b.width, b.height));
    if size_a == size_b { Ok(()) } else { Err(SizeMismatch { a: size_a, b: size_b }) }
}

/// |p − q| channel by channel: 0 for equal values, two NaNs among them, never NaN.
fn distance(p: Color, q: Color) -> Color {
    let channel = |x: f32, y: f32| {
        if x == y || (x.is_nan() && y.is_nan()) {
            return 0.0;
        }
        let d = (x - y).abs();
        if d.is_nan() { f32::INFINITY } else { d }
    };
    Color::new(channel(p.x, q.x), channel(p.y, q.y), channel(p.z, q.z))
}

fn place(index: usize, width: u32) -> (u32, u32) {
    let width = width.max(1) as usize;
    ((index % width) as u32, (index / width) as u32)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(values: &[f32]) -> Picture {
        let pixels = values.iter().map(|&v| Color::new(v, 0.0, 0.0)).collect();
        Picture::from_pixels(2, values.len() as u32 / 2, pixels).unwrap()
    }

    #[test]
    fn the_measures_are_those_of_the_definition() {
        let (a, b) = (picture(&[0.0, 1.0, 2.0, 3.0]), picture(&[0.0, 1.0, 2.5, 1.0]));
        let d = compare(&a, &b).unwrap();
        assert_eq!((d.differing, d.largest, d.first), (2, 2.0, Some((0, 1))));
        assert!((d.mean - 2.5 / 12.0).abs() < 1e-12);
        assert!((d.rmse - (4.25f64 / 12.0).sqrt()).abs() < 1e-12);
        let shown = difference_picture(&a, &b).unwrap();
        assert_eq!(shown, picture(&[0.0, 0.0, 0.25, 1.0]));
    }

    #[test]
    fn bits_decide_and_nan_is_equal_to_itself() {
        let a = picture(&[f32::NAN, 0.0]);
        assert_eq!(compare(&a, &a).unwrap(), Difference::default());
        let d = compare(&a, &picture(&[1.0, -0.0])).unwrap();
        assert_eq!((d.differing, d.largest), (2, f32::INFINITY));
        let shown = difference_picture(&a, &picture(&[1.0, 1e-45])).unwrap();
        assert_eq!(shown, picture(&[1.0, 1.0]));
    }

    #[test]
    fn sizes_must_agree() {
        let error = compare(&Picture::new(2, 3), &Picture::new(3, 2)).unwrap_err();
        assert_eq!(error.to_string(), "the pictures differ in size: 2 × 3 and 3 × 2 pixels");
        assert!(difference_picture(&Picture::new(1, 1), &Picture::new(1, 2)).is_err());
    }
}
