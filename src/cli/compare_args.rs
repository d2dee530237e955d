//! The definition of `srt compare`, `srt conformance` and `srt report`.

use std::path::PathBuf;
use std::time::Duration;

use clap::Args;
use clap::builder::{PathBufValueParser, TypedValueParser};

use super::choice::{described, named};
use super::source::is_stdin;
use super::structures::{StructureList, Structures};
use super::values::{Size, percent, seconds, sizes, whole};
use crate::accel::Quality;
use crate::compare::Family;
use crate::description::Options;
use crate::record::RayClass;
use crate::scene::Structure;

/// `srt compare`.
#[derive(Debug, Args)]
#[command(after_help = "\
Writes report.html, report.md, report.csv, report.json and the pictures into the folder; with\n\
--sampling-study, sampling.csv too.\n\n\
Exit codes: 0 all results are equal and nothing became slower; 1 a structure failed or its results\n\
differ, or --baseline shows a regression; 2 trouble, or the baseline has nothing in common with\n\
the comparison; 130 interrupted by Ctrl-C, 128 + n by another signal n: what was done is written.\n\n\
Examples:\n  \
srt compare scenes/hall.sce\n  \
srt compare scenes/*.sce --accel bvh,cwbvh --budget 60 --out results/trees\n  \
srt compare scenes/hall.sce --accel bvh8,bvh8:builder=ploc,leaf=4\n  \
srt compare scenes/torus-knot.sce --accel bvh,kdtree,octree,grid,grid:density=8,grid2,balls\n  \
srt compare --sweep 1k..10M --family hall --budget 300\n  \
srt compare scenes/soft-shadows.sce --sampling-study\n  \
srt compare scenes/hall.sce --save-rays rays\n  \
srt compare scenes/hall.sce --rays rays/hall.srtrays\n  \
srt compare scenes/hall.sce --baseline results/old/report.json --fail-above 10%")]
pub(crate) struct CompareArguments {
    /// The scene files (sce1.0)
    #[arg(value_name = "SCENE", required_unless_present = "sweep",
        value_parser = PathBufValueParser::new().try_map(named_file))]
    pub(crate) scenes: Vec<PathBuf>,

    /// The acceleration structures, separated by commas [default: none, ball, bvh, cwbvh, bvh8 and
    /// those of a program's own; the others are named]
    #[arg(long, value_name = "NAMES", value_parser = Structures::default().list_parser())]
    pub(crate) accel: Vec<StructureList>,

    /// The structure that ratios are taken to [default: none if it is compared, else the first]
    #[arg(long, value_name = "NAME")]
    pub(crate) base: Option<String>,

    /// The classes of rays that are timed, separated by commas [default: view, shadow, mirror,
    /// refraction]
    #[arg(long, value_name = "CLASSES", value_delimiter = ',',
        value_parser = named(&RayClass::ALL, RayClass::name))]
    pub(crate) classes: Vec<RayClass>,

    /// Write the recorded rays of each scene, and what they find, into a folder: SCENE.srtrays
    #[arg(long, value_name = "DIR", requires = "scenes")]
    pub(crate) save_rays: Option<PathBuf>,

    /// Measure the rays of a file that --save-rays or `srt rays import` wrote, in place of recorded
    /// ones; once for each scene, in their order
    #[arg(long, value_name = "FILE", requires = "scenes", conflicts_with = "save_rays")]
    pub(crate) rays: Vec<PathBuf>,

    /// The quality of the build: slower builds make better trees
    #[arg(long, value_name = "QUALITY", default_value = Quality::default().name(),
        value_parser = named(&Quality::ALL, Quality::name))]
    pub(crate) build: Quality,

    /// Threads that build and render [default: one a processor]; rays are timed on one
    #[arg(long, value_name = "N", allow_negative_numbers = true,
        value_parser = whole::<u16>(1, 1024))]
    pub(crate) threads: Option<u16>,

    /// How long all of it may take [default: 30 for each scene, at most 150; 60 more for --sweep,
    /// and 60 for --sampling-study]
    ///
    /// A scene may take a little longer, until the first round of each measurement is complete.
    #[arg(long, value_name = "SECONDS", allow_negative_numbers = true, value_parser = seconds)]
    pub(crate) budget: Option<Duration>,

    /// At least so many rounds of each measurement, if the budget allows
    #[arg(long, value_name = "N", allow_negative_numbers = true, default_value_t = 10,
        value_parser = whole::<u32>(1, 400))]
    pub(crate) rounds: u32,

    /// How much times differ from run to run on this machine, as a standard deviation; intervals
    /// include it
    ///
    /// No run can measure it by itself. The default was seen on virtual machines; on a machine that
    /// does nothing else it is less, and 0 gives intervals for this run alone.
    #[arg(long, value_name = "PERCENT", default_value = "5%", allow_negative_numbers = true,
        value_parser = percent)]
    pub(crate) between_runs: f64,

    /// Width and height of the pictures [default: those of the scene, at most 300 pixels a side]
    #[arg(long, value_name = "WxH", allow_hyphen_values = true)]
    pub(crate) size: Option<Size>,

    /// N × N samples a pixel; 0 is one ray through its centre [default: that of the scene, at most 2]
    #[arg(long, value_name = "N", allow_negative_numbers = true,
        value_parser = whole::<u32>(0, u64::from(Options::MAX_AA)))]
    pub(crate) aa: Option<u32>,

    /// The seed of the random numbers
    #[arg(long, value_name = "N", allow_negative_numbers = true, default_value_t = 0,
        value_parser = whole::<u64>(0, u64::MAX))]
    pub(crate) seed: u64,

    /// Also measure growth: sizes of a family of scenes, such as 1k..10M
    #[arg(long, value_name = "A..B", value_parser = sizes, requires = "family")]
    pub(crate) sweep: Option<(u32, u32)>,

    /// What grows: a mesh, by its triangles, or many objects, by their number
    #[arg(long, value_name = "KIND", requires = "sweep", visible_alias = "mesh",
        value_parser = described(&Family::ALL, Family::name, Family::description))]
    pub(crate) family: Option<Family>,

    /// Also study sampling: what random numbers and shuffling cost, and how much noise each method
    /// of sampling area lights leaves for equal samples and for equal time
    #[arg(long, requires = "scenes")]
    pub(crate) sampling_study: bool,

    /// The folder to write [default: results/<date>-<scene>]
    ///
    /// A report that is there already is replaced, but not before a scene, sweep or study of the new
    /// one is done: what is interrupted earlier is written into a new folder, DIR-partial.
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,

    /// Go on with what --out has of this comparison, or begin where it has nothing yet
    ///
    /// Each scene, sweep and study that is done is saved there as soon as it is. The command has to
    /// be the same but for --resume and --quiet.
    #[arg(long, requires = "out", conflicts_with = "save_rays")]
    pub(crate) resume: bool,

    /// An older report.json to compare with
    #[arg(long, value_name = "FILE", requires = "scenes")]
    pub(crate) baseline: Option<PathBuf>,

    /// A regression is slower than the baseline by more than this, with its whole 95 % interval
    #[arg(long, value_name = "PERCENT", default_value = "10%", allow_negative_numbers = true,
        value_parser = percent, requires = "baseline")]
    pub(crate) fail_above: f64,

    /// Treat unknown commands of the scenes as warnings
    #[arg(long)]
    pub(crate) lenient: bool,

    /// Print nothing but errors; the files and the exit code are the result
    #[arg(long, short)]
    pub(crate) quiet: bool,
}

impl CompareArguments {
    /// All structures that were named.
    pub(crate) fn structures(&self) -> Vec<Structure> {
        StructureList::joined(&self.accel)
    }
}

/// `srt conformance`.
#[derive(Debug, Args)]
#[command(after_help = "\
The hits of each structure over awkward meshes are compared with those of no structure at all, for\n\
rays that are made to find differences. The first ray whose hits differ is printed.\n\n\
Exit codes: 0 no hit differs, 1 a structure's hits differ or it failed, 2 trouble; 130 interrupted\n\
by Ctrl-C, 128 + n by another signal n: what was compared until then is printed.\n\n\
Examples:\n  \
srt conformance\n  \
srt conformance --accel bvh --budget 10\n  \
srt conformance --accel bvh8:builder=ploc,leaf=4,bvh")]
pub(crate) struct ConformanceArguments {
    /// The acceleration structures, with commas between them [default: all but the peers]
    #[arg(long, value_name = "NAMES", value_parser = Structures::default().list_parser())]
    pub(crate) accel: Vec<StructureList>,

    /// How long each structure may take [default: as long as it needs]; what it had no time for is
    /// said
    #[arg(long, value_name = "SECONDS", allow_negative_numbers = true, value_parser = seconds)]
    pub(crate) budget: Option<Duration>,

    /// Print nothing but differences and errors
    #[arg(long, short)]
    pub(crate) quiet: bool,
}

impl ConformanceArguments {
    /// All structures that were named.
    pub(crate) fn structures(&self) -> Vec<Structure> {
        StructureList::joined(&self.accel)
    }
}

/// `srt report`.
#[derive(Debug, Args)]
#[command(after_help = "Pictures are taken from the folder of FILE.\n\n\
    Examples:\n  srt report results/old/report.json --out results/again\n  \
    srt report results/old/report.json --plots figures")]
pub(crate) struct ReportArguments {
    /// A report.json that `srt compare` wrote
    #[arg(value_name = "FILE")]
    pub(crate) record: PathBuf,

    /// The folder to write [default: that of FILE]
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,

    /// Take ratios to another structure of the report
    #[arg(long, value_name = "NAME")]
    pub(crate) base: Option<String>,

    /// Also write each plot of the page as an SVG file, into this folder
    #[arg(long, value_name = "DIR")]
    pub(crate) plots: Option<PathBuf>,

    /// Print nothing but errors
    #[arg(long, short)]
    pub(crate) quiet: bool,
}

/// A report names the files of its scenes, and they are read twice.
fn named_file(path: PathBuf) -> Result<PathBuf, &'static str> {
    if is_stdin(&path) { Err("a comparison takes scenes from files") } else { Ok(path) }
}
