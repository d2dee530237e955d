//! Numbers → places along an axis.

use crate::report::numbers::{Unit, unit_of};

/// How an axis is divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::report) enum AxisKind {
    /// Equal steps are equal differences.
    Linear,
    /// Equal steps are equal factors.
    Logarithmic,
}

/// Beyond these, numbers are taken to an axis's end: the ratio and the difference of any two within are finite.
const SMALLEST: f64 = 1e-150;
const LARGEST: f64 = 1e150;

/// An axis from `low` at place `from` to `high` at place `to`.
#[derive(Clone, Copy, Debug)]
pub(in crate::report) struct Axis {
    kind: AxisKind,
    low: f64,
    high: f64,
    from: f64,
    to: f64,
}

impl AxisKind {
    /// The nearest number that an axis may have; a NaN is the smallest.
    fn within(self, value: f64) -> f64 {
        let floor = if self == Self::Logarithmic { SMALLEST } else { -LARGEST };
        value.max(floor).min(LARGEST)
    }
}

impl Axis {
    /// An axis over this range, as far as numbers can be told apart in it; a logarithmic one starts above 0.
    pub(in crate::report) fn new(kind: AxisKind, range: (f64, f64), places: (f64, f64)) -> Self {
        let (low, mut high) = (kind.within(range.0), kind.within(range.1));
        // Steps along it are numbers of their own.
        if high - low <= (1e-9 * low.abs()).max(SMALLEST) {
            high = if low == 0.0 { 1.0 } else { low + low.abs() };
        }
        Self { kind, low, high, from: places.0, to: places.1 }
    }

    /// A logarithmic axis over all positive values, with a margin; `None` if there is none.
    pub(in crate::report) fn around(
        values: impl IntoIterator<Item = f64>,
        places: (f64, f64),
    ) -> Option<Self> {
        let positive = values.into_iter().filter(|value| value.is_finite() && *value > 0.0);
        let (low, high) = positive.fold(None, |range: Option<(f64, f64)>, value| {
            Some(range.map_or((value, value), |(a, b)| (a.min(value), b.max(value))))
        })?;
        // At least a factor of 2.5, so that the axis has ticks.
        let (low, high) = (AxisKind::Logarithmic.within(low), AxisKind::Logarithmic.within(high));
        let margin = (high / low).powf(0.06).max((2.5 * low / high).sqrt()).max(1.05);
        Some(Self::new(AxisKind::Logarithmic, (low / margin, high * margin), places))
    }

    /// The place of a number.
    pub(in crate::report) fn at(&self, value: f64) -> f64 {
        let value = self.kind.within(value);
        let share = match self.kind {
            AxisKind::Linear => (value - self.low) / (self.high - self.low),
            AxisKind::Logarithmic => (value / self.low).ln() / (self.high / self.low).ln(),
        };
        self.from + share * (self.to - self.from)
    }

    /// The place of a number, at the nearer end if it is outside.
    pub(super) fn clamped(&self, value: f64) -> f64 {
        self.at(value.clamp(self.low, self.high))
    }

    /// The round numbers at the axis.
    pub(in crate::report) fn ticks(&self) -> Vec<f64> {
        match self.kind {
            AxisKind::Linear => linear_ticks(self.low, self.high),
            AxisKind::Logarithmic => logarithmic_ticks(self.low, self.high),
        }
    }
}

/// About five steps of 1, 2 or 5 times a power of ten.
fn linear_ticks(low: f64, high: f64) -> Vec<f64> {
    let rough = (high - low) / 5.0;
    let power = 10f64.powf(rough.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0].map(|m| m * power).into_iter().find(|&s| s >= rough);
    let step = step.unwrap_or(rough);
    let first = (low / step).ceil();
    (0..20).map(|i| (first + f64::from(i)) * step).take_while(|&v| v <= high * 1.000_001).collect()
}

/// Powers of ten; for a short axis also their multiples by 2 and 5, for a long one only every second or third power.
fn logarithmic_ticks(low: f64, high: f64) -> Vec<f64> {
    let decades = (high / low).log10();
    let within = |v: &f64| *v >= low * 0.999_999 && *v <= high * 1.000_001;
    let (first, last) = (low.log10().floor() as i32, high.log10().ceil() as i32);
    let factors: &[f64] = if decades < 2.2 { &[1.0, 2.0, 5.0] } else { &[1.0] };
    let every = (decades / 8.0).ceil().max(1.0) as i32;
    (first..=last)
        .filter(|power| power.rem_euclid(every) == 0)
        .flat_map(|power| factors.iter().map(move |factor| factor * 10f64.powi(power)))
        .filter(within)
        .collect()
}

/// The text at a tick: `10 ms`, `0.5`, `1 M`.
pub(in crate::report) fn tick_label(value: f64, units: &'static [Unit]) -> String {
    let (name, size) = if units.is_empty() { ("", 1.0) } else { unit_of(value, units) };
    let number = value / size;
    let places = if number > 0.0 && number < 1.0 { (-number.log10()).ceil() as usize } else { 0 };
    let number = format!("{number:.places$}");
    if name.is_empty() { number } else { format!("{number}\u{a0}{name}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_follow_the_kind() {
        let linear = Axis::new(AxisKind::Linear, (0.0, 10.0), (100.0, 200.0));
        assert_eq!(linear.at(5.0), 150.0);
        let logarithmic = Axis::new(AxisKind::Logarithmic, (1.0, 100.0), (100.0, 200.0));
        assert!((logarithmic.at(10.0) - 150.0).abs() < 1e-9);
        assert_eq!(logarithmic.clamped(1e9), 200.0);
        assert!(logarithmic.at(0.0).is_finite());
    }

    #[test]
    fn ticks_are_round() {
        assert_eq!(linear_ticks(0.0, 10.0), [0.0, 2.0, 4.0, 6.0, 8.0, 10.0]);
        assert_eq!(logarithmic_ticks(0.9, 12.0), [1.0, 2.0, 5.0, 10.0]);
        assert_eq!(logarithmic_ticks(1.0, 1e4), [1.0, 10.0, 100.0, 1000.0, 10_000.0]);
        assert!(logarithmic_ticks(1e-3, 1e18).len() <= 9);
        assert_eq!(tick_label(0.05, &[]), "0.05");
        assert_eq!(tick_label(2e7, &[("ms", 1e6)]), "20\u{a0}ms");
    }

    #[test]
    fn no_range_is_still_an_axis() {
        for axis in [
            Axis::new(AxisKind::Linear, (3.0, 3.0), (0.0, 1.0)),
            Axis::new(AxisKind::Linear, (0.0, 0.0), (0.0, 1.0)),
            Axis::around([7.0], (0.0, 1.0)).unwrap(),
        ] {
            assert!(axis.at(3.0).is_finite());
            assert!(!axis.ticks().is_empty());
        }
        assert!(Axis::around([0.0, f64::NAN], (0.0, 1.0)).is_none());
    }
}
