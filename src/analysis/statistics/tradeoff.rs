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

/// The Pareto front: the points that no other point dominates, if less is better in both coordinates. They are given as
/// indices, by growing first coordinate. Of equal points all are on the front; points with a NaN never are.
#[must_use]
pub fn pareto_front(points: &[(f64, f64)]) -> Vec<usize> {
    let dominates =
        |a: (f64, f64), b: (f64, f64)| a.0 <= b.0 && a.1 <= b.1 && (a.0 < b.0 || a.1 < b.1);
    let mut front: Vec<usize> = (0..points.len())
        .filter(|&i| !points[i].0.is_nan() && !points[i].1.is_nan())
        .filter(|&i| !points.iter().any(|&other| dominates(other, points[i])))
        .collect();
    front.sort_by(|&a, &b| points[a].0.total_cmp(&points[b].0));
    front
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

    #[test]
    fn the_front_is_what_nothing_dominates() {
        let points = [(3.0, 1.0), (1.0, 3.0), (2.0, 2.0), (3.0, 2.0), (2.0, 4.0), (f64::NAN, 0.0)];
        assert_eq!(pareto_front(&points), [1, 2, 0]);
        assert_eq!(pareto_front(&[(1.0, 1.0), (1.0, 1.0)]), [0, 1]);
        assert!(pareto_front(&[]).is_empty());
    }
}
