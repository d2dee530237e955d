//! A scene traced by Embree: a yardstick, whose hits differ from ours in their last bits.
//!
//! Every object is a geometry of its own in one scene of Embree's. Objects with a transform are
//! baked: their corners go to the world by the transform in `f64`, and are rounded once. (A mesh
//! that many objects share is stored for each of them.) Balls and cylinders are refused.

use std::time::{Duration, Instant};

use glam::Vec3;

use crate::accel::{Answers, BuildStages, Scratch, StructureShape, Tracer};
use crate::counters::Counts;
use crate::description::Shape;
use crate::embree::{Builder, EmbreeError, TriangleScene};
use crate::math::Ray;
use crate::shapes::{EndPointOverlap, Single};

use super::{BuildError, BuildReport, Object, Scene, TracedWorld};

/// A scene in Embree, traced ray by ray or in `PACKETS`.
pub(super) struct EmbreeWorld<const PACKETS: bool> {
    triangles: TriangleScene,
    count: u64,
    build_time: Duration,
}

impl<const PACKETS: bool> EmbreeWorld<PACKETS> {
    /// Hands a scene to Embree, which builds on as many threads as the current rayon pool has.
    pub(super) fn build(scene: &Scene) -> Result<Self, BuildError> {
        let start = Instant::now();
        let failed = |error: EmbreeError| BuildError::Library { text: error.to_string() };
        let mut builder = Builder::new().map_err(failed)?;
        for (id, object) in scene.objects.iter().enumerate() {
            add(&mut builder, scene, id, object)?.map_err(failed)?;
        }
        let triangles = builder.build(rayon::current_num_threads()).map_err(failed)?;
        Ok(Self { triangles, count: scene.triangle_count(), build_time: start.elapsed() })
    }
}

/// Hands over an object.
fn add(
    builder: &mut Builder,
    scene: &Scene,
    id: usize,
    object: &Object,
) -> Result<Result<(), EmbreeError>, BuildError> {
    let transform = scene.transform_of(object);
    let to_world = |p: Vec3| match &transform {
        Some(transform) => transform.world_from_object.transform_point3(p.as_dvec3()).as_vec3(),
        None => p,
    };
    Ok(match object.shape {
        Shape::Single(Single::Triangle(triangle)) => {
            let corners = [triangle.v0, triangle.v0 + triangle.e1, triangle.v0 + triangle.e2];
            builder.add(id as u32, corners.into_iter().map(to_world), &[[0, 1, 2]])
        }
        Shape::Mesh { mesh, .. } => {
            let mesh = &scene.meshes()[mesh];
            builder.add(id as u32, mesh.positions.iter().copied().map(to_world), &mesh.triangles)
        }
        Shape::Single(other) => {
            return Err(BuildError::Unsupported { object: id, shape: other.name() });
        }
    })
}

impl<const PACKETS: bool> Tracer for EmbreeWorld<PACKETS> {
    fn trace(&self, rays: &[Ray], answers: Answers<'_>, _: &mut Scratch, _: Option<&mut Counts>) {
        match (answers, PACKETS) {
            (Answers::ClosestHit(hits), false) => self.triangles.intersect(rays, hits),
            (Answers::ClosestHit(hits), true) => self.triangles.intersect_packets(rays, hits),
            (Answers::AnyHit(blocked), false) => self.triangles.occluded(rays, blocked),
            (Answers::AnyHit(blocked), true) => self.triangles.occluded_packets(rays, blocked),
        }
    }
}

impl<const PACKETS: bool> TracedWorld for EmbreeWorld<PACKETS> {
    fn build_report(&self) -> BuildReport {
        let bytes = self.triangles.index_bytes();
        BuildReport {
            time: self.build_time,
            stages: BuildStages::default(),
            objects: StructureShape::default(),
            meshes: StructureShape { bytes, ..StructureShape::default() },
            triangles: self.count,
            triangle_bytes: self.triangles.triangle_bytes(),
        }
    }

    /// Embree shows no tree.
    fn end_point_overlap(&self, _: u64) -> Option<EndPointOverlap> {
        None
    }
}
