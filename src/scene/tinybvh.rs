//! [tinybvh](https://github.com/jbikker/tinybvh) by Jacco Bikker as a foreign tracer, as it is shipped: its own trees
//! and its own triangles.
//!
//! Its `BVH8_CPU` is the tree that it documents as the fastest on processors with AVX2: eight children of a node are
//! tested at once and taken nearest first, four triangles of a leaf, laid out for it, at once; what lies behind the
//! best hit is taken off the stack; a search for any hit ends at the first. It searches ray by ray. The builder is an
//! option, by default the one with spatial splits: its trees were searched 1.15 to 1.22 × as fast on a scan as those of
//! the other, and as fast on a knot, on land and in a soup of triangles, for 5 × the time of a build. It is compiled
//! with the flags that its documentation names, for AVX2 and FMA and not for the machine at hand.
//!
//! It is compared as it is shipped alone. `BVH8_CPU` is built from triangles, keeps copies of them in its leaves, and
//! tests boxes by products and differences that are rounded once, with no way to widen them or to have another test of
//! what a leaf holds. tinybvh's plain binary tree, which has public nodes and takes a test of the caller's, is another
//! tree than the one that it documents as the fastest, and the layers that build trees call no C++.
//!
//! What it cannot do: build on a number of threads of one's choice. Its pools have as many as the machine, from 50,000
//! triangles on. On one thread it builds when it is to; on fewer than there are, its pools share as many processors
//! (Linux; elsewhere it builds on one thread).

use std::error::Error;

use crate::accel::{Allowed, Answers, OptionInfo};
use crate::math::Ray;
use crate::tinybvh::{Builder, Quality, TriangleScene};

use super::foreign::{ForeignBuild, ForeignBytes, ForeignTracer, TriangleObject};

const DEFAULT: &str = "default";
const HQ: &str = "hq";

const QUALITY: OptionInfo = OptionInfo {
    name: "quality",
    allowed: Allowed::Words(&[DEFAULT, HQ]),
    default: HQ,
    summary: "tinybvh's builder: Build, binned, or BuildHQ, with spatial splits",
};

/// Triangles in tinybvh.
pub(super) struct TinyBvh(TriangleScene);

impl ForeignTracer for TinyBvh {
    const OPTIONS: &'static [OptionInfo] = &[QUALITY];
    /// Corners, fragments, a binary tree of up to three nodes a triangle twice over, the wide tree made of it, leaves.
    const BUILD_BYTES: u64 = 500;

    fn build<'a>(
        objects: impl ExactSizeIterator<Item = TriangleObject<'a>>,
        build: &ForeignBuild<'_>,
    ) -> Result<Self, Box<dyn Error + Send + Sync>> {
        let mut builder = Builder::new()?;
        for object in objects {
            builder.add(&object.positions, object.triangles);
        }
        let quality = match build.config.options.word(&QUALITY) {
            Some(DEFAULT) => Quality::Default,
            _ => Quality::High,
        };
        Ok(Self(builder.build(quality, build.threads)?))
    }

    fn trace(&self, rays: &[Ray], answers: Answers<'_>) {
        match answers {
            Answers::ClosestHit(hits) => self.0.intersect(rays, hits),
            Answers::AnyHit(blocked) => self.0.occluded(rays, blocked),
        }
    }

    fn bytes(&self) -> ForeignBytes {
        ForeignBytes { index: self.0.bytes(), triangles: 0 }
    }
}
