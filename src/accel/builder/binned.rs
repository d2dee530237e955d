//! A binary tree built from the top by the surface area heuristic.
//!
//! A node's primitives are sorted into bins by their centres, along each axis, and are split
//! between the two bins where the expected cost is the least (`split.rs`). Primitives that are tested together
//! are counted in whole packs, which fills the leaves. After Wald: *On fast Construction of
//! SAH-based Bounding Volume Hierarchies*, 2007.
//!
//! Large parts are built in parallel, each into nodes of its own, which are then put behind each
//! other; which thread does it changes nothing.

use obvhs::bvh2::Bvh2;
use obvhs::bvh2::node::Bvh2Node;
use rayon::prelude::*;

use crate::simd::{Kernel, Simd, dispatch};

use super::super::BuildStages;
use super::branch::Branch;
use super::reference::{Centers, Corners, NOWHERE, Reference};
use super::sorted::is_dense;
use super::split::{Scratch, Splitting};
use super::terms::Terms;
use super::{Boxed, USUAL_DEPTH};

/// Parts of at least so many primitives are built in parallel.
const PARALLEL: usize = 1 << 13;

/// Boxes with a larger share of the root's surface are parted down to single primitives, whatever it costs: layouts put
/// together what they want to, and know better where rays are (`bvh8/plan.rs`). Two walls of a hall, in one leaf, are
/// tested by every ray in it.
const LARGE: f32 = 0.01;

/// Builds a tree over at least one primitive.
pub(super) fn build(primitives: &dyn Boxed, terms: Terms, stages: &mut BuildStages) -> Bvh2 {
    let mut references = stages.time("boxes", || primitives.references());
    stages.time("tree", || tree(&mut references, terms))
}

fn tree(references: &mut [Reference], terms: Terms) -> Bvh2 {
    let (bounds, centers) = references
        .par_chunks(PARALLEL)
        .map(around)
        .reduce(|| (Corners::EMPTY, NOWHERE), |a, b| (a.0.union(&b.0), both(&a.1, &b.1)));
    let large = LARGE * bounds.half_area();
    let part = Part { references: &mut *references, first: 0, bounds, centers, large, terms };
    let nodes = grow(part, 0).into_nodes();
    let primitive_indices = references.par_iter().map(Reference::index).collect();
    Bvh2 { nodes, primitive_indices, ..Bvh2::default() }
}

fn both(a: &Centers, b: &Centers) -> Centers {
    [a[0].min(b[0]), a[1].max(b[1])]
}

/// The boxes around some primitives and around their centres.
pub(super) fn around(references: &[Reference]) -> (Corners, Centers) {
    references.iter().fold((Corners::EMPTY, NOWHERE), |(bounds, centers), reference| {
        let center = reference.center();
        (bounds.union(&reference.0), both(&centers, &[center, center]))
    })
}

/// Primitives that a node is built over.
struct Part<'a> {
    references: &'a mut [Reference],
    /// The place of the first of them in the tree's order.
    first: u32,
    bounds: Corners,
    /// Only an estimate; of few primitives it means nothing.
    centers: Centers,
    /// Half of the largest surface that may be a leaf of several primitives.
    large: f32,
    terms: Terms,
}

/// Builds a node and those below it.
fn grow(mut part: Part<'_>, depth: u32) -> Branch {
    if part.references.len() < PARALLEL {
        return Branch::Grown(dispatch(Growing { part, depth }));
    }
    let bounds = part.bounds.aabb();
    let scratch = &mut *Scratch::new();
    let halves = dispatch(Halving { part: &mut part, depth, scratch });
    let [left, right] = part.halves(halves.expect("a large part is no leaf"));
    let (left, right) = rayon::join(|| grow(left, depth + 1), || grow(right, depth + 1));
    Branch::Fork(bounds, Box::new([left, right]))
}

/// Splits the primitives of a part.
struct Halving<'a, 'b> {
    part: &'a mut Part<'b>,
    depth: u32,
    scratch: &'a mut Scratch,
}

impl Kernel for Halving<'_, '_> {
    type Output = Option<Halves>;

    #[inline(always)]
    fn run<S: Simd>(self) -> Self::Output {
        self.part.split::<S>(self.depth, self.scratch)
    }
}

/// Builds a node and those below it on one thread: as one kernel, so that nothing is chosen or called
/// for each of them.
struct Growing<'a> {
    part: Part<'a>,
    depth: u32,
}

