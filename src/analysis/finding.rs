//! What a comparison shows best: one structure against another, over all scenes that both were measured in.

use serde::Serialize;

use super::class::ray_times;
use super::statistics::{BetweenRuns, Risk, ratio_of_estimates};
use crate::record::{ClassRecord, Estimate, Interval, RayClass, SceneRecord, StructureRecord};

/// How many times as fast as another a structure traces a class of rays.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Finding {
    /// The faster structure.
    pub faster: String,
    /// The slower one.
    pub slower: String,
    /// The class of rays.
    pub class: RayClass,
    /// The scenes' ratios in the geometric mean. Its interval is for these scenes, not for scenes as such, and holds
    /// for all `comparisons` together.
    pub ratio: Estimate,
    /// From how many comparisons this one was chosen: of pairs of structures, each by a class of rays.
    pub comparisons: u32,
    /// The smallest of the scenes' ratios.
    pub lowest: f64,
    /// The largest of the scenes' ratios.
    pub highest: f64,
    /// The scenes in which both were measured, and whose ratio has an interval that supports a statement.
    pub scenes: Vec<String>,
    /// The recorded rays of these scenes.
    pub rays: u64,
}

impl Finding {
    /// Whether the whole interval lies on one side of 1.
    #[must_use]
    pub fn is_certain(&self) -> bool {
        self.ratio.interval.is_some_and(|interval| interval.low > 1.0)
    }

    /// How many times half its interval's width its logarithm is away from 0.
    fn certainty(&self) -> f64 {
        let half = self.ratio.interval.map_or(f64::INFINITY, |own| log_half_width(&own));
        self.ratio.value.ln() / half.max(1e-9)
    }
}

/// The best supported finding: of pairs of trees, if there are any, that which was seen in the most scenes, then that
/// which is the most certain. Peers are left out, and scenes in which one of both failed.
///
/// The most certain of many is often certain by chance: of five structures that are alike, three classes of rays hold
/// some difference beyond a 95 % interval more often than not. So its interval is one of as many as it was chosen from.
pub(super) fn best_finding(scenes: &[SceneRecord], between_runs: BetweenRuns) -> Option<Finding> {
    // One box around everything is no tree: it has a depth, but not a tree's cost.
    let has_cost = |row: &StructureRecord| row.shape.as_ref()?.sah_cost;
    let is_tree = |row: &StructureRecord| has_cost(row).is_some();
    best_of(scenes, &is_tree, between_runs).or_else(|| best_of(scenes, &|_| true, between_runs))
}

fn best_of(
    scenes: &[SceneRecord],
    fits: &dyn Fn(&StructureRecord) -> bool,
    between_runs: BetweenRuns,
) -> Option<Finding> {
    let mut names: Vec<&str> = Vec::new();
    for row in scenes.iter().flat_map(|scene| &scene.structures) {
        if !row.peer && fits(row) && !names.contains(&row.name.as_str()) {
            names.push(&row.name);
        }
    }
    let pairs = names.iter().enumerate().flat_map(|(i, a)| names[i + 1..].iter().map(|b| (*a, *b)));
    let all = pairs.flat_map(|pair| RayClass::ALL.map(|class| (pair, class)));
    let found = all.filter_map(|(pair, class)| {
        Some((pair, class, finding(scenes, pair, class, between_runs, 1)?))
    });
    let findings: Vec<_> = found.collect();
    let comparisons = u32::try_from(findings.len()).unwrap_or(u32::MAX);
    // The first of equals: classes are in the order of reports.
    let (pair, class, _) = findings.into_iter().reduce(|best, own| {
        let (of_best, of_own) = (&best.2, &own.2);
        let better = of_own.scenes.len() > of_best.scenes.len()
            || (of_own.scenes.len() == of_best.scenes.len()
                && of_own.certainty() > of_best.certainty());
        if better { own } else { best }
    })?;
    finding(scenes, pair, class, between_runs, comparisons)
}

