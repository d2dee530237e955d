//! The points of a light, as a function of the unit square.

use glam::Vec3;

use crate::math::Lanes3;
use crate::scene::Light;
use crate::simd::{Simd, splat3};

/// A parallelogram, corner + u·side_u + v·side_v. That of a point light has no extent.
#[derive(Clone, Copy, Debug)]
pub(super) struct LightSurface {
    corner: Vec3,
    side_u: Vec3,
    side_v: Vec3,
}

impl LightSurface {
    pub(super) fn new(light: &Light) -> Self {
        match *light {
            Light::Point { position, .. } => {
                Self { corner: position, side_u: Vec3::ZERO, side_v: Vec3::ZERO }
            }
            Light::Area { corner, side_u, side_v, .. } => Self { corner, side_u, side_v },
        }
    }

    /// The points at u and v, one for each lane.
    #[inline(always)]
    pub(super) fn points<S: Simd>(&self, u: S::F16, v: S::F16) -> Lanes3<S::F16> {
        let corner: Lanes3<S::F16> = splat3(self.corner.to_array());
        let side_u: Lanes3<S::F16> = splat3(self.side_u.to_array());
        let side_v: Lanes3<S::F16> = splat3(self.side_v.to_array());
        [
            corner[0] + u * side_u[0] + v * side_v[0],
            corner[1] + u * side_u[1] + v * side_v[1],
            corner[2] + u * side_u[2] + v * side_v[2],
        ]
    }
}
