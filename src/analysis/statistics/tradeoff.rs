//! Build time against tracing time: from how many rays on a slower build pays off.

use serde::Serialize;

/// Millions per second. `None` if they took no time.
#[must_use]
pub fn million_per_second(count: u64, nanoseconds: f64) -> Option<f64> {
    let rate = count as f64 * 1e3 / nanoseconds;
    rate.is_finite().then_some(rate)
}

/// The cost of a structure and of each ray through it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cost {
    /// Nanoseconds of the build.
    pub build_ns: f64,
    /// Nanoseconds of a ray.
    pub ray_ns: f64,
}

/// From how many rays on a structure is faster than another.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(tag = "when", rename_all = "snake_case")]
pub enum BreakEven {
    /// From the first ray on: neither its build nor its rays cost more.
    Always,
    /// After so many rays: its build costs more, its rays less.
    After {
        /// The number of rays at which both have taken the same time.
        rays: f64,
    },
    /// Only up to so many rays: its build costs less, its rays more.
    Until {
        /// The number of rays at which both have taken the same time.
        rays: f64,
    },
    /// Never: neither its build nor its rays cost less.
    Never,
    /// The interval of the ratio of their rays contains 1.
    NotToldApart,
}

/// From how many rays on `own` is faster than `base`: the n with `own.build + n·own.ray = base.build + n·base.ray`. Of
/// equal costs none is faster.
#[must_use]
pub fn break_even(own: Cost, base: Cost) -> BreakEven {
    let build = own.build_ns - base.build_ns;
    let ray = base.ray_ns - own.ray_ns;
    match (build > 0.0, ray > 0.0) {
        (true, true) => BreakEven::After { rays: build / ray },
        (false, true) => BreakEven::Always,
        (false, false) if build < 0.0 && ray < 0.0 => BreakEven::Until { rays: build / ray },
        (false, false) if build < 0.0 => BreakEven::Always,
        _ => BreakEven::Never,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cost(build_ns: f64, ray_ns: f64) -> Cost {
        Cost { build_ns, ray_ns }
    }

    #[test]
    fn a_million_in_a_second_is_one() {
        assert_eq!(million_per_second(1_000_000, 1e9), Some(1.0));
        assert_eq!(million_per_second(500, 1_000.0), Some(500.0));
        assert_eq!(million_per_second(1, 0.0), None);
        assert_eq!(million_per_second(0, 0.0), None);
    }

    #[test]
    fn the_break_even_is_the_build_difference_over_the_ray_difference() {
        let base = cost(100.0, 10.0);
        assert_eq!(break_even(cost(500.0, 2.0), base), BreakEven::After { rays: 50.0 });
        assert_eq!(break_even(cost(60.0, 12.0), base), BreakEven::Until { rays: 20.0 });
        assert_eq!(break_even(cost(100.0, 2.0), base), BreakEven::Always);
        assert_eq!(break_even(cost(60.0, 10.0), base), BreakEven::Always);
        assert_eq!(break_even(cost(500.0, 10.0), base), BreakEven::Never);
        assert_eq!(break_even(cost(500.0, 12.0), base), BreakEven::Never);
        assert_eq!(break_even(base, base), BreakEven::Never);
    }
}
