//! Figures of a class of rays.

use serde::Serialize;

use super::statistics::{estimate, median, million_per_second, paired_ratio};
use crate::record::{ClassRecord, CommonRays, Estimate, HardwareCounters, RayClass, Round};

/// The figures of a class of rays with a structure.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ClassFigures {
    /// The class.
    pub class: RayClass,
    /// Rays in each round.
    pub rays: u64,
    /// The share of them that hit something, from 0 to 1.
    pub hit_share: Option<f64>,
    /// Box tests per ray.
    pub boxes_per_ray: Option<f64>,
    /// Primitive tests per ray.
    pub primitives_per_ray: Option<f64>,
    /// Own time per ray in nanoseconds: wall time without waiting for a processor that other programs used
    /// ([`Round::own_ns`]).
    pub ns_per_ray: Option<Estimate>,
    /// Processor time per ray in nanoseconds, all threads together.
    pub cpu_ns_per_ray: Option<Estimate>,
    /// The median over the rounds of wall time over own time: 1 if no other program used the processor.
    pub disturbance: Option<f64>,
    /// Instructions per clock cycle, if the processor counted both.
    pub instructions_per_cycle: Option<Estimate>,
    /// Mispredicted branches per ray, if the processor counted them.
    pub branch_misses_per_ray: Option<Estimate>,
    /// Reads per ray that missed the last-level cache, if the processor counted them.
    pub cache_misses_per_ray: Option<Estimate>,
    /// Millions of rays per second.
    pub million_rays_per_second: Option<Estimate>,
    /// How many times as fast as the scene's base, per ray, on the rays that both traced.
    pub speedup: Option<Estimate>,
    /// How many rays both traced; absent if `speedup` is the ratio of times of different rays, in older records.
    pub speedup_rays: Option<u64>,
}

impl ClassFigures {
    /// Times with a larger disturbance are marked: other programs changed the caches too, which own time does not
    /// exclude.
    pub const DISTURBED: f64 = 1.1;

    /// Whether other programs used the processor for a large part of the time.
    #[must_use]
    pub fn is_disturbed(&self) -> bool {
        self.disturbance.is_some_and(|disturbance| disturbance > Self::DISTURBED)
    }
}

/// The figures of a class; ratios are to the same class of the base.
pub(super) fn class_figures(own: &ClassRecord, base: Option<&ClassRecord>) -> ClassFigures {
    let per_ray = |n: u64| quotient(n as f64, own.rays as f64);
    let ns_per_ray = estimate(&own_ns_per_ray(&own.rounds, own.rays));
    let (speedup, speedup_rays) = base.map_or((None, None), |base| speedup(base, own));
    ClassFigures {
        class: own.class,
        rays: own.rays,
        hit_share: per_ray(own.hits),
        boxes_per_ray: own.boxes.and_then(per_ray),
        primitives_per_ray: own.primitives.and_then(per_ray),
        ns_per_ray,
        cpu_ns_per_ray: cpu_ns_per_ray(own),
        disturbance: disturbance(&own.rounds),
        instructions_per_cycle: counted(own, |counts| {
            quotient(counts.instructions? as f64, counts.cycles? as f64)
        }),
        branch_misses_per_ray: counted(own, |counts| per_ray(counts.branch_misses?)),
        cache_misses_per_ray: counted(own, |counts| per_ray(counts.cache_misses?)),
        million_rays_per_second: ns_per_ray.and_then(rate),
        speedup,
        speedup_rays,
    }
}

/// The own time per ray in nanoseconds, for each round; empty if a round has no rays.
pub(super) fn own_ns_per_ray(rounds: &[Round], rays: u64) -> Vec<f64> {
    if rays == 0 {
        return Vec::new();
    }
    rounds.iter().map(|round| round.own_ns() as f64 / rays as f64).collect()
}

/// Wall time over own time, in the median over the rounds.
fn disturbance(rounds: &[Round]) -> Option<f64> {
    let of_round = |round: &Round| {
        round.cpu_ns?;
        quotient(round.wall_ns as f64, round.own_ns() as f64)
    };
    let rounds: Option<Vec<f64>> = rounds.iter().map(of_round).collect();
    median(&rounds?)
}

/// Millions of rays per second from the time per ray.
fn rate(ns_per_ray: Estimate) -> Option<Estimate> {
    million_per_second(1, ns_per_ray.median)?;
    Some(ns_per_ray.map(|ns| million_per_second(1, ns).unwrap_or(f64::MAX)))
}

/// The ratio to the base on the rays that both traced, and their number.
fn speedup(base: &ClassRecord, own: &ClassRecord) -> (Option<Estimate>, Option<u64>) {
    let ratio = |base: &[Round], own: &[Round], base_rays, own_rays| {
        paired_ratio(&own_ns_per_ray(base, base_rays), &own_ns_per_ray(own, own_rays))
    };
    match &own.common {
        Some(CommonRays { rays, own, base }) => (ratio(base, own, *rays, *rays), Some(*rays)),
        None => {
            let same = (base.rays == own.rays).then_some(own.rays);
            (ratio(&base.rounds, &own.rounds, base.rays, own.rays), same)
        }
    }
}

/// Processor time per ray, if it was measured in every round.
fn cpu_ns_per_ray(class: &ClassRecord) -> Option<Estimate> {
    let per_ray = |round: &Round| quotient(round.cpu_ns? as f64, class.rays as f64);
    let rounds: Option<Vec<f64>> = class.rounds.iter().map(per_ray).collect();
    estimate(&rounds?)
}

