//! Intel's Embree as a foreign tracer: every object is a geometry of its own in one scene of Embree's.

use std::error::Error;

use crate::accel::Answers;
use crate::embree::{Builder, TriangleScene, Version};
use crate::math::Ray;

use super::foreign::{ForeignBuild, ForeignBytes, ForeignTracer, TriangleObject};

/// Triangles in Embree 4, or else in Embree 3, traced ray by ray or in `PACKETS` of sixteen.
pub(super) struct Embree<const FOUR: bool, const PACKETS: bool>(TriangleScene);

impl<const FOUR: bool, const PACKETS: bool> ForeignTracer for Embree<FOUR, PACKETS> {
    fn build<'a>(
        objects: impl ExactSizeIterator<Item = TriangleObject<'a>>,
        build: &ForeignBuild<'_>,
    ) -> Result<Self, Box<dyn Error + Send + Sync>> {
        let mut builder = Builder::new(if FOUR { Version::Four } else { Version::Three })?;
        for (id, object) in objects.enumerate() {
            builder.add(id as u32, object.positions.iter().copied(), object.triangles)?;
        }
        Ok(Self(builder.build(build.threads)?))
    }

    fn trace(&self, rays: &[Ray], answers: Answers<'_>) {
        let Self(triangles) = self;
        match (answers, PACKETS) {
            (Answers::ClosestHit(hits), false) => triangles.intersect(rays, hits),
            (Answers::ClosestHit(hits), true) => triangles.intersect_packets(rays, hits),
            (Answers::AnyHit(blocked), false) => triangles.occluded(rays, blocked),
            (Answers::AnyHit(blocked), true) => triangles.occluded_packets(rays, blocked),
        }
    }

    fn bytes(&self) -> ForeignBytes {
        ForeignBytes { index: self.0.index_bytes(), triangles: self.0.triangle_bytes() }
    }
}
