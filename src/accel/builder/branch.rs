//! Parts of a binary tree that were built apart, and how they are put together.

use std::vec;

use obvhs::aabb::Aabb;
use obvhs::bvh2::node::Bvh2Node;

use crate::simd::concatenated;

/// A subtree.
pub(super) enum Branch {
    /// A node, by its box, and what is below it.
    Fork(Aabb, Box<[Branch; 2]>),
    /// Nodes that name each other by their places among these. The root is the first.
    Grown(Vec<Bvh2Node>),
}

/// Nodes, and by how much their places move.
type Move = (vec::IntoIter<Bvh2Node>, u32);

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
        if let Self::Grown(nodes) = self {
            return nodes;
        }
        let (mut top, mut grown) = (vec![Bvh2Node::default()], Vec::new());
        // As many roots of what was grown as there are forks, and one.
        let mut next = 2 * self.forks() + 1;
        self.lay(0, &mut top, &mut next, &mut grown);
        let parts = std::iter::once((top.into_iter(), 0)).chain(grown);
        concatenated(parts.map(|(nodes, by)| nodes.map(move |node| moved(node, by))).collect())
    }

    /// How many forks there are.
    fn forks(&self) -> usize {
        match self {
            Self::Fork(_, below) => below.iter().map(Self::forks).sum::<usize>() + 1,
            Self::Grown(_) => 0,
        }
    }

    /// Writes the root to its place and the forks below it behind what is there; what was grown follows without its
    /// root.
    fn lay(self, place: usize, top: &mut Vec<Bvh2Node>, next: &mut usize, grown: &mut Vec<Move>) {
        match self {
            Self::Fork(bounds, below) => {
                let first = top.len();
                top[place] = Bvh2Node::new(bounds, 0, first as u32);
                top.extend([Bvh2Node::default(); 2]);
                let [left, right] = *below;
                left.lay(first, top, next, grown);
                right.lay(first + 1, top, next, grown);
            }
            Self::Grown(nodes) => {
                // The first that is no root comes to the place `next`.
                let by = *next as u32 - 1;
                let mut nodes = nodes.into_iter();
                top[place] = moved(nodes.next().expect("a root"), by);
                *next += nodes.len();
                grown.push((nodes, by));
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
