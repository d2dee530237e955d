//! obvhs's binary tree, walked by this project's own slab test.
//!
//! The tree is built by clustering and improved by reinsertion (`builder/`), its leaves are collapsed
//! by the surface area heuristic, and it is improved once more: all by obvhs. obvhs's own traversal
//! prunes with `<` and without padding, so it cannot keep the contract of [`Accel`]. The walk below
//! does; for it, the boxes of both children are laid side by side in their parent, a cache line for
//! each pair.
//!
//! * *Idea*: Primitives are parted, not space: each node has a box around what is below it.
//! * *Paper*: Kay, Kajiya: *Ray Tracing Complex Scenes*, 1986, for the search of the nearer child first; Meister,
//!   Bittner: *Parallel Locally-Ordered Clustering for Bounding Volume Hierarchy Construction*, 2018, for the build.
//! * *Build*: O(n log n), in parallel.
//! * *A ray*: O(log n) nodes in the mean, two boxes each.
//! * *Memory*: 64 bytes a node, of which there are as many as leaves but one.
//! * *It wins*: for single rays, and as what others are compared with: no scene is bad for it.
//! * *Picture*: `docs/gallery/cells-bvh.png`.

mod refit;
mod save;

use std::ops::{ControlFlow, Range};

use glam::{Vec3A, Vec4, Vec4Swizzles};
use obvhs::bvh2::leaf_collapser::collapse;
use obvhs::bvh2::{Bvh2, node::Bvh2Node};
use smallvec::SmallVec;

use crate::counters::Counters;
use crate::math::slab::crossing;
use crate::math::{Aabb, BoxRay, NONE, Ray};

use super::builder::{Builder, TreeChoice, cuts, reinsert};
use super::order::in_32_bits;
use super::refit::Memory;
use super::{
    Accel, Bounded, Build, Built, Followed, Moved, OptionInfo, Order, Primitives, Tree, Update,
};

/// The stack lives with the call up to this depth, and on the heap beyond.
const USUAL_DEPTH: usize = 32;

/// A binary tree of boxes.
#[derive(Clone, Debug)]
pub struct Bvh {
    nodes: Vec<Node>,
    /// The whole tree; `None` if there are no primitives.
    root: Option<Child>,
    /// What was needed to follow primitives that move.
    memory: Memory,
}

/// The children of a node and their boxes.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
struct Node {
    /// For each axis: the low planes of the left and right box, then their high planes.
    planes: [Vec4; 3],
    children: [Child; 2],
}

/// A leaf or a node.
#[derive(Clone, Copy, Debug, Default)]
struct Child {
    /// First slot of a leaf, or index of a node.
    first: u32,
    /// Slots of a leaf; 0 for a node.
    count: u32,
}

const BUILDER: OptionInfo = Builder::option("ploc");
const LEAF: OptionInfo = OptionInfo::leaf(32, "8; in the fastest build 1");

impl Accel for Bvh {
    const ONE_BY_ONE: bool = true;

    /// As measured over a terrain and a sphere of two million triangles; `fastest` builds take up to 320.
    const BUILD_BYTES: u64 = 230;

    const OPTIONS: &'static [OptionInfo] = &[BUILDER, Builder::REINSERTION, LEAF];

    const UPDATES: &'static [Update] = &Update::ALL;

    fn build(primitives: &impl Bounded, build: &mut Build<'_>) -> Built<Self> {
        if primitives.count() == 0 {
            return Built {
                accel: Self { nodes: Vec::new(), root: None, memory: Memory::default() },
                order: None,
            };
        }
        let tree = binary_tree(primitives, build, cuts(build.grain));
        let (accel, order) = build.stages.time("layout", || lay_out(&tree, build.grain));
        let order = Order::of(order, tree.primitive_indices.len(), primitives.count());
        Built { accel, order: Some(order) }
    }

