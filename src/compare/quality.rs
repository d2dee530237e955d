//! What a structure is, as the report states it: form, quality and memory.
//!
//! End-point overlap is left out: it takes every triangle's area in every node it overlaps without
//! belonging to it, which the interface to structures does not tell.

use crate::record::{Memory, Shape};
use crate::scene::{BuildReport, Scene};

/// The form of the structures over the meshes; in a scene without meshes, of that over the objects.
pub(super) fn shape(report: &BuildReport, scene: &Scene) -> Shape {
    let has_meshes = report.triangles > 0;
    let shape = if has_meshes { &report.meshes } else { &report.objects };
    let primitives = if has_meshes { report.triangles } else { scene.objects.len() as u64 };
    let sizes = shape.leaf_sizes.iter().enumerate();
    Shape {
        nodes: shape.nodes,
        leaves: shape.leaves,
        depth: shape.depth,
        references: sizes.map(|(size, leaves)| size as u64 * leaves).sum(),
        leaf_sizes: trimmed(&shape.leaf_sizes),
        primitives,
        sah_cost: shape.sah_cost,
        epo: None,
    }
}

/// A histogram that ends with a leaf of each mesh (`none`) is as long as the mesh; such a one says
/// nothing and is left out.
fn trimmed(sizes: &[u64]) -> Vec<u64> {
    const LONGEST: usize = 1_024;
    if sizes.len() > LONGEST { Vec::new() } else { sizes.to_vec() }
}

/// The bytes of both levels, and of the triangles.
pub(super) fn memory(report: &BuildReport, peak_resident_bytes: Option<u64>) -> Memory {
    Memory {
        index_bytes: report.objects.bytes + report.meshes.bytes,
        primitive_bytes: report.triangle_bytes,
        peak_resident_bytes,
    }
}
