//! How light falls on surfaces: from one point of a light to each of sixteen surfaces at a time.
//!
//! Every operation is done lane by lane and rounds as that of a single value, so what a point adds
//! depends neither on its lane, nor on the surfaces beside it, nor on the instruction set.

use glam::Vec3;

use crate::math::{Lanes, Lanes3, Mask as _, dot, ones, sub};
use crate::scene::Light;
use crate::simd::{LANES, Row as _, Simd, splat3};

use super::optics::{Exponent, whole_power};
use super::receivers::{Receivers, Row, Rows3};

/// The place of a light: corner + u·side_u + v·side_v.
#[derive(Clone, Copy, Debug)]
pub(super) struct LightPlane {
    corner: Vec3,
    side_u: Vec3,
    side_v: Vec3,
}

impl LightPlane {
    pub(super) fn new(light: &Light) -> Self {
        match *light {
            Light::Point { position, .. } => {
                Self { corner: position, side_u: Vec3::ZERO, side_v: Vec3::ZERO }
            }
            Light::Area { corner, side_u, side_v, .. } => Self { corner, side_u, side_v },
        }
    }

    /// The points at a place of the unit square for each lane.
    #[inline(always)]
    fn points<S: Simd>(&self, u: S::F16, v: S::F16) -> Lanes3<S::F16> {
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

/// What one point of a light for each of sixteen surfaces would add to what they send to the eye.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Incidence {
    /// A bit for each lane: whether light that adds anything may arrive. The numbers of the other
    /// lanes are 0; if light arrives in none, they are not set.
    pub(super) lanes: u32,
    /// max(0, n·l)
    pub(super) diffuse: Row,
    /// max(0, n·h)^shininess; not set if no surface with highlights is reached.
    pub(super) specular: Row,
}

impl Incidence {
    /// Light from the points at `u`, `v` of a light; also gives the ways from the surfaces to them.
    ///
    /// Light does not arrive where the answer is known: an opaque surface is in its own shadow on
    /// the side away from the light, and light that falls from behind the shading normal on a
    /// surface without highlights adds nothing.
    #[inline(always)]
    pub(super) fn fall<S: Simd>(
        &mut self,
        plane: &LightPlane,
        receivers: &Receivers,
        u: S::F16,
        v: S::F16,
        to_light: &mut Rows3,
    ) {
        let zero = S::F16::splat(0.0);
        let way = sub(plane.points::<S>(u, v), load::<S>(&receivers.origin));
        way[0].store(&mut to_light[0]);
        way[1].store(&mut to_light[1]);
        way[2].store(&mut to_light[2]);
        let outside = zero.lt(dot(load::<S>(&receivers.geometric_normal), way)).bits();
        let reached = receivers.present & (outside | !receivers.opaque);
        self.lanes = 0;
        if reached == 0 {
            return; // As on the side of things away from a light.
        }
        let length_recip = S::F16::splat(1.0) / dot(way, way).sqrt();
        let normal = load::<S>(&receivers.normal);
        let cosine = dot(normal, way) * length_recip;
        let in_front = zero.lt(cosine).bits() & reached;
        let mut lanes = in_front & receivers.matte;
        if receivers.shining & reached != 0 {
            let l = [way[0] * length_recip, way[1] * length_recip, way[2] * length_recip];
            let half = sub(l, load::<S>(&receivers.view_dir));
            let cosine = dot(normal, half) * (S::F16::splat(1.0) / dot(half, half).sqrt());
            // A NaN, where light comes straight from behind, is not above 0 and gives no highlight.
            let above = zero.lt(cosine).bits() & receivers.shining & reached;
            let base = cosine.min(S::F16::splat(1.0)).select(above, zero);
            let power = power::<S>(receivers, base, above).select(above, zero);
            power.store(&mut self.specular);
            lanes |= zero.lt(power).bits();
        }
        cosine.select(in_front & receivers.matte, zero).store(&mut self.diffuse);
        self.lanes = lanes;
    }
}

/// Bases between 0 and 1 to the power of their surfaces' highlights.
#[inline(always)]
fn power<S: Simd>(receivers: &Receivers, base: S::F16, lanes: u32) -> S::F16 {
    if let Some(Exponent::Whole(exponent)) = receivers.exponent {
        return whole_power(base, exponent, S::F16::splat(1.0));
    }
    let (mut bases, mut powers) = ([0.0; LANES], [0.0; LANES]);
    base.store(&mut bases);
    for lane in ones(lanes) {
        powers[lane % LANES] = receivers.exponents[lane % LANES].power(bases[lane % LANES]);
    }
    S::F16::load(&powers)
}

#[inline(always)]
fn load<S: Simd>(rows: &Rows3) -> Lanes3<S::F16> {
    [S::F16::load(&rows[0]), S::F16::load(&rows[1]), S::F16::load(&rows[2])]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::description::Material;
    use crate::math::{Color, Random};
    use crate::render::finish::Finish;
    use crate::render::receivers::Receiver;
    use crate::simd::{Kernel, dispatch};

    struct Fall<'a> {
        plane: &'a LightPlane,
        receivers: &'a Receivers,
        u: Row,
        v: Row,
    }

