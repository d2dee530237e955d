//! The boxes of a structure, shown for measures of quality. No ray goes through here.

use std::ops::Range;

use crate::math::Aabb;

/// A tree of boxes in the order of a walk: parents before their children, first children first.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tree {
    nodes: Vec<TreeNode>,
}

/// A node of a [`Tree`].
#[derive(Clone, Debug, PartialEq)]
pub struct TreeNode {
    /// The box that rays are tested against before they enter; the root's is that around all, and not
    /// tested.
    pub bounds: Aabb,
    /// The slots of a leaf; empty for an inner node.
    pub slots: Range<u32>,
    /// How many children an inner node has; 0 for a leaf.
    pub children: u32,
    /// The place behind the last node below this one.
    pub end: usize,
}

impl Tree {
    /// Walks a structure from its root. `show` gives the box and the slots of a node, and adds its
    /// children, the first one first, to the list that it is given.
    #[must_use]
    pub fn of<N>(root: N, mut show: impl FnMut(&N, &mut Vec<N>) -> (Aabb, Range<u32>)) -> Self {
        let mut nodes = Vec::new();
        let mut open = vec![Step::Enter(root)];
        let mut children = Vec::new();
        while let Some(step) = open.pop() {
            match step {
                Step::Enter(node) => {
                    let (bounds, slots) = show(&node, &mut children);
                    open.push(Step::Leave(nodes.len()));
                    nodes.push(TreeNode { bounds, slots, children: children.len() as u32, end: 0 });
                    open.extend(children.drain(..).rev().map(Step::Enter));
                }
                Step::Leave(index) => nodes[index].end = nodes.len(),
            }
        }
        Self { nodes }
    }

    /// All nodes, the root first.
    #[must_use]
    pub fn nodes(&self) -> &[TreeNode] {
        &self.nodes
    }

    /// The slots of all leaves, each with the place of its leaf among the nodes.
    pub fn slots(&self) -> impl Iterator<Item = (u32, usize)> {
        self.nodes.iter().enumerate().flat_map(|(i, node)| node.slots.clone().map(move |s| (s, i)))
    }
}

/// What is still to be done of a walk.
enum Step<N> {
    Enter(N),
    Leave(usize),
}

impl TreeNode {
    /// The cost of a ray that enters: 1 for each test of a child's box or of a primitive, as in
    /// [`StructureShape::sah_cost`](super::StructureShape::sah_cost).
    #[must_use]
    pub fn cost(&self) -> f64 {
        f64::from(self.children) + self.slots.len() as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nodes_stand_in_the_order_of_a_walk() {
        // A node is its number; those below 3 have two children.
        let tree = Tree::of(0u32, |&node, children| {
            if node < 3 {
                children.extend([2 * node + 1, 2 * node + 2]);
                return (Aabb::EMPTY, 0..0);
            }
            (Aabb::EMPTY, node..node + 1)
        });
        let ends: Vec<usize> = tree.nodes().iter().map(|node| node.end).collect();
        assert_eq!(ends, [7, 4, 3, 4, 7, 6, 7]);
        let slots: Vec<(u32, usize)> = tree.slots().collect();
        assert_eq!(slots, [(3, 2), (4, 3), (5, 5), (6, 6)]);
        assert_eq!((tree.nodes()[0].cost(), tree.nodes()[2].cost()), (2.0, 1.0));
    }
}
