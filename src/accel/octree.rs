//! An octree: a cell is cut in its middle along all three axes, and each of the eight parts again.
//!
//! * *Idea*: Space is parted more finely where there is more of it, with no search for planes.
//! * *Paper*: Glassner: *Space subdivision for fast ray tracing*, 1984; Revelles, Ureña, Lastra: *An
//!   Efficient Parametric Algorithm for Octree Traversal*, 2000, for the search from the top.
//! * *Build*: O(n · depth).
//! * *A ray*: O(depth) nodes for each cell on its way; of a node three planes are measured.
//! * *Memory*: 16 bytes a cell; 40 bytes a reference to a triangle, which is a copy; references are
//!   limited by the option `references`.
//! * *It wins*: over a grid, where primitives lie in clusters. It loses to a kd-tree, whose planes go
//!   where they pay.
//! * *Picture*: `docs/gallery/cells-octree.png`.
//!
//! The rules for cells at [`Accel`] make it return the hits of all others: a primitive is listed in each
//! cell that its *box* touches, planes are measured with the padding, and the search ends by the
//! intervals of cells alone.

use std::ops::{ControlFlow, Range};

use rayon::prelude::*;
use smallvec::SmallVec;

use crate::counters::Counters;
use crate::math::{Aabb, BoxRay, Ray};

use super::build::boxes_of;
use super::cells::{CellLists, ListBuilder, MOST_REFERENCES, Mailbox, PlaneRay, references_option};
use super::order::in_32_bits;
use super::{Accel, Allowed, Bounded, Build, Built, OptionInfo, Regions, StructureShape, Tree};

/// The most steps from the root to a leaf.
const DEPTH: u32 = 21;

/// Cells with at least so many primitives are cut in parallel.
const PARALLEL: usize = 1 << 12;

/// The stack lives with the call up to this size, and on the heap beyond: seven parts wait at each
/// level, but a ray meets more than four of them only where it runs in a plane.
const USUAL_STACK: usize = 64;

/// Cells within cells.
#[derive(Clone, Debug)]
pub struct Octree {
    /// The cell of the root: the box around all primitives.
    bounds: Aabb,
    /// The root first; none without primitives. The eight parts of a cell stand behind each other.
    nodes: Vec<Node>,
    lists: CellLists,
}

/// A cell: where it is cut, or its list.
#[derive(Clone, Copy, Debug)]
struct Node {
    /// The planes of the three axes. Of a leaf the bits of the first place of the list and of the one
    /// behind its last.
    planes: [f32; 3],
    /// The first part, or [`LEAF`].
    parts: u32,
}

/// The root is part of nothing.
const LEAF: u32 = 0;

const REFERENCES: OptionInfo = references_option("8");

const SIZE: OptionInfo = OptionInfo {
    name: "leaf",
    allowed: Allowed::Numbers(1, 64),
    default: "16",
    summary: "cells with more triangles are cut, where that pays",
};

impl Accel for Octree {
    const ONE_BY_ONE: bool = true;

    /// As measured over five kinds of meshes of one and two million triangles, copies included.
    const BUILD_BYTES: u64 = 310;

    const OPTIONS: &'static [OptionInfo] = &[REFERENCES, SIZE];

