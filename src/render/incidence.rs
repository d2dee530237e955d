//! How light falls on a surface: from four points of a light at a time.
//!
//! Every operation is done lane by lane and rounds as that of a single value, so what a point adds
//! depends neither on its lane nor on the points beside it.

use glam::{Vec3, Vec4};

use crate::scene::Light;

use super::batch::Shaded;
use super::finish::Finish;

/// Points of a light that are computed with together.
pub(super) const LANES: usize = 4;

/// x, y and z of several vectors.
type Lanes3 = [Vec4; 3];

/// The place of a light, in every lane: corner + u·side_u + v·side_v.
pub(super) struct LightPlane {
    corner: Lanes3,
    side_u: Lanes3,
    side_v: Lanes3,
}

/// A surface on which light falls, in every lane.
pub(super) struct Receiver<'a> {
    finish: &'a Finish,
    origin: Lanes3,
    normal: Lanes3,
    geometric_normal: Lanes3,
    view_dir: Lanes3,
}

/// What four points of a light would add to what a surface sends to the eye.
#[derive(Clone, Copy, Debug)]
pub(super) struct Incidence {
    /// From the surface to the points.
    pub(super) to_light: Lanes3,
    /// A bit for each lane: whether light may arrive.
    pub(super) lanes: u32,
    /// max(0, n·l)
    pub(super) diffuse: Vec4,
    /// max(0, n·h)^shininess; 0 without highlights.
    pub(super) specular: Vec4,
}

impl LightPlane {
    pub(super) fn new(light: &Light) -> Self {
        match *light {
            Light::Point { position, .. } => Self {
                corner: splat(position),
                side_u: splat(Vec3::ZERO),
                side_v: splat(Vec3::ZERO),
            },
            Light::Area { corner, side_u, side_v, .. } => {
                Self { corner: splat(corner), side_u: splat(side_u), side_v: splat(side_v) }
            }
        }
    }

    /// The points at up to four samples; the lanes beyond repeat the last.
    #[inline(always)]
    fn points(&self, samples: &[[f32; 2]]) -> Lanes3 {
        let last = samples.len() - 1;
        let [u, v] = match samples {
            [a, b, c, d] => [Vec4::new(a[0], b[0], c[0], d[0]), Vec4::new(a[1], b[1], c[1], d[1])],
            _ => [0, 1].map(|i| Vec4::from_array(std::array::from_fn(|k| samples[k.min(last)][i]))),
        };
        std::array::from_fn(|axis| {
            self.corner[axis] + u * self.side_u[axis] + v * self.side_v[axis]
        })
    }
}

impl<'a> Receiver<'a> {
    #[inline(always)]
    pub(super) fn new(shaded: &Shaded, finish: &'a Finish) -> Self {
        Self {
            finish,
            origin: splat(shaded.origin),
            normal: splat(shaded.surface.normal),
            geometric_normal: splat(shaded.surface.geometric_normal),
            view_dir: splat(shaded.dir),
        }
    }

    /// Light from one to four samples of a light.
    ///
    /// Light does not arrive where the answer is known: an opaque surface is in its own shadow on
    /// the side away from the light, and light that falls from behind the shading normal on a
    /// surface without highlights adds nothing.
    #[inline(always)]
    pub(super) fn light(&self, plane: &LightPlane, samples: &[[f32; 2]]) -> Incidence {
        let points = plane.points(samples);
        let to_light: Lanes3 = std::array::from_fn(|axis| points[axis] - self.origin[axis]);
        let mut lanes = (1u32 << samples.len()) - 1;
        if self.finish.opaque {
            lanes &= dot(self.geometric_normal, to_light).cmpgt(Vec4::ZERO).bitmask();
        }
        let length_recip = dot(to_light, to_light).sqrt().recip();
        let cosine = dot(self.normal, to_light) * length_recip;
        let in_front = cosine.cmpgt(Vec4::ZERO);
        let mut specular = Vec4::ZERO;
        if self.finish.shines {
            specular = self.highlight(to_light.map(|row| row * length_recip), lanes);
        } else {
            lanes &= in_front.bitmask();
        }
        let diffuse = Vec4::select(in_front, cosine, Vec4::ZERO);
        Incidence { to_light, lanes, diffuse, specular }
    }

    /// The highlight of light from unit directions `l`.
    #[inline(always)]
    fn highlight(&self, l: Lanes3, lanes: u32) -> Vec4 {
        let half: Lanes3 = std::array::from_fn(|axis| l[axis] - self.view_dir[axis]);
        let cosine = dot(self.normal, half) * dot(half, half).sqrt().recip();
        // A NaN, where light comes straight from behind, is not above 0 and gives no highlight.
        let above = cosine.cmpgt(Vec4::ZERO);
        let power = self.finish.exponent.power(cosine.min(Vec4::ONE), lanes & above.bitmask());
        Vec4::select(above, power, Vec4::ZERO)
    }
}

