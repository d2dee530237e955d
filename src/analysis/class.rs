//! Figures of a class of rays.

use serde::Serialize;

use super::statistics::{
    BetweenRuns, Center, Risk, Rounds, median, million_per_second, ratio_of_estimates,
};
use crate::record::{
    BlockSample, ClassRecord, Estimate, HardwareCounters, RayClass, Round, SceneRecord,
    StructureRecord,
};

/// The figures of a class of rays with a structure.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ClassFigures {
    /// The class.
    pub class: RayClass,
    /// Rays in each round.
    pub rays: u64,
    /// How many rays were recorded: times and rates are estimates for all of them.
    pub recorded_rays: u64,
    /// The share of them that hit something, from 0 to 1. It is the same for all structures: that which was counted on
    /// the most rays.
    pub hit_share: Option<f64>,
    /// The share of them on which tests were counted: below 1 the two figures that follow are of a sample, and have no
    /// interval.
    pub counted_share: Option<f64>,
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
    /// How many times as fast as the scene's base: the ratio of both estimates for all recorded rays.
    pub speedup: Option<Estimate>,
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

    /// Whether each round traced a random sample of the recorded rays.
    #[must_use]
    pub fn is_sampled(&self) -> bool {
        self.rays < self.recorded_rays
    }

    /// Processor time over own time, where it is larger by more than [`DISTURBED`](Self::DISTURBED): more than one
    /// thread worked.
    #[must_use]
    pub fn processor_share(&self) -> Option<f64> {
        let share = self.cpu_ns_per_ray?.value / self.ns_per_ray?.value;
        (share > Self::DISTURBED).then_some(share)
    }
}

/// The figures of a class, for any run; ratios are to the same class of the base.
pub(super) fn class_figures(
    own: &ClassRecord,
    base: Option<&ClassRecord>,
    between_runs: BetweenRuns,
) -> ClassFigures {
    let per_counted = |n: u64| quotient(n as f64, counted_rays(own) as f64);
    let per_ray = |n: u64| quotient(n as f64, own.rays as f64);
    let times = ray_times(own);
    let for_any_run = |estimate| between_runs.widen(estimate);
    let ns_per_ray = times.estimate().map(for_any_run);
    ClassFigures {
        class: own.class,
        rays: own.rays,
        recorded_rays: own.recorded_rays(),
        hit_share: per_counted(own.hits),
        counted_share: quotient(counted_rays(own) as f64, own.recorded_rays() as f64),
        boxes_per_ray: own.boxes.and_then(per_counted),
        primitives_per_ray: own.primitives.and_then(per_counted),
        ns_per_ray,
        cpu_ns_per_ray: cpu_ns_per_ray(own).map(for_any_run),
        disturbance: disturbance(&own.rounds),
        instructions_per_cycle: counted(own, |counts| {
            quotient(counts.instructions? as f64, counts.cycles? as f64)
        }),
        branch_misses_per_ray: counted(own, |counts| per_ray(counts.branch_misses?)),
        cache_misses_per_ray: counted(own, |counts| per_ray(counts.cache_misses?)),
        million_rays_per_second: ns_per_ray.and_then(rate),
        speedup: base.and_then(|base| {
            let ratio = ratio_of_estimates(&ray_times(base), &times, Risk::USUAL)?;
            // The base's ratio to itself is 1 in every run.
            Some(if std::ptr::eq(base, own) { ratio } else { for_any_run(ratio) })
        }),
    }
}

/// The rays on which hits and tests were counted; older records do not say, and counted those of a round.
fn counted_rays(class: &ClassRecord) -> u64 {
    if class.counted_rays > 0 { class.counted_rays } else { class.rays }
}

/// The share of a class's rays that hit something: hits are equal for all structures, so by what was counted on the
/// most rays. A structure that failed may not have counted, and a peer's hits are its own.
pub(super) fn hit_share(scene: &SceneRecord, class: RayClass) -> Option<f64> {
    let rows = scene.structures.iter().filter(|row| !row.has_failed());
    let of = |row: &'_ StructureRecord| row.class(class).map(counted_rays);
    let best = rows.max_by_key(|row| (of(row).is_some() && !row.peer, of(row)))?;
    let counted = best.class(class)?;
    quotient(counted.hits as f64, counted_rays(counted) as f64)
}

/// The own time per ray of a class in nanoseconds, for each round.
pub(super) fn ray_times(class: &ClassRecord) -> Rounds {
    own_ns_per_ray(&class.rounds, class.rays, class.sample, &class.passes)
}

/// The own time per ray in nanoseconds, for each round; empty if a round has no rays.
pub(super) fn own_ns_per_ray(
    rounds: &[Round],
    rays: u64,
    sample: Option<BlockSample>,
    passes: &[u64],
) -> Rounds {
    let rounds = if rays == 0 { &[] } else { rounds };
    let per_ray = |round: &Round| round.own_ns() as f64 / rays as f64;
    replicates(rounds.iter().map(per_ray).collect(), sample, passes)
}

/// The rounds of a class with some value in each.
fn replicates(values: Vec<f64>, sample: Option<BlockSample>, passes: &[u64]) -> Rounds {
    let passes = passes.iter().map(|&rounds| usize::try_from(rounds).unwrap_or(usize::MAX));
    Rounds { values, center: center(sample), passes: passes.collect() }
}

