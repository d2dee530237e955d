//! A tree by the surface area heuristic that may cut boxes in two.
//!
//! Stich, Friedrich, Dietrich: *Spatial Splits in Bounding Volume Hierarchies*, 2009. A node's boxes are parted by
//! their centres, as in `binned.rs`. Where both halves overlap, planes are weighed as well: a box that such a plane
//! meets is cut, and each side refers to the primitive by its part of the box, or the primitive goes to one side whole
//! where that is cheaper. Stich et al. cut the *triangle* and take the boxes around both pieces, which are smaller;
//! equal hits allow parts of the box alone, since together they must cover it (`docs/splits.md`). So it gains less
//! here, on triangles that lie across the axes the least.
//!
//! A build takes 9 to 16 times that in bins, and up to 30 % more memory. A ray meets fewer boxes that overlap, and
//! tests some primitives twice: together no gain, but on diffuse rays among hair and furrows (0.86 – 1.1 ×,
//! `docs/splits.md`).

use obvhs::bvh2::Bvh2;
use obvhs::bvh2::node::Bvh2Node;

use crate::simd::dispatch;

use super::super::BuildStages;
use super::binned::around;
use super::branch::Branch;
use super::reference::{Corners, Reference};
use super::split::{Scratch, Splitting};
use super::terms::{Effort, Terms};
use super::{Boxed, USUAL_DEPTH};

/// Parts of at least so many references are built in parallel.
const PARALLEL: usize = 1 << 12;

/// References beyond one for each primitive, at most, in percent of the primitives.
const EXTRA_PERCENT: usize = 30;

/// Planes are weighed where halves overlap by at least this share of the surface of the box around all, as in the
/// paper.
const OVERLAP: f32 = 1e-5;

/// Slabs between the planes that are weighed along an axis.
const SLABS: usize = 32;

/// Builds a tree over at least one primitive; `cuts` says whether boxes are cut at all.
pub(super) fn build(
    primitives: &dyn Boxed,
    terms: Terms,
    cuts: bool,
    stages: &mut BuildStages,
) -> Bvh2 {
    let references = stages.time("boxes", || primitives.references());
    stages.time("tree", || tree(references, terms, cuts))
}

fn tree(references: Vec<Reference>, terms: Terms, cuts: bool) -> Bvh2 {
    let (bounds, _) = around(&references);
    let budget = if cuts { references.len() * EXTRA_PERCENT / 100 } else { 0 };
    // Costs that come from a sample could not be compared with those of planes.
    let effort = Effort { sample: usize::MAX / 2, ..terms.effort };
    let spatial =
        Spatial { terms: Terms { effort, ..terms }, least_overlap: OVERLAP * bounds.half_area() };
    let (branch, primitive_indices) = spatial.grow(Part { references, bounds, budget }, 0);
    Bvh2 { nodes: branch.into_nodes(), primitive_indices, ..Bvh2::default() }
}

struct Spatial {
    terms: Terms,
    least_overlap: f32,
}

/// What a node is built over.
struct Part {
    references: Vec<Reference>,
    /// The box around them.
    bounds: Corners,
    /// How many boxes may be cut below.
    budget: usize,
}

/// Nodes, of which the first is the root, and the primitives that their leaves refer to.
struct Grown {
    nodes: Vec<Bvh2Node>,
    order: Vec<u32>,
}

impl Spatial {
    /// A node and those below it, and the primitives in the order of their leaves.
    fn grow(&self, mut part: Part, depth: u32) -> (Branch, Vec<u32>) {
        let scratch = &mut *Scratch::new();
        if part.references.len() < PARALLEL {
            let mut grown = Grown { nodes: vec![Bvh2Node::default()], order: Vec::new() };
            self.grow_in_sequence(part, 0, depth, scratch, &mut grown);
            return (Branch::Grown(grown.nodes), grown.order);
        }
        let [left, right] = self.split(&mut part, depth, scratch).expect("a large part is no leaf");
        let (left, right) =
            rayon::join(|| self.grow(left, depth + 1), || self.grow(right, depth + 1));
        let ((left, mut order), (mut right, behind)) = (left, right);
        right.move_leaves(order.len() as u32);
        order.extend(behind);
        (Branch::Fork(part.bounds.aabb(), Box::new([left, right])), order)
    }

