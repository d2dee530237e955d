//! Paths of light, followed backwards from the eye, and the vertices at which they meet surfaces.

use glam::Vec3;

use crate::math::{Color, Ray, hash_u64};
use crate::scene::Surface;

use super::optics::mirror;

/// Paths of less weight than this are dropped: a sixty-fourth of the step between two 8-bit
/// colours. Without it, rays between glass surfaces double with every bounce.
const MIN_WEIGHT: f32 = 1.0 / 16_384.0;

/// A path of light as far as it has been followed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Path {
    /// The index of its view sample in the batch.
    pub(super) sample: u32,
    /// The share of light found at its end that arrives at the eye.
    pub(super) weight: Color,
    /// The key of its random numbers.
    pub(super) key: u64,
}

/// The end of a path on a surface.
#[derive(Clone, Copy)]
pub(super) struct PathVertex {
    pub(super) path: Path,
    pub(super) surface: Surface,
    /// Direction of the ray that hit the surface. A unit vector where the surface has highlights or
    /// secondary rays.
    pub(super) dir: Vec3,
    /// Where rays start that leave the surface on the side from which it is seen.
    pub(super) origin: Vec3,
}

impl Path {
    /// The path of a view sample before its first hit.
    pub(super) fn from_eye(sample: u32, key: u64) -> Self {
        Self { sample, weight: Color::ONE, key }
    }

    /// The path that goes on with `share` of the light, unless its weight is too small. `branch`
    /// is 1 for mirrored and 2 for refracted rays, so that their random numbers differ.
    pub(super) fn continued(&self, share: Color, branch: u64) -> Option<Self> {
        let weight = self.weight * share;
        let key = hash_u64(self.key ^ branch);
        (weight.abs().max_element() >= MIN_WEIGHT).then_some(Self { weight, key, ..*self })
    }
}

impl PathVertex {
    /// The ray along the mirror direction. Where an interpolated normal would send it into the
    /// surface, the surface's own normal is used.
    pub(super) fn mirrored_ray(&self) -> Ray {
        let geometric = self.surface.geometric_normal;
        let mut dir = mirror(self.dir, self.surface.normal);
        if dir.dot(geometric) <= 0.0 {
            dir = mirror(self.dir, geometric);
        }
        Ray::new(self.origin, dir)
    }

    /// The ray through the surface along `dir`, or straight on where an interpolated normal would
    /// not let it through.
    pub(super) fn refracted_ray(&self, dir: Vec3) -> Ray {
        let enters = dir.dot(self.surface.geometric_normal) < 0.0;
        let dir = if enters { dir } else { self.dir };
        Ray::new(self.surface.origin_behind(), dir)
    }
}
