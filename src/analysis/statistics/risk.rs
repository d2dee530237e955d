//! How often an interval may miss its value, and how many standard errors wide it has to be for that.

/// The probability that an interval does not contain its value, at either end alike: 0.05 for one of 95 %.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Risk(f64);

impl Risk {
    /// That of one interval of 95 %.
    pub const USUAL: Self = Self(0.05);

    /// The risk of each of some intervals, so that together they miss no more often than one would: by Bonferroni's
    /// inequality, whatever they have in common.
    #[must_use]
    pub fn shared_by(self, intervals: usize) -> Self {
        Self(self.0 / intervals.max(1) as f64)
    }

    /// The risk at each end.
    pub(super) fn of_an_end(self) -> f64 {
        self.0 / 2.0
    }

    /// Half the width of the interval of a normal distribution, in standard deviations.
    #[must_use]
    pub fn normal(self) -> f64 {
        smallest_with(self.0, |x| libm::erfc(x / std::f64::consts::SQRT_2))
    }

    /// Half the width of the interval of Student's distribution, in standard errors.
    pub(super) fn student(self, degrees: usize) -> f64 {
        smallest_with(self.0, |t| student_outside(t, degrees.min(MANY_DEGREES)))
    }
}

/// With more degrees of freedom Student's quantiles are within a thousandth of the normal distribution's.
const MANY_DEGREES: usize = 2_000;

/// The smallest number that is missed with no more than a probability, which falls as the number grows.
fn smallest_with(probability: f64, outside: impl Fn(f64) -> f64) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    while outside(high) > probability && high < 1e9 {
        (low, high) = (high, 2.0 * high);
    }
    for _ in 0..60 {
        let middle = f64::midpoint(low, high);
        if outside(middle) > probability {
            low = middle;
        } else {
            high = middle;
        }
    }
    high
}

/// The probability that Student's t lies outside of −t to t: Abramowitz, Stegun, *Handbook of Mathematical Functions*,
/// 26.7.3 for odd, 26.7.4 for even degrees of freedom.
fn student_outside(t: f64, degrees: usize) -> f64 {
    let (sine, cosine) = (t / (degrees as f64).sqrt()).atan().sin_cos();
    let odd = degrees % 2 == 1;
    // The first term is cos θ or 1; each that follows has two more factors of the cosine.
    let first = if odd { cosine } else { 1.0 };
    let factor = |power: usize| {
        let power = power as f64;
        cosine * cosine * if odd { power / (power + 1.0) } else { (power - 1.0) / power }
    };
    let powers = (2..degrees.saturating_sub(1)).step_by(2);
    let terms = powers.scan(first, |term, power| {
        *term *= factor(power);
        Some(*term)
    });
    let sum = if degrees == 1 { 0.0 } else { first + terms.sum::<f64>() };
    match odd {
        true => 1.0 - std::f64::consts::FRAC_2_PI * (sine.atan2(cosine) + sine * sum),
        false => 1.0 - sine * sum,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_those_of_the_tables() {
        let tables = [(1, 12.706), (2, 4.303), (3, 3.182), (4, 2.776), (5, 2.571), (9, 2.262)];
        for (degrees, quantile) in tables.into_iter().chain([(30, 2.042), (120, 1.980)]) {
            let own = Risk::USUAL.student(degrees);
            assert!((own - quantile).abs() < 6e-4, "{degrees}: {own}");
        }
        for (intervals, degrees, quantile) in [(5, 4, 4.604), (50, 4, 8.610), (50, 9, 4.781)] {
            let own = Risk::USUAL.shared_by(intervals).student(degrees);
            assert!((own - quantile).abs() < 6e-4, "{intervals}, {degrees}: {own}");
        }
        assert!((Risk::USUAL.normal() - 1.959_964).abs() < 1e-6);
        assert!((Risk::USUAL.shared_by(5).normal() - 2.575_829).abs() < 1e-6);
        assert!(Risk::USUAL.student(usize::MAX) < 1.962);
    }
}
