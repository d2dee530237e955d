//! A point on a shape, in the shape's own space.

use glam::DVec3;

/// Where a ray met a shape, computed in `f64` after the search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint {
    /// The point, on the surface to within `f64` rounding in the direction of the normal.
    pub position: DVec3,
    /// Outward unit normal: perpendicular to the surface, on the outside of a closed one.
    pub normal: DVec3,
    /// A distance from the surface, along the normal, at which the `f32` formula of the shape
    /// separates the sides: rays that start nearer may hit where they start.
    pub clearance: f64,
}