    fn build(primitives: &impl Bounded, build: &mut Build<'_>) -> Built<Self> {
        let boxes = build.stages.time("boxes", || boxes_of(primitives));
        Self::over(&boxes, build)
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
        let mut end = ray.end();
        let plane_ray = PlaneRay::new(ray, box_ray);
        // What makes of the place of a part in the order of the ray its place in space.
        let mirrored = (0..3).map(|axis| u32::from(!plane_ray.upwards[axis]) << axis).sum::<u32>();
        let mut mailbox = Mailbox::EMPTY;
        let mut stack = SmallVec::<[(u32, f32, f32); USUAL_STACK]>::new();
        stack.push((0, near.max(ray.t_min), far.min(ray.end())));
        while let Some((at, near, far)) = stack.pop() {
            let far = far.min(end);
            if near > far {
                continue;
            }
            let node = self.nodes[at as usize];
            if node.parts == LEAF {
                let flow =
                    self.lists.offer(node.list(), &mut mailbox, &mut end, counters, &mut leaf);
                if flow.is_break() {
                    return;
                }
                continue;
            }
            counters.boxes(3);
            let enters: [f32; 3] =
                std::array::from_fn(|axis| plane_ray.enters(axis, node.planes[axis]));
            let leaves: [f32; 3] =
                std::array::from_fn(|axis| plane_ray.leaves(axis, node.planes[axis]));
            // The part that the ray enters last is pushed first.
            for place in (0..8).rev() {
                let (mut near, mut far) = (near, far);
                for axis in 0..3 {
                    if place >> axis & 1 == 0 {
                        far = far.min(leaves[axis]);
                    } else {
                        near = near.max(enters[axis]);
                    }
                }
                // Nothing but its own interval leaves a part out.
                if near <= far {
                    stack.push((node.parts + (place ^ mirrored), near, far));
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

impl Octree {
    fn over(boxes: &[Aabb], build: &mut Build<'_>) -> Built<Self> {
        let Build { config, grain, stages } = build;
        let count = boxes.len() as u32;
        let bounds = boxes.iter().copied().fold(Aabb::EMPTY, Aabb::union);
        let references = config.options.number(&REFERENCES).unwrap_or(8);
        let size = config.options.number(&SIZE).unwrap_or(16) as usize;
        let builder = Builder { boxes, size };
        let root = stages.time("tree", || {
            let budget = u64::from(references - 1) * u64::from(count);
            let budget = budget.min(MOST_REFERENCES.saturating_sub(count.into()));
            (count > 0).then(|| builder.cut(bounds, (0..count).collect(), budget, DEPTH))
        });
        stages.time("layout", || {
            let (mut nodes, mut lists) = (Vec::new(), ListBuilder::new(*grain));
            if let Some(root) = &root {
                nodes.push(Node::leaf(&(0..0)));
                lay_out(root, 0, &mut nodes, &mut lists);
            }
            nodes.shrink_to_fit();
            let (lists, order) = lists.finish();
            Built { accel: Self { bounds, nodes, lists }, order }
        })
    }

    /// All cells with their lists.
    fn cells(&self) -> Option<Tree> {
        self.nodes.first()?;
        Some(Tree::of((0, self.bounds), |&(at, cell), children| {
            let node = self.nodes[at as usize];
            if node.parts == LEAF {
                return (cell, node.list());
            }
            children
                .extend((0..8).map(|place| (node.parts + place, part(&cell, node.planes, place))));
            (cell, 0..0)
        }))
    }
}

impl Node {
    fn leaf(list: &Range<u32>) -> Self {
        let [first, behind] = [list.start, list.end].map(f32::from_bits);
        Self { planes: [first, behind, 0.0], parts: LEAF }
    }

    #[inline(always)]
    fn list(self) -> Range<u32> {
        self.planes[0].to_bits()..self.planes[1].to_bits()
    }
}

/// Part `place` of a cell: its bit of an axis is set above the plane.
fn part(cell: &Aabb, planes: [f32; 3], place: u32) -> Aabb {
    let mut part = *cell;
    for (axis, plane) in planes.into_iter().enumerate() {
        if place >> axis & 1 == 0 {
            part.max[axis] = plane;
        } else {
            part.min[axis] = plane;
        }
    }
    part
}

/// A cell with what it is cut into.
enum Cut {
    Leaf(Vec<u32>),
    Parts([f32; 3], Box<[Cut; 8]>),
}

/// Writes a cell to its place, and those within behind what is there.
fn lay_out(cut: &Cut, place: usize, nodes: &mut Vec<Node>, lists: &mut ListBuilder) {
    match cut {
        Cut::Leaf(ids) => nodes[place] = Node::leaf(&lists.add(ids)),
        Cut::Parts(planes, parts) => {
            let first = nodes.len();
            nodes[place] = Node { planes: *planes, parts: in_32_bits(first) };
            nodes.extend([Node::leaf(&(0..0)); 8]);
            for (part, place) in parts.iter().zip(first..) {
                lay_out(part, place, nodes, lists);
            }
        }
    }
}

struct Builder<'a> {
    boxes: &'a [Aabb],
    /// What is larger is cut.
    size: usize,
}

impl Builder<'_> {
    fn cut(&self, cell: Aabb, ids: Vec<u32>, budget: u64, depth: u32) -> Cut {
        if ids.len() <= self.size || depth == 0 {
            return Cut::Leaf(ids);
        }
        let planes = cell.center().to_array();
        let parts: [Aabb; 8] = std::array::from_fn(|place| part(&cell, planes, place as u32));
        // Closed boxes and closed cells: what lies in a plane is listed on both sides.
        let touches =
            |part: &Aabb, id: u32| !self.boxes[id as usize].intersection(*part).is_empty();
        let lists = parts.map(|part| -> Vec<u32> {
            ids.iter().copied().filter(|&id| touches(&part, id)).collect()
        });
        // A ray that meets the cell meets each part with the ratio of their surfaces, about 1 : 4, so
        // that a cut that makes four of each reference gains nothing.
        let references: usize = lists.iter().map(Vec::len).sum();
        let added = (references - ids.len()) as u64;
        if references >= 3 * ids.len() || added > budget {
            return Cut::Leaf(ids);
        }
        let is_large = ids.len() >= PARALLEL;
        drop(ids);
        // What is left of the budget is shared by how many primitives touch the parts.
        let rest = u128::from(budget - added);
        let share = |list: &[u32]| (rest * list.len() as u128 / references as u128) as u64;
        let mut jobs: Vec<(Aabb, Vec<u32>)> = parts.into_iter().zip(lists).collect();
        let cut = |(part, list): (Aabb, Vec<u32>)| {
            let budget = share(&list);
            self.cut(part, list, budget, depth - 1)
        };
        let cuts: Vec<Cut> = match is_large {
            true => jobs.into_par_iter().with_max_len(1).map(cut).collect(),
            false => jobs.drain(..).map(cut).collect(),
        };
        let Ok(cuts) = cuts.try_into() else { unreachable!("a cell has eight parts") };
        Cut::Parts(planes, Box::new(cuts))
    }
}
