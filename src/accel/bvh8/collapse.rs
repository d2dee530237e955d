//! From a binary tree to nodes of eight children, as `plan.rs` has chosen.
//!
//! The top of the wide tree is laid out first, level by level, down to a fixed number of subtrees.
//! These are laid out in parallel, each with its nodes and slots counted from 0, and then put
//! behind each other. So nothing depends on the number of threads.

use std::collections::VecDeque;

use obvhs::bvh2::Bvh2;
use rayon::prelude::*;

use crate::math::{Aabb, NONE};
use crate::simd::{Kernel, Simd, concatenated, dispatch};

use super::node::{Child, Node, WIDTH};
use super::plan::{Leaves, Plan, Roots, pair};

/// The most subtrees that are laid out in parallel, and binary nodes for which there is one.
const SUBTREES: usize = 512;
const NODES_OF_SUBTREE: usize = 1024;

/// A wide tree, or a part of one: its nodes, and the primitives in slots.
#[derive(Default)]
pub(super) struct Wide {
    /// Children behind their parents; the root is the first.
    pub(super) nodes: Vec<Node>,
    pub(super) order: Vec<u32>,
}

/// A binary node that becomes a wide one.
struct Open {
    binary: u32,
    /// The place of the wide one.
    place: usize,
    /// Half of its surface.
    area: f32,
}

/// Lays out a tree whose leaves hold no more primitives than a leaf may.
pub(super) fn collapse(tree: &Bvh2, plan: &Plan, leaves: Leaves) -> Wide {
    let layout = Layout { tree, plan, leaves };
    let (top, open) = layout.top();
    let subtree = |open: &Open| dispatch(LayOut { layout: &layout, binary: open.binary });
    let subtrees: Vec<_> = open.par_iter().map(subtree).collect();
    top.with_subtrees(&open, &subtrees, leaves.block)
}

/// What a layout is made from.
struct Layout<'a> {
    tree: &'a Bvh2,
    plan: &'a Plan<'a>,
    leaves: Leaves,
}

/// A root, and what is below it, counted from where that begins.
struct Subtree {
    root: Node,
    below: Wide,
}

impl Layout<'_> {
    /// The top of the tree, and the nodes in it that are still open.
    fn top(&self) -> (Wide, Vec<Open>) {
        let mut wide = Wide { nodes: vec![Node::EMPTY], order: Vec::new() };
        let mut open = VecDeque::from([Open { binary: 0, place: 0, area: 0.0 }]);
        let subtrees = SUBTREES.min(self.tree.nodes.len() / NODES_OF_SUBTREE + 1);
        while open.len() < subtrees
            && let Some(Open { binary, place, .. }) = open.pop_front()
        {
            let mut below = Vec::new();
            let node = LayOutNode { layout: self, binary, wide: &mut wide, open: &mut below };
            wide.nodes[place] = dispatch(node);
            open.extend(below);
        }
        (wide, open.into())
    }

    /// A wide node. Its leaves are added to `wide`, and so are places for its inner children, which
    /// join the open ones.
    #[inline(always)]
    fn node<S: Simd>(&self, binary: u32, wide: &mut Wide, open: &mut Vec<Open>) -> Node {
        let mut roots = Roots::new();
        self.plan.children(binary, &mut roots);
        let mut node = Node::EMPTY;
        for (lane, &root) in roots.iter().enumerate() {
            let child = if self.plan.is_leaf(root) {
                self.leaf(root, wide)
            } else {
                wide.nodes.push(Node::EMPTY);
                let area = self.tree.nodes[root as usize].aabb().half_area();
                open.push(Open { binary: root, place: wide.nodes.len() - 1, area });
                Child::node(wide.nodes.len() - 1)
            };
            node.set(lane, child, &self.bounds(root));
        }
        node.sort_with::<S>();
        node
    }

    /// Puts the primitives below a binary node into a leaf, in ascending order: of equal hits in a
    /// pack, the first lane is then the first primitive.
    #[inline(always)]
    fn leaf(&self, root: u32, wide: &mut Wide) -> Child {
        let (mut primitives, mut count) = ([NONE; WIDTH], 0);
        self.gather(root, &mut primitives, &mut count);
        sort_eight(&mut primitives);
        let (start, block) = (wide.order.len(), self.leaves.block);
        wide.order.extend_from_slice(&primitives[..count.next_multiple_of(block)]);
        Child::leaf(start / block, count)
    }

    /// Adds the primitives below a binary node to a list that has room for them.
    fn gather(&self, root: u32, list: &mut [u32; WIDTH], count: &mut usize) {
        let node = &self.tree.nodes[root as usize];
        if node.is_leaf() {
            let (first, own) = (node.first_index as usize, node.prim_count as usize);
            let primitives = &self.tree.primitive_indices[first..first + own];
            for (to, from) in list[*count..].iter_mut().zip(primitives) {
                *to = *from;
            }
            *count += own;
        } else {
            let [left, right] = pair(self.tree, root);
            self.gather(left, list, count);
            self.gather(right, list, count);
        }
    }

    #[inline(always)]
    fn bounds(&self, node: u32) -> Aabb {
        let obvhs::aabb::Aabb { min, max } = *self.tree.nodes[node as usize].aabb();
        Aabb { min, max }
    }
}

