//! All settings of a rendering, with those of the scene file as a start.

use crate::scene::Scene;

use super::{Crop, Sampling, View};

/// Everything that decides a picture beside the scene. Structures, threads and instruction sets are
/// not among the settings, because none of them changes a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Width of the whole picture in pixels.
    pub width: u32,
    /// Height of the whole picture in pixels.
    pub height: u32,
    /// The part that is rendered; a crop shows the same pixels as the whole.
    pub crop: Option<Crop>,
    /// 0: one ray through each pixel's centre; n: n × n jittered samples.
    pub aa: u32,
    /// Each view sample takes m × m samples of each area light; at least 1.
    pub light_samples: u32,
    /// How the samples of area lights are chosen.
    pub sampling: Sampling,
    /// How many times a view ray may be mirrored or refracted.
    pub max_recursion: u32,
    /// Part of the key of all random numbers.
    pub seed: u64,
    /// What a pixel shows.
    pub view: View,
    /// Whether tests of boxes and primitives are counted for the statistics. Counting takes time.
    pub count: bool,
}

impl Settings {
    /// The most that `aa · light_samples` may be. The samples of a light for one pixel are made and
    /// traced together, so their number must stay within memory.
    pub const MAX_LIGHT_SIDE: u32 = 1_024;

    /// The most pixels that are rendered at once, of the crop if there is one: as many as a picture
    /// of 16384 × 16384 has. All of them are held until the picture is written, with 12 bytes each
    /// and, while tiles are put together, twice. That is 6 GiB for so many.
    pub const MAX_PIXELS: u64 = 1 << 28;

    /// The settings of the scene file.
    #[must_use]
    pub fn of_scene(scene: &Scene) -> Self {
        Self {
            width: scene.camera.width,
            height: scene.camera.height,
            crop: None,
            aa: scene.options.aa,
            light_samples: 1,
            sampling: Sampling::default(),
            max_recursion: scene.options.max_recursion,
            seed: 0,
            view: View::default(),
            count: false,
        }
    }

    /// The part of the picture that is rendered.
    #[must_use]
    pub fn region(&self) -> Crop {
        self.crop.unwrap_or(Crop { x0: 0, y0: 0, x1: self.width, y1: self.height })
    }

    /// The number of view samples per pixel.
    #[must_use]
    pub fn samples_per_pixel(&self) -> u32 {
        self.aa.max(1).pow(2)
    }

    /// The samples that a [`Film`](crate::film::Film) adds up for each pixel: its view samples if it shows their
    /// colour, and 1 if it shows what one ray hit or what all of them tested.
    #[must_use]
    pub fn film_samples(&self) -> u32 {
        if self.view == View::Color { self.samples_per_pixel() } else { 1 }
    }
}
