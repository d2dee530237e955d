//! An object: a shape, its place in the world, and its material.

use glam::{Vec3, Vec3A};

use crate::description::Shape;
use crate::math::{Aabb, NONE};

/// Something that rays hit. Small: there may be millions.
#[derive(Clone, Debug)]
pub struct Object {
    /// Its shape in its own space; the index of a mesh is that into the scene's meshes.
    pub shape: Shape,
    /// Index into the scene's transforms; [`NONE`] if its own space is the world's.
    pub(super) transform: u32,
    /// The corners of [`bounds`](Self::bounds).
    pub(super) corners: [Vec3; 2],
    /// Index into the scene's materials.
    pub material: usize,
}

impl Object {
    /// A box around it in the world. A hit on it counts only within this box (see
    /// [`Accel`](crate::accel::Accel)).
    #[inline]
    #[must_use]
    pub fn bounds(&self) -> Aabb {
        let [min, max] = self.corners.map(Vec3A::from);
        Aabb { min, max }
    }

    /// Whether its own space is not the world's.
    #[inline]
    #[must_use]
    pub fn is_transformed(&self) -> bool {
        self.transform != NONE
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_object_is_small() {
        assert!(size_of::<Object>() <= 80);
    }
}
