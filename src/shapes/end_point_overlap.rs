//! End-point overlap: how much of the surfaces lies in boxes that it does not belong to.
//!
//! Aila, Karras, Laine: *On Quality Metrics of Bounding Volume Hierarchies*, HPG 2013. A ray that
//! ends on a surface must enter every box that the end lies in. Those of the tree above the
//! surface are its due; the others are waste, which the surface area heuristic does not see:
//!
//! EPO = Σ over nodes *n* of C(*n*) · A((S \ Q(*n*)) ∩ *n*) / A(S)
//!
//! S is the whole surface, Q(*n*) that of the triangles below the node, A area, and C what a ray
//! that enters has to pay ([`TreeNode::cost`](crate::accel::TreeNode::cost)). A triangle that several
//! leaves refer to is one part of the surface, and below every node above any of these leaves.

use std::collections::HashSet;

use glam::DVec3;
use rayon::iter::{IntoParallelIterator, ParallelIterator};

use crate::accel::Tree;
use crate::math::Random;

use super::TriangleSet;
use super::clip::{area, area_within};

/// Up to so many triangles all are clipped; of more, as many are chosen.
pub const OVERLAP_SAMPLES: usize = 20_000;

/// What a ray's end costs in boxes that it does not belong to.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct EndPointOverlap {
    /// The mean over the surface.
    pub cost: f64,
    /// The standard error of the mean; 0 if all triangles were clipped.
    pub standard_error: f64,
    /// How many triangles were chosen, by area and with a seed; `None` if all were clipped.
    pub samples: Option<u64>,
}

impl EndPointOverlap {
    /// The cost of a ray that ends in two meshes: costs are added, as for the surface area heuristic.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self {
            cost: self.cost + other.cost,
            standard_error: self.standard_error.hypot(other.standard_error),
            samples: match (self.samples, other.samples) {
                (Some(a), Some(b)) => Some(a + b),
                (a, b) => a.or(b),
            },
        }
    }
}

/// The overlap of a tree over some triangles, on the threads of the current rayon pool: of all
/// triangles, or of at most `most`, chosen with a chance proportional to their areas.
///
/// 0 for a surface without area.
#[must_use]
pub fn end_point_overlap(
    tree: &Tree,
    triangles: &TriangleSet,
    most: usize,
    seed: u64,
) -> EndPointOverlap {
    let references = References::new(tree, triangles);
    let slots = &references.slots;
    // The areas of all triangles up to one, and with it.
    let mut sum = 0.0;
    let sums: Vec<f64> = slots
        .iter()
        .map(|&slot| {
            sum += area(triangles.corners(slot));
            sum
        })
        .collect();
    if sum.is_nan() || sum <= 0.0 {
        return EndPointOverlap::default();
    }
    let waste = |index: usize| {
        let slot = slots[index];
        waste(tree, references.leaves_of(triangles.prim(slot)), triangles.corners(slot))
    };
    if slots.len() <= most {
        // Added in order: the sum shall not depend on the threads.
        let each: Vec<f64> = (0..slots.len()).into_par_iter().map(waste).collect();
        return EndPointOverlap { cost: each.iter().sum::<f64>() / sum, ..Default::default() };
    }
    let mut random = Random::new(&[seed]);
    let mut choose = || {
        let place = f64::from(random.next_f32()) * sum;
        sums.partition_point(|&sum| sum <= place).min(slots.len() - 1)
    };
    let chosen: Vec<usize> = (0..most).map(|_| choose()).collect();
    let of_its_area = |index: usize| waste(index) / area(triangles.corners(slots[index]));
    let each: Vec<f64> = chosen.into_par_iter().map(of_its_area).collect();
    sampled(&each)
}

/// Which leaves refer to which triangles.
struct References {
    /// A slot of each triangle: of copies the first in the order of a walk.
    slots: Vec<u32>,
    /// Each triangle's id with each of its leaves, in ascending order.
    leaves: Vec<(u32, usize)>,
}

