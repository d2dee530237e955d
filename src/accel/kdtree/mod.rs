//! A kd-tree: space is cut in two by a plane along an axis, and each half again.
//!
//! * *Idea*: A ray passes the cells of a partition one after the other, so the first cells with a hit
//!   end the search. Planes lie where a ray is expected to cost the least, by the surface area
//!   heuristic (MacDonald, Booth: *Heuristics for ray tracing using space subdivision*, 1990).
//! * *Paper*: Wald, Havran: *On building fast kd-Trees for Ray Tracing, and on doing that in O(N log
//!   N)*, 2006; Havran: *Heuristic Ray Shooting Algorithms*, 2000, for the search.
//! * *Build*: O(n log n): the sides of boxes are sorted once, and the lists are parted with the cells
//!   (`cut.rs`).
//! * *A ray*: O(log n) cells in the mean; of a node one plane is measured, of a box three times two.
//! * *Memory*: 8 bytes a node; 40 bytes a reference to a triangle, which is a copy; references are
//!   limited by the option `references`.
//! * *It wins*: where large empty parts lie between, and rays are to stop early: on closed scans it is
//!   as fast as `bvh` ray by ray. It loses where boxes overlap much, since primitives have references
//!   in many cells, and its build takes four times as long.
//! * *Picture*: `docs/gallery/cells-kdtree.png`.
//!
//! The rules for cells at [`Accel`] make it return the hits of all others: a primitive is listed in each
//! cell that its *box* touches, planes are measured with the padding, and the search ends by the
//! intervals of cells alone.

mod cut;
mod sides;

use std::ops::{ControlFlow, Range};

use smallvec::SmallVec;

use crate::counters::Counters;
use crate::math::{Aabb, BoxRay, Ray};

use self::cut::{Cut, Limits};
use super::build::boxes_of;
use super::cells::{CellLists, ListBuilder, Mailbox, PlaneRay, references_option};
use super::{Accel, Allowed, Bounded, Build, Built, OptionInfo, Regions, StructureShape, Tree};

/// The stack lives with the call up to this depth, and on the heap beyond.
const USUAL_DEPTH: usize = 32;

/// Cells within cells.
#[derive(Clone, Debug)]
pub struct KdTree {
    /// The cell of the root: the box around all primitives.
    bounds: Aabb,
    /// The root first; none without primitives.
    nodes: Vec<Node>,
    lists: CellLists,
}

/// A cell that is cut in two, or a leaf, in eight bytes.
#[derive(Clone, Copy, Debug)]
struct Node {
    /// The plane; of a leaf the bits of the first place of its list.
    plane: f32,
    /// The axis in the lowest two bits, or [`LEAF`]. Above them the node above the plane, of which the one
    /// below is the next; of a leaf how long the list is.
    word: u32,
}

/// What a leaf has in the place of an axis.
const LEAF: u32 = 3;

/// What the words of nodes can hold.
const MOST_NODES: usize = 1 << 30;

const REFERENCES: OptionInfo = references_option("4");

const BONUS: OptionInfo = OptionInfo {
    name: "bonus",
    allowed: Allowed::Numbers(0, 90),
    default: "20",
    summary: "how much less a cut costs that leaves a half empty, in percent",
};

impl Accel for KdTree {
    const ONE_BY_ONE: bool = true;

    /// As measured over five kinds of meshes of one and two million triangles, copies included.
    const BUILD_BYTES: u64 = 260;

    const OPTIONS: &'static [OptionInfo] = &[REFERENCES, BONUS];

