//! A tree of bounding balls.
//!
//! * *Idea*: As a tree of boxes, but a node has a ball around it: a test without a direction's sign or
//!   order, and the same from all sides.
//! * *Paper*: Rubin, Whitted: *A 3-dimensional representation for fast rendering of complex scenes*,
//!   1980, for the hierarchy; Weghorst, Hooper, Greenberg: *Improved computational methods for ray
//!   tracing*, 1984, for what a volume's form costs and gives.
//! * *Build*: that of the binary tree (`builder=`), and O(n · depth) for the balls.
//! * *A ray*: O(log n) nodes in the mean, two balls each.
//! * *Memory*: 48 bytes a node: of each child centre, radius and place.
//! * *It wins*: seldom: where objects are round. Balls around flat or long parts are much larger than
//!   boxes, and overlap.
//!
//! A ball encloses the corners of the *boxes* of the primitives below, and is tested with the padding
//! (`sphere_ray.rs`): what a primitive's own box accepts is never skipped, so hits are those of all others.

use std::ops::{ControlFlow, Range};

use glam::Vec3;
use obvhs::bvh2::leaf_collapser::collapse;
use obvhs::bvh2::{Bvh2, node::Bvh2Node};
use rayon::prelude::*;
use smallvec::SmallVec;

use crate::counters::Counters;
use crate::math::{Aabb, BoxRay, NONE, Ray};

use super::build::boxes_of;
use super::builder::Builder;
use super::sphere_ray::SphereRay;
use super::{Accel, Bounded, Build, Built, OptionInfo, Order, RegionForm, Regions, StructureShape};

/// The stack lives with the call up to this depth, and on the heap beyond.
const USUAL_DEPTH: usize = 32;

/// A binary tree of balls.
#[derive(Clone, Debug)]
pub struct BallTree {
    nodes: Vec<[Child; 2]>,
    /// The ball around all; `None` if there are no primitives.
    root: Option<Child>,
}

/// A leaf or a node, and the ball around it.
#[derive(Clone, Copy, Debug, Default)]
struct Child {
    center: Vec3,
    /// Not less than the distance of any corner of a box below.
    radius: f32,
    /// First slot of a leaf, or index of a node.
    first: u32,
    /// Slots of a leaf; 0 for a node.
    count: u32,
}

const BUILDER: OptionInfo = Builder::option("sah");
const LEAF: OptionInfo = OptionInfo::leaf(32, "4");

impl Accel for BallTree {
    const ONE_BY_ONE: bool = true;

    /// As measured.
    const BUILD_BYTES: u64 = 200;

    const OPTIONS: &'static [OptionInfo] = &[BUILDER, LEAF];

    fn build(primitives: &impl Bounded, build: &mut Build<'_>) -> Built<Self> {
        let Build { config, grain, stages } = build;
        if primitives.count() == 0 {
            return Built { accel: Self { nodes: Vec::new(), root: None }, order: None };
        }
        let most = config.options.number(&LEAF).unwrap_or(config.max_leaf.min(4)).max(1);
        let builder = Builder::chosen(&config.options, &BUILDER).unwrap_or(Builder::Sah);
        let mut tree = builder.tree(primitives, *grain, 1, config.quality, stages);
        let cost = config.quality.parameters().collapse_traversal_cost;
        stages.time("collapse", || collapse(&mut tree, most, cost));
        stages.time("balls", || lay_out(&tree, &boxes_of(primitives), *grain))
    }

    #[inline]
    fn traverse<C: Counters>(
        &self,
        ray: &Ray,
        box_ray: &BoxRay,
        counters: &mut C,
        mut leaf: impl FnMut(Range<u32>, &mut C) -> ControlFlow<(), f32>,
    ) {
        let Some(root) = self.root else { return };
        let sphere_ray = SphereRay::new(ray, box_ray);
        let mut end = ray.t_max;
        counters.boxes(1);
        let Some(begin) = root.entered(&sphere_ray, end) else { return };
        let mut stack = SmallVec::<[(Child, f64); USUAL_DEPTH]>::new();
        stack.push((root, begin));
        while let Some((at, begin)) = stack.pop() {
            // Inclusive: a ball that begins at the end may hold a tie.
            if begin > f64::from(end) {
                continue;
            }
            if at.count > 0 {
                match leaf(at.first..at.first + at.count, counters) {
                    ControlFlow::Continue(t) => end = t,
                    ControlFlow::Break(()) => return,
                }
                continue;
            }
            counters.boxes(2);
            let children = &self.nodes[at.first as usize];
            let [a, b] = [0, 1].map(|i| children[i].entered(&sphere_ray, end));
            // The nearer child last, so that it is on top.
            let nearer = usize::from(b < a);
            for (child, begin) in [(1 - nearer, [b, a][nearer]), (nearer, [a, b][nearer])] {
                if let Some(begin) = begin {
                    stack.push((children[child], begin));
                }
            }
        }
    }

    fn bytes(&self) -> u64 {
        (size_of::<Self>() + size_of_val(&self.nodes[..])) as u64
    }

    fn regions(&self) -> Regions {
        let mut regions = Regions::default();
        let mut open: Vec<(Child, u32)> = self.root.iter().map(|&root| (root, 0)).collect();
        while let Some((Child { center, radius, first, count }, level)) = open.pop() {
            let form = RegionForm::Ball { center, radius };
            if count > 0 {
                regions.push_leaf(form, level, first..first + count);
                continue;
            }
            regions.push_inner(form, level);
            open.extend(self.nodes[first as usize].iter().rev().map(|&child| (child, level + 1)));
        }
        regions
    }

