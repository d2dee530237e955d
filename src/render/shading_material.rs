//! A material as shading needs it: the terms that depend on the material alone, computed once.

use crate::description::Material;
use crate::math::Color;

use super::exponent::Exponent;

/// The coefficients of the shading model for one material.
#[derive(Clone, Copy, Debug)]
pub(super) struct ShadingMaterial {
    /// α·ca·cr: the reflected ambient light.
    pub(super) ambient: Color,
    /// α·cr: the factor of diffuse reflection.
    pub(super) diffuse: Color,
    /// cp: the factor of highlights and of mirror reflection.
    pub(super) specular: Color,
    /// The exponent of highlights.
    pub(super) exponent: Exponent,
    /// (1 − cp)(1 − α): the share of light that reaches the border of a clear medium, where it is
    /// reflected and refracted.
    pub(super) clear: Color,
    /// The index of refraction of the inside.
    pub(super) refractive_index: f32,
    /// 1 − α: the share of light that a shadow ray keeps behind the surface.
    pub(super) transparency: f32,
    /// Whether the surface lets no light through.
    pub(super) opaque: bool,
    /// Whether there is diffuse reflection.
    pub(super) has_diffuse: bool,
    /// Whether there are highlights and mirror reflection.
    pub(super) has_specular: bool,
}

impl ShadingMaterial {
    pub(super) fn new(material: &Material) -> Self {
        let transparency = 1.0 - material.alpha;
        let diffuse = material.alpha * material.reflectance;
        Self {
            ambient: material.alpha * material.ambient_light * material.reflectance,
            diffuse,
            specular: material.specular,
            exponent: Exponent::new(material.shininess),
            clear: (Color::ONE - material.specular).max(Color::ZERO) * transparency,
            refractive_index: material.refractive_index,
            transparency,
            opaque: material.alpha >= 1.0,
            has_diffuse: diffuse != Color::ZERO,
            has_specular: material.specular != Color::ZERO,
        }
    }

    /// Whether light is reflected or refracted at a border of clear media.
    pub(super) fn is_clear(&self) -> bool {
        self.clear.max_element() > 0.0
    }

    /// Whether mirrored or refracted rays leave the surface.
    pub(super) fn has_secondary_rays(&self) -> bool {
        self.has_specular || self.is_clear()
    }
}