/// A wide node by itself.
struct LayOutNode<'a> {
    layout: &'a Layout<'a>,
    binary: u32,
    wide: &'a mut Wide,
    open: &'a mut Vec<Open>,
}

impl Kernel for LayOutNode<'_> {
    type Output = Node;

    #[inline(always)]
    fn run<S: Simd>(self) -> Node {
        self.layout.node::<S>(self.binary, self.wide, self.open)
    }
}

/// A wide node and all below it.
struct LayOut<'a> {
    layout: &'a Layout<'a>,
    binary: u32,
}

impl Kernel for LayOut<'_> {
    type Output = Subtree;

    #[inline(always)]
    fn run<S: Simd>(self) -> Subtree {
        let Self { layout, binary } = self;
        let mut below = Wide::default();
        let mut open = Vec::new();
        let root = layout.node::<S>(binary, &mut below, &mut open);
        while let Some(Open { binary, place, .. }) = open.pop() {
            let first = open.len();
            below.nodes[place] = layout.node::<S>(binary, &mut below, &mut open);
            // Large children are visited most: they come next, and their nodes lie near.
            open[first..].sort_by(|a, b| a.area.total_cmp(&b.area));
        }
        Subtree { root, below }
    }
}

/// Sorts eight numbers by nineteen comparisons, the same whatever the numbers are: without a branch.
#[inline(always)]
fn sort_eight(list: &mut [u32; 8]) {
    // Written out, because the compiler does not unroll a loop over a table of them.
    let mut sort = |a: usize, b: usize| {
        (list[a], list[b]) = (list[a].min(list[b]), list[a].max(list[b]));
    };
    sort(0, 2);
    sort(1, 3);
    sort(4, 6);
    sort(5, 7);
    sort(0, 4);
    sort(1, 5);
    sort(2, 6);
    sort(3, 7);
    sort(0, 1);
    sort(2, 3);
    sort(4, 5);
    sort(6, 7);
    sort(2, 4);
    sort(3, 5);
    sort(1, 4);
    sort(3, 6);
    sort(1, 2);
    sort(3, 4);
    sort(5, 6);
}

