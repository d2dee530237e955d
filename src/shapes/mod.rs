//! The shapes that rays hit: one file a shape, each with its name, formula, box and surface point.
//!
//! [`Single`] is the list of the shapes that are one primitive; meshes are sets of triangles. A
//! formula is written once and called by every structure. Shapes do not depend on scenes, materials or
//! files; transforms are applied before a ray gets here.

/// The same expression for whichever shape a [`Single`] is.
macro_rules! for_shape {
    ($single:expr, $shape:ident => $result:expr) => {
        match $single {
            Single::Ball($shape) => $result,
            Single::Cylinder($shape) => $result,
            Single::Triangle($shape) => $result,
        }
    };
}

mod ball;
mod clip;
mod cylinder;
mod end_point_overlap;
mod instance;
mod mesh_error;
mod ray_group;
mod sheared_ray;
mod single;
mod single_many;
mod single_shape;
mod surface_point;
mod triangle;
mod triangle_mesh;
mod triangle_set;

pub use ball::Ball;
pub use cylinder::Cylinder;
pub use end_point_overlap::{EndPointOverlap, OVERLAP_SAMPLES, end_point_overlap};
pub use instance::{Entered, Instance};
pub use mesh_error::MeshError;
pub use sheared_ray::{TriangleRay, TriangleRays};
pub use surface_point::SurfacePoint;
pub use triangle::Triangle;
pub use triangle_mesh::TriangleMesh;
pub use triangle_set::TriangleSet;

use single_shape::SingleShape;

/// A shape that is one primitive, in its own space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Single {
    /// A ball.
    Ball(Ball),
    /// The canonical cylinder.
    Cylinder(Cylinder),
    /// A triangle.
    Triangle(Triangle),
}

impl Single {
    /// The names of all shapes, in the order in which they are listed.
    pub const NAMES: [&'static str; 3] = [Ball::NAME, Cylinder::NAME, Triangle::NAME];
}
