//! What follows from the record of a scene that moves: medians, totals, and from how many rays on a rebuild pays off.

use serde::Serialize;

use super::statistics::{BreakEven, Cost, break_even, median};
use crate::record::{Motion, RayClass, Strategy, StrategyRecord};

/// The figures of each structure and strategy, in the order of the record.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct StrategyFigures {
    /// The structure.
    pub structure: String,
    /// The strategy.
    pub strategy: Strategy,
    /// The median time to be ready for a frame, in nanoseconds.
    pub update_ns: Option<f64>,
    /// The quartiles of these times.
    pub quartiles_ns: Option<[f64; 2]>,
    /// The mean time of a ray of each class over all frames, in nanoseconds; `None` of a class without rays.
    pub ray_ns: Vec<(RayClass, Option<f64>)>,
    /// The cost of its trees in the last frame, as a share of that of the same structure built anew: over the triangles
    /// of meshes where these move, else over the objects.
    pub sah_share: Option<f64>,
    /// Nanoseconds for all frames and all recorded rays, and the share of them that updates took.
    pub total_ns: f64,
    /// From how many rays a frame on it takes less time than the same structure built anew; `None` for that itself.
    pub break_even: Option<BreakEven>,
}

/// Analyses a record.
#[must_use]
pub fn motion_figures(motion: &Motion) -> Vec<StrategyFigures> {
    motion.strategies.iter().map(|own| figures(motion, own)).collect()
}

fn figures(motion: &Motion, own: &StrategyRecord) -> StrategyFigures {
    let base = motion
        .strategies
        .iter()
        .find(|other| other.structure == own.structure && other.strategy == Strategy::Rebuild);
    let updates = update_times(own);
    let class = |(place, rays): (usize, &crate::record::MotionRays)| {
        let count: u64 = rays.rays.iter().sum();
        let time: u64 = own.trace_ns[place].iter().sum();
        (rays.class, (count > 0).then(|| time as f64 / count as f64))
    };
    let deformed = motion.moved.iter().any(|moved| moved.triangles > 0);
    let tree = usize::from(!deformed);
    let sah = |record: &StrategyRecord| record.sah_costs[tree];
    let shares = base.and_then(|base| Some(sah(own)? / sah(base)?));
    let against = base.filter(|base| base.strategy != own.strategy);
    StrategyFigures {
        structure: own.structure.clone(),
        strategy: own.strategy,
        update_ns: median(&updates),
        quartiles_ns: quartiles(&updates),
        ray_ns: motion.rays.iter().enumerate().map(class).collect(),
        sah_share: shares.filter(|share| share.is_finite()),
        total_ns: updates.iter().sum::<f64>() + trace_time(own),
        break_even: against
            .and_then(|base| Some(break_even(cost(motion, own)?, cost(motion, base)?))),
    }
}

/// Nanoseconds: of several threads the time that passed, of one thread without waiting for a processor.
fn update_times(own: &StrategyRecord) -> Vec<f64> {
    own.updates.iter().map(|round| round.own_ns() as f64).collect()
}

fn trace_time(own: &StrategyRecord) -> f64 {
    own.trace_ns.iter().flatten().sum::<u64>() as f64
}

/// The mean cost of a frame: of its update, and of each of its rays.
fn cost(motion: &Motion, own: &StrategyRecord) -> Option<Cost> {
    let updates = update_times(own);
    let rays: u64 = motion.rays.iter().flat_map(|own| &own.rays).sum();
    (rays > 0 && !updates.is_empty()).then(|| Cost {
        build_ns: updates.iter().sum::<f64>() / updates.len() as f64,
        ray_ns: trace_time(own) / rays as f64,
    })
}

/// The medians of the lower and of the upper half; `None` of fewer than four values.
fn quartiles(values: &[f64]) -> Option<[f64; 2]> {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let half = sorted.len() / 2;
    (sorted.len() >= 4)
        .then(|| Some([median(&sorted[..half])?, median(&sorted[sorted.len() - half..])?]))?
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::{MotionRays, Moved, Round};

    fn record(strategy: Strategy, update: [u64; 4], trace: [u64; 4], cost: f64) -> StrategyRecord {
        let round = |wall_ns| Round { wall_ns, ..Round::default() };
        StrategyRecord {
            structure: "bvh8".to_owned(),
            strategy,
            updates: update.map(round).to_vec(),
            trace_ns: vec![trace.to_vec()],
            sah_costs: [Some(cost), None],
            rebuilt: 0,
            compared: 40,
            differing: 0,
        }
    }

    #[test]
    fn a_refit_wins_up_to_so_many_rays_a_frame() {
        let motion = Motion {
            moved: vec![Moved { objects: 1, triangles: 9, is_same_scene: true }; 4],
            rays: vec![MotionRays { class: RayClass::View, rays: vec![10; 4] }],
            strategies: vec![
                record(Strategy::Rebuild, [900, 1000, 1100, 1000], [100; 4], 20.0),
                record(Strategy::Refit, [100, 100, 80, 120], [150; 4], 30.0),
            ],
            ..Motion::default()
        };
        let figures = motion_figures(&motion);
        assert_eq!((figures[0].update_ns, figures[0].break_even), (Some(1000.0), None));
        assert_eq!(figures[0].quartiles_ns, Some([950.0, 1050.0]));
        assert_eq!(figures[1].ray_ns, [(RayClass::View, Some(15.0))]);
        assert_eq!(figures[1].sah_share, Some(1.5));
        assert_eq!(figures[1].total_ns, 1000.0);
        // 900 ns are saved in a frame, and each ray costs 5 ns more.
        assert_eq!(figures[1].break_even, Some(BreakEven::Until { rays: 180.0 }));
    }

    #[test]
    fn nothing_follows_from_nothing() {
        let motion = Motion {
            strategies: vec![record(Strategy::Refit, [1; 4], [0; 4], 1.0)],
            ..Motion::default()
        };
        let figures = motion_figures(&motion);
        assert_eq!((figures[0].sah_share, figures[0].break_even), (None, None));
    }
}
