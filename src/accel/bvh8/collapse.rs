//! From a binary tree to nodes of eight children: the cheapest of all collapses.
//!
//! Which nodes of a binary tree become nodes of a wide one, which are swallowed by their ancestors
//! and which become leaves is chosen by dynamic programming on the surface area heuristic: for
//! every binary node and every number of roots, the cheapest forest that stands for it. After
//! Ylitie, Karras, Laine: *Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs*,
//! 2017, section 3.1.

use obvhs::bvh2::Bvh2;

use crate::math::{Aabb, NONE};

use super::node::{Child, Node, WIDTH};

/// Visiting a node costs as much as testing a pack of eight primitives at once; ratios between 0.6
/// and 1.5 give trees of the same speed.
const NODE_COST: f32 = 1.0;
const PACK_COST: f32 = 1.0;

/// How primitives may be put into leaves.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leaves {
    /// The most primitives in a leaf, up to 8.
    pub(super) most: u32,
    /// Slots between the beginnings of two leaves: 8 where packs of eight are tested at once, 1
    /// where primitives are tested one by one.
    pub(super) block: usize,
}

/// A wide tree: its nodes, the first of them the root, and the primitives in slots.
pub(super) struct Wide {
    pub(super) nodes: Vec<Node>,
    pub(super) order: Vec<u32>,
}

/// The cheapest ways to stand for a binary node.
#[derive(Clone, Copy)]
struct Forests {
    /// The cost with at most 1, 2, … 7 roots.
    cost: [f32; WIDTH - 1],
    /// How many of these roots the left child gets; of one root's eight children for the first.
    left: [u8; WIDTH - 1],
}

/// One root: a leaf, in place of a left share.
const LEAF: u8 = 0xff;
/// As many roots are no better than one less.
const ONE_LESS: u8 = 0;

/// Collapses a tree whose leaves are single primitives.
pub(super) fn collapse(tree: &Bvh2, leaves: Leaves) -> Wide {
    let plan = plan(tree, leaves);
    let mut wide = Wide {
        nodes: Vec::with_capacity(tree.nodes.len() / 6 + 1),
        order: Vec::with_capacity(tree.primitive_indices.len() * 5 / 4),
    };
    wide.nodes.push(Node::EMPTY);
    // Binary nodes that become wide ones, and the place of each.
    let mut open = vec![(0, 0)];
    let mut roots = Vec::with_capacity(WIDTH);
    while let Some((binary, place)) = open.pop() {
        roots.clear();
        children_of(tree, &plan, binary, &mut roots);
        let mut node = Node::EMPTY;
        let first_open = open.len();
        for (lane, &root) in roots.iter().enumerate() {
            let child = if is_leaf(tree, &plan, root) {
                wide.add_leaf(tree, root, leaves)
            } else {
                wide.nodes.push(Node::EMPTY);
                open.push((root, wide.nodes.len() - 1));
                Child::node(wide.nodes.len() - 1)
            };
            node.set(lane, child, &bounds(tree, root));
        }
        node.sort();
        wide.nodes[place] = node;
        // Large children are visited most: they come next, and their nodes lie near.
        open[first_open..].sort_by(|(a, _), (b, _)| {
            bounds(tree, *a).half_area().total_cmp(&bounds(tree, *b).half_area())
        });
    }
    wide.order.shrink_to_fit();
    wide.nodes.shrink_to_fit();
    wide
}

impl Wide {
    /// Puts the primitives below a binary node into a leaf, in ascending order: of equal hits in a
    /// pack, the first lane is then the first primitive.
    fn add_leaf(&mut self, tree: &Bvh2, root: usize, leaves: Leaves) -> Child {
        let start = self.order.len();
        let mut open = vec![root];
        while let Some(binary) = open.pop() {
            let node = &tree.nodes[binary];
            if node.is_leaf() {
                let first = node.first_index as usize;
                let range = first..first + node.prim_count as usize;
                self.order.extend_from_slice(&tree.primitive_indices[range]);
            } else {
                open.extend(pair(tree, binary));
            }
        }
        self.order[start..].sort_unstable();
        let count = self.order.len() - start;
        self.order.resize(self.order.len().next_multiple_of(leaves.block), NONE);
        Child::leaf(start / leaves.block, count)
    }
}

fn pair(tree: &Bvh2, node: usize) -> [usize; 2] {
    let left = tree.nodes[node].first_index as usize;
    [left, left + 1]
}

fn bounds(tree: &Bvh2, node: usize) -> Aabb {
    let obvhs::aabb::Aabb { min, max } = *tree.nodes[node].aabb();
    Aabb { min, max }
}

fn is_leaf(tree: &Bvh2, plan: &[Forests], node: usize) -> bool {
    tree.nodes[node].is_leaf() || plan[node].left[0] == LEAF
}

/// The roots of the forest that a node's children are.
fn children_of(tree: &Bvh2, plan: &[Forests], node: usize, roots: &mut Vec<usize>) {
    if is_leaf(tree, plan, node) {
        roots.push(node); // the whole tree is one leaf
        return;
    }
    let [left, right] = pair(tree, node);
    let share = usize::from(plan[node].left[0]);
    add_roots(tree, plan, left, share, roots);
    add_roots(tree, plan, right, WIDTH - share, roots);
}

