//! The sums over the points of a light: how much of its light a shaded point reflects.

use crate::math::Color;
use crate::math::ones;
use crate::render::shading_material::ShadingMaterial;
use crate::simd::{Kernel, LANES, Row as _, Simd};

use super::shading_lanes::LaneFloats;
use super::shadow_rays::ShadowRow;

/// The sums of sixteen shaded points, a lane each.
#[derive(Clone, Copy, Default)]
pub(super) struct LightSums {
    diffuse: LaneFloats,
    specular: LaneFloats,
}

impl LightSums {
    /// The share of the light's colour that the point in a lane sends to the eye, times the number
    /// of the light's samples.
    #[inline]
    pub(super) fn reflected(&self, lane: usize, material: &ShadingMaterial) -> Color {
        let mut reflected = self.diffuse[lane] * material.diffuse;
        if material.has_specular {
            reflected += self.specular[lane] * material.specular;
        }
        reflected
    }
}

/// Adds what arrives along shadow rays to the sums. Each lane adds point by point, so that its sum
/// does not depend on the other lanes.
pub(super) struct AddArriving<'a> {
    pub(super) rows: &'a [ShadowRow],
    /// The share of the light that arrives along each ray of the rows.
    pub(super) transmittances: &'a [f32],
    pub(super) sums: &'a mut [LightSums],
}

impl Kernel for AddArriving<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self) {
        let mut rest = self.transmittances;
        for ShadowRow { lanes, has_specular, contribution } in self.rows {
            let (own, behind) = rest.split_at(contribution.lit.count_ones() as usize);
            rest = behind;
            let transmittances = S::F16::load(&spread(own, contribution.lit));
            let LightSums { diffuse, specular } = &mut self.sums[*lanes];
            let sum = S::F16::load(diffuse) + S::F16::load(&contribution.diffuse) * transmittances;
            sum.store(diffuse);
            if *has_specular {
                let sum =
                    S::F16::load(specular) + S::F16::load(&contribution.specular) * transmittances;
                sum.store(specular);
            }
        }
    }
}

/// Values of the lanes of a mask, each in its lane; the others are 0.
#[inline(always)]
fn spread(values: &[f32], mask: u32) -> LaneFloats {
    let mut lanes = [0.0; LANES];
    if let Some(all) = values.first_chunk() {
        lanes = *all;
    } else {
        for (lane, &value) in ones(mask).zip(values) {
            lanes[lane % LANES] = value;
        }
    }
    lanes
}
