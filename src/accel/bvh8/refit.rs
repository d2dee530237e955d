//! The tree of eight children follows primitives that move; its boxes in lanes.

use std::ops::Range;

use crate::accel::builder::Boxes;
use crate::accel::refit::{
    Below, FitNode, Grown, Leader, bounds_of, fit_leaves_one_by_one, follow, sort_by_id,
};
use crate::accel::{Build, BuildConfig, BuildStages, Followed, Moved, Packs, Primitives, Update};
use crate::math::{Aabb, Lanes as _};
use crate::simd::{Kernel, Row as _, Simd, dispatch};

use super::collapse::Wide;
use super::node::{Child, FAR, Node, WIDTH, near_planes};
use super::plan::Leaves;
use super::{Bvh8, Height, wide_tree};

impl FitNode for Node {
    const WIDTH: usize = WIDTH;

    type Child = Child;

    fn inner(index: usize) -> Child {
        Child::node(index)
    }

    fn leaf(slots: Range<u32>, block: usize) -> Child {
        Child::leaf(slots.start as usize / block, slots.len())
    }

    fn child(&self, lane: usize) -> Child {
        Child(self.children()[lane])
    }

    fn below(&self, lane: usize, block: usize) -> Option<Below> {
        let child = self.child(lane);
        if child == Child::ABSENT {
            return None;
        }
        Some(if child.is_leaf() {
            let first = (child.block() * block) as u32;
            Below::Slots(first..first + child.count())
        } else {
            Below::Node(child.index())
        })
    }

    fn child_bounds(&self, lane: usize) -> Aabb {
        Self::child_bounds(self, lane)
    }

    fn put(&mut self, lane: usize, child: Child, bounds: &Aabb) {
        self.set(lane, child, bounds);
    }

    fn settle(&mut self) {
        self.sort();
    }

    fn bounds(&self) -> Aabb {
        Self::bounds(self)
    }
}

/// Lets the tree follow.
pub(super) fn refit<P: Primitives>(
    tree: &mut Bvh8,
    update: Update,
    primitives: &P,
    moved: Moved<'_>,
    build: &Build<'_>,
) -> Followed {
    let Bvh8 { nodes, memory, .. } = tree;
    if nodes.is_empty() {
        return Followed::in_place(Aabb::EMPTY);
    }
    let leaves = Leaves::of(build.config, build.grain);
    let leader = Leading { primitives, config: build.config, grain: build.grain, leaves };
    let followed = follow(update, moved, (nodes, memory), &leader);
    if update != Update::Refit {
        tree.height = Height::of(&tree.nodes);
    }
    followed
}

/// Primitives, and how the tree over them was built.
struct Leading<'a, P> {
    primitives: &'a P,
    config: &'a BuildConfig,
    grain: u32,
    leaves: Leaves,
}

impl<P: Primitives> Leading<'_, P> {
    const PACKED: bool = <P::Packs as Packs>::GRAIN > 1;
}

impl<P: Primitives> Leader<Node> for Leading<'_, P> {
    fn block(&self) -> usize {
        self.leaves.block
    }

    fn grain(&self) -> usize {
        self.leaves.block
    }

    fn bounds(&self, slots: Range<u32>) -> Aabb {
        bounds_of(self.primitives, slots)
    }

    fn sort(&self, slots: &mut [u32]) {
        sort_by_id(self.primitives, slots);
    }

    fn grow(&self, slots: &[u32]) -> Grown<Node> {
        let stages = &mut BuildStages::default();
        let mut build = Build { config: self.config, grain: self.grain, stages };
        let boxes = Boxes::of(self.primitives, slots);
        let (Wide { nodes, order }, _) = wide_tree(&boxes, self.leaves, &mut build, false);
        Grown { nodes, order }
    }

    fn fit_leaves(&self, nodes: &mut [Node]) {
        if const { Self::PACKED } {
            dispatch(FitLeaves { nodes, packs: self.primitives.packs() });
        } else {
            fit_leaves_one_by_one(self, nodes);
        }
    }

    fn fit_inner(&self, nodes: &mut [Node]) {
        dispatch(FitInner { nodes });
    }
}

/// The boxes of leaves: of each the smallest and the largest planes of its pack.
struct FitLeaves<'a, K> {
    nodes: &'a mut [Node],
    packs: &'a K,
}

impl<K: Packs> Kernel for FitLeaves<'_, K> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let infinity = S::F8::splat(f32::INFINITY);
        let none = S::F8::splat(f32::NEG_INFINITY);
        for node in self.nodes {
            for lane in 0..WIDTH {
                let child = Child(node.children()[lane]);
                if !child.is_leaf() || child == Child::ABSENT {
                    continue;
                }
                let [low, high] = self.packs.boxes::<S>(child.block());
                let mask = (1u32 << child.count()) - 1;
                let mut bounds = Aabb::EMPTY;
                for axis in 0..3 {
                    bounds.min[axis] = low[axis].select(mask, infinity).smallest();
                    bounds.max[axis] = high[axis].select(mask, none).largest();
                }
                node.set(lane, child, &bounds);
            }
        }
    }
}

/// The boxes of inner children, from the last node to the first. Absent children have empty boxes, which change no
/// union.
struct FitInner<'a> {
    nodes: &'a mut [Node],
}

impl Kernel for FitInner<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let low_planes = near_planes(0);
        for index in (0..self.nodes.len()).rev() {
            for lane in 0..WIDTH {
                let child = Child(self.nodes[index].children()[lane]);
                if child.is_leaf() {
                    continue;
                }
                let below = &self.nodes[child.index()];
                let mut bounds = Aabb::EMPTY;
                for (axis, low) in low_planes.into_iter().enumerate() {
                    bounds.min[axis] = below.planes::<S>(low).smallest();
                    bounds.max[axis] = below.planes::<S>(low ^ FAR).largest();
                }
                self.nodes[index].set(lane, child, &bounds);
            }
        }
    }
}
