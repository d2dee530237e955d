//! What one point of a light contributes to each of sixteen points that are shaded.
//!
//! Every operation is done lane by lane and rounds as that of a single value. So a contribution
//! depends neither on its lane, nor on the other lanes, nor on the instruction set.
//!
//! Knows neither whether something blocks the light nor the colours of lights and materials.

use crate::math::{Lanes, Lanes3, Mask as _, dot, ones, sub};
use crate::render::exponent::{Exponent, whole_power};
use crate::simd::{LANES, Row as _, Simd};

use super::light_surface::LightSurface;
use super::shading_lanes::{LaneFloats, LaneVectors, ShadingLanes};

/// The terms of the shading model for one point of a light, a shaded point in each lane.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct LightContribution {
    /// Mask of the lanes to which the light adds something unless it is blocked. The terms of the
    /// others are 0. If the mask is empty, terms are not set.
    pub(super) lit: u32,
    /// max(0, n·l)
    pub(super) diffuse: LaneFloats,
    /// max(0, n·h)^shininess; not set if the light reaches no surface with highlights.
    pub(super) specular: LaneFloats,
}

impl LightContribution {
    /// Computes the terms for the points at `u`, `v` of a light. `to_light` is set to the vectors
    /// from the shaded points to them.
    ///
    /// Some lanes need no shadow ray: an opaque surface that faces away from the light is in its own
    /// shadow, and a surface without highlights whose shading normal faces away reflects nothing.
    #[inline(always)]
    pub(super) fn compute<S: Simd>(
        &mut self,
        light: &LightSurface,
        lanes: &ShadingLanes,
        u: S::F16,
        v: S::F16,
        to_light: &mut LaneVectors,
    ) {
        let zero = S::F16::splat(0.0);
        let way = sub(light.points::<S>(u, v), load::<S>(&lanes.origin));
        store::<S>(way, to_light);
        let outside = zero.lt(dot(load::<S>(&lanes.geometric_normal), way)).bits();
        let reached = lanes.present & (outside | !lanes.opaque);
        self.lit = 0;
        if reached == 0 {
            return; // The side of an object away from a light.
        }
        let length_recip = S::F16::splat(1.0) / dot(way, way).sqrt();
        let normal = load::<S>(&lanes.normal);
        let cosine = dot(normal, way) * length_recip;
        let diffuse = zero.lt(cosine).bits() & reached & lanes.has_diffuse;
        let mut specular = 0;
        if lanes.has_specular & reached != 0 {
            let l = [way[0] * length_recip, way[1] * length_recip, way[2] * length_recip];
            let power = highlight::<S>(lanes, normal, l, reached);
            power.store(&mut self.specular);
            specular = zero.lt(power).bits();
        }
        cosine.select(diffuse, zero).store(&mut self.diffuse);
        self.lit = diffuse | specular;
    }
}

/// max(0, n·h)^shininess for the lanes of `reached` with highlights, 0 for the others; `l` are unit
/// vectors to the light.
#[inline(always)]
fn highlight<S: Simd>(
    lanes: &ShadingLanes,
    normal: Lanes3<S::F16>,
    l: Lanes3<S::F16>,
    reached: u32,
) -> S::F16 {
    let zero = S::F16::splat(0.0);
    let half = sub(l, load::<S>(&lanes.view_dir));
    let cosine = dot(normal, half) * (S::F16::splat(1.0) / dot(half, half).sqrt());
    // A NaN, where light comes straight from behind, is not above 0 and gives no highlight.
    let above = zero.lt(cosine).bits() & lanes.has_specular & reached;
    let base = cosine.min(S::F16::splat(1.0)).select(above, zero);
    power::<S>(lanes, base, above).select(above, zero)
}

/// Bases between 0 and 1 to the power of their surfaces' exponents.
#[inline(always)]
fn power<S: Simd>(lanes: &ShadingLanes, base: S::F16, mask: u32) -> S::F16 {
    if let Some(Exponent::Whole(exponent)) = lanes.common_exponent {
        return whole_power(base, exponent, S::F16::splat(1.0));
    }
    let (mut bases, mut powers) = ([0.0; LANES], [0.0; LANES]);
    base.store(&mut bases);
    for lane in ones(mask) {
        powers[lane % LANES] = lanes.exponents[lane % LANES].power(bases[lane % LANES]);
    }
    S::F16::load(&powers)
}

#[inline(always)]
fn load<S: Simd>(vectors: &LaneVectors) -> Lanes3<S::F16> {
    [S::F16::load(&vectors[0]), S::F16::load(&vectors[1]), S::F16::load(&vectors[2])]
}

