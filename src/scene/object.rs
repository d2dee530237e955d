//! An object: a form, its place in the world, and its material.

use glam::{Vec3, Vec3A};

use crate::description::Normals;
use crate::math::{Aabb, NONE};
use crate::shapes::{Ball, Triangle};

/// The forms of objects as they are traced.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Form {
    /// A ball.
    Ball(Ball),
    /// The canonical cylinder.
    Cylinder,
    /// A triangle.
    Triangle(Triangle),
    /// A mesh.
    Mesh {
        /// Index into the scene's meshes.
        mesh: usize,
        /// How its faces are shaded.
        normals: Normals,
    },
}

/// Something that rays hit. Small: there may be millions.
#[derive(Clone, Debug)]
pub struct Object {
    /// Its form in its own space.
    pub form: Form,
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
