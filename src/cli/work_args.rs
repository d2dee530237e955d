//! The arguments that decide what is rendered, and by what: those of `srt` and of `srt part`.

use clap::Args;

use super::choice::{described, named};
use super::frames::LAST_FRAME;
use super::structures::Structures;
use super::values::{self, Size, whole};
use crate::accel::Quality;
use crate::description::Options;
use crate::film::Crop;
use crate::render::{Sampling, Settings, View};
use crate::scene::Structure;

/// The structure that is traced where none is named.
pub(super) const USUAL_STRUCTURE: &str = "bvh8";

/// What is rendered beside the scene, and by what.
#[derive(Debug, Args)]
pub(crate) struct WorkArguments {
    /// The acceleration structure [default: bvh8, or that of a built scene]
    #[arg(long, value_name = "NAME", value_parser = Structures::default().parser(),
        help_heading = "Structure")]
    pub(crate) accel: Option<Structure>,

    /// The quality of the build: slower builds make better trees [default: medium]
    #[arg(long, value_name = "QUALITY",
        value_parser = named(&Quality::ALL, Quality::name), help_heading = "Structure")]
    pub(crate) build: Option<Quality>,

    /// Threads that build and render, at most four a processor [default: one a processor]
    #[arg(long, value_name = "N", allow_negative_numbers = true,
        value_parser = whole::<u16>(1, 1024), help_heading = "Structure")]
    pub(crate) threads: Option<u16>,

    /// The frame of a scene that moves [default: 0, or that of a built scene]
    #[arg(long, value_name = "N", allow_negative_numbers = true,
        value_parser = whole::<u32>(0, u64::from(LAST_FRAME)), help_heading = "Picture")]
    pub(crate) frame: Option<u32>,

    /// Width and height in pixels [default: those of the scene]
    #[arg(long, value_name = "WxH", allow_hyphen_values = true, help_heading = "Picture")]
    pub(crate) size: Option<Size>,

    /// Render only the columns x0 to x1 and rows y0 to y1, counted from the top left
    ///
    /// x1 and y1 are the first column and row outside: 0,0,320,240 is the top left corner, 320
    /// pixels wide and 240 high. The picture has these pixels alone, with the values that they have
    /// in the whole picture.
    #[arg(long, value_name = "x0,y0,x1,y1", allow_hyphen_values = true, value_parser = values::crop,
        help_heading = "Picture")]
    pub(crate) crop: Option<Crop>,

    /// N × N samples a pixel; 0 is one ray through its centre [default: that of the scene]
    ///
    /// For --view color and heatmap: the other views show what one ray through the centre hits.
    #[arg(long, value_name = "N", allow_negative_numbers = true,
        value_parser = whole::<u32>(0, u64::from(Options::MAX_AA)), help_heading = "Picture")]
    pub(crate) aa: Option<u32>,

    /// How the samples of lights are made
    #[arg(long, value_name = "METHOD", default_value = Sampling::default().name(),
        value_parser = described(&Sampling::ALL, Sampling::name, Sampling::summary),
        help_heading = "Picture")]
    pub(crate) sampling: Sampling,

    /// N × N samples of each area light for each sample of a pixel
    #[arg(long, value_name = "N", allow_negative_numbers = true, default_value_t = 1,
        value_parser = whole::<u32>(1, u64::from(Settings::MAX_LIGHT_SIDE)),
        help_heading = "Picture")]
    pub(crate) light_samples: u32,

    /// How many times a ray may be mirrored or refracted [default: that of the scene]
    #[arg(long, value_name = "N", allow_negative_numbers = true,
        value_parser = whole::<u32>(0, u64::from(Options::MAX_RECURSION)),
        help_heading = "Picture")]
    pub(crate) max_recursion: Option<u32>,

    /// The seed of the random numbers
    #[arg(
        long,
        value_name = "N",
        allow_negative_numbers = true,
        default_value_t = 0,
        value_parser = whole::<u64>(0, u64::MAX),
        help_heading = "Picture"
    )]
    pub(crate) seed: u64,

    /// What the pixels show
    ///
    /// All but color and heatmap show what one ray through the centre of each pixel hits, whatever --aa is.
    /// Depths (in steps of equal factors) and heatmaps are coloured, and the scale is printed on
    /// standard error; exr and hdr hold the numbers themselves.
    #[arg(long, value_name = "WHAT", default_value = View::default().name(),
        value_parser = described(&View::ALL, View::name, View::summary),
        help_heading = "Picture")]
    pub(crate) view: View,
}
