//! The table of structures: a new one is a file in `accel/` and a line here.

use crate::accel::{Accel, BoundingBall, BuildConfig, Bvh, CompressedWideBvh, Exhaustive};

use super::{Scene, TracedWorld, World};

/// A structure by name.
#[derive(Clone, Copy, Debug)]
pub struct Structure {
    /// What `--accel` and reports call it.
    pub name: &'static str,
    /// One line about it.
    pub summary: &'static str,
    build: fn(&Scene, &BuildConfig) -> Box<dyn TracedWorld>,
}

impl Structure {
    /// A structure that indexes the objects by `O` and the triangles of each mesh by `T`.
    #[must_use]
    pub const fn new<O: Accel + 'static, T: Accel + 'static>(
        name: &'static str,
        summary: &'static str,
    ) -> Self {
        Self { name, summary, build: |scene, config| Box::new(World::<O, T>::build(scene, config)) }
    }

    /// Builds it over a scene.
    #[must_use]
    pub fn build(&self, scene: &Scene, config: &BuildConfig) -> Box<dyn TracedWorld> {
        (self.build)(scene, config)
    }
}

/// All structures, the simplest first.
pub const STRUCTURES: &[Structure] = &[
    Structure::new::<Exhaustive, Exhaustive>("none", "test every object and every triangle"),
    Structure::new::<Exhaustive, BoundingBall>("ball", "one bounding ball around each mesh"),
    Structure::new::<Bvh, Bvh>("bvh", "obvhs's binary tree over objects and triangles"),
    Structure::new::<CompressedWideBvh, CompressedWideBvh>(
        "cwbvh",
        "obvhs's compressed eight-wide tree over objects and triangles",
    ),
];

/// The structure of a name.
#[must_use]
pub fn structure_named(name: &str) -> Option<&'static Structure> {
    STRUCTURES.iter().find(|structure| structure.name == name)
}