    /// A node at a place among others, and those below it behind all of them.
    fn grow_in_sequence(
        &self,
        mut part: Part,
        place: usize,
        depth: u32,
        scratch: &mut Scratch,
        grown: &mut Grown,
    ) {
        let bounds = part.bounds.aabb();
        let Some([left, right]) = self.split(&mut part, depth, scratch) else {
            let (first, count) = (grown.order.len() as u32, part.references.len() as u32);
            grown.nodes[place] = Bvh2Node::new(bounds, count, first);
            grown.order.extend(part.references.iter().map(Reference::index));
            return;
        };
        let below = grown.nodes.len();
        grown.nodes[place] = Bvh2Node::new(bounds, 0, below as u32);
        grown.nodes.extend([Bvh2Node::default(); 2]);
        self.grow_in_sequence(left, below, depth + 1, scratch, grown);
        self.grow_in_sequence(right, below + 1, depth + 1, scratch, grown);
    }

    /// Both halves of a part, whose references they take; nothing if it is to be a leaf.
    fn split(&self, part: &mut Part, depth: u32, scratch: &mut Scratch) -> Option<[Part; 2]> {
        let Part { references, bounds, budget } = part;
        let (count, budget) = (references.len(), *budget);
        if count <= self.terms.unparted() || depth >= USUAL_DEPTH && count <= self.terms.most {
            return None;
        }
        let mut whole = (count / 2, None);
        if depth < USUAL_DEPTH {
            let (_, centers) = around(references);
            let (terms, centers) = (self.terms, &centers);
            let (best, _) = dispatch(Splitting { references, centers, terms, scratch });
            let plane = (budget > 0 && overlap(&best.halves) > self.least_overlap)
                .then(|| Plane::best(references, bounds, &self.terms))
                .flatten()
                .filter(|plane| plane.cost < best.cost);
            let least = plane.map_or(best.cost, |plane| plane.cost);
            if count <= self.terms.most && self.terms.cost(bounds.half_area(), count) <= least {
                return None;
            }
            let cut = plane.and_then(|plane| Cut::new(references, &plane, &self.terms, budget));
            if let Some(cut) = cut {
                references.clear();
                return Some(cut.parts(budget));
            }
            if best.count > 0 {
                whole = (best.count, Some(best.halves));
            }
        }
        let (front, halves) = whole;
        let behind = references.split_off(front);
        let lists = [std::mem::take(references), behind];
        let halves = halves.unwrap_or_else(|| [around(&lists[0]).0, around(&lists[1]).0]);
        Some(parts(lists, halves, budget))
    }
}

/// Half the surface of what two boxes have in common.
fn overlap([a, b]: &[Corners; 2]) -> f32 {
    let common = Corners(std::array::from_fn(|lane| a.0[lane].min(b.0[lane])));
    let is_there = (0..3).map(|axis| common.range(axis)).all(|[low, high]| low <= high);
    if is_there { common.half_area() } else { 0.0 }
}

/// Both halves, with a budget shared by their numbers of references.
fn parts(lists: [Vec<Reference>; 2], bounds: [Corners; 2], budget: usize) -> [Part; 2] {
    let [front, back] = lists;
    let share = (budget as u64 * front.len() as u64 / (front.len() + back.len()) as u64) as usize;
    [
        Part { references: front, bounds: bounds[0], budget: share },
        Part { references: back, bounds: bounds[1], budget: budget - share },
    ]
}

/// A plane across an axis, and what both sides cost together.
#[derive(Clone, Copy)]
struct Plane {
    axis: usize,
    at: f32,
    cost: f32,
}

/// What lies in a slab of space: the box around it, and how many boxes begin and end there.
#[derive(Clone, Copy)]
struct Slab {
    bounds: Corners,
    begin: usize,
    end: usize,
}

impl Plane {
    /// The cheapest of those between slabs of equal width.
    fn best(references: &[Reference], bounds: &Corners, terms: &Terms) -> Option<Self> {
        let planes = (0..3).filter_map(|axis| Self::best_across(axis, references, bounds, terms));
        planes.reduce(|best, other| if other.cost < best.cost { other } else { best })
    }

