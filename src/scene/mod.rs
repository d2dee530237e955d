//! The scene as traced: a description and its meshes, compiled; and the worlds made of it.
//!
//! [`Scene`] is what all structures share: objects, materials, lights, camera. A *world* is a scene
//! with a structure built over it, on two levels: one over the objects, one over the triangles of
//! each mesh. The world finds what rays hit; the scene has what a hit means.

mod camera;
mod change;
mod compile;
#[cfg(feature = "embree")]
mod embree;
mod error;
mod foreign;
mod geometry_hash;
#[cfg(feature = "libraries")]
mod libraries;
mod lights;
mod mesh_rays;
mod object;
mod object_list;
mod range;
mod saved;
mod structure;
mod structures;
mod surface;
#[cfg(feature = "tinybvh")]
mod tinybvh;
mod transforms;
mod world;
mod world_regions;

use std::borrow::Cow;
use std::sync::Arc;

use rayon::prelude::*;

use crate::assets::MeshData;
use crate::description::{Material, Options, Shape};
use crate::math::{Aabb, Transform};
use crate::shapes::Single;

pub use crate::shapes::EndPointOverlap;

pub use camera::Camera;
pub use change::SceneChange;
pub use error::{BuildError, ReadError, SaveError, SceneError};
pub use foreign::{ForeignBuild, ForeignBytes, ForeignTracer, TriangleObject};
pub use lights::Light;
pub use object::Object;
pub use object_list::ObjectList;
pub use structure::Structure;
pub use structures::{PEERS, STRUCTURES, structure_named};
pub use surface::Surface;
use transforms::Transforms;
pub use world::{BuildReport, TracedWorld, World};
pub use world_regions::WorldRegions;

/// A scene, compiled: plain data in the world's space, ready to be indexed and traced.
#[derive(Clone, Debug)]
pub struct Scene {
    /// How it is seen.
    pub camera: Camera,
    /// The rendering options of the scene file.
    pub options: Options,
    /// What the objects are made of.
    pub materials: Vec<Material>,
    /// What rays hit; an object's index is its id in every hit.
    pub objects: Vec<Object>,
    /// What gives light.
    pub lights: Vec<Light>,
    meshes: Vec<Arc<MeshData>>,
    transforms: Transforms,
}

impl Scene {
    /// The box around all objects; empty if there are none.
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        let chunks = self.objects.par_chunks(1 << 12);
        let of_chunk = |objects: &[Object]| {
            objects.iter().map(|object| object.bounds()).fold(Aabb::EMPTY, Aabb::union)
        };
        chunks.map(of_chunk).reduce(|| Aabb::EMPTY, Aabb::union)
    }

    /// The meshes, as objects refer to them.
    #[must_use]
    pub fn meshes(&self) -> &[Arc<MeshData>] {
        &self.meshes
    }

    /// What takes an object to the world, if its own space is another.
    #[inline]
    #[must_use]
    pub fn transform_of(&self, object: &Object) -> Option<Cow<'_, Transform>> {
        self.transforms.get(object.transform)
    }

    /// How many triangles there are, a mesh counted for each object that is made of it.
    #[must_use]
    pub fn triangle_count(&self) -> u64 {
        let of_object = |object: &Object| match object.shape {
            Shape::Single(Single::Triangle(_)) => 1,
            Shape::Single(_) => 0,
            Shape::Mesh { mesh, .. } => self.meshes[mesh].triangles.len() as u64,
        };
        self.objects.iter().map(of_object).sum()
    }

    /// How many triangles are in memory: those of each mesh once, and single ones.
    #[must_use]
    pub fn stored_triangle_count(&self) -> u64 {
        let in_meshes: u64 = self.meshes.iter().map(|mesh| mesh.triangles.len() as u64).sum();
        let is_triangle =
            |object: &&Object| matches!(object.shape, Shape::Single(Single::Triangle(_)));
        in_meshes + self.objects.iter().filter(is_triangle).count() as u64
    }

    /// Whether any material lets light through.
    #[must_use]
    pub fn has_transparency(&self) -> bool {
        self.materials.iter().any(|material| material.alpha < 1.0)
            && self.objects.iter().any(|object| self.materials[object.material].alpha < 1.0)
    }
}
