//! Binary trees of bounding volumes of any form, so that "which volume" can be seen: `balls` (`ball.rs`) and `kdop`
//! (`kdop.rs`).
//!
//! The tree is that of any builder over boxes. Each node then gets a volume that encloses the corners of the *boxes* of
//! the primitives below, and that is tested with the padding: what a primitive's own box accepts is never skipped, so
//! hits are those of all other structures. Goldsmith, Salmon: *Automatic Creation of Object Hierarchies for Ray
//! Tracing*, 1987, and Weghorst, Hooper, Greenberg: *Improved Computational Methods for Ray Tracing*, 1984, weigh what
//! a form costs against what it keeps away.

mod ball;
mod kdop;

use std::ops::{ControlFlow, Range};

use obvhs::bvh2::leaf_collapser::collapse;
use obvhs::bvh2::{Bvh2, node::Bvh2Node};
use smallvec::SmallVec;

use crate::counters::Counters;
use crate::math::{Aabb, BoxRay, NONE, Ray};

use super::build::boxes_of;
use super::builder::{Builder, TreeChoice};
use super::order::in_32_bits;
use super::{Accel, Bounded, Build, Built, OptionInfo, Order, RegionForm, Regions, StructureShape};

pub use ball::Ball;
pub use kdop::KDop;

/// The stack lives with the call up to this depth, and on the heap beyond.
const USUAL_DEPTH: usize = 32;

/// A form of bounding volumes.
pub trait Volume: Clone + Copy + Default + Send + Sync + 'static {
    /// A ray as such volumes see it.
    type Ray;

    /// A ray; the box ray has the padding.
    fn ray(ray: &Ray, box_ray: &BoxRay) -> Self::Ray;

    /// The volume about the middle of a node's box, which holds all corners of some of the primitives' boxes. Indices
    /// that are [`NONE`] stand for nothing.
    fn around(bounds: &Aabb, boxes: &[Aabb], some: &[u32]) -> Self;

    /// What it looks like in pictures.
    fn form(&self) -> RegionForm;

    /// Where a ray enters the volume, if it meets that between its own begin and an end, both included. It must be met
    /// by every ray that meets, between the same, the padded box of a primitive inside.
    fn entered(&self, ray: &Self::Ray, end: f32) -> Option<f64>;
}

/// A binary tree of bounding volumes.
#[derive(Clone, Debug)]
pub struct VolumeTree<V> {
    nodes: Vec<[Child<V>; 2]>,
    /// The volume around all; `None` if there are no primitives.
    root: Option<Child<V>>,
}

/// A binary tree of bounding balls.
pub type BallTree = VolumeTree<Ball>;

/// A binary tree of polytopes between seven pairs of parallel planes.
pub type KDopTree = VolumeTree<KDop>;

/// A leaf or a node, and the volume around it.
#[derive(Clone, Copy, Debug, Default)]
struct Child<V> {
    volume: V,
    /// First slot of a leaf, or index of a node.
    first: u32,
    /// Slots of a leaf; 0 for a node.
    count: u32,
}

// Boxes are not cut: a volume is one around whole boxes.
const BUILDER: OptionInfo = Builder::option_without_cuts("sah");
const LEAF: OptionInfo = OptionInfo::leaf(32, "4");

impl<V: Volume> Accel for VolumeTree<V> {
    const ONE_BY_ONE: bool = true;

    /// As measured with balls, and what larger volumes take more.
    const BUILD_BYTES: u64 = 170 + size_of::<Child<V>>() as u64;

    const OPTIONS: &'static [OptionInfo] = &[BUILDER, Builder::REINSERTION, LEAF];