/// What of the rounds is the estimate for all recorded rays.
fn center(sample: Option<BlockSample>) -> Center {
    if sample.is_some() { Center::Mean } else { Center::Median }
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
    million_per_second(1, ns_per_ray.value)?;
    Some(ns_per_ray.map(|ns| million_per_second(1, ns).unwrap_or(f64::MAX)))
}

/// Processor time per ray, if it was measured in every round.
fn cpu_ns_per_ray(class: &ClassRecord) -> Option<Estimate> {
    let per_ray = |round: &Round| quotient(round.cpu_ns? as f64, class.rays as f64);
    estimate_of(class, per_ray)
}

/// The estimate of something that the processor counted, if it did so in every round.
fn counted(
    class: &ClassRecord,
    value: impl Fn(&HardwareCounters) -> Option<f64>,
) -> Option<Estimate> {
    estimate_of(class, |round| value(round.hardware.as_ref()?))
}

/// The estimate of something that is known of every round.
fn estimate_of(class: &ClassRecord, value: impl Fn(&Round) -> Option<f64>) -> Option<Estimate> {
    let values: Option<Vec<f64>> = class.rounds.iter().map(value).collect();
    replicates(values?, class.sample, &class.passes).estimate()
}

/// `None` instead of infinity or NaN.
pub(super) fn quotient(a: f64, b: f64) -> Option<f64> {
    (b != 0.0).then(|| a / b)
}

#[cfg(test)]
mod tests {
    use super::*;

    const NONE: BetweenRuns = BetweenRuns(0.0);

    fn class(rays: u64, wall_ns: &[u64]) -> ClassRecord {
        ClassRecord {
            class: RayClass::View,
            rays,
            sample: None,
            counted_rays: 0,
            hits: rays / 4,
            boxes: Some(rays * 3),
            primitives: None,
            rounds: rounds(wall_ns),
            passes: Vec::new(),
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
        let figures = class_figures(&own, Some(&base), NONE);
        assert_eq!(figures.speedup.unwrap().value, 1.0, "equal work took equal time");
        assert_eq!(figures.ns_per_ray.unwrap().value, 99.0);
        assert!(figures.is_disturbed() && !class_figures(&base, None, NONE).is_disturbed());
        // Two threads together have more processor time than the wall time of the round.
        let parallel = class_figures(&busy(10_000, 19_000), None, NONE);
        assert_eq!(parallel.ns_per_ray.unwrap().value, 100.0);
        assert_eq!(parallel.disturbance, Some(1.0));
    }

    #[test]
    fn ratios_are_of_estimates_for_all_recorded_rays() {
        let mut base = class(100, &[40_000, 20_000, 30_000, 30_000, 20_000, 40_000]);
        base.sample = Some(BlockSample { blocks: 10, rays_per_block: 10, of_rays: 1_000 });
        base.counted_rays = 50;
        let own = class(1_000, &[100_000; 6]);
        let figures = class_figures(&own, Some(&base), NONE);
        let speedup = figures.speedup.unwrap();
        assert!((speedup.value - 3.0).abs() < 1e-12, "{speedup:?}");
        assert!(speedup.supports_a_statement(), "{speedup:?}");
        let base = class_figures(&base, None, NONE);
        assert!(base.is_sampled() && !figures.is_sampled());
        assert_eq!((base.rays, base.recorded_rays), (100, 1_000));
        assert_eq!(base.boxes_per_ray, Some(6.0), "300 of 50 counted rays");
        assert_eq!(base.ns_per_ray.unwrap().value, 300.0);
    }

    #[test]
    fn figures_are_per_ray() {
        let base = class(100, &[40_000; 6]);
        let own = class(1_000, &[100_000; 6]);
        let figures = class_figures(&own, Some(&base), NONE);
        assert_eq!(figures.ns_per_ray.unwrap().value, 100.0);
        assert_eq!(figures.million_rays_per_second.unwrap().value, 10.0);
        assert_eq!(figures.speedup.unwrap().value, 4.0);
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
        let figures = class_figures(&class, None, NONE);
        let ipc = figures.instructions_per_cycle.unwrap();
        assert_eq!((ipc.value, ipc.rounds), (2.5, 6));
        assert_eq!(figures.branch_misses_per_ray.unwrap().value, 1.5);
        assert_eq!(figures.cache_misses_per_ray, None, "not counted");
        class.rounds[3].hardware = None;
        let figures = class_figures(&class, None, NONE);
        assert_eq!(figures.instructions_per_cycle, None, "not counted in every round");
        class.rounds =
            vec![Round { hardware: Some(HardwareCounters::default()), wall_ns: 1, cpu_ns: None }];
        assert_eq!(class_figures(&class, None, NONE).branch_misses_per_ray, None);
        class.rounds[0].hardware = Some(HardwareCounters {
            cycles: Some(0),
            instructions: Some(0),
            ..HardwareCounters::default()
        });
        assert_eq!(class_figures(&class, None, NONE).instructions_per_cycle, None, "never ran");
    }

    #[test]
    fn no_rays_and_no_rounds_have_no_figures() {
        for nothing in [class(0, &[5; 6]), class(10, &[])] {
            let figures = class_figures(&nothing, Some(&nothing), NONE);
            assert_eq!((figures.ns_per_ray, figures.speedup), (None, None));
            assert_eq!(figures.million_rays_per_second, None);
        }
    }
}
