//! Partial rebuilds: those parts of a tree are built anew that have become much worse than they were when they were
//! built, and all else stays.
//!
//! What a ray pays that meets the box of a node is, by the surface area heuristic, the sum over all below it of their
//! surfaces as shares of its own. A part that is moved or scaled as a whole keeps that cost; one whose primitives go
//! different ways does not. From the leaves up, a part whose cost has grown by more than a factor is to be built anew,
//! over its own primitives, as the whole would be. For those above, it then counts as good as it was when it was built:
//! so what is rebuilt is what has become worse, and not all that holds it. Where that hope was vain, what is above will
//! have grown in the next frame. What nodes cost is noted first as the tree first follows in this way.
//!
//! After Lauterbach, Yoon, Tuft, Manocha: *RT-DEFORM: Interactive Ray Tracing of Dynamic Scenes using BVHs*, 2006, who
//! rebuild the whole by such a measure, and Yoon, Curtis, Manocha: *Ray Tracing Dynamic Scenes using Selective
//! Restructuring*, 2007, who restructure parts.
//!
//! The new parts have other numbers of nodes and slots, so the tree is laid out anew in such a frame: what stays is
//! copied, which takes far less time than to build it. Parts are built in parallel, each by itself, and laid out in the
//! order of their roots: nothing depends on the number of threads.

use crate::math::NONE;
use crate::parallel::values;

use super::super::order::in_32_bits;
use super::{Below, FitNode, Grown, Leader};

/// By how much the cost of a part may grow before it is built anew.
const GROWTH: f32 = 1.2;

/// A part of fewer leaves is left as it is: there is little to win.
const LEAST_LEAVES: u32 = 16;

/// What each node of a tree and all below it cost a ray that meets its box: 1 for each node, and for each test of a
/// leaf.
pub(super) fn costs<N: FitNode>(nodes: &[N], block: usize) -> Vec<f32> {
    look_at(nodes, None, block).costs
}

/// What the nodes of a tree cost, and which are to be built anew.
struct Look {
    costs: Vec<f32>,
    is_worse: Vec<bool>,
}

/// Looks at the nodes of a tree, whose children stand behind their parents. Where it is known what each cost when it
/// was built, a node that has become worse costs that again, as those above see it.
fn look_at<N: FitNode>(nodes: &[N], built: Option<&[f32]>, block: usize) -> Look {
    let (mut costs, mut is_worse) = (vec![0.0; nodes.len()], vec![false; nodes.len()]);
    // Of all below each node, for a ray that meets a box of surface 1; and how many leaves there are.
    let mut below: Vec<(f64, u32)> = vec![(0.0, 0); nodes.len()];
    // With the surface of its box, a node's cost is known.
    let mut weigh = |node: usize, area: f64, below: &mut (f64, u32)| {
        costs[node] = 1.0 + (below.0 / area) as f32;
        if let Some(built) = built
            && below.1 >= LEAST_LEAVES
            && costs[node] > GROWTH * built[node]
        {
            is_worse[node] = true;
            below.0 = f64::from(built[node] - 1.0) * area;
        }
    };
    for (index, node) in nodes.iter().enumerate().rev() {
        let (mut sum, mut leaves) = (0.0, 0);
        for lane in 0..N::WIDTH {
            match node.below(lane, block) {
                Some(Below::Node(child)) => {
                    let area = node.child_bounds(lane).half_area();
                    weigh(child, area, &mut below[child]);
                    sum += area + below[child].0;
                    leaves += below[child].1;
                }
                Some(Below::Slots(slots)) => {
                    // A block is tested at once.
                    let tests = slots.len().div_ceil(block);
                    sum += node.child_bounds(lane).half_area() * tests as f64;
                    leaves += 1;
                }
                None => {}
            }
        }
        below[index] = (sum, leaves);
    }
    weigh(0, nodes[0].bounds().half_area(), &mut below[0]);
    Look { costs, is_worse }
}

/// Builds anew what has become much worse than `built` says of each node. Returns the new order of the slots; `None` if
/// all stays.
pub(super) fn regrow<N: FitNode>(
    nodes: &mut Vec<N>,
    built: &mut Vec<f32>,
    leader: &dyn Leader<N>,
) -> Option<Vec<u32>> {
    let block = leader.block();
    let Look { is_worse, .. } = look_at(nodes, Some(built), block);
    let roots = topmost(nodes, block, &is_worse);
    if roots.is_empty() {
        return None;
    }
    let parts = values(roots.len(), &|place| {
        let root = roots[place];
        let mut slots = slots_below(nodes, root, block);
        leader.sort(&mut slots);
        let Grown { nodes, order } = leader.grow(&slots);
        let slot = |place: u32| slots.get(place as usize).copied().unwrap_or(NONE);
        let order = order.into_iter().map(slot).collect();
        (!nodes.is_empty()).then_some(Part { root, nodes, order })
    });
    let parts: Vec<_> = parts.into_iter().flatten().collect();
    if parts.is_empty() {
        return None;
    }
    let Layout { nodes: whole, order, places } = Layout::new(nodes, &parts, leader);
    // What is new is as good as it was built now, all else as it was built then.
    let mut costs = costs(&whole, block);
    for Part { root, .. } in &parts {
        built[*root] = f32::NAN;
    }
    for (&place, &cost) in places.iter().zip(&*built) {
        if place != NONE && !cost.is_nan() {
            costs[place as usize] = cost;
        }
    }
    (*nodes, *built) = (whole, costs);
    Some(order)
}

