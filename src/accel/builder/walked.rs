//! A tree that a library built, as it is walked, in the form of the other builders' trees.
//!
//! Of the library's tree only its form is taken: which primitives a node parts in which two halves. Boxes are unions
//! of the primitives' own, so that a ray meets what it meets in the tree of any other builder, and hits are equal to
//! the bit. Beyond a depth that trees over usual boxes do not have, primitives are halved by number, as by the
//! builders of this project: over boxes that shrink towards a point a library's tree may be a chain.

use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::node::Bvh2Node;

use crate::math::NONE;

use super::super::BuildStages;
use super::{Boxed, USUAL_DEPTH};

/// The largest coordinate that is shown to a library: squares of lengths are numbers of single precision.
const LARGEST: f32 = 1e18;

/// A node with two below it, in a walk.
pub(super) const FORK: u32 = NONE;

/// The corners of a box as they are shown to a library: what is not finite, or not a number, or too large for the
/// areas that it computes, is moved to where it can compute.
pub(super) fn shown(bounds: &Aabb) -> [[f32; 3]; 2] {
    let near = |c: f32| if c.is_nan() { 0.0 } else { c.clamp(-LARGEST, LARGEST) };
    [bounds.min, bounds.max].map(|corner| corner.to_array().map(near))
}

/// Builds a tree over at least one primitive by the walk through a library's, which it makes over the boxes.
pub(super) fn build(
    primitives: &dyn Boxed,
    walk: fn(&[Aabb]) -> Vec<u32>,
    stages: &mut BuildStages,
) -> Bvh2 {
    let boxes = stages.time("boxes", || primitives.obvhs_boxes());
    stages.time("tree", || tree(&walk(&boxes), &boxes))
}

/// The tree of a walk that goes to a node before those below it, and to all on its left before those on its right: of
/// each node [`FORK`], of each leaf the index of its primitive. There is at least one primitive.
///
/// # Panics
/// If the walk has not each of the primitives in a leaf: the library has lost some.
fn tree(walk: &[u32], boxes: &[Aabb]) -> Bvh2 {
    assert_eq!(walk.len(), 2 * boxes.len() - 1, "a leaf for each primitive");
    let mut steps = walk.iter().copied();
    let mut step = || steps.next().expect("each fork has two below it");
    let mut nodes = Vec::with_capacity(walk.len());
    nodes.push(Bvh2Node::default());
    let mut order = Vec::with_capacity(boxes.len());
    // Nodes that are still to be placed, and how deep they are.
    let mut open = vec![(0, 0)];
    while let Some((place, depth)) = open.pop() {
        match step() {
            FORK if depth < USUAL_DEPTH => {
                let below = fork(&mut nodes, place);
                open.extend([(below + 1, depth + 1), (below, depth + 1)]);
            }
            FORK => {
                let first = order.len();
                let mut subtrees = 2;
                while subtrees > 0 {
                    match step() {
                        FORK => subtrees += 1,
                        primitive => {
                            order.push(primitive);
                            subtrees -= 1;
                        }
                    }
                }
                halve(&mut nodes, place, &order, first, boxes);
            }
            primitive => {
                nodes[place] = Bvh2Node::new(boxes[primitive as usize], 1, order.len() as u32);
                order.push(primitive);
            }
        }
    }
    assert_eq!(order.len(), boxes.len(), "a leaf for each primitive");
    // Those below a node stand behind it.
    for place in (0..nodes.len()).rev() {
        let node = nodes[place];
        if !node.is_leaf() {
            let below = node.first_index as usize;
            let around = nodes[below].aabb().union(nodes[below + 1].aabb());
            nodes[place] = Bvh2Node::new(around, 0, node.first_index);
        }
    }
    Bvh2 { nodes, primitive_indices: order, ..Bvh2::default() }
}

