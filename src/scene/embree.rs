//! Intel's Embree as a foreign tracer: every object is a geometry of its own in one scene of Embree's.
//!
//! It is compared as it is shipped alone. The nodes of a scene's tree cannot be read through its interface, and a
//! geometry of the user's, which would let this project's formula decide, gets its candidates from a test of boxes that
//! rounds in Embree's own way: which primitive is offered where a ray meets the edge of its box is no promise, and so
//! equal hits would be none. Its `rtcBuildBVH`, which builds a tree of the caller's own nodes over any boxes, is
//! another builder than that of its scenes, and is not offered as one here.

use std::error::Error;

use crate::accel::Answers;
use crate::embree::{Builder, TriangleScene, Version};
use crate::math::Ray;

use super::foreign::{ForeignBuild, ForeignBytes, ForeignTracer, TriangleObject};

/// Triangles in Embree 4, or else in Embree 3, traced ray by ray or in `PACKETS` of sixteen.
pub(super) struct Embree<const FOUR: bool, const PACKETS: bool>(TriangleScene);

impl<const FOUR: bool, const PACKETS: bool> Embree<FOUR, PACKETS> {
    const VERSION: Version = if FOUR { Version::Four } else { Version::Three };
}

impl<const FOUR: bool, const PACKETS: bool> ForeignTracer for Embree<FOUR, PACKETS> {
    fn loaded() -> Result<Option<String>, Box<dyn Error + Send + Sync>> {
        Ok(Some(format!("Embree {}", Builder::found(Self::VERSION)?)))
    }

    fn build<'a>(
        objects: impl ExactSizeIterator<Item = TriangleObject<'a>>,
        build: &ForeignBuild<'_>,
    ) -> Result<Self, Box<dyn Error + Send + Sync>> {
        let mut builder = Builder::new(Self::VERSION)?;
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
