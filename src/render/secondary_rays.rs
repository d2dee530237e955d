//! The rays by which paths go on from the surfaces that they have hit.

use crate::math::Color;

use super::frame::Frame;
use super::optics::refract;
use super::path::PathVertex;
use super::shading_material::ShadingMaterial;
use super::wave::Wave;

/// The mirrored and the refracted rays of one bounce.
#[derive(Default)]
pub(super) struct SecondaryRays {
    pub(super) mirrored: Wave,
    pub(super) refracted: Wave,
}

impl SecondaryRays {
    /// Appends the rays that leave the vertices of a wave.
    pub(super) fn append(&mut self, frame: &Frame<'_>, vertices: &[PathVertex]) {
        for vertex in vertices {
            let material = frame.material_of(&vertex.surface);
            if material.has_secondary_rays() {
                self.append_vertex(vertex, material);
            }
        }
    }

    /// A surface mirrors the share `cp`. Of the rest, the share 1 − alpha reaches the border of a
    /// clear medium. Fresnel's equations divide it into what is reflected and what is refracted.
    #[inline]
    fn append_vertex(&mut self, vertex: &PathVertex, material: &ShadingMaterial) {
        let mut mirrored = material.specular;
        if material.is_clear() {
            mirrored += self.append_refracted(vertex, material);
        }
        if let Some(path) = vertex.path.continued(mirrored, 1) {
            self.mirrored.push(vertex.mirrored_ray(), path);
        }
    }

    /// Appends the ray through the border, if there is one. Returns the share that is reflected.
    #[inline]
    fn append_refracted(&mut self, vertex: &PathVertex, material: &ShadingMaterial) -> Color {
        let index = material.refractive_index;
        let eta = if vertex.surface.from_inside { index } else { 1.0 / index };
        let border = refract(vertex.dir, vertex.surface.normal, eta);
        if let Some(dir) = border.dir {
            let refracted = (1.0 - border.reflected) * material.clear;
            if let Some(path) = vertex.path.continued(refracted, 2) {
                self.refracted.push(vertex.refracted_ray(dir), path);
            }
        }
        border.reflected * material.clear
    }
}
