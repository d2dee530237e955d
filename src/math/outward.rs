//! Rounding from `f64` to `f32` outwards, for what is to enclose.

/// The largest `f32` that is not above a number; NaN of what is none.
#[inline]
pub(crate) fn round_down(exact: f64) -> f32 {
    let nearest = exact as f32;
    if f64::from(nearest) > exact { nearest.next_down() } else { nearest }
}

/// The smallest `f32` that is not below a number; NaN of what is none.
#[inline]
pub(crate) fn round_up(exact: f64) -> f32 {
    let nearest = exact as f32;
    if f64::from(nearest) < exact { nearest.next_up() } else { nearest }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_rounded_to_the_next_floats() {
        let floats = [0.0, 1.0, 0.1, 1e-45, 1e-40, f32::MIN_POSITIVE, 1e30, f32::MAX];
        for float in floats.into_iter().flat_map(|float| [float, -float]) {
            let exact = f64::from(float);
            assert_eq!([round_down(exact), round_up(exact)], [float; 2]);
            // Beside it by so little that it is the nearest float of both.
            let [below, above] = [exact.next_down(), exact.next_up()];
            assert_eq!([round_down(below), round_up(below)], [float.next_down(), float], "{float}");
            assert_eq!([round_down(above), round_up(above)], [float, float.next_up()], "{float}");
            // Signs of zeros, too.
            let mirrored = -round_down(-exact);
            assert_eq!(mirrored.to_bits(), round_up(exact).to_bits(), "{float}");
        }
        let halfway = 1.0 + f64::from(f32::EPSILON) / 2.0;
        assert_eq!([round_down(halfway), round_up(halfway)], [1.0, 1.0 + f32::EPSILON]);
    }

    #[test]
    fn numbers_beyond_all_floats_lie_between_the_largest_and_infinity() {
        for beyond in [3.5e38, 1e300, f64::MAX] {
            assert_eq!([round_down(beyond), round_up(beyond)], [f32::MAX, f32::INFINITY]);
            assert_eq!([round_down(-beyond), round_up(-beyond)], [f32::NEG_INFINITY, f32::MIN]);
        }
        for infinite in [f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!([round_down(infinite), round_up(infinite)], [infinite as f32; 2]);
        }
        assert!(round_down(f64::NAN).is_nan() && round_up(f64::NAN).is_nan());
    }
}