/// One structure against another with a class of rays, as one of some comparisons; `None` if no scene supports a
/// statement.
fn finding(
    scenes: &[SceneRecord],
    (a, b): (&str, &str),
    class: RayClass,
    between_runs: BetweenRuns,
    comparisons: u32,
) -> Option<Finding> {
    let risk = Risk::USUAL.shared_by(comparisons as usize);
    let of_scene = |scene: &SceneRecord| {
        let (a, b) = (traced(scene, a, class)?, traced(scene, b, class)?);
        let ratio = |risk| ratio_of_estimates(&ray_times(b), &ray_times(a), risk);
        let rays = a.recorded_rays();
        between_runs.widen(ratio(Risk::USUAL)?).supports_a_statement().then_some(())?;
        Some((scene.name.clone(), ratio(risk)?, rays))
    };
    let seen: Vec<(String, Estimate, u64)> = scenes.iter().filter_map(of_scene).collect();
    // What differs between runs is alike for all scenes of a run: more scenes do not average it away.
    let mean = mean_ratio(&seen.iter().map(|scene| scene.1).collect::<Vec<_>>())?;
    let mean = between_runs.widen_at(mean, risk);
    let swapped = mean.value < 1.0;
    let (faster, slower) = if swapped { (b, a) } else { (a, b) };
    let upright = |value: f64| if swapped { 1.0 / value } else { value };
    let ratios = || seen.iter().map(|scene| upright(scene.1.value));
    Some(Finding {
        faster: faster.to_owned(),
        slower: slower.to_owned(),
        class,
        ratio: mean.map(upright),
        comparisons,
        lowest: ratios().fold(f64::INFINITY, f64::min),
        highest: ratios().fold(0.0, f64::max),
        rays: seen.iter().map(|scene| scene.2).fold(0, u64::saturating_add),
        scenes: seen.into_iter().map(|scene| scene.0).collect(),
    })
}

/// What a structure traced of a class, if it did not fail later.
fn traced<'a>(scene: &'a SceneRecord, name: &str, class: RayClass) -> Option<&'a ClassRecord> {
    scene.structure(name).filter(|row| !row.has_failed())?.class(class)
}

/// The geometric mean of ratios with intervals. Their errors are independent, so the squares of what their logarithms
/// may be off by add up. It has no interval if one of them has none. `None` without ratios.
fn mean_ratio(ratios: &[Estimate]) -> Option<Estimate> {
    if let [only] = ratios {
        return Some(*only);
    }
    let rounds = ratios.iter().map(|ratio| ratio.rounds).min()?;
    let n = ratios.len() as f64;
    let logs: f64 = ratios.iter().map(|ratio| ratio.value.ln()).sum();
    let squares: Option<f64> =
        ratios.iter().map(|ratio| ratio.interval.map(|own| log_half_width(&own).powi(2))).sum();
    let value = (logs / n).exp();
    let reach = squares.map(|squares| (squares.sqrt() / n).exp());
    let interval = reach.map(|reach| Interval { low: value / reach, high: value * reach });
    Some(Estimate { value, interval, rounds })
}

