//! What a comparison shows best: one structure against another, over all scenes that both were measured in.

use serde::Serialize;

use super::class::ray_times;
use super::statistics::{BetweenRuns, NORMAL, ratio_of_estimates};
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
    /// The scenes' ratios in the geometric mean. Its interval is for these scenes, not for scenes as such.
    pub ratio: Estimate,
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

    /// How many standard errors its logarithm is away from 0.
    fn certainty(&self) -> f64 {
        let error = self.ratio.interval.map_or(f64::INFINITY, |own| log_error(&own));
        self.ratio.value.ln() / error.max(1e-9)
    }
}

/// The best supported finding: of pairs of trees, if there are any, that which was seen in the most scenes, then that
/// which is the most certain. Peers are left out.
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
    let findings: Vec<Finding> = pairs
        .flat_map(|pair| RayClass::ALL.map(|class| (pair, class)))
        .filter_map(|((a, b), class)| finding(scenes, a, b, class, between_runs))
        .collect();
    // The first of equals: classes are in the order of reports.
    findings.into_iter().reduce(|best, own| {
        let better = own.scenes.len() > best.scenes.len()
            || (own.scenes.len() == best.scenes.len() && own.certainty() > best.certainty());
        if better { own } else { best }
    })
}

/// One structure against another with a class of rays; `None` if no scene supports a statement.
fn finding(
    scenes: &[SceneRecord],
    a: &str,
    b: &str,
    class: RayClass,
    between_runs: BetweenRuns,
) -> Option<Finding> {
    let of_scene = |scene: &SceneRecord| {
        let (a, b) = (traced(scene, a, class)?, traced(scene, b, class)?);
        let ratio = ratio_of_estimates(&ray_times(b), &ray_times(a))?;
        let rays = a.recorded_rays();
        between_runs.widen(ratio).supports_a_statement().then(|| (scene.name.clone(), ratio, rays))
    };
    let seen: Vec<(String, Estimate, u64)> = scenes.iter().filter_map(of_scene).collect();
    // What differs between runs is alike for all scenes of a run: more scenes do not average it away.
    let mean = mean_ratio(&seen.iter().map(|scene| scene.1).collect::<Vec<_>>())?;
    let mean = between_runs.widen(mean);
    let swapped = mean.value < 1.0;
    let (faster, slower) = if swapped { (b, a) } else { (a, b) };
    let upright = |value: f64| if swapped { 1.0 / value } else { value };
    let ratios = || seen.iter().map(|scene| upright(scene.1.value));
    Some(Finding {
        faster: faster.to_owned(),
        slower: slower.to_owned(),
        class,
        ratio: mean.map(upright),
        lowest: ratios().fold(f64::INFINITY, f64::min),
        highest: ratios().fold(0.0, f64::max),
        rays: seen.iter().map(|scene| scene.2).fold(0, u64::saturating_add),
        scenes: seen.into_iter().map(|scene| scene.0).collect(),
    })
}

fn traced<'a>(scene: &'a SceneRecord, name: &str, class: RayClass) -> Option<&'a ClassRecord> {
    scene.structure(name)?.class(class)
}

/// The geometric mean of ratios with intervals. Their errors are independent, so the squares of the errors of their
/// logarithms add up. `None` without ratios, or if one has no interval.
fn mean_ratio(ratios: &[Estimate]) -> Option<Estimate> {
    if let [only] = ratios {
        return Some(*only);
    }
    let rounds = ratios.iter().map(|ratio| ratio.rounds).min()?;
    let n = ratios.len() as f64;
    let logs: f64 = ratios.iter().map(|ratio| ratio.value.ln()).sum();
    let squares: Option<f64> =
        ratios.iter().map(|ratio| ratio.interval.map(|own| log_error(&own).powi(2))).sum();
    let (value, reach) = ((logs / n).exp(), (NORMAL * squares?.sqrt() / n).exp());
    let interval = Some(Interval { low: value / reach, high: value * reach });
    Some(Estimate { value, interval, rounds })
}

/// The standard error of a logarithm, by the width of its interval.
fn log_error(interval: &Interval) -> f64 {
    (interval.high / interval.low).ln() / (2.0 * NORMAL)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::{Round, ShapeRecord};

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
