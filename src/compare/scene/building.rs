//! The first step: builds all structures, to be traced, and notes what they are.

use std::time::Duration;

use crate::compare::candidate::Candidate;
use crate::compare::clock::nanoseconds;
use crate::compare::context::SceneContext;
use crate::compare::machine::{forget_peak, peak_resident_bytes};
use crate::record::{BuildStage, Memory, ShapeRecord};
use crate::scene::{BuildReport, Scene};

/// Builds on all threads, and fills in form, memory and the stages of the build.
pub(super) fn build_all(context: &SceneContext<'_>, candidates: &mut [Candidate<'_>]) {
    for candidate in candidates {
        let peak_is_its_own = forget_peak();
        context.pools.all.install(|| candidate.build(context.scene, &context.plan.build));
        let peak = if peak_is_its_own { peak_resident_bytes() } else { None };
        if let Some(report) = candidate.build_report() {
            let has_shape = !candidate.is_peer();
            candidate.record.shape = has_shape.then(|| shape(&report, context.scene));
            candidate.record.build.stages = build_stages(&report);
            candidate.record.memory = Some(memory(&report, peak));
        }
    }
}

/// What the build spent its time on.
pub(super) fn build_stages(report: &BuildReport) -> Vec<BuildStage> {
    let stage = |(name, time): (&str, Duration)| BuildStage {
        name: name.to_owned(),
        ns: nanoseconds(time),
    };
    report.stages.iter().map(stage).collect()
}

/// The form of the structures over the meshes; in a scene without meshes, of that over the objects.
fn shape(report: &BuildReport, scene: &Scene) -> ShapeRecord {
    let has_meshes = report.triangles > 0;
    let shape = if has_meshes { &report.meshes } else { &report.objects };
    let primitives = if has_meshes { report.triangles } else { scene.objects.len() as u64 };
    let sizes = shape.leaf_sizes.iter().enumerate();
    ShapeRecord {
        nodes: shape.nodes,
        leaves: shape.leaves,
        depth: shape.depth,
        references: sizes.map(|(size, leaves)| size as u64 * leaves).sum(),
        leaf_sizes: without_long_histograms(&shape.leaf_sizes),
        primitives,
        sah_cost: shape.sah_cost,
        // Measured in a later step, because it takes longer than all of this.
        epo: None,
        epo_standard_error: None,
        epo_samples: None,
    }
}

/// A structure with one leaf a mesh (`none`) has a histogram as long as the largest mesh, which shows
/// nothing and is left out.
fn without_long_histograms(leaf_sizes: &[u64]) -> Vec<u64> {
    const LONGEST: usize = 1_024;
    if leaf_sizes.len() > LONGEST { Vec::new() } else { leaf_sizes.to_vec() }
}

/// The bytes of both levels, and of the triangles.
fn memory(report: &BuildReport, peak_resident_bytes: Option<u64>) -> Memory {
    Memory {
        index_bytes: report.objects.bytes + report.meshes.bytes,
        primitive_bytes: report.triangle_bytes,
        peak_resident_bytes,
    }
}
