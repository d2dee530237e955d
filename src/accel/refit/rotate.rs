//! Rotations: what hangs at two places near each other in a tree changes places where boxes become smaller by it.
//!
//! At each node, the last ones first, a child may change places with a grandchild below another child, or two
//! grandchildren below different children: in a binary tree these are the six rotations of A. Kensler, *Tree Rotations
//! for Improving Bounding Volume Hierarchies*, 2008, done in each frame as by Kopta, Ize, Spjut, Brunvand, Davis,
//! Kensler: *Fast, Effective BVH Updates for Animated Scenes*, 2012. The box of the node stays as it is, and only those
//! of the one or two children change whose own children are others. The best is done, if it makes the sum of their
//! surfaces smaller. How many children a node has, and which slots a leaf has, stays.
//!
//! One thread goes over the nodes, so the tree does not depend on how many there are.

use smallvec::SmallVec;

use crate::math::Aabb;

use super::paths::Paths;
use super::{Below, FitNode, WIDEST};

/// The share of a node's own surface that must be saved: less is noise, and each exchange has a cost.
const LEAST_GAIN: f32 = 1e-3;

/// A node and one of its lanes.
type Place = (usize, usize);

/// Two places that change what hangs there.
struct Exchange {
    places: [Place; 2],
    /// The lanes of the node at the top in which the nodes of these places hang; none for itself.
    lanes: [Option<usize>; 2],
    /// Whether children still stand behind their parents afterwards.
    keeps_order: bool,
}

/// Rotates at all nodes, whose boxes fit. Returns whether anything has changed. Nodes still have to settle.
pub(super) fn all<N: FitNode>(nodes: &mut Vec<N>, block: usize) -> bool {
    // Siblings of a wide tree stand side by side before all that is below them, so that hardly an exchange is lost
    // where the order is to be kept. Of a binary tree, half of them would be.
    let any_order = N::WIDTH == 2;
    let (mut changed, mut disordered) = (false, false);
    for index in (0..nodes.len()).rev() {
        for _ in 0..turns::<N>() {
            let Some(exchange) = best(nodes, index, block, any_order) else { break };
            exchange.carry_out(nodes, index);
            changed = true;
            disordered |= !exchange.keeps_order;
        }
    }
    if disordered {
        *nodes = in_order(nodes, block);
    }
    changed
}

/// Rotates at some nodes, each of which stands behind all that are below it. Returns whether anything has changed.
pub(super) fn some<N: FitNode>(
    nodes: &mut [N],
    some: &[usize],
    paths: &mut Paths,
    block: usize,
) -> bool {
    let mut changed = false;
    for &index in some {
        for _ in 0..turns::<N>() {
            let Some(exchange) = best(nodes, index, block, false) else { break };
            exchange.carry_out(nodes, index);
            nodes[index].settle();
            for (node, lane) in exchange.places {
                nodes[node].settle();
                paths.note(nodes, (node, lane), block);
            }
            changed = true;
        }
    }
    changed
}

/// How often it is rotated at a node: there is more to do where there are more children.
const fn turns<N: FitNode>() -> usize {
    N::WIDTH / 2
}

/// An inner child of a node.
struct Inner {
    index: usize,
    lane: usize,
    area: f32,
    /// What hangs there.
    children: Children,
    /// Of each of them, the box around the others.
    rests: [Aabb; WIDEST],
    /// By how much that is smaller, by its surface, than the box around all.
    saved: [f32; WIDEST],
}

/// The children of a node: their boxes, and the indices of those that are nodes; of a leaf the largest number.
struct Children {
    bounds: [Aabb; WIDEST],
    indices: [usize; WIDEST],
    count: usize,
}

impl Children {
    fn of<N: FitNode>(node: &N, block: usize) -> Self {
        let (bounds, indices) = ([Aabb::EMPTY; WIDEST], [usize::MAX; WIDEST]);
        let mut children = Self { bounds, indices, count: 0 };
        for lane in 0..N::WIDTH {
            // Lanes without a child are the last ones.
            let Some(below) = node.below(lane, block) else { break };
            if let Below::Node(index) = below {
                children.indices[lane] = index;
            }
            children.bounds[lane] = node.child_bounds(lane);
            children.count += 1;
        }
        children
    }
}

