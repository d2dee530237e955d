//! What all threads of a rendering share: the scene, the settings, and what is computed from both
//! before the first ray. It does not change while they render.

use std::sync::Arc;

use crate::scene::{Camera, Scene, Surface};

use super::light_samples::LightSamples;
use super::shading_material::ShadingMaterial;
use super::view_rays::ViewRays;
use super::{CellView, Settings};

pub(super) struct Frame<'a> {
    pub(super) scene: &'a Scene,
    pub(super) settings: &'a Settings,
    pub(super) view_rays: ViewRays,
    pub(super) light_samples: LightSamples,
    /// The scene's materials, in its order.
    pub(super) materials: Vec<ShadingMaterial>,
    /// Whether any object lets light through.
    pub(super) has_transparency: bool,
    /// The cells of the structure, where they are shown.
    pub(super) cells: Option<Arc<CellView>>,
}

impl<'a> Frame<'a> {
    pub(super) fn new(
        scene: &'a Scene,
        camera: &Camera,
        settings: &'a Settings,
        cells: Option<Arc<CellView>>,
    ) -> Self {
        let camera = camera.resized(settings.width, settings.height);
        Self {
            scene,
            settings,
            view_rays: ViewRays::new(camera, settings),
            light_samples: LightSamples::new(
                settings.sampling,
                settings.seed,
                settings.aa,
                settings.light_samples,
            ),
            materials: scene.materials.iter().map(ShadingMaterial::new).collect(),
            has_transparency: scene.has_transparency(),
            cells,
        }
    }

    pub(super) fn material_of(&self, surface: &Surface) -> &ShadingMaterial {
        &self.materials[surface.material]
    }
}