    /// There is no [`Tree`](super::Tree), which is one of boxes.
    fn shape(&self) -> StructureShape {
        let nodes = self.nodes.len() as u64;
        let mut shape = StructureShape { nodes, bytes: self.bytes(), ..StructureShape::default() };
        let mut open: Vec<(Child, u32)> = self.root.iter().map(|&root| (root, 0)).collect();
        while let Some((child, depth)) = open.pop() {
            match child.count {
                0 => open.extend(self.nodes[child.first as usize].map(|child| (child, depth + 1))),
                count => shape.add_leaf(count, depth),
            }
        }
        shape
    }
}

impl Child {
    /// With the ball about the middle of a node's box around the boxes of some primitives.
    fn around(self, node: &Bvh2Node, boxes: &[Aabb], some: &[u32]) -> Self {
        let center = Vec3::from(0.5 * node.aabb().min + 0.5 * node.aabb().max);
        let middle = center.as_dvec3();
        let square = |&index: &u32| {
            // Of a box the corner that is farther along each axis.
            let bounds = boxes[index as usize];
            let [low, high] = [bounds.min, bounds.max].map(|corner| Vec3::from(corner).as_dvec3());
            (low - middle).abs().max((high - middle).abs()).length_squared()
        };
        let all = some.par_iter().with_min_len(1 << 12).filter(|&&index| index != NONE);
        let largest = all.map(square).reduce(|| 0.0, f64::max);
        // Rounded up: to the next float if the nearest is less.
        let exact = largest.sqrt() * (1.0 + 4.0 * f64::EPSILON);
        let radius = exact as f32;
        let radius = if f64::from(radius) < exact { radius.next_up() } else { radius };
        Self { center, radius, ..self }
    }

    /// Where a ray enters the ball.
    #[inline(always)]
    fn entered(&self, ray: &SphereRay, end: f32) -> Option<f64> {
        ray.enters(self.center.as_dvec3(), f64::from(self.radius), end)
    }
}

/// What is still to be done of a walk: which child of which node it is, `None` for the root.
enum Step<'a> {
    Enter(&'a Bvh2Node, Option<(usize, usize)>),
    /// The slots of all below begin there.
    Leave(&'a Bvh2Node, Option<(usize, usize)>, Child, usize),
}

/// Puts balls in the place of boxes, in the order in which a walk meets them, and moves every leaf's range
/// to a multiple of `grain`.
fn lay_out(tree: &Bvh2, boxes: &[Aabb], grain: u32) -> Built<BallTree> {
    let mut nodes: Vec<[Child; 2]> = Vec::with_capacity(tree.nodes.len() / 2);
    let mut order: Vec<u32> = Vec::with_capacity(tree.primitive_indices.len());
    let mut root = Child::default();
    let mut open = vec![Step::Enter(&tree.nodes[0], None)];
    while let Some(step) = open.pop() {
        match step {
            Step::Enter(from, parent) if from.is_leaf() => {
                order.resize(order.len().next_multiple_of(grain as usize), NONE);
                let child =
                    Child { first: order.len() as u32, count: from.prim_count, ..Child::default() };
                open.push(Step::Leave(from, parent, child, order.len()));
                let first = from.first_index as usize;
                let own = first..first + from.prim_count as usize;
                order.extend_from_slice(&tree.primitive_indices[own]);
            }
            Step::Enter(from, parent) => {
                let place = nodes.len();
                nodes.push([Child::default(); 2]);
                let child = Child { first: place as u32, ..Child::default() };
                open.push(Step::Leave(from, parent, child, order.len()));
                let first = from.first_index as usize;
                let below = |side| Step::Enter(&tree.nodes[first + side], Some((place, side)));
                open.extend([below(1), below(0)]);
            }
            Step::Leave(from, parent, child, begin) => {
                let child = child.around(from, boxes, &order[begin..]);
                match parent {
                    Some((node, side)) => nodes[node][side] = child,
                    None => root = child,
                }
            }
        }
    }
    nodes.shrink_to_fit();
    Built { accel: BallTree { nodes, root: Some(root) }, order: Some(Order::Permutation(order)) }
}

#[cfg(test)]
mod tests {
    use glam::{DVec3, Vec3A};

    use super::super::builder::tests::Boxes;
    use super::super::{BuildConfig, BuildStages};
    use super::*;
    use crate::math::Random;

    #[test]
    fn balls_hold_the_corners_of_all_boxes_below() {
        let mut random = Random::new(&[37]);
        let mut point = || Vec3A::from_array(std::array::from_fn(|_| random.next_f32()));
        let boxes: Vec<Aabb> = (0..700)
            .map(|_| (point(), point()))
            .map(|(a, b)| Aabb { min: a, max: a + 0.1 * b })
            .collect();
        let config = BuildConfig::default();
        let mut build = Build { config: &config, grain: 4, stages: &mut BuildStages::default() };
        let Built { accel, order } = BallTree::build(&Boxes(boxes.clone()), &mut build);
        let order = order.expect("there is an order");
        let mut open = vec![(accel.root.expect("there are boxes"), vec![])];
        let mut leaves = 0;
        while let Some((child, mut above)) = open.pop() {
            above.push((child.center.as_dvec3(), f64::from(child.radius)));
            if child.count == 0 {
                open.extend(accel.nodes[child.first as usize].map(|below| (below, above.clone())));
                continue;
            }
            leaves += child.count;
            for slot in child.first..child.first + child.count {
                for corner in boxes[order.slots()[slot as usize] as usize].corners() {
                    let corner = Vec3::from(corner).as_dvec3();
                    assert!(above.iter().all(|&(center, radius): &(DVec3, f64)| {
                        corner.distance_squared(center) <= radius * radius
                    }));
                }
            }
        }
        assert_eq!(leaves, 700);
    }
}