    fn build(primitives: &impl Bounded, build: &mut Build<'_>) -> Built<Self> {
        let Build { config, grain, stages } = build;
        if primitives.count() == 0 {
            return Built { accel: Self { nodes: Vec::new(), root: None }, order: None };
        }
        let most = config.options.number(&LEAF).unwrap_or(config.max_leaf.min(4)).max(1);
        let choice = TreeChoice::of(config, false, &BUILDER, Builder::Sah);
        let mut tree = choice.tree(primitives, *grain, 1, stages);
        let cost = config.quality.parameters().collapse_traversal_cost;
        stages.time("collapse", || collapse(&mut tree, most, cost));
        stages.time("volumes", || lay_out(&tree, &boxes_of(primitives), *grain))
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
        let volume_ray = V::ray(ray, box_ray);
        let mut end = ray.end();
        counters.boxes(1);
        let Some(begin) = root.volume.entered(&volume_ray, end) else { return };
        let mut stack = SmallVec::<[(Child<V>, f64); USUAL_DEPTH]>::new();
        stack.push((root, begin));
        while let Some((at, begin)) = stack.pop() {
            // Inclusive: a volume that begins at the end may hold a tie.
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
            let [a, b] = [0, 1].map(|i| children[i].volume.entered(&volume_ray, end));
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
        let mut open: Vec<(Child<V>, u32)> = self.root.iter().map(|&root| (root, 0)).collect();
        while let Some((Child { volume, first, count }, level)) = open.pop() {
            let form = volume.form();
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
        let mut open: Vec<(Child<V>, u32)> = self.root.iter().map(|&root| (root, 0)).collect();
        while let Some((child, depth)) = open.pop() {
            match child.count {
                0 => open.extend(self.nodes[child.first as usize].map(|child| (child, depth + 1))),
                count => shape.add_leaf(count, depth),
            }
        }
        shape
    }
}

/// What is still to be done of a walk: which child of which node it is, `None` for the root.
enum Step<'a, V> {
    Enter(&'a Bvh2Node, Option<(usize, usize)>),
    /// The slots of all below begin there.
    Leave(&'a Bvh2Node, Option<(usize, usize)>, Child<V>, usize),
}

/// Puts volumes in the place of boxes, in the order in which a walk meets them, and moves every leaf's range
/// to a multiple of `grain`.
fn lay_out<V: Volume>(tree: &Bvh2, boxes: &[Aabb], grain: u32) -> Built<VolumeTree<V>> {
    let mut nodes: Vec<[Child<V>; 2]> = Vec::with_capacity(tree.nodes.len() / 2);
    let mut order: Vec<u32> = Vec::with_capacity(tree.primitive_indices.len());
    let mut root = Child::default();
    let mut open: Vec<Step<'_, V>> = vec![Step::Enter(&tree.nodes[0], None)];
    while let Some(step) = open.pop() {
        match step {
            Step::Enter(from, parent) if from.is_leaf() => {
                order.resize(order.len().next_multiple_of(grain as usize), NONE);
                let child = Child {
                    first: in_32_bits(order.len()),
                    count: from.prim_count,
                    ..Child::default()
                };
                open.push(Step::Leave(from, parent, child, order.len()));
                let first = from.first_index as usize;
                let own = first..first + from.prim_count as usize;
                order.extend_from_slice(&tree.primitive_indices[own]);
            }
            Step::Enter(from, parent) => {
                let place = nodes.len();
                nodes.push([Child::default(); 2]);
                let child = Child { first: in_32_bits(place), ..Child::default() };
                open.push(Step::Leave(from, parent, child, order.len()));
                let first = from.first_index as usize;
                let below = |side| Step::Enter(&tree.nodes[first + side], Some((place, side)));
                open.extend([below(1), below(0)]);
            }
            Step::Leave(from, parent, child, begin) => {
                let box_of = Aabb { min: from.aabb().min, max: from.aabb().max };
                let volume = V::around(&box_of, boxes, &order[begin..]);
                let child = Child { volume, ..child };
                match parent {
                    Some((node, side)) => nodes[node][side] = child,
                    None => root = child,
                }
            }
        }
    }
    nodes.shrink_to_fit();
    Built { accel: VolumeTree { nodes, root: Some(root) }, order: Some(Order::Permutation(order)) }
}

#[cfg(test)]
pub(super) mod tests {
    use glam::Vec3A;

    use super::super::builder::Boxes;
    use super::super::{BuildConfig, BuildStages};
    use super::*;
    use crate::math::Random;

    /// Builds a tree over small boxes and asks, for every leaf and each of its boxes, whether all volumes above hold
    /// it.
    pub(in super::super) fn assert_volumes_hold_what_is_below<V: Volume>(
        holds: impl Fn(&V, &Aabb) -> bool,
    ) {
        let mut random = Random::new(&[37]);
        let mut point = || Vec3A::from_array(std::array::from_fn(|_| random.next_f32()));
        let boxes: Vec<Aabb> = (0..700)
            .map(|_| (point(), point()))
            .map(|(a, b)| Aabb { min: a, max: a + 0.1 * b })
            .collect();
        let config = BuildConfig::default();
        let mut build = Build { config: &config, grain: 4, stages: &mut BuildStages::default() };
        let Built { accel, order } = VolumeTree::<V>::build(&Boxes(boxes.clone()), &mut build);
        let order = order.expect("there is an order");
        let mut open = vec![(accel.root.expect("there are boxes"), vec![])];
        let mut leaves = 0;
        while let Some((child, mut above)) = open.pop() {
            above.push(child.volume);
            if child.count == 0 {
                open.extend(accel.nodes[child.first as usize].map(|below| (below, above.clone())));
                continue;
            }
            leaves += child.count;
            for slot in child.first..child.first + child.count {
                let bounds = &boxes[order.slots()[slot as usize] as usize];
                assert!(above.iter().all(|volume| holds(volume, bounds)));
            }
        }
        assert_eq!(leaves, 700);
    }

    /// Asks whether every ray that meets a padded box meets the volume around it, and no later.
    pub(in super::super) fn assert_what_the_box_accepts_the_volume_accepts<V: Volume>() {
        use crate::math::Padding;
        use glam::Vec3;

        let mut random = Random::new(&[19]);
        let (mut met, mut missed) = (0, 0);
        for number in 0..20_000 {
            let mut point = || Vec3A::from_array(std::array::from_fn(|_| random.next_f32() - 0.5));
            let aabb = Aabb::of_points([point(), point()]);
            let origin = [1.0, 3.0, 1e3][number % 3] * Vec3::from(point());
            let (a, b) = (Vec3::from(aabb.corners()[number % 8]), Vec3::from(point()));
            let ray = Ray::new(origin, a + [0.0, 1e-3, 0.3][number / 3 % 3] * b - origin);
            let box_ray = BoxRay::new(&ray, Padding::of_bounds(&aabb));
            let (near, far) = box_ray.interval(&aabb);
            let volume = V::around(&aabb, &[aabb], &[0, NONE]);
            let entered = volume.entered(&V::ray(&ray, &box_ray), near.max(0.0));
            if near.max(0.0) <= far {
                met += 1;
                let begin = entered.expect("the box is met");
                assert!(begin <= f64::from(near.max(0.0)), "{ray:?} {aabb:?}");
            } else {
                missed += u32::from(volume.entered(&V::ray(&ray, &box_ray), f32::MAX).is_none());
            }
        }
        assert!(met > 5_000 && missed > 500, "{met} {missed}");
    }
}