#[inline(always)]
fn store<S: Simd>(vectors: Lanes3<S::F16>, to: &mut LaneVectors) {
    vectors[0].store(&mut to[0]);
    vectors[1].store(&mut to[1]);
    vectors[2].store(&mut to[2]);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::description::Material;
    use crate::math::{Color, Random};
    use crate::render::direct_light::shading_lanes::ShadingPoint;
    use crate::render::shading_material::ShadingMaterial;
    use crate::scene::Light;
    use crate::simd::{Kernel, dispatch};
    use glam::Vec3;

    struct Compute<'a> {
        light: &'a LightSurface,
        lanes: &'a ShadingLanes,
        u: LaneFloats,
        v: LaneFloats,
    }

    impl Kernel for Compute<'_> {
        type Output = (LightContribution, LaneVectors);
        #[inline(always)]
        fn run<S: Simd>(self) -> Self::Output {
            let (mut terms, mut to_light) = (LightContribution::default(), LaneVectors::default());
            let (u, v) = (S::F16::load(&self.u), S::F16::load(&self.v));
            terms.compute::<S>(self.light, self.lanes, u, v, &mut to_light);
            (terms, to_light)
        }
    }

    fn compute(
        light: &Light,
        lanes: &ShadingLanes,
        u: LaneFloats,
        v: LaneFloats,
    ) -> (LightContribution, LaneVectors) {
        dispatch(Compute { light: &LightSurface::new(light), lanes, u, v })
    }

    /// The contribution of a light to a surface at the origin with normal +z, seen from above:
    /// whether it is lit, the diffuse and the specular term.
    fn lit(material: &Material, position: Vec3) -> (bool, f32, f32) {
        let material = &ShadingMaterial::new(material);
        let [origin, normal, view_dir] = [Vec3::ZERO, Vec3::Z, -Vec3::Z];
        let point = ShadingPoint { material, origin, normal, geometric_normal: normal, view_dir };
        let light = Light::Point { position, color: Color::ONE };
        let mut lanes = ShadingLanes::EMPTY;
        lanes.fill([point; 3].into_iter());
        let (terms, _) = compute(&light, &lanes, [0.0; LANES], [0.0; LANES]);
        assert!([0, 0b111].contains(&terms.lit));
        (terms.lit != 0, terms.diffuse[2], terms.specular[2])
    }

    fn shiny(shininess: f32) -> Material {
        Material { specular: Color::ONE, shininess, ..Material::default() }
    }

    #[test]
    fn light_from_the_eye_gives_full_diffuse_and_full_highlight() {
        assert_eq!(lit(&shiny(50.0), 7.0 * Vec3::Z), (true, 1.0, 1.0));
    }

    #[test]
    fn slanted_light_falls_off_with_the_cosine_and_highlights_with_its_power() {
        let (sin, cos) = 60f32.to_radians().sin_cos();
        for shininess in [10.0, 2.5] {
            let (_, diffuse, specular) = lit(&shiny(shininess), 3.0 * Vec3::new(sin, 0.0, cos));
            assert!((diffuse - 0.5).abs() < 1e-6);
            let expected = 30f32.to_radians().cos().powf(shininess);
            assert!((specular - expected).abs() < 1e-5);
        }
    }

    #[test]
    fn points_are_lit_where_light_can_reach_them_and_adds_something() {
        let behind = -Vec3::Z;
        assert!(!lit(&shiny(3.0), behind).0);
        let clear = Material { alpha: 0.5, ..shiny(3.0) };
        let (arrives, diffuse, specular) = lit(&clear, Vec3::new(1.0, 0.0, -0.1));
        assert!(arrives && diffuse == 0.0 && specular > 0.0);
        assert!(!lit(&Material { alpha: 0.5, ..Material::default() }, behind).0);
        let black = Material { reflectance: Color::ZERO, ..Material::default() };
        assert!(!lit(&black, Vec3::Z).0);
    }

    #[test]
    fn a_point_at_the_surface_gives_no_nan() {
        for material in [Material::default(), shiny(2.0), Material { alpha: 0.5, ..shiny(2.0) }] {
            assert_eq!(lit(&material, Vec3::ZERO), (false, 0.0, 0.0));
        }
    }

    /// Points anywhere, of three materials in turn.
    fn some_points(materials: &[ShadingMaterial; 3]) -> Vec<ShadingPoint<'_>> {
        let mut random = Random::new(&[3]);
        let mut vector = || Vec3::from_array(std::array::from_fn(|_| random.next_f32() - 0.5));
        let point = |material| ShadingPoint {
            material,
            origin: vector(),
            normal: vector().normalize(),
            geometric_normal: vector().normalize(),
            view_dir: vector().normalize(),
        };
        materials.iter().cycle().take(LANES).map(point).collect()
    }

    #[test]
    fn a_contribution_depends_neither_on_its_lane_nor_on_other_lanes() {
        let light = Light::Area {
            corner: Vec3::new(-1.0, -2.0, 1.5),
            side_u: Vec3::new(2.0, 0.0, 0.5),
            side_v: Vec3::new(0.0, 3.0, -1.0),
            color: Color::ONE,
        };
        let (u, v) = (std::array::from_fn(|i| i as f32 / 16.0), [0.3; LANES]);
        let matte = ShadingMaterial::new(&Material::default());
        let clear = ShadingMaterial::new(&Material { alpha: 0.5, ..shiny(7.0) });
        for materials in [[matte, clear, ShadingMaterial::new(&shiny(2.5))], [matte, clear, clear]]
        {
            let points = some_points(&materials);
            let mut lanes = ShadingLanes::EMPTY;
            lanes.fill(points.iter().copied());
            let (together, ways) = compute(&light, &lanes, u, v);
            assert!(together.lit.count_ones() > 4);
            for lane in 0..LANES {
                lanes.fill(std::iter::once(points[lane]));
                let (alone, way) = compute(&light, &lanes, [u[lane]; LANES], v);
                assert_eq!(together.lit >> lane & 1, alone.lit);
                let bits = |row: [f32; 5]| row.map(f32::to_bits);
                let of = |i: &LightContribution, [x, y, z]: &LaneVectors, lane: usize| {
                    bits([x[lane], y[lane], z[lane], i.diffuse[lane], i.specular[lane]])
                };
                assert_eq!(of(&together, &ways, lane), of(&alone, &way, 0));
            }
        }
    }
}
