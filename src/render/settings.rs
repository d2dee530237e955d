//! What a picture is to be: size, sampling, view.

use crate::scene::Scene;

/// How area lights are sampled.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Sampling {
    /// Jittered samples that are made once, shuffled for each pixel and light, and dealt out to
    /// the pixel's view samples: together they cover the light evenly.
    #[default]
    Shuffled,
    /// Samples made on the fly, for each view sample on its own.
    Independent,
}

/// What a pixel shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum View {
    /// The picture.
    #[default]
    Color,
    /// The shading normal of what is seen: (n + 1)/2 as a colour.
    Normal,
    /// How far away it is, along the view ray, in the scene's unit.
    Depth,
    /// Which object it is: a colour for each.
    Object,
    /// Which primitive it is: a colour for each.
    Primitive,
    /// How many boxes and primitives all of a pixel's rays tested.
    Heatmap,
}

/// A part of the picture, in pixels from the top left; the right and bottom ends are excluded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Crop {
    /// First column.
    pub x0: u32,
    /// First row.
    pub y0: u32,
    /// Behind the last column.
    pub x1: u32,
    /// Behind the last row.
    pub y1: u32,
}

impl Crop {
    /// Width in pixels.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.x1 - self.x0
    }

    /// Height in pixels.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.y1 - self.y0
    }
}

/// Everything that decides a picture beside the scene. Nothing here knows of structures, threads
/// or instruction sets, because none of these changes a picture.
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
    /// How they are chosen.
    pub sampling: Sampling,
    /// How many times a view ray may be mirrored or refracted.
    pub max_recursion: u32,
    /// Where the random numbers start.
    pub seed: u64,
    /// What a pixel shows.
    pub view: View,
    /// Whether boxes and primitives are counted for the statistics. Counting takes time.
    pub count: bool,
}

impl Settings {
    /// What the scene file asks for.
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

    /// View samples a pixel.
    #[must_use]
    pub fn samples_per_pixel(&self) -> u32 {
        self.aa.max(1).pow(2)
    }
}