    #[inline]
    fn traverse<C: Counters>(
        &self,
        ray: &Ray,
        box_ray: &BoxRay,
        counters: &mut C,
        mut leaf: impl FnMut(Range<u32>, &mut C) -> ControlFlow<(), f32>,
    ) {
        // The root's own box is not tested: its children's are, for the same price.
        let Some(mut at) = self.root else { return };
        let pair_ray = PairRay::new(box_ray);
        let t_min = Vec4::splat(ray.t_min);
        let mut end = ray.end();
        let mut stack = SmallVec::<[(Child, f32); USUAL_DEPTH]>::new();
        loop {
            if at.count == 0 {
                counters.boxes(2);
                let node = &self.nodes[at.first as usize];
                let (near, far) = pair_ray.intervals(node);
                let near = near.max(t_min);
                let entered = near.cmple(far.min(Vec4::splat(end))).bitmask() & 0b11;
                if entered == 0b11 {
                    // The nearer child first, the other kept with where it begins.
                    let other = usize::from(near[0] <= near[1]);
                    stack.push((node.children[other], near[other]));
                    at = node.children[1 - other];
                    continue;
                }
                if entered != 0 {
                    at = node.children[entered as usize >> 1];
                    continue;
                }
            } else {
                match leaf(at.first..at.first + at.count, counters) {
                    ControlFlow::Continue(t) => end = t,
                    ControlFlow::Break(()) => return,
                }
            }
            loop {
                let Some((next, near)) = stack.pop() else { return };
                if near <= end {
                    at = next;
                    break;
                }
            }
        }
    }

    fn refit<P: Primitives>(
        &mut self,
        update: Update,
        primitives: &P,
        moved: Moved<'_>,
        build: &Build<'_>,
    ) -> Followed {
        refit::refit(self, update, primitives, moved, build)
    }

    fn bytes(&self) -> u64 {
        let nodes = self.nodes.capacity() * size_of::<Node>();
        (size_of::<Self>() + nodes + self.memory.bytes()) as u64
    }

    fn tree(&self) -> Option<Tree> {
        let bounds = self.nodes.first().map_or(Aabb::EMPTY, Node::bounds);
        Some(Tree::of((self.root?, bounds), |&(child, bounds), children| {
            if child.count == 0 {
                let node = &self.nodes[child.first as usize];
                children.extend([0, 1].map(|side| (node.children[side], node.child_bounds(side))));
                return (bounds, 0..0);
            }
            (bounds, child.first..child.first + child.count)
        }))
    }
}

impl Node {
    /// The box of the left (0) or right (1) child.
    fn child_bounds(&self, side: usize) -> Aabb {
        let corner = |first: usize| Vec3A::from_array(self.planes.map(|axis| axis[first + side]));
        Aabb { min: corner(0), max: corner(2) }
    }

    /// The box around both children.
    fn bounds(&self) -> Aabb {
        self.child_bounds(0).union(self.child_bounds(1))
    }
}

/// A ray as a pair of boxes sees it: each axis' origins and inverse direction in all lanes.
struct PairRay {
    origins: [Vec4; 3],
    inv_dir: [Vec4; 3],
}

impl PairRay {
    #[inline(always)]
    fn new(box_ray: &BoxRay) -> Self {
        let (plus, minus) = (box_ray.origin_plus, box_ray.origin_minus);
        Self {
            origins: std::array::from_fn(|axis| {
                Vec4::new(plus[axis], plus[axis], minus[axis], minus[axis])
            }),
            inv_dir: std::array::from_fn(|axis| Vec4::splat(box_ray.inv_dir[axis])),
        }
    }

    /// [`BoxRay::interval`] of the left box in lane 0 and of the right box in lane 1.
    #[inline(always)]
    fn intervals(&self, node: &Node) -> (Vec4, Vec4) {
        let [x, y, z]: [(Vec4, Vec4); 3] = std::array::from_fn(|axis| {
            let t = crossing(node.planes[axis], self.origins[axis], self.inv_dir[axis]);
            let swapped = t.zwxy();
            (t.min(swapped), t.max(swapped))
        });
        (x.0.max(y.0).max(z.0), x.1.min(y.1).min(z.1))
    }
}

/// The tree that is laid out, over at least one primitive. Where no option is given, it is that of obvhs's
/// `build_bvh2`.
fn binary_tree(primitives: &impl Bounded, build: &mut Build<'_>, cuts: bool) -> Bvh2 {
    let Build { config, grain, stages } = build;
    let parameters = config.quality.parameters();
    let usual_leaf = parameters.max_prims_per_leaf.min(config.max_leaf);
    let most = config.options.number(&LEAF).unwrap_or(usual_leaf).max(1);
    let choice = TreeChoice::of(config, cuts, &BUILDER, Builder::Ploc);
    let mut tree = choice.tree(primitives, *grain, 1, stages);
    let cost = parameters.collapse_traversal_cost;
    stages.time("collapse", || collapse(&mut tree, most, cost));
    let again = parameters.post_collapse_reinsertion_batch_ratio_multiplier;
    reinsert(&mut tree, again * choice.reinserted, stages);
    tree
}

