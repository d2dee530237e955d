//! What a picture is to be: size, sampling, view.

use std::fmt;

use crate::scene::Scene;

/// How area lights are sampled. The default leaves less noise in the same time by the study in
/// `docs/sampling.md`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Sampling {
    /// Jittered samples that are made once, shuffled for each pixel and light, and assigned to the
    /// pixel's view samples: together they cover the light evenly.
    #[default]
    Shuffled,
    /// Samples made on the fly, for each view sample separately.
    Independent,
}

impl Sampling {
    /// All ways.
    pub const ALL: [Self; 2] = [Self::Shuffled, Self::Independent];

    /// The name on the command line and in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Shuffled => "shuffled",
            Self::Independent => "independent",
        }
    }

    /// What it is, in a line.
    #[must_use]
    pub fn summary(self) -> &'static str {
        match self {
            Self::Shuffled => "made once, then shuffled for each pixel and light",
            Self::Independent => "made on the fly for each sample of a pixel",
        }
    }
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

impl View {
    /// All views.
    pub const ALL: [Self; 6] =
        [Self::Color, Self::Normal, Self::Depth, Self::Object, Self::Primitive, Self::Heatmap];

    /// The name on the command line and in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Color => "color",
            Self::Normal => "normal",
            Self::Depth => "depth",
            Self::Object => "object",
            Self::Primitive => "primitive",
            Self::Heatmap => "heatmap",
        }
    }

    /// What it is, in a line.
    #[must_use]
    pub fn summary(self) -> &'static str {
        match self {
            Self::Color => "the shaded scene",
            Self::Normal => "the normal of the surface",
            Self::Depth => "the distance from the eye",
            Self::Object => "which object was hit, a colour each",
            Self::Primitive => "which primitive was hit, a colour each",
            Self::Heatmap => "how many boxes and primitives the rays tested",
        }
    }
}

/// A part of the picture, in pixels from the top left; the right and bottom ends are excluded.
///
/// Shown as it is written on the command line: `x0,y0,x1,y1`.
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

    /// How many pixels there are; for a crop that is not empty.
    #[must_use]
    pub fn pixels(&self) -> u64 {
        u64::from(self.width()) * u64::from(self.height())
    }

    /// Whether there is a pixel in it.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.x0 >= self.x1 || self.y0 >= self.y1
    }

    /// Whether it lies within a picture of this size.
    #[must_use]
    pub fn is_within(&self, width: u32, height: u32) -> bool {
        self.x1 <= width && self.y1 <= height
    }
}

impl fmt::Display for Crop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{},{},{},{}", self.x0, self.y0, self.x1, self.y1)
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
    /// The most that `aa · light_samples` may be: the samples of a light for one pixel are made and
    /// traced together, so their number must stay within memory.
    pub const MAX_LIGHT_SIDE: u32 = 1_024;

    /// The most pixels that are rendered at once, of the crop if there is one: as many as in a
    /// picture of 16384 × 16384. All of them are held until the picture is written, at first twice
    /// and with 12 bytes each: 6 GiB for so many.
    pub const MAX_PIXELS: u64 = 1 << 28;

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
