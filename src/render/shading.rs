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

    #[test]
    fn light_from_the_eye_gives_full_diffuse_and_full_highlight() {
        let material = Material {
            reflectance: Color::new(0.5, 0.25, 1.0),
            specular: Color::splat(0.2),
            shininess: 50.0,
            ..Material::default()
        };
        let mut sum = LightSum::default();
        sum.add(&material, Vec3::Z, -Vec3::Z, [(&(7.0 * Vec3::Z), &1.0)].into_iter());
        let color = sum.color(&material, Color::splat(0.8), 1);
        assert!((color - 0.8 * (material.reflectance + material.specular)).length() < 1e-6);
    }

    #[test]
    fn slanted_light_falls_off_with_the_cosine_and_highlights_with_its_power() {
        let material = Material { specular: Color::ONE, shininess: 10.0, ..Material::default() };
        let mut sum = LightSum::default();
        let (sin, cos) = 60f32.to_radians().sin_cos();
        let to_light = Vec3::new(sin, 0.0, cos);
        sum.add(&material, Vec3::Z, -Vec3::Z, [(&to_light, &1.0)].into_iter());
        assert!((sum.diffuse - 0.5).abs() < 1e-6);
        assert!((sum.specular - 30f32.to_radians().cos().powi(10)).abs() < 1e-5);
    }

    #[test]
    fn light_from_behind_gives_nothing_diffuse() {
        let mut sum = LightSum::default();
        let below = [(&-Vec3::Z, &1.0)].into_iter();
        sum.add(&Material::default(), Vec3::Z, -Vec3::Z, below);
        assert_eq!(sum, LightSum::default());
    }
}
