//! Which nodes of a binary tree become nodes of a wide one, and which become leaves.
//!
//! Chosen by dynamic programming: for every binary node and every number of roots, the cheapest forest that
//! can replace it. After Ylitie, Karras, Laine: *Efficient Incoherent Ray Traversal on GPUs Through
//! Compressed Wide BVHs*, 2017, section 3.1. What a node costs is weighed by how many rays meet its box
//! (`meeting.rs`).
//!
//! A node's choices depend on its children's alone, so subtrees are planned in parallel, and how
//! they are shared among threads changes nothing. Costs are forgotten as soon as the parent's are
//! known; what is kept of a node is a word.

use std::sync::atomic::{AtomicU32, Ordering};

use obvhs::bvh2::Bvh2;
use smallvec::SmallVec;

use crate::math::Lanes as _;
use crate::simd::{Kernel, Row as _, Simd, dispatch};

use super::meeting::Meeting;
use super::node::WIDTH;

/// Visiting a node costs as much as testing a pack of eight primitives at once; ratios between 0.6
/// and 1.5 give trees of the same speed.
pub(super) const NODE_COST: f32 = 1.0;
pub(super) const PACK_COST: f32 = 1.0;

/// Down to this depth the children of a node are planned in parallel.
const PARALLEL_DEPTH: u32 = 9;

/// What to do with every node of a binary tree.
pub(super) struct Plan<'a> {
    tree: &'a Bvh2,
    choices: Vec<Choices>,
}

/// How many roots a binary node's left child gets of the node's 1, 2, … 7 roots, four bits each;
/// of the eight children of a single root in the lowest bits.
#[derive(Clone, Copy)]
struct Choices(u32);

/// In the lowest bits: the single root is a leaf.
const LEAF: u32 = 15;
/// As many roots are no better than one less.
const ONE_LESS: u32 = 0;

/// How primitives may be put into leaves.
#[derive(Clone, Copy, Debug)]
pub(super) struct Leaves {
    /// The most primitives in a leaf, up to 8.
    pub(super) most: u32,
    /// Slots between the beginnings of two leaves: 8 where packs of eight are tested at once, 1
    /// where primitives are tested one by one.
    pub(super) block: usize,
}

/// The cheapest replacements of a binary node.
#[derive(Clone, Copy)]
pub(super) struct Forests {
    /// The cost with at most 1, 2, … 7 roots; then infinity.
    pub(super) cost: [f32; WIDTH],
    /// Primitives below the node.
    count: u32,
}

/// Roots of a forest.
pub(super) type Roots = SmallVec<[u32; WIDTH]>;

/// The children of a node of a binary tree.
pub(super) fn pair(tree: &Bvh2, node: u32) -> [u32; 2] {
    let left = tree.nodes[node as usize].first_index;
    [left, left + 1]
}

impl<'a> Plan<'a> {
    /// Plans the collapse of a tree.
    pub(super) fn new(tree: &'a Bvh2, leaves: Leaves) -> Self {
        let blank = || AtomicU32::new(LEAF);
        let planner = Planner {
            tree,
            leaves,
            meeting: Meeting::within(tree.nodes[0].aabb()),
            choices: std::iter::repeat_with(blank).take(tree.nodes.len()).collect(),
        };
        planner.plan(0, 0);
        let choices = planner.choices.into_iter().map(|word| Choices(word.into_inner())).collect();
        Self { tree, choices }
    }

    /// Whether a node stays one root and is a leaf.
    pub(super) fn is_leaf(&self, node: u32) -> bool {
        self.choices[node as usize].left_share(1) == LEAF
    }

    /// The children of the wide node that a binary node becomes; itself if it is a leaf, which a
    /// whole tree can be.
    pub(super) fn children(&self, node: u32, roots: &mut Roots) {
        if self.is_leaf(node) {
            roots.push(node);
            return;
        }
        let share = self.choices[node as usize].left_share(1);
        let [left, right] = pair(self.tree, node);
        self.add_roots(left, share, roots);
        self.add_roots(right, WIDTH as u32 - share, roots);
    }