impl Wide {
    /// With subtrees behind it, and their roots in their places.
    fn with_subtrees(mut self, open: &[Open], subtrees: &[Subtree], block: usize) -> Self {
        // The subtrees, and by how many nodes and blocks each moves.
        let mut moved = Vec::with_capacity(subtrees.len());
        let (mut nodes, mut blocks) = (self.nodes.len(), self.order.len() / block);
        for (&Open { place, .. }, Subtree { root, below }) in open.iter().zip(subtrees) {
            self.nodes[place] = root.moved(nodes, blocks);
            moved.push((below, nodes, blocks));
            nodes += below.nodes.len();
            blocks += below.order.len() / block;
        }
        let parts = || std::iter::once((&self, 0, 0)).chain(moved.iter().copied());
        let nodes = parts().map(|(part, nodes, blocks)| {
            part.nodes.iter().map(move |node| node.moved(nodes, blocks))
        });
        let order = parts().map(|(part, ..)| part.order.iter().copied());
        Self { nodes: concatenated(nodes.collect()), order: concatenated(order.collect()) }
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::math::Random;
    use glam::Vec3A;
    use obvhs::BvhBuildParams;

    pub(in super::super) fn tree_of(count: u32) -> Bvh2 {
        let mut random = Random::new(&[5, u64::from(count)]);
        let boxes: Vec<_> = (0..count)
            .map(|_| {
                let at = Vec3A::from_array(std::array::from_fn(|_| random.next_f32()));
                obvhs::aabb::Aabb { min: at, max: at + 0.05 * random.next_f32() }
            })
            .collect();
        let parameters = BvhBuildParams { max_prims_per_leaf: 1, ..BvhBuildParams::medium_build() };
        obvhs::bvh2::builder::build_bvh2(&boxes, parameters, &mut std::time::Duration::default())
    }

    fn wide_of(tree: &Bvh2, leaves: Leaves) -> Wide {
        collapse(tree, &Plan::new(tree, leaves), leaves)
    }

    #[test]
    fn every_primitive_is_in_one_leaf_within_all_boxes_above() {
        for (count, leaves) in [
            (1, Leaves { most: 8, block: 8 }),
            (2, Leaves { most: 1, block: 1 }),
            (9, Leaves { most: 8, block: 8 }),
            (1000, Leaves { most: 8, block: 8 }),
            (1000, Leaves { most: 3, block: 1 }),
            (40_000, Leaves { most: 8, block: 8 }),
            (10_000, Leaves { most: 1, block: 1 }),
        ] {
            let wide = wide_of(&tree_of(count), leaves);
            let mut seen: Vec<_> =
                wide.order.iter().copied().filter(|&slot| slot != NONE).collect();
            seen.sort_unstable();
            assert_eq!(seen, (0..count).collect::<Vec<_>>());
            let mut slots = 0;
            for (index, node) in wide.nodes.iter().enumerate() {
                for (lane, child) in node.present() {
                    if child.is_leaf() {
                        let first = child.block() * leaves.block;
                        let range = first..first + child.count() as usize;
                        assert!(child.count() <= leaves.most);
                        assert!(wide.order[range].is_sorted());
                        slots += child.count();
                    } else {
                        assert!(child.index() > index, "children are behind their parents");
                        let inner = &wide.nodes[child.index()];
                        for (below, _) in inner.present() {
                            let (outer, inner) =
                                (node.child_bounds(lane), inner.child_bounds(below));
                            assert_eq!(outer.union(inner), outer);
                        }
                    }
                }
            }
            assert_eq!(slots, count);
        }
    }

    #[test]
    fn eight_numbers_are_sorted() {
        // Comparisons that sort all zeros and ones sort everything.
        for ones in 0..256u32 {
            let mut list = std::array::from_fn(|place| ones >> place & 1);
            sort_eight(&mut list);
            assert!(list.is_sorted() && list.iter().sum::<u32>() == ones.count_ones());
        }
    }

    #[test]
    fn one_thread_and_several_lay_out_the_same() {
        let tree = tree_of(30_000);
        let on = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
            let wide = || wide_of(&tree, Leaves { most: 8, block: 8 });
            pool.expect("a pool").install(wide)
        };
        let (one, three) = (on(1), on(3));
        assert_eq!(one.order, three.order);
        assert_eq!(one.nodes, three.nodes);
    }
}
