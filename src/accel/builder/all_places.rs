//! A tree by the surface area heuristic, for which every place between two primitives is weighed.
//!
//! MacDonald, Booth: *Heuristics for ray tracing using space subdivision*, 1990; Goldsmith, Salmon:
//! *Automatic creation of object hierarchies for ray tracing*, 1987, for the heuristic. Primitives are
//! sorted by their centres along each axis once. A node sweeps over its part of each list from both sides,
//! which gives the boxes before and behind every place, and parts the lists in their order: O(n log n).
//! Bins (`binned.rs`) are an approximation of it that is built in a fraction of the time.

use std::sync::atomic::{AtomicBool, Ordering};

use obvhs::bvh2::Bvh2;
use obvhs::bvh2::node::Bvh2Node;
use rayon::prelude::*;

use super::super::BuildStages;
use super::branch::Branch;
use super::reference::{Corners, Reference};
use super::terms::Terms;
use super::{Boxed, USUAL_DEPTH};

/// Parts of at least so many primitives are built in parallel.
const PARALLEL: usize = 1 << 12;

/// Builds a tree over at least one primitive.
pub(super) fn build(primitives: &dyn Boxed, terms: Terms, stages: &mut BuildStages) -> Bvh2 {
    let references = stages.time("boxes", || primitives.references());
    tree(&references, terms, stages)
}

fn tree(references: &[Reference], terms: Terms, stages: &mut BuildStages) -> Bvh2 {
    let count = references.len() as u32;
    let mut lists: [Vec<u32>; 3] = stages.time("sort", || {
        std::array::from_fn(|axis| {
            let center = |&index: &u32| references[index as usize].center()[axis];
            let mut list: Vec<u32> = (0..count).collect();
            // Of equal centres the smaller index comes first, so that there is one order.
            list.par_sort_unstable_by(|a, b| center(a).total_cmp(&center(b)).then(a.cmp(b)));
            list
        })
    });
    stages.time("tree", || {
        let is_first = (0..count).map(|_| AtomicBool::new(false)).collect();
        let sweep = Sweep { boxes: references.iter().map(|one| one.0).collect(), is_first, terms };
        let mut spare = vec![0; count as usize];
        let part =
            Part { lists: lists.each_mut().map(|list| &mut list[..]), spare: &mut spare, first: 0 };
        let nodes = sweep.grow(part, 0).into_nodes();
        let [primitive_indices, ..] = lists;
        Bvh2 { nodes, primitive_indices, ..Bvh2::default() }
    })
}

struct Sweep {
    /// By the indices of primitives.
    boxes: Vec<Corners>,
    /// Whether a primitive is in the first half of its node, while that is parted. A primitive is in one
    /// node at a time, so threads write to different places.
    is_first: Vec<AtomicBool>,
    terms: Terms,
}

/// What a node is built over.
struct Part<'a> {
    /// The same primitives by their centres along each axis.
    lists: [&'a mut [u32]; 3],
    /// As much memory.
    spare: &'a mut [u32],
    /// The place of the first of them in the tree's order.
    first: u32,
}

/// A place between primitives.
struct Place {
    axis: usize,
    /// How many are before it.
    before: usize,
}

impl Sweep {
    /// A node and those below it.
    fn grow(&self, part: Part<'_>, depth: u32) -> Branch {
        if part.count() < PARALLEL {
            let mut nodes = vec![Bvh2Node::default()];
            self.grow_in_sequence(part, &mut nodes, 0, depth, &mut Vec::new());
            return Branch::Grown(nodes);
        }
        let (bounds, place) = self.place(&part, depth, &mut Vec::new());
        let place = place.expect("a large part is no leaf");
        let [left, right] = self.part(part, &place);
        let (left, right) =
            rayon::join(|| self.grow(left, depth + 1), || self.grow(right, depth + 1));
        Branch::Fork(bounds.aabb(), Box::new([left, right]))
    }

    /// A node at a place among others, and those below it behind all of them.
    fn grow_in_sequence(
        &self,
        part: Part<'_>,
        nodes: &mut Vec<Bvh2Node>,
        at: usize,
        depth: u32,
        costs: &mut Vec<f32>,
    ) {
        let (bounds, place) = self.place(&part, depth, costs);
        let Some(place) = place else {
            nodes[at] = Bvh2Node::new(bounds.aabb(), part.count() as u32, part.first);
            return;
        };
        let [left, right] = self.part(part, &place);
        let below = nodes.len();
        nodes[at] = Bvh2Node::new(bounds.aabb(), 0, below as u32);
        nodes.extend([Bvh2Node::default(); 2]);
        self.grow_in_sequence(left, nodes, below, depth + 1, costs);
        self.grow_in_sequence(right, nodes, below + 1, depth + 1, costs);
    }

    /// The box around a part, and the best place in it; none if it is to be a leaf.
    fn place(&self, part: &Part<'_>, depth: u32, costs: &mut Vec<f32>) -> (Corners, Option<Place>) {
        let count = part.count();
        let mut bounds = Corners::EMPTY;
        if count <= self.terms.unparted() || depth >= USUAL_DEPTH {
            for &index in &*part.lists[0] {
                bounds = bounds.union(&self.boxes[index as usize]);
            }
            let halved = (count > self.terms.most).then_some(Place { axis: 0, before: count / 2 });
            return (bounds, halved);
        }
        let (mut least, mut best) = (f32::INFINITY, Place { axis: 0, before: count / 2 });
        for axis in 0..3 {
            costs.clear();
            bounds = Corners::EMPTY;
            for (before, &index) in (1..).zip(&*part.lists[axis]) {
                bounds = bounds.union(&self.boxes[index as usize]);
                costs.push(self.terms.cost(bounds.half_area(), before));
            }
            let mut behind = Corners::EMPTY;
            for before in (1..count).rev() {
                behind = behind.union(&self.boxes[part.lists[axis][before] as usize]);
                let cost = costs[before - 1] + self.terms.cost(behind.half_area(), count - before);
                if cost < least {
                    (least, best) = (cost, Place { axis, before });
                }
            }
        }
        let is_leaf =
            count <= self.terms.most && self.terms.cost(bounds.half_area(), count) <= least;
        (bounds, (!is_leaf).then_some(best))
    }

    /// The primitives before a place, and those behind it.
    fn part<'a>(&self, part: Part<'a>, &Place { axis, before }: &Place) -> [Part<'a>; 2] {
        let Part { lists, spare, first } = part;
        for (place, &index) in lists[axis].iter().enumerate() {
            self.is_first[index as usize].store(place < before, Ordering::Relaxed);
        }
        for other in [(axis + 1) % 3, (axis + 2) % 3] {
            let (mut front, mut back) = (0, 0);
            for place in 0..lists[other].len() {
                let index = lists[other][place];
                // Both are written, and one of them is written again: without a branch.
                let is_first = self.is_first[index as usize].load(Ordering::Relaxed);
                (lists[other][front], spare[back]) = (index, index);
                front += usize::from(is_first);
                back += usize::from(!is_first);
            }
            lists[other][front..].copy_from_slice(&spare[..back]);
        }
        let [x, y, z] = lists.map(|list| list.split_at_mut(before));
        let spare = spare.split_at_mut(before);
        [
            Part { lists: [x.0, y.0, z.0], spare: spare.0, first },
            Part { lists: [x.1, y.1, z.1], spare: spare.1, first: first + before as u32 },
        ]
    }
}

impl Part<'_> {
    fn count(&self) -> usize {
        self.lists[0].len()
    }
}