fn add_roots(tree: &Bvh2, plan: &[Forests], node: usize, count: usize, roots: &mut Vec<usize>) {
    let mut count = count;
    while count > 1 && plan[node].left[count - 1] == ONE_LESS {
        count -= 1;
    }
    if count == 1 || tree.nodes[node].is_leaf() {
        roots.push(node);
        return;
    }
    let [left, right] = pair(tree, node);
    let share = usize::from(plan[node].left[count - 1]);
    add_roots(tree, plan, left, share, roots);
    add_roots(tree, plan, right, count - share, roots);
}

/// The cheapest forests of every node, children before their parents.
fn plan(tree: &Bvh2, leaves: Leaves) -> Vec<Forests> {
    let mut parents_first = Vec::with_capacity(tree.nodes.len());
    let mut open = vec![0];
    while let Some(node) = open.pop() {
        parents_first.push(node);
        if !tree.nodes[node].is_leaf() {
            open.extend(pair(tree, node));
        }
    }
    let none = Forests { cost: [0.0; WIDTH - 1], left: [LEAF; WIDTH - 1] };
    let mut plan = vec![none; tree.nodes.len()];
    let mut counts = vec![0; tree.nodes.len()];
    for &node in parents_first.iter().rev() {
        let area = tree.nodes[node].aabb().half_area();
        let packs = |count: u32| if leaves.block > 1 { 1.0 } else { count as f32 };
        if tree.nodes[node].is_leaf() {
            counts[node] = tree.nodes[node].prim_count;
            plan[node].cost = [area * packs(counts[node]) * PACK_COST; WIDTH - 1];
            continue;
        }
        let [left, right] = pair(tree, node);
        counts[node] = counts[left] + counts[right];
        let fits = counts[node] <= leaves.most;
        let as_leaf = if fits { area * packs(counts[node]) * PACK_COST } else { f32::INFINITY };
        plan[node] = forests(&plan[left], &plan[right], as_leaf, area * NODE_COST);
    }
    plan
}

/// The cheapest forests of a node from those of its children.
fn forests(left: &Forests, right: &Forests, as_leaf: f32, as_node: f32) -> Forests {
    // The cheapest way to part `count` roots among both children, each of which takes 1 to 7.
    let part = |count: usize| {
        let shares = count.saturating_sub(WIDTH - 1).max(1)..count.min(WIDTH);
        shares.fold((f32::INFINITY, ONE_LESS), |best, share| {
            let cost = left.cost[share - 1] + right.cost[count - share - 1];
            if cost < best.0 { (cost, share as u8) } else { best }
        })
    };
    let (below, share) = part(WIDTH);
    let inner = (below + as_node, share);
    let one = if as_leaf <= inner.0 { (as_leaf, LEAF) } else { inner };
    let mut forests = Forests { cost: [one.0; WIDTH - 1], left: [one.1; WIDTH - 1] };
    for count in 2..WIDTH {
        let fewer = forests.cost[count - 2];
        let (cost, share) = part(count);
        let better = cost < fewer;
        forests.cost[count - 1] = if better { cost } else { fewer };
        forests.left[count - 1] = if better { share } else { ONE_LESS };
    }
    forests
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Random;
    use glam::Vec3A;
    use obvhs::BvhBuildParams;

    fn tree_of(count: u32) -> Bvh2 {
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

    #[test]
    fn every_primitive_is_in_one_leaf_within_all_boxes_above() {
        for (count, leaves) in [
            (1, Leaves { most: 8, block: 8 }),
            (2, Leaves { most: 1, block: 1 }),
            (9, Leaves { most: 8, block: 8 }),
            (1000, Leaves { most: 8, block: 8 }),
            (1000, Leaves { most: 3, block: 1 }),
        ] {
            let tree = tree_of(count);
            let wide = collapse(&tree, leaves);
            let mut seen: Vec<_> =
                wide.order.iter().copied().filter(|&slot| slot != NONE).collect();
            seen.sort_unstable();
            assert_eq!(seen, (0..count).collect::<Vec<_>>());
            let mut slots = 0;
            for node in &wide.nodes {
                for (lane, child) in node.present() {
                    if child.is_leaf() {
                        let first = child.block() * leaves.block;
                        let range = first..first + child.count() as usize;
                        assert!(child.count() <= leaves.most);
                        assert!(wide.order[range].is_sorted());
                        slots += child.count();
                    } else {
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

    /// The cost of the cheapest collapse by trying all of them, without memory.
    fn cheapest(tree: &Bvh2, node: usize, roots: usize) -> f32 {
        let area = tree.nodes[node].aabb().half_area();
        if tree.nodes[node].is_leaf() {
            return area * PACK_COST;
        }
        let [left, right] = pair(tree, node);
        let part = |count: usize| {
            (1..count)
                .filter(|&share| share < WIDTH && count - share < WIDTH)
                .map(|share| cheapest(tree, left, share) + cheapest(tree, right, count - share))
                .fold(f32::INFINITY, f32::min)
        };
        let mut best = area * NODE_COST + part(WIDTH);
        for count in 2..=roots {
            best = best.min(part(count));
        }
        best
    }

    #[test]
    fn no_collapse_is_cheaper() {
        let tree = tree_of(12);
        // Leaves of one primitive, so that inner nodes alone are chosen.
        let plan = plan(&tree, Leaves { most: 1, block: 8 });
        for roots in 1..WIDTH {
            let (found, all) = (plan[0].cost[roots - 1], cheapest(&tree, 0, roots));
            assert!((found - all).abs() <= 1e-5 * all, "{roots} roots: {found} and {all}");
        }
    }
}
