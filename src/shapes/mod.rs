//! The forms that rays hit: one file a shape, each with its formula, its box, and its point.
//!
//! A formula is written once and called by every structure. Shapes do not depend on scenes,
//! materials or files; transforms are applied before a ray gets here.

mod ball;
mod clip;
mod cylinder;
mod end_point_overlap;
#[cfg(feature = "program")]
mod instance;
mod mesh_error;
#[cfg(feature = "program")]
mod ray_group;
#[cfg(feature = "program")]
mod single;
#[cfg(feature = "program")]
mod single_many;
mod surface_point;
mod triangle;
mod triangle_set;

pub use ball::Ball;
pub use cylinder::Cylinder;
pub use end_point_overlap::{EndPointOverlap, OVERLAP_SAMPLES, end_point_overlap};
#[cfg(feature = "program")]
pub use instance::Instance;
pub use mesh_error::MeshError;
#[cfg(feature = "program")]
pub use single::Single;
pub use surface_point::SurfacePoint;
pub use triangle::Triangle;
pub use triangle_set::TriangleSet;