    impl Kernel for Fall<'_> {
        type Output = (Incidence, Rows3);
        #[inline(always)]
        fn run<S: Simd>(self) -> Self::Output {
            let (mut incidence, mut to_light) = (Incidence::default(), Rows3::default());
            let (u, v) = (S::F16::load(&self.u), S::F16::load(&self.v));
            incidence.fall::<S>(self.plane, self.receivers, u, v, &mut to_light);
            (incidence, to_light)
        }
    }

    fn fall(light: &Light, receivers: &Receivers, u: Row, v: Row) -> (Incidence, Rows3) {
        dispatch(Fall { plane: &LightPlane::new(light), receivers, u, v })
    }

    /// What light from a point adds on a surface at the origin with normal +z, seen from above:
    /// whether any arrives, diffuse, and highlight.
    fn lit(material: &Material, point: Vec3) -> (bool, f32, f32) {
        let finish = &Finish::new(material);
        let [origin, normal, view_dir] = [Vec3::ZERO, Vec3::Z, -Vec3::Z];
        let surface = Receiver { finish, origin, normal, geometric_normal: normal, view_dir };
        let light = Light::Point { position: point, color: Color::ONE };
        let mut receivers = Receivers::NONE;
        receivers.lay_out([surface; 3].into_iter());
        let (incidence, _) = fall(&light, &receivers, [0.0; LANES], [0.0; LANES]);
        assert!([0, 0b111].contains(&incidence.lanes));
        (incidence.lanes != 0, incidence.diffuse[2], incidence.specular[2])
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
    fn light_arrives_from_where_it_can_and_where_it_adds_something() {
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

    /// Surfaces of three materials here and there.
    fn some_surfaces(finishes: &[Finish; 3]) -> Vec<Receiver<'_>> {
        let mut random = Random::new(&[3]);
        let mut vector = || Vec3::from_array(std::array::from_fn(|_| random.next_f32() - 0.5));
        let receiver = |finish| Receiver {
            finish,
            origin: vector(),
            normal: vector().normalize(),
            geometric_normal: vector().normalize(),
            view_dir: vector().normalize(),
        };
        finishes.iter().cycle().take(LANES).map(receiver).collect()
    }

    #[test]
    fn what_a_point_adds_depends_neither_on_its_lane_nor_on_its_neighbours() {
        let light = Light::Area {
            corner: Vec3::new(-1.0, -2.0, 1.5),
            side_u: Vec3::new(2.0, 0.0, 0.5),
            side_v: Vec3::new(0.0, 3.0, -1.0),
            color: Color::ONE,
        };
        let (u, v) = (std::array::from_fn(|i| i as f32 / 16.0), [0.3; LANES]);
        let matte = Finish::new(&Material::default());
        let clear = Finish::new(&Material { alpha: 0.5, ..shiny(7.0) });
        for finishes in [[matte, clear, Finish::new(&shiny(2.5))], [matte, clear, clear]] {
            let surfaces = some_surfaces(&finishes);
            let mut receivers = Receivers::NONE;
            receivers.lay_out(surfaces.iter().copied());
            let (together, ways) = fall(&light, &receivers, u, v);
            assert!(together.lanes.count_ones() > 4);
            for lane in 0..LANES {
                receivers.lay_out(std::iter::once(surfaces[lane]));
                let (alone, way) = fall(&light, &receivers, [u[lane]; LANES], v);
                assert_eq!(together.lanes >> lane & 1, alone.lanes);
                let bits = |row: [f32; 5]| row.map(f32::to_bits);
                let of = |i: &Incidence, [x, y, z]: &Rows3, lane: usize| {
                    bits([x[lane], y[lane], z[lane], i.diffuse[lane], i.specular[lane]])
                };
                assert_eq!(of(&together, &ways, lane), of(&alone, &way, 0));
            }
        }
    }
}