/// A part that a node is still to be built over.
struct Open<'a> {
    part: Part<'a>,
    depth: u32,
    /// The place of the node.
    place: usize,
}

impl Kernel for Growing<'_> {
    type Output = Vec<Bvh2Node>;

    /// Nodes are in the order of a walk that goes to the left first, both children of one side by side.
    #[inline(always)]
    fn run<S: Simd>(self) -> Self::Output {
        let Self { part, depth } = self;
        let scratch = &mut *Scratch::new();
        // Where leaves hold several primitives, they are more than half full.
        let leaves = part.references.len().div_ceil(part.terms.most.min(2));
        let mut nodes = Vec::with_capacity(2 * leaves);
        nodes.push(Bvh2Node::default());
        let mut open = Vec::with_capacity(USUAL_DEPTH as usize);
        open.push(Open { part, depth, place: 0 });
        while let Some(Open { mut part, depth, place }) = open.pop() {
            let bounds = part.bounds.aabb();
            let Some(halves) = part.split::<S>(depth, scratch) else {
                nodes[place] = Bvh2Node::new(bounds, part.references.len() as u32, part.first);
                continue;
            };
            let [left, right] = part.halves(halves);
            let below = nodes.len();
            nodes[place] = Bvh2Node::new(bounds, 0, below as u32);
            nodes.push(Bvh2Node::default());
            nodes.push(Bvh2Node::default());
            open.push(Open { part: right, depth: depth + 1, place: below + 1 });
            open.push(Open { part: left, depth: depth + 1, place: below });
        }
        nodes
    }
}

/// How many primitives are in the first half of a part, the boxes around both halves and around their
/// centres.
type Halves = (usize, [Corners; 2], [Centers; 2]);

impl<'a> Part<'a> {
    /// Splits the primitives in place. Returns how many are in the first half, the boxes around both
    /// and around their centres; nothing if they are to be a leaf.
    #[inline(always)]
    fn split<S: Simd>(&mut self, depth: u32, scratch: &mut Scratch) -> Option<Halves> {
        let Self { references, centers, terms, .. } = self;
        let terms = *terms;
        let count = references.len();
        let is_large = self.bounds.half_area() > self.large;
        let (most, unparted) = if is_large { (1, 1) } else { (terms.most, terms.unparted()) };
        if count <= unparted || count <= most && is_dense::<S>(references, &self.bounds) {
            return None;
        }
        if depth < USUAL_DEPTH {
            let splitting = Splitting { references, centers, terms, scratch };
            let (best, centers) = splitting.run::<S>();
            if count <= most && terms.cost(self.bounds.half_area(), count) <= best.cost {
                return None;
            }
            if best.count > 0 {
                return Some((best.count, best.halves, centers));
            }
        } else if count <= most {
            return None;
        }
        // By number.
        let (left, right) = references.split_at(count / 2);
        let (left, right) = (around(left), around(right));
        Some((count / 2, [left.0, right.0], [left.1, right.1]))
    }

