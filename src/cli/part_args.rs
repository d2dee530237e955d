//! The definitions of `srt part` and `srt assemble`.

use std::path::PathBuf;

use clap::Args;

use super::choice::described;
use super::render_args::PictureArguments;
use super::values;
use super::work_args::WorkArguments;
use crate::film::{Division, Share};

/// `srt part`.
#[derive(Debug, Args)]
#[command(after_help = "\
All parts together are the picture of `srt SCENE`, bit for bit, whatever each was rendered with: structure,\n\
threads, instruction set. docs/many-machines.md has how to run them.\n\n\
Exit codes: 0 done, 2 trouble.\n\n\
Examples:\n  \
srt part scene.sce --part 3/7 -o part-3.srtp\n  \
parallel srt part scene.sce --part {}/7 -o part-{}.srtp ::: $(seq 7)\n  \
srt assemble part-*.srtp -o picture.png")]
pub(crate) struct PartArguments {
    /// The scene file (sce1.0); `-` is standard input
    #[arg(value_name = "SCENE")]
    pub(crate) scene: PathBuf,

    /// Which part of how many: 3/7 is the third of seven
    #[arg(long, value_name = "K/N", allow_hyphen_values = true, value_parser = values::share)]
    pub(crate) part: Share,

    /// How the picture is divided
    #[arg(long, value_name = "WAY", default_value = Division::default().name(),
        value_parser = described(&Division::ALL, Division::name, Division::summary))]
    pub(crate) by: Division,

    /// The file to write; `-` is standard output
    #[arg(long, short, value_name = "FILE")]
    pub(crate) output: PathBuf,

    /// What is rendered beside the scene, and by what.
    #[command(flatten)]
    pub(crate) work: WorkArguments,

    /// Treat unknown commands of the scene as warnings
    #[arg(long, help_heading = "Output")]
    pub(crate) lenient: bool,

    /// Print nothing but errors
    #[arg(long, short, help_heading = "Output")]
    pub(crate) quiet: bool,
}

/// `srt assemble`.
#[derive(Debug, Args)]
#[command(after_help = "\
Parts of different scenes, settings or versions are refused; those that are missing or there twice are named.\n\n\
Exit codes: 0 done, 2 trouble.\n\n\
Example:\n  srt assemble part-*.srtp -o picture.png")]
pub(crate) struct AssembleArguments {
    /// The parts, all of them, in any order
    #[arg(value_name = "PART", required = true)]
    pub(crate) parts: Vec<PathBuf>,

    /// The picture to write; `-` is standard output
    ///
    /// The extension decides the format, as that of `srt SCENE OUTPUT` does.
    #[arg(long, short, value_name = "OUTPUT")]
    pub(crate) output: PathBuf,

    /// How its light is fitted into the picture, and in which format.
    #[command(flatten)]
    pub(crate) picture: PictureArguments,

    /// Print nothing but errors
    #[arg(long, short, help_heading = "Output")]
    pub(crate) quiet: bool,
}
