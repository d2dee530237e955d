//! The table of structures: a new one is a file in `accel/` and a line here.

use crate::accel::{Accel, BoundingBall, BuildConfig, Bvh, Bvh8, CompressedWideBvh, Exhaustive};

#[cfg(feature = "embree")]
use super::embree::Embree;
use super::foreign::{ForeignTracer, ForeignWorld};
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
    pub peer: bool,
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
        Self { name, summary, peer: false, build }
    }

    /// Another program's library, as a peer.
    #[must_use]
    pub const fn foreign<F: ForeignTracer + 'static>(
        name: &'static str,
        summary: &'static str,
    ) -> Self {
        let build: BuildFunction =
            |scene, config| Ok(Box::new(ForeignWorld::<F>::build(scene, config)?));
        Self { name, summary, peer: true, build }
    }

    /// Builds it over a scene.
    ///
    /// # Errors
    /// If a peer does not know what the scene is made of. The structures of this crate, and
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
pub const PEERS: &[Structure] = &[
    #[cfg(feature = "embree")]
    Structure::foreign::<Embree<false>>(
        "embree",
        "Intel's Embree, ray by ray: a peer, for scenes of triangles",
    ),
    #[cfg(feature = "embree")]
    Structure::foreign::<Embree<true>>(
        "embree16",
        "Intel's Embree, in packets of 16 rays: a peer, for scenes of triangles",
    ),
];

/// The structure, or the peer, of a name.
#[must_use]
pub fn structure_named(name: &str) -> Option<&'static Structure> {
    STRUCTURES.iter().chain(PEERS).find(|structure| structure.name == name)
}
