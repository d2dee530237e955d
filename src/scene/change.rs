//! What has changed from one frame of a scene to the next, where it is the same scene that has moved.

use std::sync::Arc;

use crate::description::Shape;
use crate::math::NONE;

use super::{Object, Scene};

/// A scene that has moved: the same objects, made of the same meshes, whose triangles are the same but for where they
/// are.
#[derive(Debug)]
pub struct SceneChange<'a> {
    /// The scene as it was.
    pub before: &'a Scene,
    /// The scene as it is.
    pub after: &'a Scene,
    /// The meshes that are others, by their places.
    pub(super) meshes: Vec<usize>,
    /// The objects that are elsewhere, or whose mesh is another, ascending.
    pub(super) objects: Vec<u32>,
}

impl<'a> SceneChange<'a> {
    /// What has moved from one scene to another. `None` where they are not the same scene: another number of objects,
    /// an object of another form, a mesh of other triangles.
    #[must_use]
    pub fn between(before: &'a Scene, after: &'a Scene) -> Option<Self> {
        let is_same = before.objects.len() == after.objects.len()
            && before.meshes.len() == after.meshes.len();
        let mut meshes = Vec::new();
        for (place, (old, new)) in before.meshes.iter().zip(&after.meshes).enumerate() {
            if !Arc::ptr_eq(old, new) && old.positions != new.positions {
                meshes.push(place);
            }
            if !Arc::ptr_eq(old, new) && old.triangles != new.triangles {
                return None;
            }
        }
        let mut objects = Vec::new();
        for (id, (old, new)) in before.objects.iter().zip(&after.objects).enumerate() {
            let is_of_other_mesh = match (&old.shape, &new.shape) {
                (Shape::Mesh { mesh: old, .. }, Shape::Mesh { mesh: new, .. }) if old == new => {
                    meshes.binary_search(old).is_ok()
                }
                (Shape::Single(_), Shape::Single(_)) => false,
                _ => return None,
            };
            if is_of_other_mesh || has_moved((before, old), (after, new)) {
                objects.push(id as u32);
            }
        }
        is_same.then_some(Self { before, after, meshes, objects })
    }

    /// How many objects have moved, or have a mesh that has.
    #[must_use]
    pub fn moved_objects(&self) -> usize {
        self.objects.len()
    }

    /// How many triangles have moved within their meshes, each mesh once.
    #[must_use]
    pub fn moved_triangles(&self) -> u64 {
        let triangles = |&mesh: &usize| self.after.meshes[mesh].triangles.len() as u64;
        self.meshes.iter().map(triangles).sum()
    }
}

/// Whether an object is elsewhere.
fn has_moved((before, old): (&Scene, &Object), (after, new): (&Scene, &Object)) -> bool {
    let matrix = |scene: &Scene, object: &Object| {
        (object.transform != NONE)
            .then(|| scene.transform_of(object).map(|transform| transform.world_from_object))
    };
    old.corners != new.corners
        || old.shape != new.shape
        || matrix(before, old) != matrix(after, new)
}
