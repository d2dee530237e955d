//! Triangles that tinybvh indexes.

use glam::Vec3;

use crate::math::{Hit, Ray};

use super::TinyBvhError;
use super::index::Index;

/// Which of tinybvh's builders.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quality {
    /// `Build`: binned, by the surface area heuristic.
    Default,
    /// `BuildHQ`: with spatial splits, which cut triangles.
    High,
}

/// What a tree says of itself.
#[derive(Clone, Copy, Debug, Default)]
#[repr(C)]
pub(super) struct Facts {
    bytes: u64,
    spatial: bool,
    threaded: bool,
}

/// A corner as tinybvh reads it: in one piece, whose fourth number is ignored.
#[derive(Clone, Copy)]
#[repr(C, align(16))]
pub(super) struct Corner([f32; 4]);

/// Triangles while they are gathered.
#[derive(Default)]
pub struct Builder {
    /// Three of each triangle.
    corners: Vec<Corner>,
    /// The place of the first triangle of each object.
    firsts: Vec<u32>,
}

/// Triangles, indexed; they do not change any more.
pub struct TriangleScene {
    /// None if there are no triangles, which tinybvh refuses.
    index: Option<Index>,
    firsts: Vec<u32>,
}

impl Builder {
    /// No triangles yet.
    ///
    /// # Errors
    /// If the processor lacks what tinybvh needs.
    pub fn new() -> Result<Self, TinyBvhError> {
        Index::check_processor()?;
        Ok(Self::default())
    }

    /// Adds the triangles of the next object, by three indices each.
    ///
    /// # Panics
    /// If an index is out of range.
    pub fn add(&mut self, positions: &[Vec3], triangles: &[[u32; 3]]) {
        self.firsts.push((self.corners.len() / 3) as u32);
        let corner = |&i: &u32| Corner(positions[i as usize].extend(0.0).to_array());
        self.corners.extend(triangles.as_flattened().iter().map(corner));
    }

    /// Indexes them, on one thread or on as many of the processors as there are to be threads.
    ///
    /// # Errors
    /// If tinybvh cannot, for want of memory or because of its limits.
    pub fn build(self, quality: Quality, threads: usize) -> Result<TriangleScene, TinyBvhError> {
        let Self { corners, firsts } = self;
        let index = match corners.is_empty() {
            true => None,
            false => Some(Index::build(&corners, quality, threads)?),
        };
        Ok(TriangleScene { index, firsts })
    }
}

impl TriangleScene {
    /// The closest hit of each ray: the object by its place among those that were added, the triangle by its place in
    /// the object.
    ///
    /// # Panics
    /// If the slices differ in length.
    pub fn intersect(&self, rays: &[Ray], hits: &mut [Hit]) {
        let Some(index) = &self.index else { return hits.fill(Hit::MISS) };
        index.closest(rays, hits);
        for hit in hits.iter_mut().filter(|hit| hit.is_hit()) {
            let object = self.firsts.partition_point(|&first| first <= hit.prim) - 1;
            hit.object = object as u32;
            hit.prim -= self.firsts[object];
        }
    }

    /// Whether each ray hits anything.
    ///
    /// # Panics
    /// If the slices differ in length.
    pub fn occluded(&self, rays: &[Ray], blocked: &mut [bool]) {
        match &self.index {
            Some(index) => index.any(rays, blocked),
            None => blocked.fill(false),
        }
    }

    /// Bytes of the index, whose leaves hold the triangles, and of the trees that it was made from, which tinybvh
    /// keeps.
    #[must_use]
    pub fn bytes(&self) -> u64 {
        self.index.as_ref().map_or(0, |index| index.facts().bytes)
    }

    /// Which builder has built it; none if there was nothing to build.
    #[must_use]
    pub fn quality(&self) -> Option<Quality> {
        let spatial = self.index.as_ref()?.facts().spatial;
        Some(if spatial { Quality::High } else { Quality::Default })
    }

    /// Whether it was built on several threads, as those of 50,000 triangles are if there are several.
    #[must_use]
    pub fn was_built_on_threads(&self) -> bool {
        self.index.as_ref().is_some_and(|index| index.facts().threaded)
    }
}