impl Inner {
    fn of<N: FitNode>(nodes: &[N], (index, lane): Place, area: f32, block: usize) -> Self {
        let children = Children::of(&nodes[index], block);
        let mut rests = [Aabb::EMPTY; WIDEST];
        let mut before = Aabb::EMPTY;
        for (rest, bounds) in rests.iter_mut().zip(&children.bounds[..children.count]) {
            *rest = before;
            before = before.union(*bounds);
        }
        let (mut behind, mut saved) = (Aabb::EMPTY, [0.0; WIDEST]);
        for lane in (0..children.count).rev() {
            rests[lane] = rests[lane].union(behind);
            behind = behind.union(children.bounds[lane]);
            saved[lane] = area - area_of(&rests[lane]);
        }
        Self { index, lane, area, children, rests, saved }
    }

    /// By how much the box becomes smaller if a box comes into a lane.
    fn gain(&self, lane: usize, bounds: &Aabb) -> f32 {
        self.area - area_of(&self.rests[lane].union(*bounds))
    }
}

/// The best exchange below a node.
fn best<N: FitNode>(nodes: &[N], top: usize, block: usize, any_order: bool) -> Option<Exchange> {
    // Most nodes of a wide tree have leaves alone.
    let is_inner = |lane| matches!(nodes[top].below(lane, block), Some(Below::Node(_)));
    if !(0..N::WIDTH).any(is_inner) {
        return None;
    }
    let own = Children::of(&nodes[top], block);
    let mut inner = SmallVec::<[Inner; WIDEST]>::new();
    let mut around = Aabb::EMPTY;
    for lane in 0..own.count {
        around = around.union(own.bounds[lane]);
        if own.indices[lane] != usize::MAX {
            let area = area_of(&own.bounds[lane]);
            inner.push(Inner::of(nodes, (own.indices[lane], lane), area, block));
        }
    }
    let (mut best, mut most) = (None, LEAST_GAIN * area_of(&around));
    for (number, one) in inner.iter().enumerate() {
        for lane in 0..one.children.count {
            // A child of the node comes in, and this one beside its parent.
            let own_lanes = if one.saved[lane] > most { 0..own.count } else { 0..0 };
            for with in own_lanes.filter(|&with| with != one.lane) {
                let gain = one.gain(lane, &own.bounds[with]);
                let keeps_order = own.indices[with] > one.index;
                if gain > most && (any_order || keeps_order) {
                    let (places, lanes) =
                        ([(one.index, lane), (top, with)], [Some(one.lane), None]);
                    (best, most) = (Some(Exchange { places, lanes, keeps_order }), gain);
                }
            }
            // One from below another child comes in, and this one to where that was.
            for other in &inner[number + 1..] {
                for with in 0..other.children.count {
                    if one.saved[lane] + other.saved[with] <= most {
                        continue;
                    }
                    let gain = one.gain(lane, &other.children.bounds[with])
                        + other.gain(with, &one.children.bounds[lane]);
                    let keeps_order = one.children.indices[lane] > other.index
                        && other.children.indices[with] > one.index;
                    if gain > most && (any_order || keeps_order) {
                        let places = [(one.index, lane), (other.index, with)];
                        let lanes = [Some(one.lane), Some(other.lane)];
                        (best, most) = (Some(Exchange { places, lanes, keeps_order }), gain);
                    }
                }
            }
        }
    }
    best
}

impl Exchange {
    fn carry_out<N: FitNode>(&self, nodes: &mut [N], top: usize) {
        let [a, b] = self
            .places
            .map(|(node, lane)| (nodes[node].child(lane), nodes[node].child_bounds(lane)));
        for ((node, lane), (child, bounds)) in self.places.into_iter().zip([b, a]) {
            nodes[node].put(lane, child, &bounds);
        }
        for ((node, _), lane) in self.places.into_iter().zip(self.lanes) {
            if let Some(lane) = lane {
                let bounds = nodes[node].bounds();
                nodes[top].fit(lane, &bounds);
            }
        }
    }
}

/// Half of the surface of a box.
fn area_of(bounds: &Aabb) -> f32 {
    let size = bounds.max - bounds.min;
    size.x * size.y + size.y * size.z + size.z * size.x
}

/// The same tree with its nodes in the order of a walk, the first child of each right behind it.
fn in_order<N: FitNode>(nodes: &[N], block: usize) -> Vec<N> {
    let mut ordered: Vec<N> = Vec::with_capacity(nodes.len());
    let mut open: Vec<(usize, Option<Place>)> = vec![(0, None)];
    while let Some((index, parent)) = open.pop() {
        let own = ordered.len();
        if let Some((parent, lane)) = parent {
            let bounds = ordered[parent].child_bounds(lane);
            ordered[parent].put(lane, N::inner(own), &bounds);
        }
        ordered.push(nodes[index].clone());
        for lane in (0..N::WIDTH).rev() {
            if let Some(Below::Node(child)) = nodes[index].below(lane, block) {
                open.push((child, Some((own, lane))));
            }
        }
    }
    ordered
}
