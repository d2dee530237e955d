//! A tree along Morton's curve whose upper nodes are parted by the surface area heuristic.
//!
//! Pantaleoni, Luebke: *HLBVH: Hierarchical LBVH Construction for Real-Time Ray Tracing of Dynamic Geometry*, 2010, and
//! Garanzha, Pantaleoni, McAllister: *Simpler and Faster HLBVH with Work Queues*, 2011. Primitives that share the first
//! bits of their codes are a cluster: a cell of a coarse grid. Each cluster is a tree of [`lbvh`](super::lbvh); the
//! tree over the clusters, which is small and visited by every ray, is that of [`binned`](super::binned).

use obvhs::bvh2::Bvh2;
use rayon::prelude::*;

use crate::math::Aabb;

use super::super::BuildStages;
use super::branch::Branch;
use super::lbvh::{CODE_BITS, Coded, Curve, coded};
use super::terms::{Effort, Terms};
use super::{Boxed, Boxes, binned, top_down};

/// The bits that the codes of a cluster share: cells of a grid of 16 along each axis.
const SHARED: u32 = 12;

/// Builds a tree over at least one primitive.
pub(super) fn build(primitives: &dyn Boxed, effort: Effort, stages: &mut BuildStages) -> Bvh2 {
    let boxes = stages.time("boxes", || primitives.obvhs_boxes());
    let mut coded = stages.time("codes", || coded(&boxes));
    stages.time("sort", || coded.par_sort_unstable());
    let clusters = stages.time("clusters", || clusters(&Curve(&boxes), &mut coded));
    let bounds = clusters.iter().map(|cluster| {
        let bounds = cluster.bounds();
        Aabb { min: bounds.min, max: bounds.max }
    });
    let terms = Terms { pack_bits: 0, most: 1, effort };
    let above = binned::build(&Boxes(bounds.collect()), terms, &mut BuildStages::default());
    stages.time("tree", || {
        let mut clusters: Vec<Option<Branch>> = clusters.into_iter().map(Some).collect();
        let nodes = joined(&above, 0, &mut clusters).into_nodes();
        let primitive_indices = coded.par_iter().map(|one| one.index).collect();
        Bvh2 { nodes, primitive_indices, ..Bvh2::default() }
    })
}

/// The trees of the clusters, in the order of the curve.
fn clusters(curve: &Curve<'_>, coded: &mut [Coded]) -> Vec<Branch> {
    let cell = |one: &Coded| one.code >> (CODE_BITS - SHARED);
    let mut first = 0;
    let mut clusters = Vec::new();
    for cluster in coded.chunk_by_mut(|a, b| cell(a) == cell(b)) {
        let count = cluster.len() as u32;
        clusters.push((cluster, first));
        first += count;
    }
    let grown = clusters.into_par_iter().map(|(items, first)| top_down::grow(curve, items, first));
    grown.collect()
}

/// The tree below a node of that over the clusters, each of which is taken once.
fn joined(above: &Bvh2, node: usize, clusters: &mut [Option<Branch>]) -> Branch {
    let node = &above.nodes[node];
    let first = node.first_index as usize;
    if node.is_leaf() {
        let cluster = above.primitive_indices[first] as usize;
        return clusters[cluster].take().expect("a leaf holds one cluster, each once");
    }
    let below = [first, first + 1].map(|child| joined(above, child, clusters));
    Branch::Fork(*node.aabb(), Box::new(below))
}
