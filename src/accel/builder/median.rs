//! A tree whose nodes have as many primitives on one side as on the other.
//!
//! Kay, Kajiya: *Ray Tracing Complex Scenes*, 1986. Primitives are parted by number at the median of
//! their centres. There the axes take turns; here it is the axis along which the centres lie farthest
//! apart. The depth is ⌈log₂ n⌉, whatever the primitives are, and so it is built in O(n log n). Where
//! large and small ones, or dense and empty parts, lie side by side, rays pay for what the surface area
//! heuristic would have seen.

use glam::Vec4;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;

use super::super::BuildStages;
use super::Boxed;
use super::bins::widest_axis;
use super::reference::{NOWHERE, Reference};
use super::top_down::{self, Division};

/// Builds a tree over at least one primitive.
pub(super) fn build(primitives: &dyn Boxed, stages: &mut BuildStages) -> Bvh2 {
    let mut references = stages.time("boxes", || primitives.references());
    stages.time("tree", || top_down::build(&Median, &mut references))
}

struct Median;

impl Division for Median {
    type Item = Reference;

    fn divide(&self, references: &mut [Reference]) -> usize {
        let around = references.iter().fold(NOWHERE, |[low, high], reference| {
            let center = reference.center();
            // What is not a number, of a box that is not finite, has no place.
            let center = Vec4::select(center.cmpeq(center), center, Vec4::ZERO);
            [low.min(center), high.max(center)]
        });
        let axis = widest_axis(&around);
        let half = references.len() / 2;
        // Of equal centres the smaller index comes first, so that there is one order.
        references.select_nth_unstable_by(half, |a, b| {
            let by_center = a.center()[axis].total_cmp(&b.center()[axis]);
            by_center.then_with(|| a.index().cmp(&b.index()))
        });
        half
    }

    fn leaf(&self, reference: &Reference) -> (u32, Aabb) {
        (reference.index(), reference.0.aabb())
    }
}
