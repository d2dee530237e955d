//! Where the cells of a kd-tree are cut: by the surface area heuristic, greedily from the top.
//!
//! The cost of a ray that meets a cell is that of a step and of both halves, each times the chance that
//! the ray meets it: the ratio of the surfaces. Planes beside the sides of boxes are the only ones worth
//! a look, since the cost is linear between them. A plane lies one float *beside* its side, below a low
//! one and above a high one: in the side it would touch the box, which both halves would list.

use crate::math::Aabb;

use super::super::BuildStages;
use super::sides::{Side, Sides};

/// The cost of a step to one half of a cell.
const STEP: f64 = 1.0;

/// The cost of a leaf that is not empty, and of each test in it.
const LEAF: f64 = 1.0;
const TEST: f64 = 1.5;

/// The cost of a test of one primitive alone, which can be a whole mesh.
const LONE_TEST: f64 = 4.0;

/// Halves of at least so many primitives are cut in parallel.
const PARALLEL: usize = 1 << 12;

/// What a build is limited by.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    /// The most references a primitive, in the mean.
    pub(super) references: u32,
    /// The bonus for an empty half in percent.
    pub(super) bonus: u32,
    /// How many primitives are tested at once.
    pub(super) grain: u32,
}

/// A cell with what it is cut into.
pub(super) enum Cut {
    Leaf(Vec<u32>),
    Plane {
        axis: usize,
        plane: f32,
        /// Below and above.
        halves: Box<[Cut; 2]>,
    },
}

/// Cuts the box around all boxes, which it returns; nothing without boxes.
pub(super) fn cut(
    boxes: Vec<Aabb>,
    limits: Limits,
    stages: &mut BuildStages,
) -> Option<(Aabb, Cut)> {
    let count = boxes.len() as u32;
    if count == 0 {
        return None;
    }
    let bounds = boxes.iter().copied().fold(Aabb::EMPTY, Aabb::union);
    let sides = stages.time("sides", || Sides::of(&boxes));
    drop(boxes);
    // Havran: deeper cells are seldom worth it, and of those that rounding makes no end would be.
    let depth = (8.0 + 1.3 * f64::from(count).log2()) as u32;
    let budget = u64::from(limits.references - 1) * u64::from(count);
    let cell = Cell { bounds, depth, budget };
    Some((bounds, stages.time("tree", || cell.cut(sides, &limits))))
}

/// The halves of a cell below and above a plane.
pub(super) fn halves(cell: &Aabb, axis: usize, plane: f32) -> [Aabb; 2] {
    let (mut below, mut above) = (*cell, *cell);
    (below.max[axis], above.min[axis]) = (plane, plane);
    [below, above]
}

/// A cell that may be cut.
struct Cell {
    bounds: Aabb,
    /// How many steps the deepest leaf within may lie below.
    depth: u32,
    /// How many references cuts may add.
    budget: u64,
}

/// A plane, and how many primitives touch the halves.
#[derive(Clone, Copy)]
struct Plane {
    axis: usize,
    plane: f32,
    below: usize,
    above: usize,
}

impl Cell {
    fn cut(self, sides: Sides, limits: &Limits) -> Cut {
        let best = if self.depth > 0 { self.cheapest(&sides, limits) } else { None };
        let Some(Plane { axis, plane, below, above }) = best else { return Cut::Leaf(sides.ids) };
        let count = sides.count();
        let [lower, upper] = halves(&self.bounds, axis, plane);
        let [under, over] = sides.cut(axis, plane);
        // What is left of the budget is shared by how many primitives are on either side.
        let all = (below + above) as u64;
        let rest = self.budget - (all - count as u64);
        let share = (u128::from(rest) * below as u128 / u128::from(all)) as u64;
        let half = |bounds, budget| Self { bounds, depth: self.depth - 1, budget };
        let (lower, upper) = (half(lower, share), half(upper, rest - share));
        let halves = if count < PARALLEL {
            (lower.cut(under, limits), upper.cut(over, limits))
        } else {
            rayon::join(|| lower.cut(under, limits), || upper.cut(over, limits))
        };
        Cut::Plane { axis, plane, halves: Box::new(halves.into()) }
    }