    #[inline(always)]
    fn halves(self, (count, bounds, centers): Halves) -> [Self; 2] {
        let Self { references, first, large, terms, .. } = self;
        let (front, back) = references.split_at_mut(count);
        let part = |references, first, half: usize| {
            let (bounds, centers) = (bounds[half], centers[half]);
            Part { references, first, bounds, centers, large, terms }
        };
        [part(front, first, 0), part(back, first + count as u32, 1)]
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::Quality;
    use super::super::Boxes;
    use super::super::terms::Effort;
    use super::*;
    use crate::math::{Aabb, Random};
    use glam::Vec3A;

    fn terms(pack_bits: u32, most: usize, quality: Quality) -> Terms {
        Terms { pack_bits, most, effort: Effort::of(quality) }
    }

    fn single() -> Terms {
        terms(0, 1, Quality::Medium)
    }

    fn packed() -> Terms {
        terms(3, 8, Quality::Medium)
    }

    fn boxes(count: u32) -> Vec<Aabb> {
        let mut random = Random::new(&[7, u64::from(count)]);
        let mut point = || Vec3A::from_array(std::array::from_fn(|_| random.next_f32()));
        (0..count)
            .map(|_| (point(), point()))
            .map(|(a, b)| Aabb { min: a, max: a + 0.1 * b })
            .collect()
    }

    fn build_over(boxes: &[Aabb], terms: Terms) -> Bvh2 {
        build(&Boxes(boxes.to_vec()), terms, &mut BuildStages::default())
    }

    fn bounds_of(node: &Bvh2Node) -> Aabb {
        Aabb { min: node.aabb().min, max: node.aabb().max }
    }

    /// Every primitive once, boxes that are the unions of those below, leaves that are not too large:
    /// depth.
    fn check(boxes: &[Aabb], terms: Terms) -> u32 {
        let tree = build_over(boxes, terms);
        let mut seen = vec![false; boxes.len()];
        let mut deepest = 0;
        let mut open = vec![(0, 0)];
        let mut nodes = 0;
        while let Some((index, depth)) = open.pop() {
            nodes += 1;
            let node: &Bvh2Node = &tree.nodes[index as usize];
            deepest = deepest.max(depth);
            let first = node.first_index as usize;
            let expected = if node.is_leaf() {
                let count = node.prim_count as usize;
                assert!(count <= terms.most);
                let mut around = Aabb::EMPTY;
                for &primitive in &tree.primitive_indices[first..first + count] {
                    assert!(!std::mem::replace(&mut seen[primitive as usize], true));
                    around = around.union(boxes[primitive as usize]);
                }
                around
            } else {
                open.extend([(node.first_index, depth + 1), (node.first_index + 1, depth + 1)]);
                let [left, right] = [first, first + 1].map(|child| bounds_of(&tree.nodes[child]));
                left.union(right)
            };
            assert_eq!(bounds_of(node), expected);
        }
        assert!(seen.iter().all(|&seen| seen));
        assert_eq!(nodes, tree.nodes.len());
        deepest
    }

    #[test]
    fn trees_hold_all_primitives_in_the_boxes_around_them() {
        for count in [1, 2, 3, 17, 1000, 70_000] {
            for quality in Quality::ALL {
                check(&boxes(count), terms(0, 1, quality));
                check(&boxes(count), terms(3, 1, quality));
                check(&boxes(count), terms(3, 8, quality));
            }
        }
    }

    #[test]
    fn boxes_far_from_the_origin_are_parted_as_far_as_they_differ() {
        let far = Vec3A::splat(1e7);
        let boxes = boxes(20_000)
            .into_iter()
            .map(|b| Aabb { min: far + 9.0 * b.min, max: far + 9.0 * b.max });
        check(&boxes.collect::<Vec<_>>(), packed());
    }

    #[test]
    fn equal_centers_are_halved() {
        assert_eq!(check(&vec![boxes(1)[0]; 1024], single()), 10);
    }

    #[test]
    fn centers_that_shrink_towards_a_point_make_no_chain() {
        let at = |i: i32| Vec3A::splat(0.5f32.powi(i / 8));
        let boxes: Vec<_> = (0..1000).map(|i| Aabb { min: at(i), max: at(i) }).collect();
        assert!(check(&boxes, single()) < USUAL_DEPTH + 32);
    }

    #[test]
    fn boxes_that_are_not_finite_lose_no_primitive() {
        let mut boxes = boxes(6000);
        for (i, bounds) in boxes.iter_mut().enumerate().filter(|(i, _)| i % 7 == 0) {
            let far = if i % 2 == 0 { f32::INFINITY } else { f32::MAX };
            *bounds = Aabb { min: Vec3A::splat(-far), max: Vec3A::splat(far) };
        }
        check(&boxes, single());
        check(&boxes, packed());
    }

    #[test]
    fn one_large_box_among_small_ones_is_soon_apart() {
        let mut boxes = boxes(40_000);
        boxes.push(Aabb { min: Vec3A::splat(-9.0), max: Vec3A::splat(9.0) });
        let tree = build_over(&boxes, packed());
        let large = tree.nodes.iter().filter(|node| node.aabb().max.x == 9.0).count();
        assert!(large < 20, "{large} nodes");
    }

    #[test]
    fn the_number_of_threads_changes_nothing() {
        let boxes = boxes(50_000);
        let on = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
            pool.expect("a pool").install(|| build_over(&boxes, packed()))
        };
        let (one, three) = (on(1), on(3));
        assert_eq!(one.primitive_indices, three.primitive_indices);
        let corners = |tree: &Bvh2| -> Vec<_> {
            tree.nodes.iter().map(|n| (n.aabb().min, n.aabb().max, n.first_index)).collect()
        };
        assert_eq!(corners(&one), corners(&three));
    }
}