/// Makes a node one with two below it, which are put behind all others, and tells where.
fn fork(nodes: &mut Vec<Bvh2Node>, place: usize) -> usize {
    let below = nodes.len();
    nodes.extend([Bvh2Node::default(); 2]);
    nodes[place] = Bvh2Node::new(Aabb::default(), 0, below as u32);
    below
}

/// Puts a tree over the last primitives of the order to a place.
fn halve(nodes: &mut Vec<Bvh2Node>, place: usize, order: &[u32], first: usize, boxes: &[Aabb]) {
    let mut open = vec![(place, first..order.len())];
    while let Some((place, part)) = open.pop() {
        if part.len() == 1 {
            let bounds = boxes[order[part.start] as usize];
            nodes[place] = Bvh2Node::new(bounds, 1, part.start as u32);
            continue;
        }
        let below = fork(nodes, place);
        let middle = part.start + part.len() / 2;
        open.extend([(below + 1, middle..part.end), (below, part.start..middle)]);
    }
}

#[cfg(test)]
mod tests {
    use glam::Vec3A;

    use super::*;

    fn boxes(count: u32) -> Vec<Aabb> {
        let at = |i: u32| Vec3A::splat(i as f32);
        (0..count).map(|i| Aabb { min: at(i), max: at(i + 1) }).collect()
    }

    /// The leaves from the left to the right: their primitive and their depth. Each node has the box around both below.
    fn leaves(tree: &Bvh2) -> Vec<(u32, u32)> {
        let (mut open, mut leaves) = (vec![(0, 0)], Vec::new());
        while let Some((place, depth)) = open.pop() {
            let node = &tree.nodes[place as usize];
            let first = node.first_index;
            if node.is_leaf() {
                leaves.push((tree.primitive_indices[first as usize], depth));
                continue;
            }
            let [a, b] = [first, first + 1].map(|below| *tree.nodes[below as usize].aabb());
            assert_eq!(*node.aabb(), a.union(&b));
            open.extend([(first + 1, depth + 1), (first, depth + 1)]);
        }
        leaves
    }

    #[test]
    fn a_walk_is_a_tree_of_the_same_form() {
        let of = |walk: &[u32]| leaves(&tree(walk, &boxes(walk.len() as u32 / 2 + 1)));
        assert_eq!(of(&[0]), [(0, 0)]);
        assert_eq!(of(&[FORK, 1, 0]), [(1, 1), (0, 1)]);
        let walk = [FORK, FORK, 3, FORK, 1, 0, FORK, 2, 4];
        assert_eq!(of(&walk), [(3, 2), (1, 3), (0, 3), (2, 2), (4, 2)]);
    }

    #[test]
    fn a_chain_ends_in_halves() {
        let count = 100_000;
        let to_the_right = (0..count - 1).flat_map(|one| [FORK, one]).chain([count - 1]);
        let to_the_left = (0..count - 1).map(|_| FORK).chain(0..count);
        for walk in [to_the_right.collect(), to_the_left.collect::<Vec<_>>()] {
            let tree = tree(&walk, &boxes(count));
            assert_eq!(tree.nodes.len(), walk.len());
            let leaves = leaves(&tree);
            assert!(leaves.iter().map(|leaf| leaf.0).eq(0..count));
            let deepest = leaves.iter().map(|leaf| leaf.1).max();
            assert_eq!(deepest, Some(USUAL_DEPTH + (count - USUAL_DEPTH).ilog2() + 1));
        }
    }

    #[test]
    #[should_panic(expected = "a leaf for each primitive")]
    fn a_primitive_that_a_library_loses_is_seen() {
        tree(&[FORK, 1, 0], &boxes(3));
    }

    #[test]
    fn what_is_no_length_is_shown_as_one() {
        let bounds = Aabb {
            min: Vec3A::new(f32::NEG_INFINITY, -2.0, f32::NAN),
            max: Vec3A::new(f32::INFINITY, f32::MAX, 3.0),
        };
        assert_eq!(shown(&bounds), [[-LARGEST, -2.0, 0.0], [LARGEST, LARGEST, 3.0]]);
    }
}
