//! Builds and rays of a scene's structures against each other: which pays off after how many rays, and which is
//! dominated by another.
//!
//! Both costs are those of one thread, of which the recorded rays' times are: all threads build in less time, but they
//! also trace as many rays at once. Two costs are told apart where the interval of their ratio does not contain 1.

use std::cmp::Ordering;

use super::class::{ClassFigures, quotient, ray_times};
use super::scene::{StructureFigures, floats};
use super::statistics::{
    BetweenRuns, BreakEven, Cost, Risk, break_even, paired_ratio, ratio_of_estimates,
};
use crate::record::{Estimate, Interval, RayClass, SceneRecord, StructureRecord};

/// Computes what depends on all structures of a scene, which are in the order of the record: mean rays, break-even
/// points, the Pareto front.
pub(super) fn compare_costs(
    scene: &SceneRecord,
    structures: &mut [StructureFigures],
    base: Option<&StructureRecord>,
    between_runs: BetweenRuns,
) {
    let traced = |class: &RayClass| structures.iter().any(|own| own.class(*class).is_some());
    let classes: Vec<RayClass> = RayClass::RENDERED.into_iter().filter(traced).collect();
    for own in structures.iter_mut() {
        own.mean_ray_ns = mean_ray_ns(own, &classes);
    }
    let compare = |a: usize, b: usize| {
        let (records, figures) = ([a, b].map(|i| &scene.structures[i]), &structures[a]);
        costs_against(records, figures, &classes, between_runs)
    };
    let is_base = |row: &StructureRecord| base.is_some_and(|base| base.name == row.name);
    let base = scene.structures.iter().position(is_base);
    let count = structures.len();
    let break_evens: Vec<_> = (0..count)
        .map(|own| {
            let base = base.filter(|&base| base != own)?;
            let orders = compare(own, base)?;
            Some(break_even_as_told(structures[own].cost()?, structures[base].cost()?, orders))
        })
        .collect();
    let dominates = |other: usize, own: usize| match compare(other, own) {
        Some((build, ray)) => build.is_le() && ray.is_le() && (build.is_lt() || ray.is_lt()),
        None => false,
    };
    let on_front: Vec<bool> = (0..count)
        .map(|own| {
            let others = (0..count).filter(|&other| other != own);
            structures[own].cost().is_some() && !others.into_iter().any(|o| dominates(o, own))
        })
        .collect();
    for ((own, break_even), on_front) in structures.iter_mut().zip(break_evens).zip(on_front) {
        own.break_even = break_even;
        own.on_pareto_front = on_front;
    }
}

/// The break-even of costs, as far as the orders of build and ray tell them apart: builds that are not told apart count
/// as equal.
fn break_even_as_told(own: Cost, base: Cost, (build, ray): (Ordering, Ordering)) -> BreakEven {
    // Medians of ratios decide, those of times may lie the other way round.
    let is_so = |order: Ordering, own: f64, base: f64| own.partial_cmp(&base) == Some(order);
    if ray.is_eq() || !is_so(ray, own.ray_ns, base.ray_ns) {
        return BreakEven::NotToldApart;
    }
    let build_ns = match is_so(build, own.build_ns, base.build_ns) {
        true => own.build_ns,
        false => base.build_ns,
    };
    break_even(Cost { build_ns, ..own }, base)
}

/// The mean over the rays of some classes; `None` if one was not traced, or is not narrow enough to be ranked by.
fn mean_ray_ns(own: &StructureFigures, classes: &[RayClass]) -> Option<f64> {
    let (mut ns, mut rays) = (0.0, 0.0);
    for &class in classes {
        let own = own.class(class)?;
        ns += own.ns_per_ray.filter(Estimate::supports_a_statement)?.value * weight(own);
        rays += weight(own);
    }
    quotient(ns, rays)
}

fn weight(class: &ClassFigures) -> f64 {
    class.recorded_rays as f64
}

/// Build and mean ray of the first of two structures: less, greater, or not told apart from those of the second. `None`
/// if one of both has no interval.
fn costs_against(
    [own, other]: [&StructureRecord; 2],
    figures: &StructureFigures,
    classes: &[RayClass],
    between_runs: BetweenRuns,
) -> Option<(Ordering, Ordering)> {
    let builds = [own, other].map(|row| floats(&row.build.one_thread_ns));
    let build = between_runs.widen(paired_ratio(&builds[1], &builds[0])?);
    let all = figures.mean_ray_ns?
        * classes.iter().filter_map(|&c| figures.class(c)).map(weight).sum::<f64>();
    // The quotient of two sums is the mean of the quotients, weighted by the terms below. Passes and places in memory
    // are the same for all classes, so their errors are taken as one.
    let (mut low, mut high) = (0.0, 0.0);
    for &class in classes {
        let times = |row: &StructureRecord| row.class(class).map(ray_times);
        let ratio = ratio_of_estimates(&times(other)?, &times(own)?, Risk::USUAL)?;
        let interval = between_runs.widen(ratio).interval?;
        let of_class = figures.class(class)?;
        let share = of_class.ns_per_ray?.value * weight(of_class) / all;
        (low, high) = (low + share * interval.low, high + share * interval.high);
    }
    Some((order(build.interval?), order(Interval { low, high })))
}

