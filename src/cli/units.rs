//! Numbers for people: three or four figures and a unit.

use std::time::Duration;

/// A time: `1.23 s`, `45.6 ms`, `789 µs`, `2 min 5 s`, `1 h 2 min`.
pub(crate) fn time(duration: Duration) -> String {
    let seconds = duration.as_secs_f64();
    if duration.as_millis() >= 119_500 {
        return long_time(seconds.round() as u64);
    }
    // The bounds lie where rounding to three figures would reach the next unit.
    match seconds {
        s if s >= 0.999_5 => format!("{} s", three_figures(s)),
        s if s >= 0.999_5e-3 => format!("{} ms", three_figures(s * 1e3)),
        s => format!("{} µs", three_figures(s * 1e6)),
    }
}

/// Whole seconds in the two largest units that they fill.
fn long_time(seconds: u64) -> String {
    match seconds / 60 {
        minutes if minutes < 60 => format!("{minutes} min {} s", seconds % 60),
        minutes => format!("{} h {} min", minutes / 60, minutes % 60),
    }
}

/// A count: `999`, `1.23 k`, `12.3 M`, `4.56 G`.
pub(crate) fn count(n: u64) -> String {
    match n {
        0..1_000 => n.to_string(),
        _ => scaled(n as f64, 1e3, &["k", "M", "G", "T", "P", "E"]),
    }
}

/// A number of bytes: `512 B`, `4.50 MiB`.
pub(crate) fn bytes(n: u64) -> String {
    match n {
        0..1_024 => format!("{n} B"),
        _ => scaled(n as f64, 1_024.0, &["KiB", "MiB", "GiB", "TiB", "PiB", "EiB"]),
    }
}

/// A speed in rays: `12.3 M rays/s`. No time gives no speed.
pub(crate) fn rays_per_second(rays: u64, duration: Duration) -> String {
    let speed = rays as f64 / duration.as_secs_f64();
    if speed.is_finite() {
        format!("{} M rays/s", three_figures(speed / 1e6))
    } else {
        "– M rays/s".to_owned()
    }
}

/// A mean per ray with one or two decimals; `–` where there were no rays.
pub(crate) fn per_ray(total: u64, rays: u64) -> String {
    match rays {
        0 => "–".to_owned(),
        _ => {
            let mean = total as f64 / rays as f64;
            if mean < 99.995 { format!("{mean:.2}") } else { format!("{mean:.1}") }
        }
    }
}

/// A number of any size with four figures: `3.756`, `1723`, `1.500e-5`.
pub(crate) fn figures(value: f32) -> String {
    match value.abs() {
        v if v != 0.0 && !(1e-3..1e6).contains(&v) => format!("{value:.3e}"),
        v if v < 10.0 => format!("{value:.3}"),
        v if v < 1e3 => format!("{value:.1}"),
        _ => format!("{value:.0}"),
    }
}

/// Divides by `step` until three figures show less than a step.
fn scaled(mut value: f64, step: f64, units: &[&str]) -> String {
    let mut unit = 0;
    value /= step;
    while value >= step - 0.5 && unit + 1 < units.len() {
        value /= step;
        unit += 1;
    }
    format!("{} {}", three_figures(value), units[unit])
}

/// Three figures without an exponent: `1.23`, `12.3`, `123`, `1023`.
fn three_figures(value: f64) -> String {
    match value {
        v if v < 9.995 => format!("{v:.2}"),
        v if v < 99.95 => format!("{v:.1}"),
        v => format!("{v:.0}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times() {
        let at = |seconds: f64| time(Duration::from_secs_f64(seconds));
        assert_eq!(at(0.0), "0.00 µs");
        assert_eq!(at(789e-6), "789 µs");
        assert_eq!(at(0.000_999_7), "1.00 ms");
        assert_eq!(at(0.0456), "45.6 ms");
        assert_eq!(at(0.999_7), "1.00 s");
        assert_eq!(at(1.234), "1.23 s");
        assert_eq!(at(59.96), "60.0 s");
        assert_eq!(at(119.4), "119 s");
        assert_eq!(at(119.6), "2 min 0 s");
        assert_eq!(at(125.0), "2 min 5 s");
        assert_eq!(at(3_720.0), "1 h 2 min");
    }

    #[test]
    fn counts() {
        assert_eq!(count(0), "0");
        assert_eq!(count(999), "999");
        assert_eq!(count(1_234), "1.23 k");
        assert_eq!(count(999_999), "1.00 M");
        assert_eq!(count(12_345_678), "12.3 M");
        assert_eq!(count(u64::MAX), "18.4 E");
    }

    #[test]
    fn sizes_in_memory() {
        assert_eq!(bytes(512), "512 B");
        assert_eq!(bytes(1_024), "1.00 KiB");
        assert_eq!(bytes(4_718_592), "4.50 MiB");
        assert_eq!(bytes(1_048_575), "1.00 MiB");
        assert_eq!(bytes(1_047_000), "1022 KiB");
    }

    #[test]
    fn figures_of_any_size() {
        assert_eq!(figures(0.0), "0.000");
        assert_eq!(figures(3.756_4), "3.756");
        assert_eq!(figures(172.39), "172.4");
        assert_eq!(figures(1_723.9), "1724");
        assert_eq!(figures(1.5e-5), "1.500e-5");
        assert_eq!(figures(2.5e7), "2.500e7");
    }

    #[test]
    fn rates() {
        let second = Duration::from_secs(1);
        assert_eq!(rays_per_second(12_345_678, second), "12.3 M rays/s");
        assert_eq!(rays_per_second(12_345, second), "0.01 M rays/s");
        assert_eq!(rays_per_second(5, Duration::ZERO), "– M rays/s");
        assert_eq!(per_ray(469, 20), "23.45");
        assert_eq!(per_ray(1_234_567, 1_000), "1234.6");
        assert_eq!(per_ray(0, 0), "–");
    }
}