impl References {
    fn new(tree: &Tree, triangles: &TriangleSet) -> Self {
        let mut seen = HashSet::new();
        let (mut slots, mut leaves) = (Vec::new(), Vec::new());
        for (slot, leaf) in tree.slots() {
            let prim = triangles.prim(slot);
            leaves.push((prim, leaf));
            if seen.insert(prim) {
                slots.push(slot);
            }
        }
        leaves.sort_unstable();
        Self { slots, leaves }
    }

    /// A triangle's leaves, in ascending order.
    fn leaves_of(&self, prim: u32) -> &[(u32, usize)] {
        let first = self.leaves.partition_point(|&(other, _)| other < prim);
        let count = self.leaves[first..].partition_point(|&(other, _)| other == prim);
        &self.leaves[first..first + count]
    }
}

/// The mean of what was found at chosen places.
fn sampled(each: &[f64]) -> EndPointOverlap {
    let count = each.len() as f64;
    let cost = each.iter().sum::<f64>() / count;
    let squares: f64 = each.iter().map(|x| (x - cost).powi(2)).sum();
    let standard_error = (squares / (count - 1.0).max(1.0) / count).sqrt();
    EndPointOverlap { cost, standard_error, samples: Some(each.len() as u64) }
}

/// The area of a triangle within each box that it does not belong to, times the node's cost.
///
/// Nodes below a box that it does not meet are left out, as a ray's search leaves them out.
fn waste(tree: &Tree, leaves: &[(u32, usize)], corners: [DVec3; 3]) -> f64 {
    let nodes = tree.nodes();
    let (mut at, mut waste) = (0, 0.0);
    while let Some(node) = nodes.get(at) {
        let next = leaves.partition_point(|&(_, leaf)| leaf < at);
        let is_below = leaves.get(next).is_some_and(|&(_, leaf)| leaf < node.end);
        if !is_below {
            let area = area_within(corners, &node.bounds);
            if area == 0.0 {
                at = node.end;
                continue;
            }
            waste += node.cost() * area;
        }
        at += 1;
    }
    waste
}

#[cfg(test)]
mod tests {
    use glam::Vec3;

    use super::*;
    use crate::accel::{
        Accel, Bounded as _, BuildConfig, Bvh, CompressedWideBvh, Exhaustive, Indexed,
        Primitives as _,
    };
    use crate::math::Aabb;

    fn set(corners: &[[f32; 3]]) -> TriangleSet {
        let positions: Vec<Vec3> = corners.iter().copied().map(Vec3::from).collect();
        let corners = (0..positions.len() as u32).collect::<Vec<_>>();
        TriangleSet::new(&positions, corners.as_chunks::<3>().0)
    }

    /// The tree of a structure with a triangle a leaf, and the triangles in its order.
    fn tree<A: Accel>(triangles: TriangleSet) -> (Tree, TriangleSet) {
        let config = BuildConfig { max_leaf: 1, ..BuildConfig::default() };
        let indexed: Indexed<_, A> = Indexed::build(triangles, &config);
        (indexed.tree().unwrap(), indexed.primitives().clone())
    }

    fn exact<A: Accel>(triangles: &TriangleSet) -> f64 {
        let (tree, triangles) = tree::<A>(triangles.clone());
        let overlap = end_point_overlap(&tree, &triangles, usize::MAX, 1);
        assert_eq!((overlap.standard_error, overlap.samples), (0.0, None));
        overlap.cost
    }

