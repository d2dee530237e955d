//! The parts of space of the structures over a scene, on both levels. No ray goes through here.

use crate::accel::Regions;

/// The parts of space that rays into a scene are tested against.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WorldRegions {
    /// Those over the objects, in the world's space; leaves hold the objects' ids. Empty where all of the scene is one
    /// mesh in the world's own space, which is searched by itself.
    pub objects: Regions,
    /// Those over the triangles of each mesh, in its own space.
    pub meshes: Vec<Regions>,
}

impl WorldRegions {
    /// Whether there are none: every primitive is tested.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.objects.all().is_empty() && self.meshes.iter().all(|mesh| mesh.all().is_empty())
    }
}
