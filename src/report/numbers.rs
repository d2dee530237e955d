//! Numbers as people read them. Only this file rounds, so that all reports and the terminal show the same numbers.
//!
//! Tables show three or four digits with a unit; CSV and JSON have numbers in full precision. A spread `low–high` has
//! the decimals and the unit of its value.

use crate::record::Estimate;

/// What is shown in place of a missing number.
pub(crate) const NOTHING: &str = "–";

/// A unit and how many of the base unit it is.
pub(crate) type Unit = (&'static str, f64);

/// Units of times in nanoseconds, largest first.
pub(crate) const TIME: &[Unit] = &[("s", 1e9), ("ms", 1e6), ("µs", 1e3), ("ns", 1.0)];
/// Units of sizes in bytes, largest first.
pub(crate) const BYTES: &[Unit] =
    &[("GiB", 1_073_741_824.0), ("MiB", 1_048_576.0), ("KiB", 1_024.0), ("B", 1.0)];
/// Factors of counts, largest first.
pub(crate) const COUNT: &[Unit] = &[("G", 1e9), ("M", 1e6), ("k", 1e3), ("", 1.0)];

/// The decimals of a number with three digits, at most `most`.
pub(crate) fn decimals(value: f64, most: usize) -> usize {
    let enough = match value.abs() {
        v if v >= 99.95 => 0,
        v if v >= 9.995 => 1,
        v if v >= 0.9995 || v == 0.0 => 2,
        v if v >= 0.099_95 => 3,
        v if v >= 0.009_995 => 4,
        _ => 5,
    };
    enough.min(most)
}

/// A number with three digits or more, in groups of three.
pub(crate) fn figures(value: f64) -> String {
    grouped(&format!("{value:.*}", decimals(value, 5)))
}

/// A whole number in groups of three digits: `1 234 567`, with no-break spaces.
pub(crate) fn whole(n: u64) -> String {
    grouped(&n.to_string())
}

/// A number of things, in the plural unless it is 1.
pub(crate) fn things(n: u64, thing: &str) -> String {
    format!("{} {thing}{}", whole(n), if n == 1 { "" } else { "s" })
}

/// The sides of a picture: `300 × 200`.
pub(crate) fn size([width, height]: [u32; 2]) -> String {
    format!("{width}\u{a0}×\u{a0}{height}")
}

/// Splits the digits before the point into groups of three.
fn grouped(number: &str) -> String {
    let digits = number.find('.').unwrap_or(number.len());
    let start = usize::from(number.starts_with('-'));
    let mut text = String::with_capacity(number.len() + 4);
    for (i, c) in number.char_indices() {
        if i > start && i < digits && (digits - i).is_multiple_of(3) && digits - start > 4 {
            text.push('\u{202f}');
        }
        text.push(c);
    }
    text
}

/// The largest unit in which a number is at least 1, as it will be rounded.
pub(crate) fn unit_of(value: f64, units: &'static [Unit]) -> Unit {
    let fits = |unit: &&Unit| value.abs() >= 0.9995 * unit.1;
    units.iter().find(fits).or(units.last()).copied().unwrap_or(("", 1.0))
}

/// A number in the unit that suits it; plain without units.
pub(crate) fn in_units(value: f64, units: &'static [Unit]) -> String {
    if units.is_empty() { figures(value) } else { with_unit(value, units) }
}

/// A number in the unit that suits it.
fn with_unit(value: f64, units: &'static [Unit]) -> String {
    let (name, size) = unit_of(value, units);
    let number = figures(value / size);
    if name.is_empty() { number } else { format!("{number}\u{a0}{name}") }
}

/// A time: `45.6 ms`.
pub(crate) fn time(nanoseconds: f64) -> String {
    with_unit(nanoseconds, TIME)
}

/// A time that somebody waits for: `45.6 ms`; from two minutes on in the two largest units that it
/// fills, `2 min 5 s` or `1 h 2 min`.
pub(crate) fn duration(seconds: f64) -> String {
    if seconds < 119.5 {
        return time(seconds * 1e9);
    }
    let seconds = seconds.round() as u64;
    match seconds / 60 {
        minutes if minutes < 60 => format!("{minutes}\u{a0}min {}\u{a0}s", seconds % 60),
        minutes => format!("{}\u{a0}h {}\u{a0}min", minutes / 60, minutes % 60),
    }
}

/// A size in memory: `4.50 MiB`; bytes are whole.
pub(crate) fn bytes(n: u64) -> String {
    if n < 1_024 { format!("{n}\u{a0}B") } else { with_unit(n as f64, BYTES) }
}

/// A count: `999`, `1.23 M`; below a thousand exact.
pub(crate) fn count(n: u64) -> String {
    if n < 1_000 { n.to_string() } else { with_unit(n as f64, COUNT) }
}

/// A computed number of rays: `1.23 M`.
pub(crate) fn about(n: f64) -> String {
    with_unit(n, COUNT)
}

/// A share as a percentage: `12.3 %`.
pub(crate) fn percent(share: f64) -> String {
    format!("{:.1}\u{a0}%", share * 100.0)
}

/// A share that may be far below a percent, with three digits.
pub(crate) fn small_percent(share: f64) -> String {
    format!("{}\u{a0}%", figures(share * 100.0))
}

/// A value without its interval, with three digits.
pub(crate) fn value(estimate: Estimate) -> String {
    figures(estimate.value)
}

/// The interval of an estimate with the decimals of its value: `3.02–3.21`.
pub(crate) fn spread(estimate: Estimate) -> Option<String> {
    let interval = estimate.interval?;
    let places = decimals(estimate.value, 5);
    let show = |value: f64| grouped(&format!("{value:.places$}"));
    Some(format!("{}–{}", show(interval.low), show(interval.high)))
}

/// Value and interval in the unit of the value: `45.6 ms (45.2–46.0)`.
pub(crate) fn time_estimate(estimate: Estimate) -> (String, Option<String>) {
    let (name, size) = unit_of(estimate.value, TIME);
    let scaled = estimate.map(|ns| ns / size);
    (format!("{}\u{a0}{name}", value(scaled)), spread(scaled))
}

/// A number in full precision: reading it gives the same number.
pub(crate) fn exact(value: f64) -> String {
    format!("{value}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::Interval;

    #[test]
    fn three_figures_and_a_unit() {
        assert_eq!(time(45_600_000.0), "45.6\u{a0}ms");
        assert_eq!(time(999_900.0), "1.00\u{a0}ms");
        assert_eq!(time(0.5), "0.500\u{a0}ns");
        assert_eq!(time(12_345e9), "12\u{202f}345\u{a0}s");
        assert_eq!(bytes(1_023), "1023\u{a0}B");
        assert_eq!(bytes(4_718_592), "4.50\u{a0}MiB");
        assert_eq!((count(999), count(1_234_567)), ("999".to_owned(), "1.23\u{a0}M".to_owned()));
        assert_eq!(percent(0.1234), "12.3\u{a0}%");
        assert_eq!(whole(1_234_567), "1\u{202f}234\u{202f}567");
        assert_eq!((whole(1_234), whole(12_345)), ("1234".to_owned(), "12\u{202f}345".to_owned()));
    }

    #[test]
    fn long_times_have_two_units() {
        assert_eq!(duration(59.96), "60.0\u{a0}s");
        assert_eq!(duration(119.4), "119\u{a0}s");
        assert_eq!(duration(119.6), "2\u{a0}min 0\u{a0}s");
        assert_eq!(duration(125.0), "2\u{a0}min 5\u{a0}s");
        assert_eq!(duration(3_720.0), "1\u{a0}h 2\u{a0}min");
    }

    #[test]
    fn an_interval_has_the_decimals_of_its_median() {
        let interval = Some(Interval { low: 9.9, high: 10.25 });
        let estimate = Estimate { value: 10.0, interval, rounds: 10 };
        assert_eq!(super::value(estimate), "10.0");
        assert_eq!(spread(estimate).as_deref(), Some("9.9–10.2"));
        let (text, range) = time_estimate(estimate.map(|x| x * 1e6));
        assert_eq!((text.as_str(), range.as_deref()), ("10.0\u{a0}ms", Some("9.9–10.2")));
    }

    #[test]
    fn exact_numbers_read_back_as_they_were() {
        for value in [0.1, 1.0 / 3.0, 1e-300, 123_456_789.123] {
            assert_eq!(exact(value).parse::<f64>().unwrap(), value);
        }
    }
}
