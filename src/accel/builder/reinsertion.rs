//! Subtrees of a binary tree put elsewhere, where that makes the surfaces of its nodes smaller together.
//!
//! After Meister, Bittner: *Parallel Reinsertion for Bounding Volume Hierarchy Optimization*, 2018. The search for the
//! best place of a subtree is obvhs's, and so is the reinsertion of a share of all nodes, again and again. The largest
//! nodes alone are reinserted here: they are what most rays meet, and what a build from the top chooses with the least
//! knowledge of what is below.

use std::collections::{BTreeSet, BinaryHeap};

use obvhs::bvh2::Bvh2;
use obvhs::bvh2::node::Bvh2Node;
use obvhs::bvh2::reinsertion::{
    Reinsertion, ReinsertionOptimizer, find_reinsertion, reinsert_node,
};
use rayon::prelude::*;

use super::super::BuildStages;

/// So many nodes, those with the largest surfaces, are sought a better place for.
const LARGEST: usize = 1000;

/// But no more than one of so many: a small tree is built quickly, and gains as much from as small a part of it.
const ONE_OF: usize = 16;

/// The most rounds of that. On scans no node finds a better place after four.
const ROUNDS: usize = 8;

/// Improves a tree by reinserting a share of its nodes again and again.
pub(in super::super) fn reinsert(tree: &mut Bvh2, share: f32, stages: &mut BuildStages) {
    if share > 0.0 {
        stages.time("reinsertion", || ReinsertionOptimizer::default().run(tree, share, None));
    }
}

/// Improves a tree by reinserting its largest nodes, until none finds a better place.
pub(super) fn reinsert_largest(tree: &mut Bvh2, stages: &mut BuildStages) {
    stages.time("reinsertion", || {
        tree.init_parents_if_uninit();
        tree.children_are_ordered_after_parents = false;
        for _ in 0..ROUNDS {
            if !reinsert_once(tree) {
                break;
            }
        }
    });
}

/// Reinserts those of the largest nodes that find a better place. Returns whether there were any.
fn reinsert_once(tree: &mut Bvh2) -> bool {
    let largest = largest(tree);
    let found = largest.par_iter().map(|&node| find_reinsertion(tree, node as usize));
    let mut found: Vec<Reinsertion> = found.filter(|found| found.area_diff > 0.0).collect();
    // The best come first; no two are of the same node, so that the order is one.
    found.sort_unstable_by(|a, b| b.area_diff.total_cmp(&a.area_diff).then(a.from.cmp(&b.from)));
    let mut touched = BTreeSet::new();
    for &Reinsertion { from, to, .. } in &found {
        // What is known of a place holds as long as the nodes beside it have not moved.
        let parent = |node: u32| tree.parents[node as usize];
        let beside = [to, from, Bvh2Node::get_sibling_id32(from), parent(to), parent(from)];
        if beside.iter().all(|node| !touched.contains(node)) {
            touched.extend(beside);
            reinsert_node(tree, from as usize, to as usize);
        }
    }
    !found.is_empty()
}

/// The nodes with the largest surfaces, but for the root. No node has a larger one than that above it, so they are
/// found from the top.
fn largest(tree: &Bvh2) -> Vec<u32> {
    // Surfaces are positive: their bits are in the same order.
    let entry = |node: u32| (tree.nodes[node as usize].aabb().half_area().to_bits(), node);
    let most = LARGEST.min(tree.nodes.len() / ONE_OF);
    let mut largest = Vec::with_capacity(most + 1);
    let mut open = BinaryHeap::from([entry(0)]);
    while largest.len() <= most
        && let Some((_, node)) = open.pop()
    {
        largest.push(node);
        let node = &tree.nodes[node as usize];
        if !node.is_leaf() {
            open.extend([entry(node.first_index), entry(node.first_index + 1)]);
        }
    }
    largest.split_off(1)
}

#[cfg(test)]
mod tests {
    use super::super::super::Quality;
    use super::super::terms::{Effort, Terms};
    use super::super::{Boxes, binned};
    use super::*;
    use crate::math::{Aabb, Random};
    use glam::Vec3A;

    /// A tree over boxes of very different sizes.
    fn tree(count: u32) -> Bvh2 {
        let mut random = Random::new(&[41, u64::from(count)]);
        let mut point = || Vec3A::from_array(std::array::from_fn(|_| random.next_f32()));
        let boxes = (0..count).map(|index| {
            let (at, size) = (point(), if index % 9 == 0 { 1.0 } else { 0.02 });
            Aabb { min: at, max: at + size * point() }
        });
        let terms = Terms { pack_bits: 3, most: 8, effort: Effort::of(Quality::Medium) };
        binned::build(&Boxes(boxes.collect()), terms, &mut BuildStages::default())
    }

    fn areas(tree: &Bvh2) -> f64 {
        tree.nodes.iter().map(|node| f64::from(node.aabb().half_area())).sum()
    }

    /// The leaves below a node, in order; all boxes are around those below.
    fn leaves(tree: &Bvh2, node: u32, found: &mut Vec<(u32, u32)>) {
        let node = &tree.nodes[node as usize];
        if node.is_leaf() {
            found.push((node.first_index, node.prim_count));
            return;
        }
        let children = [node.first_index, node.first_index + 1];
        let [left, right] = children.map(|child| *tree.nodes[child as usize].aabb());
        assert_eq!(*node.aabb(), left.union(&right));
        children.iter().for_each(|&child| leaves(tree, child, found));
    }

    #[test]
    fn trees_become_cheaper_and_keep_their_leaves() {
        for count in [1, 2, 3, 10, 500, 20_000] {
            let before = tree(count);
            let mut after = before.clone();
            reinsert_largest(&mut after, &mut BuildStages::default());
            let [old, new] = [&before, &after].map(|tree| {
                let mut found = Vec::new();
                leaves(tree, 0, &mut found);
                found.sort_unstable();
                found
            });
            assert_eq!(old, new);
            assert!(areas(&after) <= areas(&before));
            assert!(count < 500 || areas(&after) < 0.98 * areas(&before), "{count} boxes");
        }
    }

    #[test]
    fn the_largest_nodes_are_those_of_all() {
        for count in [1, 2, 300, 20_000] {
            let tree = tree(count);
            let area = |&node: &u32| tree.nodes[node as usize].aabb().half_area();
            let found: Vec<f32> = largest(&tree).iter().map(area).collect();
            let mut all: Vec<f32> = (1..tree.nodes.len() as u32).map(|node| area(&node)).collect();
            all.sort_unstable_by(|a, b| b.total_cmp(a));
            all.truncate(LARGEST.min(tree.nodes.len() / ONE_OF));
            assert_eq!(found, all);
        }
    }

    #[test]
    fn the_number_of_threads_changes_nothing() {
        let on = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
            let mut tree = tree(20_000);
            pool.expect("a pool")
                .install(|| reinsert_largest(&mut tree, &mut BuildStages::default()));
            tree.nodes
                .iter()
                .map(|n| (n.aabb().min, n.aabb().max, n.first_index))
                .collect::<Vec<_>>()
        };
        assert_eq!(on(1), on(3));
    }
}
