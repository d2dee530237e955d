//! A tree by the crate [bvh](https://github.com/svenstaro/bvh) 0.13, by its author's name, since `bvh` is taken.
//!
//! From the top, in six buckets along the axis on which centres lie farthest apart; a half is weighed by the square of
//! its box's diagonal, which the library has for its surface. It builds on all threads (`build_par`): each half has
//! places of its own among the nodes, which are as many as it has primitives, so that the tree is the same on any
//! number of threads. Its nodes are public. It calls itself for each level, of which there are fewer than a thousand:
//! each has 5/6 of the length of the one above, or less, along one of the axes, and from the machine's epsilon on it
//! halves by number.

use bvh::aabb::{self, Bounded as HasBox};
use bvh::bounding_hierarchy::{BHShape, BoundingHierarchy};
use bvh::bvh::{Bvh, BvhNode};
use nalgebra::Point3;
use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use rayon::prelude::*;

use super::super::BuildStages;
use super::Boxed;
use super::walked::{self, FORK};

/// Builds a tree over at least one primitive.
pub(super) fn build(primitives: &dyn Boxed, stages: &mut BuildStages) -> Bvh2 {
    walked::build(primitives, walk, stages)
}

/// A box as the library takes it.
struct Shape {
    bounds: aabb::Aabb<f32, 3>,
    /// Where the library puts it, which the library does not need again.
    node: usize,
}

impl HasBox<f32, 3> for Shape {
    fn aabb(&self) -> aabb::Aabb<f32, 3> {
        self.bounds
    }
}

impl BHShape<f32, 3> for Shape {
    fn set_bh_node_index(&mut self, index: usize) {
        self.node = index;
    }

    fn bh_node_index(&self) -> usize {
        self.node
    }
}

/// The nodes of the library's tree.
fn walk(boxes: &[Aabb]) -> Vec<u32> {
    let shape = |bounds: &Aabb| {
        let [min, max] = walked::shown(bounds).map(Point3::from);
        Shape { bounds: aabb::Aabb::with_bounds(min, max), node: 0 }
    };
    let mut shapes: Vec<Shape> = boxes.par_iter().map(shape).collect();
    let tree = <Bvh<f32, 3> as BoundingHierarchy<f32, 3>>::build_par(&mut shapes);
    let mut walk = Vec::with_capacity(tree.nodes.len());
    let mut open = vec![0];
    while let Some(place) = open.pop() {
        match tree.nodes[place] {
            BvhNode::Leaf { shape_index, .. } => walk.push(shape_index as u32),
            BvhNode::Node { child_l_index, child_r_index, .. } => {
                walk.push(FORK);
                open.extend([child_r_index, child_l_index]);
            }
        }
    }
    walk
}
