//! obvhs's binary tree, walked by this project's own slab test.
//!
//! The tree is built by PLOC (Meister, Bittner: *Parallel Locally-Ordered Clustering for Bounding
//! Volume Hierarchy Construction*, 2018), improved by reinsertion (Meister, Bittner: *Parallel
//! Reinsertion for Bounding Volume Hierarchy Optimization*, 2018), and its leaves are collapsed by
//! the surface area heuristic: all by obvhs. obvhs's own traversal prunes with `<` and knows no
//! padding, so it cannot keep the contract of [`Accel`]; the walk below does.

use std::ops::{ControlFlow, Range};

use obvhs::bvh2::builder::build_bvh2;
use obvhs::bvh2::node::Bvh2Node;
use smallvec::SmallVec;

use crate::counters::Counters;
use crate::math::{Aabb, BoxRay, NONE, Ray};

use super::{Accel, Bounded, BuildConfig, Built, StructureShape, obvhs_boxes};

/// The stack lives with the call up to this depth, and on the heap beyond.
const USUAL_DEPTH: usize = 64;

/// A binary tree of boxes.
#[derive(Clone, Debug)]
pub struct Bvh {
    nodes: Vec<Bvh2Node>,
}

impl Accel for Bvh {
    fn build(primitives: &impl Bounded, config: &BuildConfig) -> Built<Self> {
        if primitives.count() == 0 {
            return Built { accel: Self { nodes: Vec::new() }, order: Some(Vec::new()) };
        }
        let mut parameters = config.quality.parameters();
        parameters.max_prims_per_leaf = parameters.max_prims_per_leaf.min(config.max_leaf);
        let boxes = obvhs_boxes(primitives);
        let tree = build_bvh2(&boxes, parameters, &mut std::time::Duration::default());
        let mut nodes = tree.nodes;
        let order = align_leaves(&mut nodes, &tree.primitive_indices, primitives.lanes());
        nodes.shrink_to_fit();
        Built { accel: Self { nodes }, order: Some(order) }
    }

    #[inline]
    fn traverse<C: Counters>(
        &self,
        ray: &Ray,
        box_ray: &BoxRay,
        counters: &mut C,
        mut leaf: impl FnMut(Range<u32>, &mut C) -> ControlFlow<(), f32>,
    ) {
        let Some(root) = self.nodes.first() else { return };
        let mut end = ray.t_max;
        let enter = |node: &Bvh2Node, end: f32| {
            let (near, far) = box_ray.interval(&node_box(node));
            let near = near.max(ray.t_min);
            (near <= far.min(end)).then_some(near)
        };
        counters.boxes(1);
        if enter(root, end).is_none() {
            return;
        }
        let mut stack = SmallVec::<[(u32, f32); USUAL_DEPTH]>::new();
        let mut node = root;
        loop {
            if node.is_leaf() {
                let slots = node.first_index..node.first_index + node.prim_count;
                match leaf(slots, counters) {
                    ControlFlow::Continue(t) => end = t,
                    ControlFlow::Break(()) => return,
                }
            } else {
                let first = node.first_index;
                let [left, right] = [first, first + 1].map(|i| enter(self.node(i), end));
                counters.boxes(2);
                match (left, right) {
                    (Some(l), Some(r)) => {
                        // The nearer child first, the other kept with where it begins.
                        let left_is_near = l <= r;
                        let (near, far) = if left_is_near { (0, 1) } else { (1, 0) };
                        stack.push((first + far, if left_is_near { r } else { l }));
                        node = self.node(first + near);
                        continue;
                    }
                    (Some(_), None) => {
                        node = self.node(first);
                        continue;
                    }
                    (None, Some(_)) => {
                        node = self.node(first + 1);
                        continue;
                    }
                    (None, None) => {}
                }
            }
            loop {
                let Some((next, near)) = stack.pop() else { return };
                if near <= end {
                    node = self.node(next);
                    break;
                }
            }
        }
    }

    fn shape(&self) -> StructureShape {
        let mut shape = StructureShape::default();
        let mut open = if self.nodes.is_empty() { vec![] } else { vec![(0, 0)] };
        while let Some((index, depth)) = open.pop() {
            let node = self.node(index);
            if node.is_leaf() {
                shape.add_leaf(node.prim_count, depth);
            } else {
                shape.nodes += 1;
                open.extend([(node.first_index, depth + 1), (node.first_index + 1, depth + 1)]);
            }
        }
        shape.bytes = (size_of::<Self>() + self.nodes.capacity() * size_of::<Bvh2Node>()) as u64;
        shape
    }
}

impl Bvh {
    #[inline]
    fn node(&self, index: u32) -> &Bvh2Node {
        &self.nodes[index as usize]
    }
}

#[inline]
fn node_box(node: &Bvh2Node) -> Aabb {
    let aabb = node.aabb();
    Aabb { min: aabb.min, max: aabb.max }
}

/// Moves every leaf's range to a multiple of `lanes`; returns slot → primitive index, with
/// [`NONE`] between leaves.
fn align_leaves(nodes: &mut [Bvh2Node], indices: &[u32], lanes: u32) -> Vec<u32> {
    let mut order = Vec::with_capacity(indices.len());
    // From the root, so that leaves lie in the order in which a walk meets them.
    let mut open = vec![0];
    while let Some(index) = open.pop() {
        let node = &mut nodes[index as usize];
        let first = node.first_index;
        if node.is_leaf() {
            order.resize(order.len().next_multiple_of(lanes as usize), NONE);
            node.first_index = order.len() as u32;
            order.extend_from_slice(&indices[first as usize..(first + node.prim_count) as usize]);
        } else {
            open.extend([first + 1, first]);
        }
    }
    order
}
