//! The binary tree that is collapsed: a primitive in each leaf.
//!
//! Built by obvhs: PLOC (Meister, Bittner: *Parallel Locally-Ordered Clustering for Bounding Volume
//! Hierarchy Construction*, 2018), improved by reinsertion (Meister, Bittner: *Parallel Reinsertion
//! for Bounding Volume Hierarchy Optimization*, 2018).

use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::reinsertion::ReinsertionOptimizer;
use obvhs::ploc::PlocBuilder;

use crate::accel::{BuildStages, Quality};

/// Builds a tree over at least one box.
pub(super) fn binary_tree(boxes: &[Aabb], quality: Quality, stages: &mut BuildStages) -> Bvh2 {
    let parameters = quality.parameters();
    let mut tree = stages.time("clustering", || {
        PlocBuilder::with_capacity(boxes.len()).build(
            parameters.ploc_search_distance,
            boxes,
            (0..boxes.len() as u32).collect(),
            parameters.sort_precision,
            parameters.search_depth_threshold,
        )
    });
    let first = parameters.reinsertion_batch_ratio;
    let second = first * parameters.post_collapse_reinsertion_batch_ratio_multiplier;
    stages.time("reinsertion", || {
        let mut optimizer = ReinsertionOptimizer::default();
        optimizer.run(&mut tree, first, None);
        optimizer.run(&mut tree, second, None);
    });
    tree
}
