//! Refitting: primitives have moved, and the boxes of a tree follow them. Its nodes and slots stay as they are.
//!
//! The boxes of leaves are made anew from those of their primitives, as a build makes them, and those above are the
//! unions of what is below, to the bit. So a tree that was refitted keeps the contract of [`Accel`](super::Accel) as a
//! new one does; only how well it parts the primitives becomes worse as they move. Where few have moved, only the paths
//! from their leaves to the root are gone up.

use std::collections::BinaryHeap;
use std::ops::Range;

use rayon::prelude::*;

use crate::math::Aabb;

/// Which primitives have moved.
#[derive(Clone, Copy, Debug)]
pub enum Moved<'a> {
    /// Any of them.
    All,
    /// Those in some slots, in any order.
    Slots(&'a [u32]),
}

/// What a node has below it.
pub(super) enum Below {
    /// The node of an index, which is larger than that of the node itself.
    Node(usize),
    /// A leaf.
    Slots(Range<u32>),
}

/// A node of a tree of boxes, with a lane for each child.
pub(super) trait FitNode: Send + Sync {
    /// How many lanes there are.
    const WIDTH: usize;

    /// What a lane has below it; slots are counted in blocks of so many. `None` for an empty lane.
    fn below(&self, lane: usize, block: usize) -> Option<Below>;

    /// The box of a child.
    fn child_bounds(&self, lane: usize) -> Aabb;

    /// Gives a child its box.
    fn fit(&mut self, lane: usize, bounds: &Aabb);

    /// What follows from the boxes of all children.
    fn settle(&mut self) {}

    /// The box around all children.
    fn bounds(&self) -> Aabb {
        (0..Self::WIDTH).map(|lane| self.child_bounds(lane)).fold(Aabb::EMPTY, Aabb::union)
    }
}

/// Nodes that a thread takes together.
pub(super) const CHUNK: usize = 1 << 9;

/// A tree whose boxes can follow its primitives.
pub(super) struct Fit<'a, N> {
    /// The root is the first, and there is one.
    pub(super) nodes: &'a mut [N],
    /// Slots from the beginning of one block to that of the next.
    pub(super) block: usize,
    /// The way up, once it was needed.
    pub(super) paths: &'a mut Option<Paths>,
}

impl<N: FitNode> Fit<'_, N> {
    /// Lets the boxes follow. `fit_leaves` does so for the leaves of some nodes, `fit_inner` for all other children,
    /// the last nodes first; `bounds_of` is the box of a leaf. Returns the box around all.
    pub(super) fn follow(
        self,
        moved: Moved<'_>,
        bounds_of: impl Fn(Range<u32>) -> Aabb,
        fit_leaves: impl Fn(&mut [N]) + Send + Sync,
        fit_inner: impl FnOnce(&mut [N]),
    ) -> Aabb {
        /// For so many slots a node it is no more work to go through all.
        const MANY: usize = 4;
        match moved {
            Moved::Slots(slots) if MANY * slots.len() < self.nodes.len() => {
                self.follow_some(slots, bounds_of)
            }
            Moved::Slots(_) | Moved::All => {
                self.nodes.par_chunks_mut(CHUNK).for_each(fit_leaves);
                fit_inner(self.nodes);
                let settle = |nodes: &mut [N]| nodes.iter_mut().for_each(N::settle);
                self.nodes.par_chunks_mut(CHUNK).for_each(settle);
                self.nodes[0].bounds()
            }
        }
    }

    /// Goes up from the leaves of some slots, as far as boxes change.
    fn follow_some(self, slots: &[u32], bounds_of: impl Fn(Range<u32>) -> Aabb) -> Aabb {
        let Self { nodes, block, paths } = self;
        let paths = paths.get_or_insert_with(|| Paths::of(nodes, block));
        let mut leaves: Vec<u32> = slots.iter().map(|&slot| paths.leaves[slot as usize]).collect();
        leaves.sort_unstable();
        leaves.dedup();
        // Nodes of which a child's box has changed, those with the largest index first: each comes up behind all below.
        let mut changed = BinaryHeap::new();
        for leaf in leaves {
            let (node, lane) = place::<N>(leaf);
            if let Some(Below::Slots(slots)) = nodes[node].below(lane, block) {
                fit_if_other(nodes, (node, lane), &bounds_of(slots), &mut changed);
            }
        }
        while let Some(index) = changed.pop() {
            // Several of its children may have changed.
            if changed.peek() == Some(&index) {
                continue;
            }
            nodes[index].settle();
            if index > 0 {
                let bounds = nodes[index].bounds();
                fit_if_other(nodes, place::<N>(paths.parents[index]), &bounds, &mut changed);
            }
        }
        nodes[0].bounds()
    }
}

fn fit_if_other<N: FitNode>(
    nodes: &mut [N],
    (node, lane): (usize, usize),
    bounds: &Aabb,
    changed: &mut BinaryHeap<usize>,
) {
    if nodes[node].child_bounds(lane) != *bounds {
        nodes[node].fit(lane, bounds);
        changed.push(node);
    }
}

/// The boxes of inner children, from the last node to the first.
pub(super) fn fit_inner<N: FitNode>(nodes: &mut [N], block: usize) {
    for index in (0..nodes.len()).rev() {
        for lane in 0..N::WIDTH {
            if let Some(Below::Node(child)) = nodes[index].below(lane, block) {
                let bounds = nodes[child].bounds();
                nodes[index].fit(lane, &bounds);
            }
        }
    }
}

/// The boxes of the leaves of some nodes.
pub(super) fn fit_leaves<N: FitNode>(
    nodes: &mut [N],
    block: usize,
    bounds_of: impl Fn(Range<u32>) -> Aabb,
) {
    for node in nodes {
        for lane in 0..N::WIDTH {
            if let Some(Below::Slots(slots)) = node.below(lane, block) {
                node.fit(lane, &bounds_of(slots));
            }
        }
    }
}

/// The way up a tree: where each node, and each slot, hangs. A place is the index of a node times its lanes, plus the
/// lane.
#[derive(Clone, Debug, Default)]
pub(super) struct Paths {
    parents: Vec<u32>,
    leaves: Vec<u32>,
}

fn place<N: FitNode>(place: u32) -> (usize, usize) {
    (place as usize / N::WIDTH, place as usize % N::WIDTH)
}

impl Paths {
    fn of<N: FitNode>(nodes: &[N], block: usize) -> Self {
        let mut paths = Self { parents: vec![0; nodes.len()], leaves: Vec::new() };
        for (index, node) in nodes.iter().enumerate() {
            for lane in 0..N::WIDTH {
                let place = u32::try_from(index * N::WIDTH + lane).expect("places fit in 32 bits");
                match node.below(lane, block) {
                    Some(Below::Node(child)) => paths.parents[child] = place,
                    Some(Below::Slots(slots)) => {
                        let end = slots.end as usize;
                        paths.leaves.resize(end.max(paths.leaves.len()), 0);
                        paths.leaves[slots.start as usize..end].fill(place);
                    }
                    None => {}
                }
            }
        }
        paths
    }

    /// The memory that it takes.
    pub(super) fn bytes(&self) -> usize {
        size_of::<u32>() * (self.parents.capacity() + self.leaves.capacity())
    }
}