/// Half the width of an interval of a logarithm.
fn log_half_width(interval: &Interval) -> f64 {
    (interval.high / interval.low).ln() / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Random;
    use crate::record::{Round, ShapeRecord, Status};

    /// Structures by their names, costs as trees if they are any, and times.
    fn scene(name: &str, structures: &[(&str, Option<f64>, &[u64])]) -> SceneRecord {
        let row = |&(name, sah_cost, ns): &(&str, Option<f64>, &[u64])| StructureRecord {
            name: name.to_owned(),
            shape: Some(ShapeRecord { depth: 1, sah_cost, ..ShapeRecord::default() }),
            classes: vec![ClassRecord {
                class: RayClass::View,
                rays: 10,
                sample: None,
                counted_rays: 10,
                hits: 0,
                boxes: None,
                primitives: None,
                rounds: ns.iter().map(|&wall_ns| Round { wall_ns, ..Round::default() }).collect(),
                passes: Vec::new(),
            }],
            ..StructureRecord::default()
        };
        let structures = structures.iter().map(row).collect();
        SceneRecord { name: name.to_owned(), structures, ..SceneRecord::default() }
    }

    const SIX: [u64; 6] = [100; 6];

    #[test]
    fn trees_are_compared_with_trees_over_all_scenes() {
        let quick = [25, 24, 25, 26, 25, 25];
        let scenes = [
            scene(
                "a",
                &[
                    ("ball", None, &[9_000; 6]),
                    ("bvh", Some(9.0), &SIX),
                    ("wide", Some(5.0), &quick),
                ],
            ),
            scene(
                "b",
                &[("ball", None, &[7_000; 6]), ("bvh", Some(9.0), &SIX), ("wide", Some(5.0), &SIX)],
            ),
        ];
        let finding = best_finding(&scenes, BetweenRuns(0.0)).unwrap();
        assert_eq!((finding.faster.as_str(), finding.slower.as_str()), ("wide", "bvh"));
        assert!((finding.ratio.value - 2.0).abs() < 1e-12, "{finding:?}");
        assert_eq!((finding.lowest, finding.highest), (1.0, 4.0));
        assert_eq!((finding.scenes.len(), finding.rays), (2, 20));
        assert!(finding.is_certain());
    }

    #[test]
    fn without_two_trees_the_others_are_compared() {
        let finding = best_finding(
            &[scene("a", &[("none", None, &[900; 6]), ("bvh", Some(9.0), &SIX)])],
            BetweenRuns(0.0),
        )
        .unwrap();
        assert_eq!((finding.faster.as_str(), finding.slower.as_str()), ("bvh", "none"));
        assert_eq!(finding.ratio.value, 9.0);
    }

    #[test]
    fn what_has_no_interval_or_a_wide_one_is_no_finding() {
        let few = scene("a", &[("none", None, &[900; 5]), ("bvh", Some(9.0), &[100; 5])]);
        let wide =
            scene("b", &[("none", None, &SIX), ("bvh", Some(9.0), &[10, 900, 20, 800, 30, 700])]);
        assert_eq!(best_finding(&[few, wide], BetweenRuns(0.0)), None);
    }

    /// Five structures of one speed, five passes of two rounds each: about one finding in twenty is certain, where one
    /// in three would be with the interval of a single comparison.
    #[test]
    fn structures_of_one_speed_are_not_told_apart() {
        let mut random = Random::new(&[12]);
        let names = ["a", "b", "c", "d", "e"];
        let mut certain = 0;
        for _ in 0..200 {
            let mut of_structure = || -> Vec<u64> {
                let mut passes = Vec::new();
                for _ in 0..5 {
                    let of_pass = 1_000_000 + random.below(80_000);
                    passes.extend([of_pass, of_pass + random.below(10_000)].map(u64::from));
                }
                passes
            };
            let times = names.map(|_| of_structure());
            let rows: Vec<_> =
                names.iter().zip(&times).map(|(name, ns)| (*name, Some(9.0), &ns[..])).collect();
            let mut scene = scene("all", &rows);
            for row in &mut scene.structures {
                row.classes[0].passes = vec![2; 5];
            }
            let finding = best_finding(&[scene], BetweenRuns(0.0)).unwrap();
            assert_eq!(finding.comparisons, 10);
            certain += usize::from(finding.is_certain());
        }
        assert!(certain <= 20, "{certain} of 200");
    }

    #[test]
    fn a_structure_that_failed_is_in_no_finding() {
        let mut scene = scene("a", &[("bvh", Some(9.0), &SIX), ("wide", Some(5.0), &[50; 6])]);
        assert!(best_finding(std::slice::from_ref(&scene), BetweenRuns(0.0)).is_some());
        scene.structures[1].status = Status::Failed { message: "it fell over".to_owned() };
        assert_eq!(best_finding(&[scene], BetweenRuns(0.0)), None);
    }

    #[test]
    fn what_differs_between_runs_is_not_averaged_away_over_scenes() {
        let close = [97; 6];
        let scenes: Vec<SceneRecord> = ["a", "b", "c", "d"]
            .map(|name| scene(name, &[("bvh", Some(9.0), &SIX), ("wide", Some(5.0), &close)]))
            .into();
        let certain =
            |deviation| best_finding(&scenes, BetweenRuns(deviation)).unwrap().is_certain();
        assert!(certain(0.0) && certain(0.01) && !certain(0.03));
    }
}
