//! How cost grows with size: a straight line on two logarithmic axes.

use serde::Serialize;

/// `y = factor · x^slope`, fitted by least squares to the logarithms.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct PowerLaw {
    /// The exponent: 0 is constant, 1 is linear.
    pub slope: f64,
    /// The standard error of the slope; absent for two points, which leave no residue.
    pub slope_error: Option<f64>,
    /// y at x = 1.
    pub factor: f64,
}

impl PowerLaw {
    /// y at x.
    #[must_use]
    pub fn at(&self, x: f64) -> f64 {
        self.factor * x.powf(self.slope)
    }
}

/// Fits a power law to points (x, y). `None` for fewer than two different x, or if a coordinate is
/// not positive and finite.
#[must_use]
pub fn log_log_fit(points: &[(f64, f64)]) -> Option<PowerLaw> {
    let logs: Vec<(f64, f64)> = points.iter().map(|&(x, y)| (x.ln(), y.ln())).collect();
    if logs.iter().any(|(x, y)| !x.is_finite() || !y.is_finite()) {
        return None;
    }
    let n = logs.len() as f64;
    let mean_x = logs.iter().map(|p| p.0).sum::<f64>() / n;
    let mean_y = logs.iter().map(|p| p.1).sum::<f64>() / n;
    let spread: f64 = logs.iter().map(|p| (p.0 - mean_x).powi(2)).sum();
    if spread.is_nan() || spread <= f64::EPSILON {
        return None;
    }
    let slope = logs.iter().map(|p| (p.0 - mean_x) * (p.1 - mean_y)).sum::<f64>() / spread;
    let intercept = mean_y - slope * mean_x;
    let residue: f64 = logs.iter().map(|p| (p.1 - intercept - slope * p.0).powi(2)).sum();
    let slope_error = (logs.len() > 2).then(|| (residue / (n - 2.0) / spread).sqrt());
    Some(PowerLaw { slope, slope_error, factor: intercept.exp() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_are_found_exactly() {
        for (slope, factor) in [(0.0, 5.0), (0.5, 2.0), (1.0, 0.25), (-1.5, 1.0)] {
            let law = PowerLaw { slope, slope_error: None, factor };
            let points: Vec<_> = [1e3, 1e4, 1e5, 1e6].map(|x: f64| (x, law.at(x))).to_vec();
            let fit = log_log_fit(&points).unwrap();
            assert!((fit.slope - slope).abs() < 1e-12);
            assert!((fit.factor / factor - 1.0).abs() < 1e-11);
            assert!(fit.slope_error.unwrap() < 1e-9);
        }
    }

    #[test]
    fn the_slope_of_three_points_has_the_error_of_the_textbook() {
        // ln y = 0, 1, 1 at ln x = 0, 1, 2: slope 1/2, residue 1/6, spread 2.
        let e = std::f64::consts::E;
        let fit = log_log_fit(&[(1.0, 1.0), (e, e), (e * e, e)]).unwrap();
        assert!((fit.slope - 0.5).abs() < 1e-12);
        assert!((fit.slope_error.unwrap() - (1.0 / 12.0_f64).sqrt()).abs() < 1e-12);
    }

    #[test]
    fn what_is_no_line_has_no_fit() {
        assert_eq!(log_log_fit(&[]), None);
        assert_eq!(log_log_fit(&[(10.0, 2.0)]), None);
        assert_eq!(log_log_fit(&[(10.0, 2.0), (10.0, 3.0)]), None);
        assert_eq!(log_log_fit(&[(10.0, 2.0), (20.0, 0.0)]), None);
        assert_eq!(log_log_fit(&[(1.0, 1.0), (2.0, 4.0)]).unwrap().slope_error, None);
    }
}