/// The topmost of some nodes, in ascending order.
fn topmost<N: FitNode>(nodes: &[N], block: usize, some: &[bool]) -> Vec<usize> {
    let (mut found, mut open) = (Vec::new(), vec![0]);
    while let Some(node) = open.pop() {
        if some[node] {
            found.push(node);
        } else {
            open.extend(inner_children(&nodes[node], block));
        }
    }
    found.sort_unstable();
    found
}

fn inner_children<N: FitNode>(node: &N, block: usize) -> impl Iterator<Item = usize> {
    (0..N::WIDTH).filter_map(move |lane| match node.below(lane, block) {
        Some(Below::Node(child)) => Some(child),
        _ => None,
    })
}

fn slots_below<N: FitNode>(nodes: &[N], root: usize, block: usize) -> Vec<u32> {
    let (mut slots, mut open) = (Vec::new(), vec![root]);
    while let Some(index) = open.pop() {
        for lane in 0..N::WIDTH {
            match nodes[index].below(lane, block) {
                Some(Below::Node(child)) => open.push(child),
                Some(Below::Slots(range)) => slots.extend(range),
                None => {}
            }
        }
    }
    slots
}

/// What comes in the place of a node and of all below it.
struct Part<N> {
    root: usize,
    nodes: Vec<N>,
    /// For each slot the one in which its primitive stands as yet.
    order: Vec<u32>,
}

/// A tree with some parts exchanged.
struct Layout<N> {
    /// What stays, in the order in which it was, then the parts without their roots.
    nodes: Vec<N>,
    /// For each slot the one in which its primitive stands as yet.
    order: Vec<u32>,
    /// Where each node stands now; roots of parts are other nodes there.
    places: Vec<u32>,
}

impl<N: FitNode> Layout<N> {
    /// The parts are in the order of their roots.
    fn new(nodes: &[N], parts: &[Part<N>], leader: &dyn Leader<N>) -> Self {
        let (block, grain) = (leader.block(), leader.grain());
        let mut roots = parts.iter().map(|part| part.root).peekable();
        let mut is_root = vec![false; nodes.len()];
        let mut layout = Self { nodes: Vec::new(), order: Vec::new(), places: Vec::new() };
        // Children stand behind their parents.
        let mut goes = vec![false; nodes.len()];
        let mut kept = 0;
        for (index, node) in nodes.iter().enumerate() {
            is_root[index] = roots.next_if_eq(&index).is_some();
            layout.places.push(if goes[index] { NONE } else { kept });
            kept += u32::from(!goes[index]);
            if goes[index] || is_root[index] {
                inner_children(node, block).for_each(|child| goes[child] = true);
            }
        }
        let added: usize = parts.iter().map(|part| part.nodes.len() - 1).sum();
        layout.nodes.reserve_exact(kept as usize + added);
        for (index, node) in nodes.iter().enumerate().filter(|(index, _)| !goes[*index]) {
            let mut node = node.clone();
            // What is below a root comes with its part.
            let lanes = if is_root[index] { 0..0 } else { 0..N::WIDTH };
            for lane in lanes {
                let child = match node.below(lane, block) {
                    Some(Below::Node(child)) => N::inner(layout.places[child] as usize),
                    Some(Below::Slots(range)) => {
                        let first = layout.begin(grain);
                        layout.order.extend(range);
                        N::leaf(first..in_32_bits(layout.order.len()), block)
                    }
                    None => continue,
                };
                let bounds = node.child_bounds(lane);
                node.put(lane, child, &bounds);
            }
            layout.nodes.push(node);
        }
        for part in parts {
            let first_slot = layout.begin(grain);
            layout.order.extend_from_slice(&part.order);
            // The root goes elsewhere, so the second node is the first here.
            let first_node = layout.nodes.len() - 1;
            for (index, node) in part.nodes.iter().enumerate() {
                let mut node = node.clone();
                for lane in 0..N::WIDTH {
                    let child = match node.below(lane, block) {
                        Some(Below::Node(child)) => N::inner(first_node + child),
                        Some(Below::Slots(range)) => {
                            N::leaf(first_slot + range.start..first_slot + range.end, block)
                        }
                        None => continue,
                    };
                    let bounds = node.child_bounds(lane);
                    node.put(lane, child, &bounds);
                }
                match index {
                    0 => layout.nodes[layout.places[part.root] as usize] = node,
                    _ => layout.nodes.push(node),
                }
            }
        }
        layout.begin(grain);
        layout
    }

    /// Leaves slots empty up to the next at which a leaf may begin, and returns that.
    fn begin(&mut self, grain: usize) -> u32 {
        self.order.resize(self.order.len().next_multiple_of(grain), NONE);
        u32::try_from(self.order.len()).expect("slots are counted in 32 bits")
    }
}
