//! Materials as shading needs them: what depends on the material alone, computed once.

use crate::description::Material;
use crate::math::Color;

use super::optics::Exponent;

/// How a surface answers light.
#[derive(Clone, Copy, Debug)]
pub(super) struct Finish {
    /// What it sends of ambient light.
    pub(super) ambient: Color,
    /// What it sends of light that falls on it straight.
    pub(super) diffuse: Color,
    /// What it sends in highlights, and mirrors.
    pub(super) specular: Color,
    /// How sharp the highlights are.
    pub(super) exponent: Exponent,
    /// The share of light that meets the border of a clear medium.
    pub(super) clear: Color,
    /// The index of refraction of its inside.
    pub(super) refractive_index: f32,
    /// The share of light that passes in a straight line: what shadow rays keep.
    pub(super) transparency: f32,
    /// Whether nothing passes.
    pub(super) opaque: bool,
    /// Whether it sends on light by its diffuse reflection.
    pub(super) matte: bool,
    /// Whether it has highlights.
    pub(super) shines: bool,
}

impl Finish {
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
            matte: diffuse != Color::ZERO,
            shines: material.specular != Color::ZERO,
        }
    }

    /// Whether light that comes to the eye from this surface may have come by a mirror or through
    /// the surface.
    pub(super) fn goes_on(&self) -> bool {
        self.shines || self.clear.max_element() > 0.0
    }
}
