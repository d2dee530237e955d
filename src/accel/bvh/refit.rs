//! The binary tree follows primitives that move.

use std::ops::Range;

use crate::accel::builder::Boxes;
use crate::accel::refit::{Below, FitNode, Grown, Leader, bounds_of, follow, sort_by_id};
use crate::accel::{Build, BuildConfig, BuildStages, Followed, Moved, Primitives, Update};
use crate::math::Aabb;

use super::{Bvh, Child, Node, binary_tree, lay_out};

impl FitNode for Node {
    const WIDTH: usize = 2;

    type Child = Child;

    fn inner(index: usize) -> Child {
        Child { first: index as u32, count: 0 }
    }

    fn leaf(slots: Range<u32>, _: usize) -> Child {
        Child { first: slots.start, count: slots.end - slots.start }
    }

    fn child(&self, lane: usize) -> Child {
        self.children[lane]
    }

    fn below(&self, lane: usize, _: usize) -> Option<Below> {
        let Child { first, count } = self.children[lane];
        Some(if count == 0 {
            Below::Node(first as usize)
        } else {
            Below::Slots(first..first + count)
        })
    }

    fn child_bounds(&self, lane: usize) -> Aabb {
        Self::child_bounds(self, lane)
    }

    fn put(&mut self, lane: usize, child: Child, bounds: &Aabb) {
        self.children[lane] = child;
        self.fit(lane, bounds);
    }

    fn fit(&mut self, lane: usize, bounds: &Aabb) {
        for (axis, planes) in self.planes.iter_mut().enumerate() {
            planes[lane] = bounds.min[axis];
            planes[2 + lane] = bounds.max[axis];
        }
    }
}

/// Lets the tree follow.
pub(super) fn refit<P: Primitives>(
    tree: &mut Bvh,
    update: Update,
    primitives: &P,
    moved: Moved<'_>,
    build: &Build<'_>,
) -> Followed {
    let Bvh { nodes, root, memory } = tree;
    let leader = Leading { primitives, config: build.config, grain: build.grain };
    let Some(root) = root else { return Followed::in_place(Aabb::EMPTY) };
    if root.count > 0 {
        return Followed::in_place(leader.bounds(root.first..root.first + root.count));
    }
    follow(update, moved, (nodes, memory), &leader)
}

/// Primitives, and how the tree over them was built.
struct Leading<'a, P> {
    primitives: &'a P,
    config: &'a BuildConfig,
    grain: u32,
}

impl<P: Primitives> Leader<Node> for Leading<'_, P> {
    fn block(&self) -> usize {
        1
    }

    fn grain(&self) -> usize {
        self.grain as usize
    }

    fn bounds(&self, slots: Range<u32>) -> Aabb {
        bounds_of(self.primitives, slots)
    }

    fn sort(&self, slots: &mut [u32]) {
        sort_by_id(self.primitives, slots);
    }

    fn grow(&self, slots: &[u32]) -> Grown<Node> {
        let boxes = Boxes::of(self.primitives, slots);
        let stages = &mut BuildStages::default();
        let mut build = Build { config: self.config, grain: self.grain, stages };
        let (Bvh { nodes, .. }, order) =
            lay_out(&binary_tree(&boxes, &mut build, false), self.grain);
        Grown { nodes, order }
    }
}
