//! Sixteen points that are shaded together, a lane each. At 4 × 4 view samples they are those of
//! one pixel.
//!
//! Knows no light.

use glam::{Vec3, Vec4};

use crate::math::ones;
use crate::render::exponent::Exponent;
use crate::render::shading_material::ShadingMaterial;
use crate::simd::LANES;

/// A number for each lane.
pub(super) type LaneFloats = [f32; LANES];

/// The x, the y and the z of a vector for each lane.
pub(super) type LaneVectors = [LaneFloats; 3];

/// Up to sixteen points that follow each other in a wave. Masks have a bit for each lane, lane 0
/// the lowest.
#[derive(Clone, Debug)]
pub(super) struct ShadingLanes {
    /// Where shadow rays start.
    pub(super) origin: LaneVectors,
    /// The origins again, as the first half of a ray: x, y, z and the ray's `t_min`, which is 0.
    pub(super) ray_starts: [Vec4; LANES],
    /// Unit shading normals.
    pub(super) normal: LaneVectors,
    /// Unit normals of the surfaces themselves.
    pub(super) geometric_normal: LaneVectors,
    /// Directions of the rays that hit the points; unit vectors where there are highlights.
    pub(super) view_dir: LaneVectors,
    /// Mask of the lanes that have a point.
    pub(super) present: u32,
    /// Mask of the surfaces that let no light through.
    pub(super) opaque: u32,
    /// Mask of the surfaces with diffuse reflection.
    pub(super) has_diffuse: u32,
    /// Mask of the surfaces with highlights.
    pub(super) has_specular: u32,
    /// The exponents of highlights.
    pub(super) exponents: [Exponent; LANES],
    /// The exponent that all lanes with highlights share, if they do.
    pub(super) common_exponent: Option<Exponent>,
}

/// A point of a surface that is to be shaded.
#[derive(Clone, Copy, Debug)]
pub(super) struct ShadingPoint<'a> {
    pub(super) material: &'a ShadingMaterial,
    pub(super) origin: Vec3,
    pub(super) normal: Vec3,
    pub(super) geometric_normal: Vec3,
    pub(super) view_dir: Vec3,
}

impl ShadingLanes {
    /// No points.
    pub(super) const EMPTY: Self = Self {
        origin: [[0.0; LANES]; 3],
        ray_starts: [Vec4::ZERO; LANES],
        normal: [[0.0; LANES]; 3],
        geometric_normal: [[0.0; LANES]; 3],
        view_dir: [[0.0; LANES]; 3],
        present: 0,
        opaque: 0,
        has_diffuse: 0,
        has_specular: 0,
        exponents: [Exponent::Whole(0); LANES],
        common_exponent: None,
    };

    /// Replaces the points with up to [`LANES`] others. Lanes that get none keep their old numbers
    /// and are masked out.
    pub(super) fn fill<'a>(&mut self, points: impl Iterator<Item = ShadingPoint<'a>>) {
        (self.present, self.opaque, self.has_diffuse, self.has_specular) = (0, 0, 0, 0);
        for (lane, point) in points.enumerate().take(LANES) {
            self.set(lane, &point);
        }
        self.common_exponent = self.find_common_exponent();
    }

    #[inline]
    fn set(&mut self, lane: usize, point: &ShadingPoint<'_>) {
        for (rows, vector) in [
            (&mut self.origin, point.origin),
            (&mut self.normal, point.normal),
            (&mut self.geometric_normal, point.geometric_normal),
            (&mut self.view_dir, point.view_dir),
        ] {
            [rows[0][lane], rows[1][lane], rows[2][lane]] = vector.to_array();
        }
        self.ray_starts[lane] = point.origin.extend(0.0);
        let material = point.material;
        self.present |= 1 << lane;
        self.opaque |= u32::from(material.opaque) << lane;
        self.has_diffuse |= u32::from(material.has_diffuse) << lane;
        self.has_specular |= u32::from(material.has_specular) << lane;
        self.exponents[lane] = material.exponent;
    }

    fn find_common_exponent(&self) -> Option<Exponent> {
        let mut exponents = ones(self.has_specular).map(|lane| self.exponents[lane]);
        let first = exponents.next()?;
        exponents.all(|exponent| exponent == first).then_some(first)
    }
}
