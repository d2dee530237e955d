//! The definition of `srt show`.

use std::path::PathBuf;

use clap::Args;

use super::choice::named;
use super::frames::LAST_FRAME;
use super::structures::Structures;
use super::values::{Size, whole};
use crate::accel::Quality;
use crate::description::Options;
use crate::scene::Structure;

/// `srt show`.
#[derive(Debug, Args)]
#[command(after_help = "\
The page has a picture of the scene for each level of the structure, with the boxes, balls or cells of that\n\
level drawn over it, and a slider. It is one file that loads nothing; without scripts, and on paper, all\n\
pictures stand in rows. `srt SCENE OUTPUT --view cells` draws the leaves alone.\n\n\
Exit codes: 0 done, 2 trouble.\n\n\
Examples:\n  \
srt show bvh scene.sce -o bvh.html\n  \
srt show octree:leaf=32 scene.sce -o octree.html --levels 6 --size 960x640")]
pub(crate) struct ShowArguments {
    /// The acceleration structure
    #[arg(index = 1, value_name = "STRUCTURE", value_parser = Structures::default().parser())]
    pub(crate) accel: Structure,

    /// The scene file (sce1.0); `-` is standard input
    #[arg(index = 2, value_name = "SCENE")]
    pub(crate) scene: PathBuf,

    /// The page to write; `-` is standard output
    #[arg(long, short, value_name = "FILE")]
    pub(crate) output: PathBuf,

    /// The most levels that get a picture, of the structure over the objects and of those over the meshes
    #[arg(long, value_name = "N", allow_negative_numbers = true, default_value_t = 12,
        value_parser = whole::<u32>(1, 100))]
    pub(crate) levels: u32,

    /// Width and height of the pictures in pixels [default: 720 wide, in the form of the scene's]
    #[arg(long, value_name = "WxH", allow_hyphen_values = true)]
    pub(crate) size: Option<Size>,

    /// N × N samples a pixel; 0 is one ray through its centre [default: that of the scene]
    #[arg(long, value_name = "N", allow_negative_numbers = true,
        value_parser = whole::<u32>(0, u64::from(Options::MAX_AA)))]
    pub(crate) aa: Option<u32>,

    /// The frame of a scene that moves [default: 0, or that of a built scene]
    #[arg(long, value_name = "N", allow_negative_numbers = true,
        value_parser = whole::<u32>(0, u64::from(LAST_FRAME)))]
    pub(crate) frame: Option<u32>,

    /// The quality of the build: slower builds make better trees [default: medium]
    #[arg(long, value_name = "QUALITY", value_parser = named(&Quality::ALL, Quality::name))]
    pub(crate) build: Option<Quality>,

    /// Threads that build and render, at most four a processor [default: one a processor]
    #[arg(long, value_name = "N", allow_negative_numbers = true,
        value_parser = whole::<u16>(1, 1024))]
    pub(crate) threads: Option<u16>,

    /// Treat unknown commands of the scene as warnings
    #[arg(long)]
    pub(crate) lenient: bool,

    /// Print nothing but errors
    #[arg(long, short)]
    pub(crate) quiet: bool,
}