    fn best_across(
        axis: usize,
        references: &[Reference],
        bounds: &Corners,
        terms: &Terms,
    ) -> Option<Self> {
        let [low, high] = bounds.range(axis);
        let scale = SLABS as f32 / (high - low);
        if !(scale > 0.0 && scale < f32::INFINITY) {
            return None;
        }
        let plane = |slab: usize| low + slab as f32 * ((high - low) / SLABS as f32);
        let slab_of = |x: f32| (((x - low) * scale) as usize).min(SLABS - 1);
        let mut slabs = [Slab { bounds: Corners::EMPTY, begin: 0, end: 0 }; SLABS];
        for reference in references {
            let [begin, end] = reference.0.range(axis).map(slab_of);
            slabs[begin].begin += 1;
            slabs[end].end += 1;
            for (place, slab) in slabs.iter_mut().enumerate().take(end + 1).skip(begin) {
                let mut part = reference.0;
                if place > begin {
                    part = part.from(axis, plane(place));
                }
                if place < end {
                    part = part.up_to(axis, plane(place + 1));
                }
                slab.bounds = slab.bounds.union(&part);
            }
        }
        // The box around all behind a plane, and their number, from the last plane on.
        let mut behind = [(Corners::EMPTY, 0); SLABS];
        let mut united = (Corners::EMPTY, 0);
        for place in (1..SLABS).rev() {
            united = (united.0.union(&slabs[place].bounds), united.1 + slabs[place].end);
            behind[place] = united;
        }
        let mut before = (Corners::EMPTY, 0);
        let mut best: Option<Self> = None;
        for place in 1..SLABS {
            let slab = &slabs[place - 1];
            before = (before.0.union(&slab.bounds), before.1 + slab.begin);
            if before.1 == 0 || behind[place].1 == 0 {
                continue;
            }
            let cost = [before, behind[place]]
                .map(|(bounds, count)| terms.cost(bounds.half_area(), count));
            let cost = cost[0] + cost[1];
            if best.is_none_or(|best| cost < best.cost) {
                best = Some(Self { axis, at: plane(place), cost });
            }
        }
        best
    }
}

/// References on both sides of a plane.
struct Cut {
    lists: [Vec<Reference>; 2],
    bounds: [Corners; 2],
    /// How many are on both.
    both: usize,
}

impl Cut {
    /// Nothing if a side is empty, or more boxes would be cut than the budget allows.
    fn new(references: &[Reference], plane: &Plane, terms: &Terms, budget: usize) -> Option<Self> {
        let &Plane { axis, at, .. } = plane;
        let mut cut =
            Self { lists: [Vec::new(), Vec::new()], bounds: [Corners::EMPTY; 2], both: 0 };
        let mut across = Vec::new();
        for reference in references {
            let [low, high] = reference.0.range(axis);
            if high <= at {
                cut.add(0, *reference);
            } else if low >= at {
                cut.add(1, *reference);
            } else {
                across.push(reference);
            }
        }
        // As if all of them were cut; then each goes to one side whole where that is cheaper.
        let mut counts = [0, 1].map(|side| cut.lists[side].len() + across.len());
        let halves = |whole: &Corners| [whole.up_to(axis, at), whole.from(axis, at)];
        for reference in &across {
            let parts = halves(&reference.0);
            cut.bounds = [0, 1].map(|side| cut.bounds[side].union(&parts[side]));
        }
        for reference in across {
            let cost = |bounds: [&Corners; 2], counts: [usize; 2]| {
                terms.cost(bounds[0].half_area(), counts[0])
                    + terms.cost(bounds[1].half_area(), counts[1])
            };
            let [front, back] = cut.bounds;
            let [wide_front, wide_back] = [front.union(&reference.0), back.union(&reference.0)];
            let cut_in_two = cost([&front, &back], counts);
            let to_front = cost([&wide_front, &back], [counts[0], counts[1] - 1]);
            let to_back = cost([&front, &wide_back], [counts[0] - 1, counts[1]]);
            if cut_in_two <= to_front && cut_in_two <= to_back {
                let [front, back] = halves(&reference.0);
                cut.add(0, Reference(front));
                cut.add(1, Reference(back));
                cut.both += 1;
            } else {
                let side = usize::from(to_back < to_front);
                counts[1 - side] -= 1;
                cut.add(side, *reference);
            }
        }
        // Where whole boxes went to one side, the other is smaller than it was taken for.
        cut.bounds = [0, 1].map(|side| around(&cut.lists[side]).0);
        let is_one = cut.lists.iter().all(|list| !list.is_empty()) && cut.both <= budget;
        is_one.then_some(cut)
    }

    fn add(&mut self, side: usize, reference: Reference) {
        self.bounds[side] = self.bounds[side].union(&reference.0);
        self.lists[side].push(reference);
    }

    fn parts(self, budget: usize) -> [Part; 2] {
        parts(self.lists, self.bounds, budget - self.both)
    }
}

#[cfg(test)]
mod tests;
