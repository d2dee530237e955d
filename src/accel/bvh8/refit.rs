//! The boxes of the tree of eight children follow its primitives, in lanes.

use std::ops::Range;

use crate::accel::refit::{Below, Fit, FitNode, Moved, fit_inner, fit_leaves};
use crate::accel::{Packs, Primitives};
use crate::math::{Aabb, Lanes as _};
use crate::simd::{Kernel, Row as _, Simd, dispatch};

use super::Bvh8;
use super::node::{Child, FAR, Node, WIDTH, near_planes};

impl FitNode for Node {
    const WIDTH: usize = WIDTH;

    fn below(&self, lane: usize, block: usize) -> Option<Below> {
        let child = Child(self.children()[lane]);
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

    fn fit(&mut self, lane: usize, bounds: &Aabb) {
        self.set(lane, Child(self.children()[lane]), bounds);
    }

    fn settle(&mut self) {
        self.sort();
    }

    fn bounds(&self) -> Aabb {
        Self::bounds(self)
    }
}

/// Lets the boxes follow the primitives, and returns the box around all.
pub(super) fn refit<P: Primitives>(tree: &mut Bvh8, primitives: &P, moved: Moved<'_>) -> Aabb {
    let Bvh8 { nodes, block, paths, .. } = tree;
    if nodes.is_empty() {
        return Aabb::EMPTY;
    }
    let block = *block;
    let bounds_of = |slots: Range<u32>| {
        slots.map(|slot| primitives.bounds(slot)).fold(Aabb::EMPTY, Aabb::union)
    };
    let fit = Fit { nodes, block, paths };
    if const { <P::Packs as Packs>::GRAIN > 1 } {
        let packs = primitives.packs();
        let of_leaves = |nodes: &mut [Node]| dispatch(FitLeaves { nodes, packs });
        fit.follow(moved, bounds_of, of_leaves, |nodes| dispatch(FitInner { nodes }))
    } else {
        let of_leaves = |nodes: &mut [Node]| fit_leaves(nodes, block, bounds_of);
        fit.follow(moved, bounds_of, of_leaves, |nodes| fit_inner(nodes, block))
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
