//! Interpolation between measurements: a straight line on two logarithmic axes.

/// y at x, between the nearest points (x, y) on both sides. `None` beyond the first and the last
/// point, or if a coordinate is not positive and finite.
#[must_use]
pub fn log_log_interpolate(points: &[(f64, f64)], x: f64) -> Option<f64> {
    let fine = |value: f64| value > 0.0 && value.is_finite();
    if !fine(x) || !points.iter().all(|&(x, y)| fine(x) && fine(y)) {
        return None;
    }
    let below = points.iter().filter(|p| p.0 <= x).max_by(|a, b| a.0.total_cmp(&b.0))?;
    let above = points.iter().filter(|p| p.0 >= x).min_by(|a, b| a.0.total_cmp(&b.0))?;
    if below.0 == above.0 {
        return Some(below.1);
    }
    let share = (x / below.0).ln() / (above.0 / below.0).ln();
    Some(below.1 * (above.1 / below.1).powf(share))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_interpolated_exactly_between_points_in_any_order() {
        let points = [(100.0, 0.1), (1.0, 1.0), (10_000.0, 0.01)];
        assert!((log_log_interpolate(&points, 25.0).unwrap() - 0.2).abs() < 1e-12);
        assert!((log_log_interpolate(&points, 2_500.0).unwrap() - 0.02).abs() < 1e-12);
        assert_eq!(log_log_interpolate(&points, 100.0), Some(0.1));
    }

    #[test]
    fn there_is_no_value_beyond_the_ends() {
        let points = [(1.0, 1.0), (4.0, 0.5)];
        assert_eq!(log_log_interpolate(&points, 0.9), None);
        assert_eq!(log_log_interpolate(&points, 4.1), None);
        assert_eq!(log_log_interpolate(&[], 1.0), None);
        assert_eq!(log_log_interpolate(&[(1.0, 0.0), (4.0, 1.0)], 2.0), None);
    }
}
