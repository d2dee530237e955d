//! What a structure is, as the report states it: form, quality and memory.

use std::time::Duration;

use crate::record::{BuildStage, Memory, ShapeRecord};
use crate::scene::{BuildReport, Scene, TracedWorld};

use super::Stage;
use super::entrant::Entrant;

/// What the build spent its time on.
pub(super) fn build_stages(report: &BuildReport) -> Vec<BuildStage> {
    let stage = |(name, time): (&str, Duration)| BuildStage {
        name: name.to_owned(),
        ns: u64::try_from(time.as_nanos()).unwrap_or(u64::MAX),
    };
    report.stages.iter().map(stage).collect()
}

/// The form of the structures over the meshes; in a scene without meshes, of that over the objects.
pub(super) fn shape(report: &BuildReport, scene: &Scene) -> ShapeRecord {
    let has_meshes = report.triangles > 0;
    let shape = if has_meshes { &report.meshes } else { &report.objects };
    let primitives = if has_meshes { report.triangles } else { scene.objects.len() as u64 };
    let sizes = shape.leaf_sizes.iter().enumerate();
    ShapeRecord {
        nodes: shape.nodes,
        leaves: shape.leaves,
        depth: shape.depth,
        references: sizes.map(|(size, leaves)| size as u64 * leaves).sum(),
        leaf_sizes: trimmed(&shape.leaf_sizes),
        primitives,
        sah_cost: shape.sah_cost,
        // Measured later, and once: it takes longer than all of this.
        epo: None,
        epo_standard_error: None,
        epo_samples: None,
    }
}

/// Adds the end-point overlap to the forms of trees.
pub(super) fn add_overlap(entrants: &mut [Entrant<'_>], stage: &Stage<'_>) {
    let seed = stage.plan.picture.seed;
    for entrant in entrants {
        let measure =
            |world: &dyn TracedWorld| stage.pools.all.install(|| world.end_point_overlap(seed));
        let overlap = entrant.attempt(measure).flatten();
        if let Some((shape, overlap)) = entrant.record.shape.as_mut().zip(overlap) {
            shape.epo = Some(overlap.cost);
            shape.epo_standard_error = overlap.samples.map(|_| overlap.standard_error);
            shape.epo_samples = overlap.samples;
        }
        if (stage.cancelled)() {
            return;
        }
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