    /// The plane of the least cost, if that is less than a leaf's.
    fn cheapest(&self, sides: &Sides, limits: &Limits) -> Option<Plane> {
        let count = sides.count();
        let mut search = Search {
            cost: limits.of_leaf(count),
            best: None,
            most: count as u64 + self.budget,
            limits,
        };
        for (axis, [lows, highs]) in sides.axes.iter().enumerate() {
            search.axis(&self.bounds, axis, [lows, highs]);
        }
        search.best
    }
}

impl Limits {
    /// The cost of a leaf of so many primitives.
    fn of_leaf(&self, count: usize) -> f64 {
        match (count, self.grain as usize) {
            (0, _) => 0.0,
            (_, 1) => LEAF + LONE_TEST * count as f64,
            (_, grain) => LEAF + TEST * count.div_ceil(grain) as f64,
        }
    }
}

/// The search for the cheapest plane.
struct Search<'a> {
    cost: f64,
    best: Option<Plane>,
    /// The most references that both halves may have.
    most: u64,
    limits: &'a Limits,
}

impl Search<'_> {
    /// Weighs the planes along an axis.
    fn axis(&mut self, cell: &Aabb, axis: usize, [lows, highs]: [&[Side]; 2]) {
        let count = lows.len();
        let [width, depth] = [1, 2].map(|next| {
            let other = (axis + next) % 3;
            f64::from(cell.max[other]) - f64::from(cell.min[other])
        });
        let (low, high) = (cell.min[axis], cell.max[axis]);
        let around = Surface { ends: width * depth, around: width + depth, low, high };
        // Below low sides: what begins there is above the plane alone.
        let mut ended = 0;
        let mut begun = lows.partition_point(|side| side.at.next_down() <= low);
        while begun < count {
            let side = lows[begun].at;
            let plane = side.next_down();
            if plane >= high {
                break;
            }
            while ended < count && highs[ended].at < plane {
                ended += 1;
            }
            self.weigh(&around, Plane { axis, plane, below: begun, above: count - ended });
            while begun < count && lows[begun].at == side {
                begun += 1;
            }
        }
        // Above high sides: what ends there is below the plane alone.
        let mut begun = 0;
        let mut ended = highs.partition_point(|side| side.at.next_up() <= low);
        while ended < count {
            let side = highs[ended].at;
            let plane = side.next_up();
            if plane >= high {
                break;
            }
            while ended < count && highs[ended].at == side {
                ended += 1;
            }
            while begun < count && lows[begun].at <= plane {
                begun += 1;
            }
            self.weigh(&around, Plane { axis, plane, below: begun, above: count - ended });
        }
    }

    #[inline(always)]
    fn weigh(&mut self, surface: &Surface, plane: Plane) {
        let Plane { below, above, .. } = plane;
        let [lower, upper] = surface.shares(plane.plane);
        let tests = lower * self.limits.of_leaf(below) + upper * self.limits.of_leaf(above);
        let mut cost = STEP + tests;
        if below == 0 || above == 0 {
            cost *= 1.0 - 0.01 * f64::from(self.limits.bonus);
        }
        if cost < self.cost && (below + above) as u64 <= self.most {
            (self.cost, self.best) = (cost, Some(plane));
        }
    }
}

/// The surface of a cell, as planes along an axis part it.
struct Surface {
    /// One of the sides that lie across the axis.
    ends: f64,
    /// Half of the length around it.
    around: f64,
    low: f32,
    high: f32,
}

impl Surface {
    /// The surfaces of the halves below and above a plane, as shares of the whole.
    #[inline(always)]
    fn shares(&self, plane: f32) -> [f64; 2] {
        let [low, high, plane] = [self.low, self.high, plane].map(f64::from);
        let all = self.ends + self.around * (high - low);
        [plane - low, high - plane].map(|length| (self.ends + self.around * length) / all)
    }
}