/// Pairs the boxes of siblings, in the order in which a walk meets them, and moves every leaf's
/// range to a multiple of `grain`.
fn lay_out(tree: &Bvh2, grain: u32) -> (Bvh, Vec<u32>) {
    let mut nodes = Vec::with_capacity(tree.nodes.len() / 2);
    let mut order = Vec::with_capacity(tree.primitive_indices.len());
    let mut root = Child::default();
    // What is still to be placed, and which child of which node it is; `None` for the root.
    let mut open: Vec<(&Bvh2Node, Option<(usize, usize)>)> = vec![(&tree.nodes[0], None)];
    while let Some((from, parent)) = open.pop() {
        let child = if from.is_leaf() {
            order.resize(order.len().next_multiple_of(grain as usize), NONE);
            let child = Child { first: in_32_bits(order.len()), count: from.prim_count };
            let range = from.first_index as usize..(from.first_index + from.prim_count) as usize;
            order.extend_from_slice(&tree.primitive_indices[range]);
            child
        } else {
            let index = nodes.len();
            let left = &tree.nodes[from.first_index as usize];
            let right = &tree.nodes[from.first_index as usize + 1];
            let planes = planes_of(&bounds_of(left), &bounds_of(right));
            nodes.push(Node { planes, children: [Child::default(); 2] });
            open.extend([(right, Some((index, 1))), (left, Some((index, 0)))]);
            Child { first: in_32_bits(index), count: 0 }
        };
        match parent {
            Some((node, side)) => nodes[node].children[side] = child,
            None => root = child,
        }
    }
    nodes.shrink_to_fit();
    (Bvh { nodes, root: Some(root), memory: Memory::default() }, order)
}

fn bounds_of(node: &Bvh2Node) -> Aabb {
    let obvhs::aabb::Aabb { min, max } = *node.aabb();
    Aabb { min, max }
}

fn planes_of(left: &Aabb, right: &Aabb) -> [Vec4; 3] {
    std::array::from_fn(|axis| {
        Vec4::new(left.min[axis], right.min[axis], left.max[axis], right.max[axis])
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::build::obvhs_boxes;
    use crate::accel::builder::Boxes;
    use crate::accel::{BuildConfig, BuildOptions, BuildStages, Quality};
    use crate::math::Random;

    fn boxes() -> Boxes {
        let mut random = Random::new(&[3]);
        let mut point = || Vec3A::from_array(std::array::from_fn(|_| random.next_f32()));
        let pairs = (0..3_000).map(|_| (point(), point()));
        Boxes(pairs.map(|(a, b)| Aabb { min: a, max: a + 0.1 * b }).collect())
    }

    fn tree(boxes: &Boxes, config: &BuildConfig) -> Bvh2 {
        binary_tree(
            boxes,
            &mut Build { config, grain: 8, stages: &mut BuildStages::default() },
            true,
        )
    }

    #[test]
    fn without_options_the_tree_is_that_of_obvhs() {
        let boxes = boxes();
        for quality in Quality::ALL {
            for max_leaf in [1, 3, 8] {
                let own =
                    tree(&boxes, &BuildConfig { quality, max_leaf, ..BuildConfig::default() });
                let mut parameters = quality.parameters();
                parameters.max_prims_per_leaf = parameters.max_prims_per_leaf.min(max_leaf);
                let time = &mut std::time::Duration::default();
                let expected =
                    obvhs::bvh2::builder::build_bvh2(&obvhs_boxes(&boxes), parameters, time);
                assert_eq!(format!("{:?}", own.nodes), format!("{:?}", expected.nodes));
                assert_eq!(own.primitive_indices, expected.primitive_indices);
            }
        }
    }

    #[test]
    fn leaves_hold_as_many_as_the_option_allows() {
        let boxes = boxes();
        for (text, most) in [("leaf=1", 1), ("leaf=4", 4), ("builder=sah,leaf=20", 20)] {
            for quality in Quality::ALL {
                let options = BuildOptions::of::<Bvh>(text).expect("the options are right");
                let tree =
                    tree(&boxes, &BuildConfig { quality, options, ..BuildConfig::default() });
                let leaves = tree.nodes.iter().filter(|node| node.is_leaf());
                let largest = leaves.map(|leaf| leaf.prim_count).max();
                assert!(largest <= Some(most), "{text}, {}: {largest:?}", quality.name());
                assert!(most == 1 || largest > Some(1), "{text}, {}", quality.name());
            }
        }
    }
}
