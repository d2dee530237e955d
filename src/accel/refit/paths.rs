//! The way up a tree, for the few primitives that have moved.

use std::collections::BinaryHeap;

use crate::math::Aabb;

use super::{Below, FitNode, Leader};

/// Where each node, and each slot, hangs. A place is the index of a node times its lanes, plus the lane.
#[derive(Clone, Debug, Default)]
pub(super) struct Paths {
    parents: Vec<u32>,
    leaves: Vec<u32>,
}

fn place<N: FitNode>(place: u32) -> (usize, usize) {
    (place as usize / N::WIDTH, place as usize % N::WIDTH)
}

impl Paths {
    pub(super) fn of<N: FitNode>(nodes: &[N], block: usize) -> Self {
        let mut paths = Self { parents: vec![0; nodes.len()], leaves: Vec::new() };
        for (index, node) in nodes.iter().enumerate() {
            for lane in 0..N::WIDTH {
                if let Some(Below::Slots(slots)) = node.below(lane, block) {
                    let end = slots.end as usize;
                    paths.leaves.resize(end.max(paths.leaves.len()), 0);
                }
                paths.note(nodes, (index, lane), block);
            }
        }
        paths
    }

    /// Notes what hangs at a place.
    pub(super) fn note<N: FitNode>(
        &mut self,
        nodes: &[N],
        (index, lane): (usize, usize),
        block: usize,
    ) {
        let place = u32::try_from(index * N::WIDTH + lane).expect("places fit in 32 bits");
        match nodes[index].below(lane, block) {
            Some(Below::Node(child)) => self.parents[child] = place,
            Some(Below::Slots(slots)) => {
                self.leaves[slots.start as usize..slots.end as usize].fill(place);
            }
            None => {}
        }
    }

    /// The memory that it takes.
    pub(super) fn bytes(&self) -> usize {
        size_of::<u32>() * (self.parents.capacity() + self.leaves.capacity())
    }

    /// Goes up from the leaves of some slots, as far as boxes change. Returns the nodes of which a child's box has
    /// changed, each behind all that are below it.
    pub(super) fn follow<N: FitNode>(
        &self,
        nodes: &mut [N],
        slots: &[u32],
        leader: &dyn Leader<N>,
    ) -> Vec<usize> {
        // Empty slots: those behind the last leaf are not noted, and those between leaves stand for the first place,
        // which is then looked at for nothing.
        let leaf_of = |&slot: &u32| self.leaves.get(slot as usize).copied();
        let mut leaves: Vec<u32> = slots.iter().filter_map(leaf_of).collect();
        leaves.sort_unstable();
        leaves.dedup();
        // Those with the largest index first: each comes up behind all below.
        let mut open = BinaryHeap::new();
        for leaf in leaves {
            let (node, lane) = place::<N>(leaf);
            if let Some(Below::Slots(slots)) = nodes[node].below(lane, leader.block()) {
                fit_if_other(nodes, (node, lane), &leader.bounds(slots), &mut open);
            }
        }
        let mut changed = Vec::new();
        while let Some(index) = open.pop() {
            // Several of its children may have changed.
            if open.peek() == Some(&index) {
                continue;
            }
            nodes[index].settle();
            changed.push(index);
            if index > 0 {
                let bounds = nodes[index].bounds();
                fit_if_other(nodes, place::<N>(self.parents[index]), &bounds, &mut open);
            }
        }
        changed
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