    /// Right triangles with legs of 2, the second one moved.
    fn pair(by: [f32; 3]) -> TriangleSet {
        let first = [[0.0; 3], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0]];
        let second = first.map(|p| [p[0] + by[0], p[1] + by[1], p[2] + by[2]]);
        set(&[first, second].concat())
    }

    #[test]
    fn two_triangles_apart_waste_nothing() {
        let apart = pair([0.0, 0.0, 1.0]);
        assert_eq!(exact::<Bvh>(&apart), 0.0);
        assert_eq!(exact::<CompressedWideBvh>(&apart), 0.0);
        let none: Indexed<_, Exhaustive> = Indexed::build(apart, &BuildConfig::default());
        assert_eq!(none.tree(), None);
    }

    #[test]
    fn two_boxes_that_overlap_waste_what_lies_in_both() {
        // Of the first triangle a corner of area 1/2 lies in the box of the second; of the second
        // one, all but two corners of area 1/8 lie in the box of the first. The area is 4.
        let overlapping = pair([0.5, 0.5, 0.0]);
        let waste = exact::<Bvh>(&overlapping);
        assert!((waste - (0.5 + 1.75) / 4.0).abs() < 1e-12, "{waste}");
        // Its planes lie on the grid of the compressed boxes.
        let compressed = exact::<CompressedWideBvh>(&overlapping);
        assert!((compressed - 0.5625).abs() < 0.02, "{compressed}");
    }

    #[test]
    fn a_triangle_of_two_leaves_is_counted_once_and_belongs_to_both() {
        let mut triangles = pair([0.5, 0.5, 0.0]);
        let boxes = [0, 1].map(|index| triangles.bounds(index));
        triangles.reorder(&[0, 1, 0]);
        let tree = Tree::of(0, |&node: &u32, children| match node {
            0 => {
                children.extend([1, 2]);
                (Aabb::EMPTY, 0..0)
            }
            1 => (boxes[0], 0..1),
            _ => (boxes[1], 1..3),
        });
        // The second triangle lies in the box of the first, with 7/4 of its area; the first belongs
        // to either box. The area is 4.
        let waste = end_point_overlap(&tree, &triangles, usize::MAX, 1).cost;
        assert!((waste - 1.75 / 4.0).abs() < 1e-12, "{waste}");
    }

    /// Small triangles all over a cube, and a large one.
    fn soup(count: usize) -> TriangleSet {
        let mut random = Random::new(&[7]);
        let mut point = |size: f32| std::array::from_fn(|_| size * random.next_f32());
        let mut corners: Vec<[f32; 3]> = Vec::new();
        for _ in 1..count {
            let place: [f32; 3] = point(4.0);
            for _ in 0..3 {
                let p: [f32; 3] = point(1.0);
                corners.push(std::array::from_fn(|axis| place[axis] + p[axis]));
            }
        }
        corners.extend([[0.0; 3], [4.0, 0.0, 4.0], [0.0, 4.0, 4.0]]);
        set(&corners)
    }

    #[test]
    fn the_walk_agrees_with_the_definition() {
        let (tree, triangles) = tree::<Bvh>(soup(150));
        let mut defined = 0.0;
        for (at, node) in tree.nodes().iter().enumerate().skip(1) {
            let outside = |&(_, leaf): &(u32, usize)| !(at..node.end).contains(&leaf);
            let within = |(slot, _)| area_within(triangles.corners(slot), &node.bounds);
            defined += node.cost() * tree.slots().filter(outside).map(within).sum::<f64>();
        }
        let total: f64 = tree.slots().map(|(slot, _)| area(triangles.corners(slot))).sum();
        let walked = end_point_overlap(&tree, &triangles, usize::MAX, 1).cost;
        assert!(walked > 1.0 && (walked - defined / total).abs() < 1e-9 * walked);
    }

    #[test]
    fn a_choice_of_triangles_is_right_within_its_error() {
        let (tree, triangles) = tree::<Bvh>(soup(2_000));
        let all = end_point_overlap(&tree, &triangles, usize::MAX, 1).cost;
        for seed in 0..5 {
            let some = end_point_overlap(&tree, &triangles, 500, seed);
            assert_eq!(some.samples, Some(500));
            assert!(some.standard_error > 0.0 && some.standard_error < 0.1 * all);
            assert!((some.cost - all).abs() < 4.0 * some.standard_error, "{some:?} of {all}");
        }
    }

    #[test]
    fn what_has_no_area_wastes_nothing() {
        let (tree, triangles) = tree::<Bvh>(set(&[[1.0; 3]; 6]));
        assert_eq!(end_point_overlap(&tree, &triangles, 9, 1), EndPointOverlap::default());
        let one = EndPointOverlap { cost: 1.0, standard_error: 3.0, samples: Some(5) };
        let two = EndPointOverlap { cost: 2.0, standard_error: 4.0, samples: None };
        let sum = EndPointOverlap { cost: 3.0, standard_error: 5.0, samples: Some(5) };
        assert_eq!(one.and(two), sum);
    }
}
