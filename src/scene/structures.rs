//! The table of structures: a new one is a file in `accel/` and a line here.

use crate::accel::{Accel, BoundingBall, BuildConfig, Bvh, Bvh8, CompressedWideBvh, Exhaustive};

#[cfg(feature = "embree")]
use super::embree_world::EmbreeWorld;
use super::{BuildError, Scene, TracedWorld, World};

/// A structure by name.
#[derive(Clone, Copy, Debug)]
pub struct Structure {
    /// What `--accel` and reports call it.
    pub name: &'static str,
    /// One line about it.
    pub summary: &'static str,
    /// Whether it is another program's, compared for its speed: its hits are close to those of the
    /// others, not equal, and it counts nothing.
    pub yardstick: bool,
    build: BuildFunction,
}

type BuildFunction = fn(&Scene, &BuildConfig) -> Result<Box<dyn TracedWorld>, BuildError>;

impl Structure {
    /// A structure that indexes the objects by `O` and the triangles of each mesh by `T`.
    #[must_use]
    pub const fn new<O: Accel + 'static, T: Accel + 'static>(
        name: &'static str,
        summary: &'static str,
    ) -> Self {
        let build: BuildFunction =
            |scene, config| Ok(Box::new(World::<O, T>::build(scene, config)));
        Self { name, summary, yardstick: false, build }
    }

    /// Builds it over a scene.
    ///
    /// # Errors
    /// If a yardstick does not know what the scene is made of. The structures of this crate, and
    /// those of [`new`](Self::new), take every scene.
    pub fn try_build(
        &self,
        scene: &Scene,
        config: &BuildConfig,
    ) -> Result<Box<dyn TracedWorld>, BuildError> {
        (self.build)(scene, config)
    }

    /// Builds it over a scene that it is known to take.
    ///
    /// # Panics
    /// If it does not: see [`try_build`](Self::try_build).
    #[must_use]
    pub fn build(&self, scene: &Scene, config: &BuildConfig) -> Box<dyn TracedWorld> {
        self.try_build(scene, config).unwrap_or_else(|error| panic!("`{}`: {error}", self.name))
    }
}

/// All structures, the simplest first: those that give equal hits.
pub const STRUCTURES: &[Structure] = &[
    Structure::new::<Exhaustive, Exhaustive>("none", "test every object and every triangle"),
    Structure::new::<Exhaustive, BoundingBall>("ball", "one bounding ball around each mesh"),
    Structure::new::<Bvh, Bvh>("bvh", "obvhs's binary tree over objects and triangles"),
    Structure::new::<CompressedWideBvh, CompressedWideBvh>(
        "cwbvh",
        "obvhs's compressed eight-wide tree over objects and triangles",
    ),
    Structure::new::<Bvh8, Bvh8>(
        "bvh8",
        "an eight-wide tree over objects and triangles: many rays at once",
    ),
];

/// What the structures are measured against, where the program was built with it.
pub const YARDSTICKS: &[Structure] = &[
    #[cfg(feature = "embree")]
    Structure {
        name: "embree",
        summary: "Intel's Embree, ray by ray: a yardstick, for scenes of triangles",
        yardstick: true,
        build: |scene, _| Ok(Box::new(EmbreeWorld::<false>::build(scene)?)),
    },
    #[cfg(feature = "embree")]
    Structure {
        name: "embree16",
        summary: "Intel's Embree, in packets of 16 rays: a yardstick, for scenes of triangles",
        yardstick: true,
        build: |scene, _| Ok(Box::new(EmbreeWorld::<true>::build(scene)?)),
    },
];

/// The structure, or the yardstick, of a name.
#[must_use]
pub fn structure_named(name: &str) -> Option<&'static Structure> {
    STRUCTURES.iter().chain(YARDSTICKS).find(|structure| structure.name == name)
}
