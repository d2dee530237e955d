//! An object: a form, its place in the world, and its material.

use crate::description::Normals;
use crate::math::{Aabb, Transform};
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

/// Something that rays hit.
#[derive(Clone, Debug)]
pub struct Object {
    /// Its form in its own space.
    pub form: Form,
    /// From its own space to the world; `None` if they are the same.
    pub transform: Option<Box<Transform>>,
    /// A box around it in the world. A hit on it counts only within this box (see
    /// [`Accel`](crate::accel::Accel)).
    pub bounds: Aabb,
    /// Index into the scene's materials.
    pub material: usize,
}