    /// The roots of a node's forest with at most `count` of them.
    fn add_roots(&self, node: u32, count: u32, roots: &mut Roots) {
        let choices = self.choices[node as usize];
        let fewer = |&count: &u32| count == 1 || choices.left_share(count) != ONE_LESS;
        let count = (1..=count).rev().find(fewer).unwrap_or(1);
        if count == 1 {
            roots.push(node);
            return;
        }
        let share = choices.left_share(count);
        let [left, right] = pair(self.tree, node);
        self.add_roots(left, share, roots);
        self.add_roots(right, count - share, roots);
    }
}

impl Choices {
    /// The left child's share of so many roots.
    fn left_share(self, roots: u32) -> u32 {
        self.0 >> (4 * (roots - 1)) & 15
    }
}

/// A plan in the making. Threads write to words of their own, and read none.
struct Planner<'a> {
    tree: &'a Bvh2,
    leaves: Leaves,
    meeting: Meeting,
    choices: Vec<AtomicU32>,
}

impl Planner<'_> {
    /// Plans a subtree.
    fn plan(&self, node: u32, depth: u32) -> Forests {
        if depth == PARALLEL_DEPTH || self.tree.nodes[node as usize].is_leaf() {
            return dispatch(Sequence { planner: self, root: node });
        }
        let [left, right] = pair(self.tree, node);
        let (left, right) =
            rayon::join(|| self.plan(left, depth + 1), || self.plan(right, depth + 1));
        dispatch(Inner { planner: self, node, left: &left, right: &right })
    }

    #[inline(always)]
    fn leaf(&self, node: u32) -> Forests {
        let node = &self.tree.nodes[node as usize];
        let rays = self.meeting.of(node.aabb());
        let mut cost = [rays * self.packs(node.prim_count) * PACK_COST; WIDTH];
        cost[WIDTH - 1] = f32::INFINITY;
        Forests { cost, count: node.prim_count }
    }

    /// Tests that a leaf takes: one where packs are tested at once.
    #[inline(always)]
    fn packs(&self, primitives: u32) -> f32 {
        if self.leaves.block > 1 { 1.0 } else { primitives as f32 }
    }

    #[inline(always)]
    fn inner<S: Simd>(&self, node: u32, left: &Forests, right: &Forests) -> Forests {
        let rays = self.meeting.of(self.tree.nodes[node as usize].aabb());
        let count = left.count + right.count;
        let fits = count <= self.leaves.most;
        let as_leaf = if fits { rays * self.packs(count) * PACK_COST } else { f32::INFINITY };
        let costs = [&left.cost, &right.cost];
        let (cost, choices) = cheapest::<S>(costs, as_leaf, rays * NODE_COST);
        self.choices[node as usize].store(choices.0, Ordering::Relaxed);
        Forests { cost, count }
    }
}

/// A node whose children are planned.
struct Inner<'a> {
    planner: &'a Planner<'a>,
    node: u32,
    left: &'a Forests,
    right: &'a Forests,
}

impl Kernel for Inner<'_> {
    type Output = Forests;

    #[inline(always)]
    fn run<S: Simd>(self) -> Forests {
        self.planner.inner::<S>(self.node, self.left, self.right)
    }
}

/// A subtree that may be of any depth: without recursion.
struct Sequence<'a> {
    planner: &'a Planner<'a>,
    root: u32,
}

impl Kernel for Sequence<'_> {
    type Output = Forests;

    #[inline(always)]
    fn run<S: Simd>(self) -> Forests {
        let Self { planner, root } = self;
        let mut parents_first = Vec::new();
        let mut open = vec![root];
        while let Some(node) = open.pop() {
            parents_first.push(node);
            if !planner.tree.nodes[node as usize].is_leaf() {
                let [left, right] = pair(planner.tree, node);
                open.push(right);
                open.push(left);
            }
        }
        // Backwards, a node comes after both of its children, the left one last.
        let mut planned: Vec<Forests> = Vec::new();
        for &node in parents_first.iter().rev() {
            let forests = match planner.tree.nodes[node as usize].is_leaf() {
                true => planner.leaf(node),
                false => {
                    let left = planned.pop().expect("the left child was planned");
                    let right = planned.pop().expect("the right child was planned");
                    planner.inner::<S>(node, &left, &right)
                }
            };
            planned.push(forests);
        }
        planned.pop().expect("the root was planned")
    }
}

