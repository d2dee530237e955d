//! The definition of `srt animate`.

use std::path::PathBuf;

use clap::Args;

use super::choice::described;
use super::frames::FrameRange;
use super::structures::{StructureList, Structures};
use super::values::{self, Size, whole};
use crate::record::Strategy;
use crate::scene::{Structure, structure_named};

/// `srt animate`.
#[derive(Debug, Args)]
#[command(after_help = "\
Each structure is built for the first frame; for each frame after it, it is made ready in each way, and traces the rays\n\
of a small picture of that frame. The answers of all are compared, bit for bit, and some of them with those of no\n\
structure at all. With --out, the folder gets motion.json, motion.md, motion.csv and motion.html, a page that\n\
loads nothing, with pictures of up to 24 frames as a flip-book.\n\n\
Exit codes: 0 no answer differs; 1 one does; 2 trouble; 130 interrupted by Ctrl-C, 128 + n by another signal n: the\n\
frames that were done are written.\n\n\
Examples:\n  \
srt animate scenes/twist.sce --frames 0..60\n  \
srt animate scenes/crowd.sce --frames 0..30 --accel bvh8,kdtree --out results/crowd\n  \
srt animate scenes/twist.sce --frames 0..9 --strategies rebuild,refit --threads 1")]
pub(crate) struct AnimateArguments {
    /// The scene file (sce1.0); `-` is standard input
    #[arg(value_name = "SCENE")]
    pub(crate) scene: PathBuf,

    /// The frames: the first, for which all are built, and the last
    #[arg(long, value_name = "FIRST..LAST", allow_hyphen_values = true, value_parser = values::frames)]
    pub(crate) frames: FrameRange,

    /// The acceleration structures, separated by commas [default: bvh, bvh8]
    #[arg(long, value_name = "NAMES", value_parser = Structures::default().list_parser())]
    pub(crate) accel: Vec<StructureList>,

    /// How each is made ready for a frame, separated by commas [default: all that it offers]
    #[arg(long, value_name = "WAYS", value_delimiter = ',',
        value_parser = described(&Strategy::ALL, Strategy::name, Strategy::summary))]
    pub(crate) strategies: Vec<Strategy>,

    /// Threads that build and follow [default: one a processor]; rays are timed on one
    #[arg(long, value_name = "N", allow_negative_numbers = true,
        value_parser = whole::<u16>(1, 1024))]
    pub(crate) threads: Option<u16>,

    /// Width and height of the picture whose rays are traced
    #[arg(long, value_name = "WxH", allow_hyphen_values = true, default_value = "160x120")]
    pub(crate) size: Size,

    /// Rounds of the rays of each frame
    #[arg(long, value_name = "N", allow_negative_numbers = true, default_value_t = 3,
        value_parser = whole::<u32>(1, 100))]
    pub(crate) rounds: u32,

    /// The most rays of each class in a frame
    #[arg(long, value_name = "N", allow_negative_numbers = true, default_value_t = 50_000,
        value_parser = whole::<u32>(64, 10_000_000))]
    pub(crate) rays: u32,

    /// The folder to write motion.json, .md, .csv and .html into [default: none is written]
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,

    /// Treat unknown commands of the scene as warnings
    #[arg(long)]
    pub(crate) lenient: bool,

    /// Print nothing but errors; the files and the exit code are the result
    #[arg(long, short)]
    pub(crate) quiet: bool,
}

impl AnimateArguments {
    /// All structures that were named.
    pub(crate) fn structures(&self) -> Vec<Structure> {
        if self.accel.is_empty() {
            return ["bvh", "bvh8"].into_iter().filter_map(structure_named).copied().collect();
        }
        StructureList::joined(&self.accel)
    }

    /// The ways that were named, each once.
    pub(crate) fn strategies(&self) -> Vec<Strategy> {
        let is_wanted =
            |own: &Strategy| self.strategies.is_empty() || self.strategies.contains(own);
        Strategy::ALL.into_iter().filter(is_wanted).collect()
    }
}
