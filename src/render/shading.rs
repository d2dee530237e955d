//! The light that a surface sends to the eye: chapter 9 of Shirley et al., *Fundamentals of
//! Computer Graphics*, 2nd edition.

use glam::Vec3;

use crate::description::Material;
use crate::math::Color;

use super::optics::power;

/// What the directions to a light's samples add up to, before any colour.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct LightSum {
    /// Σ max(0, n·l)
    diffuse: f32,
    /// Σ max(0, n·h)^shininess
    specular: f32,
}

impl LightSum {
    /// Adds directions to a light, of any length, and the share of the light that arrives along
    /// each: in their order, so that the sum is the same however they are parted.
    pub(super) fn add<'a>(
        &mut self,
        material: &Material,
        normal: Vec3,
        view_dir: Vec3,
        arriving: impl Iterator<Item = (&'a Vec3, &'a f32)>,
    ) {
        let mirrors = material.specular != Color::ZERO;
        for (to_light, &share) in arriving {
            // Where nothing arrives, adding nothing is cheaper than a branch.
            let l = to_light * to_light.length_recip();
            self.diffuse += share * normal.dot(l).max(0.0);
            if mirrors && share > 0.0 {
                let half = l - view_dir;
                let cosine = (normal.dot(half) * half.length_recip()).clamp(0.0, 1.0);
                if cosine > 0.0 {
                    self.specular += share * power(cosine, material.shininess);
                }
            }
        }
    }

    /// The light sent to the eye, of a light of some colour with `samples` samples.
    #[inline]
    pub(super) fn color(&self, material: &Material, light: Color, samples: usize) -> Color {
        let diffuse = material.alpha * self.diffuse * material.reflectance;
        light * (diffuse + self.specular * material.specular) / samples as f32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What one direction to a light adds on a surface with normal +z, seen from above.
    fn lit(material: &Material, to_light: Vec3) -> LightSum {
        let mut sum = LightSum::default();
        sum.add(material, Vec3::Z, -Vec3::Z, std::iter::once((&to_light, &1.0)));
        sum
    }

    #[test]
    fn light_from_the_eye_gives_full_diffuse_and_full_highlight() {
        let material = Material {
            reflectance: Color::new(0.5, 0.25, 1.0),
            specular: Color::splat(0.2),
            shininess: 50.0,
            ..Material::default()
        };
        let color = lit(&material, 7.0 * Vec3::Z).color(&material, Color::splat(0.8), 1);
        assert!((color - 0.8 * (material.reflectance + material.specular)).length() < 1e-6);
    }

    #[test]
    fn slanted_light_falls_off_with_the_cosine_and_highlights_with_its_power() {
        let material = Material { specular: Color::ONE, shininess: 10.0, ..Material::default() };
        let (sin, cos) = 60f32.to_radians().sin_cos();
        let sum = lit(&material, Vec3::new(sin, 0.0, cos));
        assert!((sum.diffuse - 0.5).abs() < 1e-6);
        assert!((sum.specular - 30f32.to_radians().cos().powi(10)).abs() < 1e-5);
    }

    #[test]
    fn light_from_behind_gives_nothing_diffuse() {
        assert_eq!(lit(&Material::default(), -Vec3::Z), LightSum::default());
    }

    #[test]
    fn a_sum_does_not_depend_on_how_its_directions_are_parted() {
        let material = Material { specular: Color::ONE, shininess: 3.0, ..Material::default() };
        let dirs: Vec<Vec3> =
            (0..9).map(|i| Vec3::new(0.1 * i as f32, 0.3, 1.0 + 0.2 * i as f32)).collect();
        let shares = [1.0, 0.0, 0.5, 1.0, 0.25, 1.0, 0.0, 1.0, 1.0];
        let sum_of = |parts: &[std::ops::Range<usize>]| {
            let mut sum = LightSum::default();
            for part in parts {
                let arriving = dirs[part.clone()].iter().zip(&shares[part.clone()]);
                sum.add(&material, Vec3::Z, -Vec3::Z, arriving);
            }
            sum
        };
        assert_eq!(sum_of(std::slice::from_ref(&(0..9))), sum_of(&[0..2, 2..3, 3..9]));
    }
}