/// The cheapest forests of a node from those of its children.
#[inline(always)]
fn cheapest<S: Simd>(
    [left, right]: [&[f32; WIDTH]; 2],
    as_leaf: f32,
    as_node: f32,
) -> ([f32; WIDTH], Choices) {
    // The cheapest way to part 1, 2, … 8 roots among both children, a lane for each number: with a
    // share of `share` for the left child, the right one's costs begin so many lanes later.
    let mut padded = [f32::INFINITY; 2 * WIDTH];
    padded[WIDTH..].copy_from_slice(right);
    let (mut least, mut chosen) = (S::F8::splat(f32::INFINITY), S::F8::splat(f32::from_bits(1)));
    for share in 1..WIDTH {
        let right = padded[WIDTH - share..].first_chunk().expect("as many lanes are padded");
        let sum = S::F8::splat(left[share - 1]) + S::F8::load(right);
        let better = sum.lt(least);
        least = sum.select_where(better, least);
        // Bits alone: nothing is computed with them.
        chosen = S::F8::splat(f32::from_bits(share as u32)).select_where(better, chosen);
    }
    let (mut cost, mut shares) = ([0.0; WIDTH], [0.0; WIDTH]);
    least.store(&mut cost);
    chosen.store(&mut shares);
    let inner = cost[WIDTH - 1] + as_node;
    let (one, mut choices) =
        if as_leaf <= inner { (as_leaf, LEAF) } else { (inner, shares[WIDTH - 1].to_bits()) };
    let mut cheapest = [f32::INFINITY; WIDTH];
    cheapest[0] = one;
    for lane in 1..WIDTH - 1 {
        let better = cost[lane] < cheapest[lane - 1];
        cheapest[lane] = if better { cost[lane] } else { cheapest[lane - 1] };
        choices |= (if better { shares[lane].to_bits() } else { ONE_LESS }) << (4 * lane);
    }
    (cheapest, Choices(choices))
}

#[cfg(test)]
mod tests {
    use super::super::collapse::tests::tree_of;
    use super::*;

    /// The cost of the cheapest collapse by trying all of them, without memory.
    fn least(tree: &Bvh2, node: u32, roots: usize) -> f32 {
        let rays = Meeting::within(tree.nodes[0].aabb()).of(tree.nodes[node as usize].aabb());
        if tree.nodes[node as usize].is_leaf() {
            return rays * PACK_COST;
        }
        let [left, right] = pair(tree, node);
        let part = |count: usize| {
            (1..count)
                .filter(|&share| share < WIDTH && count - share < WIDTH)
                .map(|share| least(tree, left, share) + least(tree, right, count - share))
                .fold(f32::INFINITY, f32::min)
        };
        let mut best = rays * NODE_COST + part(WIDTH);
        for count in 2..=roots {
            best = best.min(part(count));
        }
        best
    }

    #[test]
    fn no_collapse_is_cheaper() {
        let tree = tree_of(12);
        // Leaves of one primitive, so that inner nodes alone are chosen.
        let leaves = Leaves { most: 1, block: 8 };
        let choices = tree.nodes.iter().map(|_| AtomicU32::new(LEAF)).collect();
        let meeting = Meeting::within(tree.nodes[0].aabb());
        let planner = Planner { tree: &tree, leaves, meeting, choices };
        let in_sequence = dispatch(Sequence { planner: &planner, root: 0 });
        for forests in [planner.plan(0, 0), in_sequence] {
            for roots in 1..WIDTH {
                let (found, all) = (forests.cost[roots - 1], least(&tree, 0, roots));
                assert!((found - all).abs() <= 1e-5 * all, "{roots} roots: {found} and {all}");
            }
        }
    }
}
