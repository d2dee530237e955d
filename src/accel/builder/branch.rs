//! Parts of a binary tree that were built apart, and how they are put together.

use obvhs::aabb::Aabb;
use obvhs::bvh2::node::Bvh2Node;
use rayon::prelude::*;

use crate::simd::ask_for_huge_pages;

/// A subtree.
pub(super) enum Branch {
    /// A node, by its box, and what is below it.
    Fork(Aabb, Box<[Branch; 2]>),
    /// Nodes that name each other by their places among these. The root is the first.
    Grown(Vec<Bvh2Node>),
}

/// Nodes without their root, and by how much their places move.
type Move = (Vec<Bvh2Node>, u32);

impl Branch {
    /// The box of its root.
    pub(super) fn bounds(&self) -> Aabb {
        match self {
            Self::Fork(bounds, _) => *bounds,
            Self::Grown(nodes) => *nodes[0].aabb(),
        }
    }

    /// Lets leaves refer to primitives so many places later.
    pub(super) fn move_leaves(&mut self, by: u32) {
        match self {
            Self::Fork(_, below) => below.iter_mut().for_each(|branch| branch.move_leaves(by)),
            Self::Grown(nodes) => {
                for leaf in nodes.iter_mut().filter(|node| node.is_leaf()) {
                    leaf.first_index += by;
                }
            }
        }
    }

    /// All nodes as one list: the forks, then what was grown below each of them.
    pub(super) fn into_nodes(self) -> Vec<Bvh2Node> {
        let (forks, grown) = self.sizes();
        // As many roots of what was grown as there are forks, and one.
        let top = 2 * forks + 1;
        let mut nodes = Vec::with_capacity(top + grown);
        if forks == 0
            && let Self::Grown(nodes) = self
        {
            return nodes;
        }
        nodes.push(Bvh2Node::default());
        let mut moves = Vec::new();
        let mut next = top;
        self.lay(0, &mut nodes, &mut next, &mut moves);
        ask_for_huge_pages(nodes.spare_capacity_mut());
        nodes.resize(top + grown, Bvh2Node::default());
        let mut rest = &mut nodes[top..];
        let mut jobs = Vec::with_capacity(moves.len());
        for (from, by) in moves {
            let to = rest.split_off_mut(..from.len() - 1).expect("all nodes were counted");
            jobs.push((to, from, by));
        }
        jobs.into_par_iter().for_each(|(to, from, by)| {
            for (to, from) in to.iter_mut().zip(&from[1..]) {
                *to = moved(*from, by);
            }
        });
        nodes
    }

    /// How many forks there are, and how many grown nodes that are no roots.
    fn sizes(&self) -> (usize, usize) {
        match self {
            Self::Fork(_, below) => {
                let [left, right] = &**below;
                let (left, right) = (left.sizes(), right.sizes());
                (left.0 + right.0 + 1, left.1 + right.1)
            }
            Self::Grown(nodes) => (0, nodes.len() - 1),
        }
    }

    /// Writes the root to its place and the forks below it behind what is there.
    fn lay(self, place: usize, top: &mut Vec<Bvh2Node>, next: &mut usize, moves: &mut Vec<Move>) {
        match self {
            Self::Fork(bounds, below) => {
                let first = top.len();
                top[place] = Bvh2Node::new(bounds, 0, first as u32);
                top.extend([Bvh2Node::default(); 2]);
                let [left, right] = *below;
                left.lay(first, top, next, moves);
                right.lay(first + 1, top, next, moves);
            }
            Self::Grown(nodes) => {
                // The first that is no root comes to the place `next`.
                let by = *next as u32 - 1;
                top[place] = moved(nodes[0], by);
                *next += nodes.len() - 1;
                moves.push((nodes, by));
            }
        }
    }
}

/// A node whose children stand so many places later.
fn moved(mut node: Bvh2Node, by: u32) -> Bvh2Node {
    if !node.is_leaf() {
        node.first_index += by;
    }
    node
}