/// The order of two times by how many times as fast the first is.
fn order(speedup: Interval) -> Ordering {
    match speedup {
        Interval { low, .. } if low > 1.0 => Ordering::Less,
        Interval { high, .. } if high < 1.0 => Ordering::Greater,
        _ => Ordering::Equal,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::scene::SceneFigures;
    use crate::record::{BuildRecord, ClassRecord, Round};

    /// A structure by its build and its ray in nanoseconds, each within so many percent from pass to pass.
    fn row(
        name: &str,
        (build, build_noise): (u64, u64),
        (ray, noise): (u64, u64),
    ) -> StructureRecord {
        let wave = [0, 1, 2, 1, 0, 2, 0, 1, 2, 0];
        // Structures do not waver alike, or what they share would cancel in their ratio.
        let start = name.len() % 7;
        let around = |ns: u64, percent: u64, n: usize| {
            ns * (100 + percent * wave[(start * n + n) % 10]) / 100
        };
        let round = |n| Round { wall_ns: 1_000 * around(ray, noise, n), ..Round::default() };
        StructureRecord {
            name: name.to_owned(),
            build: BuildRecord {
                one_thread_ns: (0..10).map(|n| around(build, build_noise, n)).collect(),
                ..BuildRecord::default()
            },
            classes: vec![ClassRecord {
                class: RayClass::View,
                rays: 1_000,
                sample: None,
                counted_rays: 1_000,
                hits: 0,
                boxes: None,
                primitives: None,
                rounds: (0..10).map(round).collect(),
                passes: vec![2; 5],
            }],
            ..StructureRecord::default()
        }
    }

    fn figures(rows: Vec<StructureRecord>) -> SceneFigures {
        let scene = SceneRecord { structures: rows, ..SceneRecord::default() };
        SceneFigures::of(&scene, "none", BetweenRuns(0.0))
    }

    fn break_even_with(own: StructureRecord) -> Option<BreakEven> {
        let all = figures(vec![row("none", (1_000, 1), (100, 1)), own]);
        all.structures[1].break_even
    }

    #[test]
    fn what_intervals_tell_apart_breaks_even() {
        let with = |build, ray| break_even_with(row("other", (build, 1), (ray, 1)));
        assert!(
            matches!(with(50_000, 50), Some(BreakEven::After { rays }) if (900.0..1100.0).contains(&rays))
        );
        assert!(
            matches!(with(100, 200), Some(BreakEven::Until { rays }) if (8.0..10.0).contains(&rays))
        );
        assert_eq!(with(100, 50), Some(BreakEven::Always));
        assert_eq!(with(50_000, 200), Some(BreakEven::Never));
    }

    #[test]
    fn rays_of_one_speed_are_not_told_apart_and_builds_count_as_equal() {
        let noisy = row("other", (50_000, 1), (99, 20));
        assert_eq!(break_even_with(noisy), Some(BreakEven::NotToldApart));
        assert_eq!(break_even_with(row("other", (990, 20), (50, 1))), Some(BreakEven::Always));
        assert_eq!(break_even_with(row("other", (990, 20), (200, 1))), Some(BreakEven::Never));
    }

    #[test]
    fn what_is_dominated_as_far_as_intervals_tell_is_not_on_the_front() {
        let all = figures(vec![
            row("none", (1_000, 1), (100, 1)),
            row("alike", (50_000, 1), (99, 20)),
            row("quick", (60_000, 1), (50, 1)),
            row("slow", (70_000, 1), (70, 1)),
        ]);
        let front: Vec<bool> = all.structures.iter().map(|own| own.on_pareto_front).collect();
        assert_eq!(front, [true, false, true, false]);
    }

    #[test]
    fn a_class_that_others_traced_is_no_part_of_a_mean() {
        let shadow = |mut row: StructureRecord| {
            row.classes.push(ClassRecord { class: RayClass::Shadow, ..row.classes[0].clone() });
            row
        };
        let all =
            figures(vec![row("none", (1_000, 1), (100, 1)), shadow(row("b", (9_000, 1), (50, 1)))]);
        assert_eq!(all.structures[0].mean_ray_ns, None);
        assert!(all.structures[1].mean_ray_ns.is_some());
        assert_eq!(
            (all.structures[1].break_even, all.structures[0].on_pareto_front),
            (None, false)
        );
    }
}