    fn build(primitives: &impl Bounded, build: &mut Build<'_>) -> Built<Self> {
        let Build { config, grain, stages } = build;
        let limits = Limits {
            references: config.options.number(&REFERENCES).unwrap_or(4),
            bonus: config.options.number(&BONUS).unwrap_or(20),
            grain: *grain,
        };
        let boxes = stages.time("boxes", || boxes_of(primitives));
        let root = cut::cut(boxes, limits, stages);
        stages.time("layout", || lay_out(root, *grain))
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
        let (mut near, mut far, mut end) = (near.max(ray.t_min), far.min(ray.end()), ray.end());
        if near > far {
            return;
        }
        let plane_ray = PlaneRay::new(ray, box_ray);
        let mut mailbox = Mailbox::EMPTY;
        let mut stack = SmallVec::<[(u32, f32, f32); USUAL_DEPTH]>::new();
        let mut at = 0;
        loop {
            let node = self.nodes[at as usize];
            if let Some(axis) = node.axis() {
                counters.boxes(1);
                let leaves = plane_ray.leaves(axis, node.plane);
                let enters = plane_ray.enters(axis, node.plane);
                let (below, above) = (at + 1, node.word >> 2);
                let (first, second) =
                    if plane_ray.upwards[axis] { (below, above) } else { (above, below) };
                // Nothing but its own interval leaves a half out. One of the two is always met: the ray
                // does not leave the first before it enters the second.
                let second_near = near.max(enters);
                if near <= leaves {
                    if second_near <= far {
                        stack.push((second, second_near, far));
                    }
                    (at, far) = (first, far.min(leaves));
                } else {
                    (at, near) = (second, second_near);
                }
                continue;
            }
            let offer = self.lists.offer(node.list(), &mut mailbox, &mut end, counters, &mut leaf);
            if offer.is_break() {
                return;
            }
            loop {
                let Some(next) = stack.pop() else { return };
                if next.1 <= end {
                    (at, near, far) = (next.0, next.1, next.2.min(end));
                    break;
                }
            }
        }
    }

    fn bytes(&self) -> u64 {
        (size_of::<Self>() + size_of_val(&self.nodes[..])) as u64 + self.lists.bytes()
    }

    fn tree(&self) -> Option<Tree> {
        self.lists.are_slots().then(|| self.cells())?
    }

    fn regions(&self) -> Regions {
        let cells = self.cells().unwrap_or_default();
        Regions::of_tree_with(&cells, |list| self.lists.slots(list))
    }

    fn shape(&self) -> StructureShape {
        StructureShape::of_tree(self.cells().as_ref(), self.bytes())
    }
}

impl KdTree {
    /// All cells with their lists.
    fn cells(&self) -> Option<Tree> {
        self.nodes.first()?;
        Some(Tree::of((0, self.bounds), |&(at, cell), children| {
            let node = self.nodes[at as usize];
            let Some(axis) = node.axis() else { return (cell, node.list()) };
            let [below, above] = cut::halves(&cell, axis, node.plane);
            children.extend([(at + 1, below), (node.word >> 2, above)]);
            (cell, 0..0)
        }))
    }
}

impl Node {
    fn leaf(list: &Range<u32>) -> Self {
        assert!(list.len() < MOST_NODES, "a leaf of a kd-tree refers to fewer than 2³⁰ primitives");
        Self { plane: f32::from_bits(list.start), word: (list.end - list.start) << 2 | LEAF }
    }

    /// The axis along which the cell is cut; `None` for a leaf.
    #[inline(always)]
    fn axis(self) -> Option<usize> {
        let axis = self.word & 3;
        (axis != LEAF).then_some(axis as usize)
    }

    #[inline(always)]
    fn list(self) -> Range<u32> {
        let first = self.plane.to_bits();
        first..first + (self.word >> 2)
    }
}

/// Puts all cells behind each other.
fn lay_out(root: Option<(Aabb, Cut)>, grain: u32) -> Built<KdTree> {
    let (mut nodes, mut lists) = (Vec::new(), ListBuilder::new(grain));
    let mut bounds = Aabb::EMPTY;
    if let Some((around, root)) = root {
        bounds = around;
        append(&root, &mut nodes, &mut lists);
    }
    nodes.shrink_to_fit();
    let (lists, order) = lists.finish();
    Built { accel: KdTree { bounds, nodes, lists }, order }
}

/// Appends a cell and those within, the lower half first.
fn append(cut: &Cut, nodes: &mut Vec<Node>, lists: &mut ListBuilder) {
    let at = nodes.len();
    assert!(at < MOST_NODES, "a kd-tree has at most 2³⁰ cells");
    match cut {
        Cut::Leaf(ids) => nodes.push(Node::leaf(&lists.add(ids))),
        Cut::Plane { axis, plane, halves } => {
            nodes.push(Node { plane: *plane, word: 0 });
            append(&halves[0], nodes, lists);
            nodes[at].word = (nodes.len() as u32) << 2 | *axis as u32;
            append(&halves[1], nodes, lists);
        }
    }
}