#[inline(always)]
fn splat(v: Vec3) -> Lanes3 {
    v.to_array().map(Vec4::splat)
}

#[inline(always)]
fn dot(a: Lanes3, b: Lanes3) -> Vec4 {
    a[0] * b[0] + (a[1] * b[1] + a[2] * b[2])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::description::Material;
    use crate::math::Color;

    /// What light from a point adds on a surface at the origin with normal +z, seen from above.
    fn lit(material: &Material, point: Vec3) -> Incidence {
        let up = splat(Vec3::Z);
        let receiver = Receiver {
            finish: &Finish::new(material),
            origin: splat(Vec3::ZERO),
            normal: up,
            geometric_normal: up,
            view_dir: splat(-Vec3::Z),
        };
        let light = Light::Point { position: point, color: Color::ONE };
        receiver.light(&LightPlane::new(&light), &[[0.0; 2]])
    }

    fn shiny(shininess: f32) -> Material {
        Material { specular: Color::ONE, shininess, ..Material::default() }
    }

    #[test]
    fn light_from_the_eye_gives_full_diffuse_and_full_highlight() {
        let incidence = lit(&shiny(50.0), 7.0 * Vec3::Z);
        assert_eq!(incidence.lanes, 1);
        assert_eq!((incidence.diffuse[0], incidence.specular[0]), (1.0, 1.0));
    }

    #[test]
    fn slanted_light_falls_off_with_the_cosine_and_highlights_with_its_power() {
        let (sin, cos) = 60f32.to_radians().sin_cos();
        for shininess in [10.0, 2.5] {
            let incidence = lit(&shiny(shininess), 3.0 * Vec3::new(sin, 0.0, cos));
            assert!((incidence.diffuse[0] - 0.5).abs() < 1e-6);
            let expected = 30f32.to_radians().cos().powf(shininess);
            assert!((incidence.specular[0] - expected).abs() < 1e-5);
        }
    }

    #[test]
    fn light_arrives_from_where_it_can() {
        let behind = -Vec3::Z;
        assert_eq!(lit(&shiny(3.0), behind).lanes, 0);
        let clear = Material { alpha: 0.5, ..shiny(3.0) };
        let through = lit(&clear, Vec3::new(1.0, 0.0, -0.1));
        assert_eq!((through.lanes, through.diffuse[0]), (1, 0.0));
        assert!(through.specular[0] > 0.0);
        assert_eq!(lit(&Material { alpha: 0.5, ..Material::default() }, behind).lanes, 0);
    }

    #[test]
    fn a_point_at_the_surface_gives_no_nan() {
        for material in [Material::default(), shiny(2.0), Material { alpha: 0.5, ..shiny(2.0) }] {
            let incidence = lit(&material, Vec3::ZERO);
            assert_eq!((incidence.diffuse[0], incidence.specular[0]), (0.0, 0.0));
        }
    }

    #[test]
    fn what_a_point_adds_does_not_depend_on_its_lane() {
        let light = Light::Area {
            corner: Vec3::new(-1.0, -2.0, 1.5),
            side_u: Vec3::new(2.0, 0.0, 0.5),
            side_v: Vec3::new(0.0, 3.0, -1.0),
            color: Color::ONE,
        };
        let plane = LightPlane::new(&light);
        let finish = Finish::new(&shiny(7.0));
        let normal = splat(Vec3::new(0.6, 0.0, 0.8));
        let receiver = Receiver {
            finish: &finish,
            origin: splat(Vec3::new(0.1, 0.2, 0.3)),
            normal,
            geometric_normal: normal,
            view_dir: splat(Vec3::new(0.0, 0.6, -0.8)),
        };
        let samples = [[0.1, 0.9], [0.5, 0.3], [0.7, 0.7], [0.99, 0.01]];
        let together = receiver.light(&plane, &samples);
        for (lane, sample) in samples.iter().enumerate() {
            let alone = receiver.light(&plane, std::slice::from_ref(sample));
            let of = |i: &Incidence, lane: usize| {
                let [x, y, z] = i.to_light.map(|row| row[lane]);
                [x, y, z, i.diffuse[lane], i.specular[lane]].map(f32::to_bits)
            };
            assert_eq!(of(&together, lane), of(&alone, 0));
            assert_eq!(together.lanes >> lane & 1, alone.lanes);
        }
    }
}
