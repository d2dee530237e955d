//! A kd-tree: a partition of space, brought from outside the crate, that keeps the contract of
//! [`Accel`] by its rules for cells.
//!
//! A plane cuts a cell in two where that is cheapest by the surface area heuristic (MacDonald,
//! Booth: *Heuristics for ray tracing using space subdivision*, 1990). A primitive is listed in
//! each cell that its box touches, so several leaves refer to it.
//!
//! Two switches break a rule each, as textbooks do: planes measured without the padding of the ray,
//! and a search that ends in the first cell with a hit. Both lose hits.

use std::ops::{ControlFlow, Range};

use srt::accel::{Accel, Bounded, Build, Built, Order, Tree};
use srt::counters::Counters;
use srt::math::{Aabb, BoxRay, NONE, Ray};

/// Cells at this depth are not cut.
const MAX_DEPTH: usize = 48;

/// Cells within cells. By default it keeps the contract; with `PADDED` off or `EARLY_EXIT` on it
/// does not.
pub(crate) struct KdTree<const PADDED: bool = true, const EARLY_EXIT: bool = false> {
    /// The cell of the root: the box around all primitives.
    bounds: Aabb,
    /// The root first; none without primitives.
    nodes: Vec<Node>,
}

/// A cell: cut in two, or with the slots of the primitives whose boxes touch it.
enum Node {
    /// The cell below the plane is the next node, the one above it has its index.
    Cut {
        axis: usize,
        plane: f32,
        above: usize,
    },
    Leaf(Range<u32>),
}

impl<const PADDED: bool, const EARLY_EXIT: bool> Accel for KdTree<PADDED, EARLY_EXIT> {
    fn build(primitives: &impl Bounded, build: &mut Build<'_>) -> Built<Self> {
        let all: Vec<u32> = (0..primitives.count()).collect();
        let boxes: Vec<Aabb> = all.iter().map(|&index| primitives.bounds(index)).collect();
        let bounds = boxes.iter().copied().fold(Aabb::EMPTY, Aabb::union);
        let grain = build.grain as usize;
        let mut builder = Builder { boxes, grain, nodes: Vec::new(), slots: Vec::new() };
        if !all.is_empty() {
            builder.add(bounds, all, 0);
        }
        let accel = Self { bounds, nodes: builder.nodes };
        Built { accel, order: Some(Order::References(builder.slots)) }
    }

    #[inline]
    fn traverse<C: Counters>(
        &self,
        ray: &Ray,
        box_ray: &BoxRay,
        counters: &mut C,
        mut leaf: impl FnMut(Range<u32>, &mut C) -> ControlFlow<(), f32>,
    ) {
        if self.nodes.is_empty() {
            return;
        }
        let (near, far) = box_ray.interval(&self.bounds);
        // Nodes, and where the ray enters and leaves their cells. Besides the current one they are
        // the other halves of the cells around it.
        let mut open = [(0, 0.0, 0.0); MAX_DEPTH + 1];
        open[0] = (0, near, far);
        let (mut count, mut end) = (1, ray.end());
        while count > 0 {
            count -= 1;
            let (at, near, far) = open[count];
            // Nothing but this leaves a cell out.
            if near.max(ray.t_min) > far.min(end) {
                continue;
            }
            match &self.nodes[at] {
                Node::Leaf(slots) if slots.is_empty() => {}
                Node::Leaf(slots) => match leaf(slots.clone(), counters) {
                    ControlFlow::Break(()) => return,
                    ControlFlow::Continue(t) if EARLY_EXIT && t < end && t <= far => return,
                    ControlFlow::Continue(t) => end = t,
                },
                &Node::Cut { axis, plane, above } => {
                    counters.boxes(1);
                    let (t_below, t_above) = Self::crossings(ray, box_ray, axis, plane);
                    let halves = if box_ray.inv_dir[axis] > 0.0 {
                        [(above, near.max(t_above), far), (at + 1, near, far.min(t_below))]
                    } else {
                        [(at + 1, near.max(t_below), far), (above, near, far.min(t_above))]
                    };
                    // The half that the ray enters first is on top.
                    open[count..count + 2].copy_from_slice(&halves);
                    count += 2;
                }
            }
        }
    }

    fn bytes(&self) -> u64 {
        (size_of::<Self>() + size_of_val(&self.nodes[..])) as u64
    }

    fn tree(&self) -> Option<Tree> {
        self.nodes.first()?;
        Some(Tree::of((0, self.bounds), |&(at, cell), children| match &self.nodes[at] {
            Node::Leaf(slots) => (cell, slots.clone()),
            Node::Cut { .. } => {
                children.extend(self.halves(at, cell));
                (cell, 0..0)
            }
        }))
    }
}

