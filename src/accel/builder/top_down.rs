//! A binary tree with one primitive in each leaf, from the top: all that is left to say is how the
//! primitives of a node are parted in two.
//!
//! Large parts are built in parallel, each into nodes of its own; which thread does it changes nothing.

use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::node::Bvh2Node;

use crate::simd::table;

use super::branch::Branch;

/// Parts of at least so many primitives are built in parallel.
const PARALLEL: usize = 1 << 12;

/// How primitives are parted.
pub(super) trait Division: Sync {
    /// What stands for a primitive.
    type Item: Send + Sync;

    /// Puts those of the first half first, and tells how many they are: at least one of at least two,
    /// and not all.
    fn divide(&self, items: &mut [Self::Item]) -> usize;

    /// The index and the box of a primitive.
    fn leaf(&self, item: &Self::Item) -> (u32, Aabb);
}

/// Builds a tree over at least one primitive.
pub(super) fn build<D: Division>(division: &D, items: &mut [D::Item]) -> Bvh2 {
    let nodes = grow(division, items, 0).into_nodes();
    let primitive_indices =
        table(items.len(), 0, |place, index| *index = division.leaf(&items[place]).0);
    Bvh2 { nodes, primitive_indices, ..Bvh2::default() }
}

/// A node and those below it. The first of its items has a place in the order of the tree.
pub(super) fn grow<D: Division>(division: &D, items: &mut [D::Item], first: u32) -> Branch {
    if items.len() < PARALLEL {
        let mut nodes = Vec::with_capacity(2 * items.len() - 1);
        nodes.push(Bvh2Node::default());
        grow_in_sequence(division, items, first, &mut nodes, 0);
        return Branch::Grown(nodes);
    }
    let count = division.divide(items);
    let (left, right) = items.split_at_mut(count);
    let behind = first + count as u32;
    let (left, right) =
        rayon::join(|| grow(division, left, first), || grow(division, right, behind));
    let bounds = left.bounds().union(&right.bounds());
    Branch::Fork(bounds, Box::new([left, right]))
}

/// A node at a place among others, and those below it behind all of them.
fn grow_in_sequence<D: Division>(
    division: &D,
    items: &mut [D::Item],
    first: u32,
    nodes: &mut Vec<Bvh2Node>,
    place: usize,
) {
    if let [one] = items {
        nodes[place] = Bvh2Node::new(division.leaf(one).1, 1, first);
        return;
    }
    let count = division.divide(items);
    let (left, right) = items.split_at_mut(count);
    let below = nodes.len();
    nodes.extend([Bvh2Node::default(); 2]);
    grow_in_sequence(division, left, first, nodes, below);
    grow_in_sequence(division, right, first + count as u32, nodes, below + 1);
    let bounds = nodes[below].aabb().union(nodes[below + 1].aabb());
    nodes[place] = Bvh2Node::new(bounds, 0, below as u32);
}
