//! The binary tree that is collapsed: a primitive in each leaf.
//!
//! Quick builds cluster from the bottom: PLOC (Meister, Bittner: *Parallel Locally-Ordered
//! Clustering for Bounding Volume Hierarchy Construction*, 2018) by obvhs. All others part from the
//! top (`binned.rs`): that takes a little longer, and a ray then costs less than in the trees of
//! obvhs's slowest build. Slow builds try to improve it by obvhs's reinsertion (Meister, Bittner:
//! *Parallel Reinsertion for Bounding Volume Hierarchy Optimization*, 2018).

use obvhs::aabb::Aabb;
use obvhs::bvh2::Bvh2;
use obvhs::bvh2::reinsertion::ReinsertionOptimizer;
use obvhs::ploc::PlocBuilder;

use crate::accel::{BuildStages, Quality};

use super::binned;
use super::collapse::Leaves;

/// Builds a tree over at least one box.
pub(super) fn binary_tree(
    boxes: &[Aabb],
    leaves: Leaves,
    quality: Quality,
    stages: &mut BuildStages,
) -> Bvh2 {
    let parameters = quality.parameters();
    let mut tree = stages.time("tree", || match quality {
        Quality::Fastest | Quality::Fast => PlocBuilder::with_capacity(boxes.len()).build(
            parameters.ploc_search_distance,
            boxes,
            (0..boxes.len() as u32).collect(),
            parameters.sort_precision,
            parameters.search_depth_threshold,
        ),
        Quality::Medium | Quality::Slow | Quality::Slowest => {
            binned::build(boxes, leaves.block as u32)
        }
    });
    // The medium tree is as good without.
    if quality != Quality::Medium && parameters.reinsertion_batch_ratio > 0.0 {
        stages.time("reinsertion", || {
            let ratio = parameters.reinsertion_batch_ratio;
            ReinsertionOptimizer::default().run(&mut tree, ratio, None);
        });
    }
    tree
}