/// The estimate of something that the processor counted, if it did so in every round.
fn counted(
    class: &ClassRecord,
    value: impl Fn(&HardwareCounters) -> Option<f64>,
) -> Option<Estimate> {
    let of_round = |round: &Round| value(round.hardware.as_ref()?);
    let rounds: Option<Vec<f64>> = class.rounds.iter().map(of_round).collect();
    estimate(&rounds?)
}

/// `None` instead of infinity or NaN.
pub(super) fn quotient(a: f64, b: f64) -> Option<f64> {
    (b != 0.0).then(|| a / b)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn class(rays: u64, wall_ns: &[u64]) -> ClassRecord {
        ClassRecord {
            class: RayClass::View,
            rays,
            hits: rays / 4,
            boxes: Some(rays * 3),
            primitives: None,
            rounds: rounds(wall_ns),
            common: None,
        }
    }

    fn rounds(wall_ns: &[u64]) -> Vec<Round> {
        wall_ns.iter().map(|&wall_ns| Round { wall_ns, ..Round::default() }).collect()
    }

    #[test]
    fn waiting_for_other_programs_is_left_out_and_reported() {
        let busy = |wall_ns, cpu_ns| {
            let mut class = class(100, &[wall_ns; 6]);
            class.rounds.iter_mut().for_each(|round| round.cpu_ns = Some(cpu_ns));
            class
        };
        let (base, own) = (busy(10_000, 9_900), busy(60_000, 9_900));
        let figures = class_figures(&own, Some(&base));
        assert_eq!(figures.speedup.unwrap().median, 1.0, "equal work took equal time");
        assert_eq!(figures.ns_per_ray.unwrap().median, 99.0);
        assert!(figures.is_disturbed() && !class_figures(&base, None).is_disturbed());
        // Two threads together have more processor time than the wall time of the round.
        let parallel = class_figures(&busy(10_000, 19_000), None);
        assert_eq!(parallel.ns_per_ray.unwrap().median, 100.0);
        assert_eq!(parallel.disturbance, Some(1.0));
    }

    #[test]
    fn ratios_are_of_the_rays_that_both_traced() {
        let base = class(100, &[40_000; 6]);
        let mut own = class(1_000, &[100_000; 6]);
        assert_eq!(class_figures(&own, Some(&base)).speedup_rays, None, "of different rays");
        let common = CommonRays { rays: 100, own: rounds(&[20_000; 6]), base: base.rounds.clone() };
        own.common = Some(common);
        let figures = class_figures(&own, Some(&base));
        assert_eq!((figures.speedup.unwrap().median, figures.speedup_rays), (2.0, Some(100)));
        assert_eq!(figures.ns_per_ray.unwrap().median, 100.0, "all rays count for the time");
    }

    #[test]
    fn figures_are_per_ray() {
        let base = class(100, &[40_000; 6]);
        let own = class(1_000, &[100_000; 6]);
        let figures = class_figures(&own, Some(&base));
        assert_eq!(figures.ns_per_ray.unwrap().median, 100.0);
        assert_eq!(figures.million_rays_per_second.unwrap().median, 10.0);
        assert_eq!(figures.speedup.unwrap().median, 4.0);
        assert_eq!((figures.hit_share, figures.boxes_per_ray), (Some(0.25), Some(3.0)));
        assert_eq!((figures.primitives_per_ray, figures.cpu_ns_per_ray), (None, None));
    }

    #[test]
    fn what_the_processor_counted_is_per_cycle_and_per_ray() {
        let mut class = class(1_000, &[5_000; 6]);
        for (round, n) in class.rounds.iter_mut().zip(0..) {
            round.hardware = Some(HardwareCounters {
                cycles: Some(20_000 + 10 * n),
                instructions: Some(50_000 + 25 * n),
                branch_misses: Some(1_500),
                cache_misses: None,
            });
        }
        let figures = class_figures(&class, None);
        let ipc = figures.instructions_per_cycle.unwrap();
        assert_eq!((ipc.median, ipc.rounds), (2.5, 6));
        assert_eq!(figures.branch_misses_per_ray.unwrap().median, 1.5);
        assert_eq!(figures.cache_misses_per_ray, None, "not counted");
        class.rounds[3].hardware = None;
        let figures = class_figures(&class, None);
        assert_eq!(figures.instructions_per_cycle, None, "not counted in every round");
        class.rounds =
            vec![Round { hardware: Some(HardwareCounters::default()), wall_ns: 1, cpu_ns: None }];
        assert_eq!(class_figures(&class, None).branch_misses_per_ray, None);
        class.rounds[0].hardware = Some(HardwareCounters {
            cycles: Some(0),
            instructions: Some(0),
            ..HardwareCounters::default()
        });
        assert_eq!(class_figures(&class, None).instructions_per_cycle, None, "never ran");
    }

    #[test]
    fn no_rays_and_no_rounds_have_no_figures() {
        for nothing in [class(0, &[5; 6]), class(10, &[])] {
            let figures = class_figures(&nothing, Some(&nothing));
            assert_eq!((figures.ns_per_ray, figures.speedup), (None, None));
            assert_eq!(figures.million_rays_per_second, None);
        }
    }
}