impl<const PADDED: bool, const EARLY_EXIT: bool> KdTree<PADDED, EARLY_EXIT> {
    /// Where a ray crosses a plane, seen from the cell below it and from the one above: as
    /// [`BoxRay::interval`] measures a high side and a low side.
    #[inline]
    fn crossings(ray: &Ray, box_ray: &BoxRay, axis: usize, plane: f32) -> (f32, f32) {
        let inv_dir = box_ray.inv_dir[axis];
        if PADDED {
            let below = (plane - box_ray.origin_minus[axis]) * inv_dir;
            let above = (plane - box_ray.origin_plus[axis]) * inv_dir;
            (below, above)
        } else {
            let both = (plane - ray.origin[axis]) * inv_dir;
            (both, both)
        }
    }

    /// The nodes below a cut, and their cells.
    fn halves(&self, at: usize, cell: Aabb) -> [(usize, Aabb); 2] {
        let Node::Cut { axis, plane, above } = self.nodes[at] else { unreachable!("a leaf") };
        let [lower, upper] = cut(cell, axis, plane);
        [(at + 1, lower), (above, upper)]
    }
}

/// The two parts of a cell.
fn cut(cell: Aabb, axis: usize, plane: f32) -> [Aabb; 2] {
    let (mut lower, mut upper) = (cell, cell);
    lower.max[axis] = plane;
    upper.min[axis] = plane;
    [lower, upper]
}

fn sorted(coordinates: impl Iterator<Item = f32>) -> Vec<f32> {
    let mut sorted: Vec<f32> = coordinates.collect();
    sorted.sort_unstable_by(f32::total_cmp);
    sorted
}

struct Builder {
    boxes: Vec<Aabb>,
    /// Leaves begin at multiples of so many slots.
    grain: usize,
    nodes: Vec<Node>,
    slots: Vec<u32>,
}

impl Builder {
    /// Appends a cell and what it is cut into.
    fn add(&mut self, cell: Aabb, listed: Vec<u32>, depth: usize) {
        let best = if depth < MAX_DEPTH { self.cheapest_cut(cell, &listed) } else { None };
        let Some((axis, plane)) = best else { return self.add_leaf(&listed) };
        let touching = |touches: &dyn Fn(&Aabb) -> bool| -> Vec<u32> {
            listed.iter().copied().filter(|&index| touches(&self.boxes[index as usize])).collect()
        };
        // Closed boxes and closed cells: what lies in the plane is listed on both sides.
        let below = touching(&|bounds| bounds.min[axis] <= plane);
        let above = touching(&|bounds| bounds.max[axis] >= plane);
        drop(listed);
        let [lower, upper] = cut(cell, axis, plane);
        let at = self.nodes.len();
        self.nodes.push(Node::Leaf(0..0));
        self.add(lower, below, depth + 1);
        self.nodes[at] = Node::Cut { axis, plane, above: self.nodes.len() };
        self.add(upper, above, depth + 1);
    }

    fn add_leaf(&mut self, listed: &[u32]) {
        self.slots.resize(self.slots.len().next_multiple_of(self.grain), NONE);
        let first = self.slots.len() as u32;
        self.slots.extend(listed);
        self.nodes.push(Node::Leaf(first..self.slots.len() as u32));
    }

    /// The plane of the least cost among the faces of the boxes, if that is less than a leaf's.
    fn cheapest_cut(&self, cell: Aabb, listed: &[u32]) -> Option<(usize, f32)> {
        let mut least = listed.len() as f64;
        let mut best = None;
        for axis in 0..3 {
            let boxes = listed.iter().map(|&index| &self.boxes[index as usize]);
            let lows = sorted(boxes.clone().map(|bounds| bounds.min[axis]));
            let highs = sorted(boxes.map(|bounds| bounds.max[axis]));
            for &plane in lows.iter().chain(&highs) {
                if !(cell.min[axis] < plane && plane < cell.max[axis]) {
                    continue;
                }
                let below = lows.partition_point(|&low| low <= plane);
                let above = listed.len() - highs.partition_point(|&high| high < plane);
                let [lower, upper] = cut(cell, axis, plane).map(|half| half.half_area());
                let tests = lower * below as f64 + upper * above as f64;
                let cost = 1.0 + tests / cell.half_area();
                if cost < least {
                    (least, best) = (cost, Some((axis, plane)));
                }
            }
        }
        best
    }
}
